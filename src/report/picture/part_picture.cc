#include "report/picture/part_picture.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/picture/picture.h"
#include "report/picture/stored_surface.h"
#include "report/stored/stored_numbers.h"
#include "report/text/atomic_file.h"
#include "report/text/json_node.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

/// Numbers and words beside the drawing.
struct PartFacts {
  std::string name, verdict, model, group, label;
  PeakMark mark;
};

std::string picture_of(const PartFacts& facts, Surface surface) {
  Picture picture;
  picture.title = fmt::format("{}: {}", facts.name, facts.verdict);
  picture.detail = fmt::format(
      "peak {:.5g} MPa{} at {}, {}; {}", facts.mark.value,
      facts.mark.has_band ? fmt::format(", band [{:.5g}, {:.5g}] MPa",
                                        facts.mark.low, facts.mark.high)
                          : "",
      facts.group, facts.label, facts.model);
  picture.sight = best_sight(surface, facts.mark.at);
  picture.mark = facts.mark;
  picture.layers = {{std::move(surface)}};
  return svg_of(picture);
}

/// The frame of the label, else that of the largest stress.
template <class Frames>
std::size_t frame_of(const Frames& labels, const std::string& label,
                     std::size_t otherwise) {
  const auto found = std::ranges::find(labels, label);
  return found == labels.end()
             ? otherwise
             : static_cast<std::size_t>(found - labels.begin());
}

}  // namespace

void write_part_picture(const PartView& view,
                        const assessment::PartResult& result,
                        const std::filesystem::path& folder) {
  if (view.triangles.empty() || view.stress.integers.rows() == 0) return;
  const assessment::PeakStress& peak = judged_peak(result);
  std::vector<std::string> labels;
  for (const ViewInstant& frame : view.frames) labels.push_back(frame.label);
  const auto frame = static_cast<Eigen::Index>(
      frame_of(labels, peak.label, static_cast<std::size_t>(view.peak_frame)));
  const PackedField& field = view.stress;
  const Eigen::MatrixX3d points = view.positions(view.places, Eigen::all);
  Surface surface{millimetres(points), view.triangles, view.cell_triangles,
                  field.integers.cast<double>() *
                      field.scale.cwiseProduct(
                          field.coefficients.col(frame).cast<double>()) /
                      1e6};
  write_file(
      folder / (result.name + ".svg"),
      picture_of({result.name,
                  std::string(part::text(result.verdict)),
                  result.model,
                  peak.group,
                  peak.label,
                  {millimetres(peak.at), megapascals(peak.value),
                   megapascals(peak.band_low), megapascals(peak.band_high),
                   peak.verdict != assessment::PeakVerdict::kSingular}},
                 std::move(surface)));
}

std::vector<std::string> part_names(const StoredPage& page) {
  const auto json = ordered_json::parse(page.result);
  std::vector<std::string> names;
  for (const JsonNode& part :
       JsonNode(json, "result:").at("parts").elements()) {
    names.push_back(part.at("name").text());
  }
  return names;
}

std::string stored_part_picture(const StoredPage& page,
                                const std::string& part) {
  const auto result_json = ordered_json::parse(page.result);
  const auto results = JsonNode(result_json, "result:").at("parts").elements();
  for (std::size_t p = 0; p < results.size(); ++p) {
    const JsonNode& result = results[p];
    if (result.at("name").text() != part) continue;
    const auto view_json = ordered_json::parse(page.parts[p]);
    const JsonNode view(view_json, "view of a part:");
    const JsonNode peak = result.has("peak_outside_singular_zones")
                              ? result.at("peak_outside_singular_zones")
                              : result.at("peak_von_mises");
    const auto at = peak.at("at_mm").numbers<3>();
    const auto frame = frame_of(
        view_json.at("frames").at("label").get<std::vector<std::string>>(),
        peak.at("case").text(),
        static_cast<std::size_t>(view.at("peak_frame").number()));
    PeakMark mark{{at[0], at[1], at[2]},
                  peak.at("value_MPa").number(),
                  0,
                  0,
                  peak.has("band_MPa")};
    if (mark.has_band) {
      const auto band = peak.at("band_MPa").numbers<2>();
      mark.low = band[0];
      mark.high = band[1];
    }
    return picture_of(
        {part, result.at("verdict").text(), result.at("model").text(),
         peak.at("group").text(), peak.at("case").text(), mark},
        stored_surface(view, frame));
  }
  const auto names = part_names(page);
  throw Error(
      "U001", "--part", fmt::format("the result has no part \"{}\"", part),
      names.empty() ? "It has none."
                    : fmt::format("It has {}.", fmt::join(names, ", ")));
}

}  // namespace clevis::report
