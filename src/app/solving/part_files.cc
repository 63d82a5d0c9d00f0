#include "app/solving/part_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/text/atomic_file.h"
#include "report/text/csv_field.h"
#include "stress/output/field_output.h"

namespace clevis::app {
namespace {

constexpr int kFrames = 20;            // steps of the series
constexpr int kFrameSubdivisions = 2;  // coarse: the series is to look at

/// Instants that make the series: the ends and kFrames − 1 between.
std::vector<int> frame_instants(std::size_t instants) {
  const int last = static_cast<int>(instants) - 1;
  std::vector<int> frames;
  for (int k = 0; k <= std::min(kFrames, last); ++k) {
    frames.push_back(last * k / std::min(kFrames, std::max(last, 1)));
  }
  return frames;
}

std::string frame_name(const std::string& part, std::size_t frame) {
  return fmt::format("{}/{}_{:04}.vtu", report::kFramesFolder, part, frame);
}

/// Values over the whole motion that go with the worst instant's field.
std::vector<stress::ScalarField> worst_scalars(
    const assessment::PartFields& fields, double yield_strength) {
  const stress::StressHistory& worst = fields.worst;
  stress::ScalarField peak{"von_mises_worst", "Pa", worst.worst};
  stress::ScalarField when{"worst_time", "s", worst.worst};
  for (Eigen::Index c = 0; c < worst.worst.cols(); ++c) {
    for (Eigen::Index q = 0; q < worst.worst.rows(); ++q) {
      when.values(q, c) =
          fields.times[static_cast<std::size_t>(worst.worst_instant(q, c))];
    }
  }
  // Capped: an unloaded corner has no meaningful factor.
  constexpr double kLargest = 1e3;
  stress::ScalarField safety{
      "safety_factor", "1",
      (yield_strength / worst.worst.array().max(yield_strength / kLargest))
          .matrix()};
  const stress::ScalarField zone{"singular_zone", "1",
                                 fields.zones.value_or(Eigen::MatrixXd::Zero(
                                     worst.worst.rows(), worst.worst.cols()))};
  return {peak, when, safety, zone};
}

std::string history_csv(const std::vector<assessment::InstantRow>& history) {
  std::string text = "label,time_s,peak_von_mises_MPa,strain_energy_mJ\n";
  for (const auto& row : history) {
    text += fmt::format("{},{},{},{}\n", report::csv_field(row.label), row.time,
                        row.peak * 1e-6, row.strain_energy * 1e3);
  }
  return text;
}

std::string pvd(const std::vector<std::string>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const auto& entry : entries) text += entry;
  return text + "</Collection>\n</VTKFile>\n";
}

std::string pvd_entry(double time, std::size_t part, const std::string& file) {
  return fmt::format(
      "<DataSet timestep=\"{:.9g}\" group=\"\" part=\"{}\" file=\"{}\"/>\n",
      time, part, file);
}

std::vector<std::string> series_of(const std::vector<std::string>& parts,
                                   const mechanism::Motion& motion) {
  std::vector<std::string> entries;
  const auto frames = frame_instants(motion.instants.size());
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const double time = motion.instants[static_cast<std::size_t>(frames[f])].t;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      entries.push_back(pvd_entry(time, p, frame_name(parts[p], f)));
    }
  }
  return entries;
}

void write_vtu(const std::filesystem::path& file,
               const stress::FieldOutput& output, stress::CellOrder order) {
  report::write_file(file, [&](const report::TextSink& sink) {
    output.write(order, sink);
  });
}

void write_frames(const assessment::PartAssessment& assessment,
                  const MovingPart& moving,
                  const std::filesystem::path& folder) {
  const auto& instants = moving.motion->instants;
  const auto frames = frame_instants(instants.size());
  const int subdivisions =
      std::min(kFrameSubdivisions, assessment.fields.worst.subdivisions);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto& pose = instants[static_cast<std::size_t>(frames[f])]
                           .bodies[static_cast<std::size_t>(moving.body)]
                           .pose;
    const stress::FieldOutput output(
        assessment.fields.dim, assessment.fields.shape,
        assessment.fields.at(frames[f], subdivisions), {}, pose);
    write_vtu(folder / frame_name(assessment.result.name, f), output,
              stress::CellOrder::kLinear);
  }
  report::write_file(folder / (assessment.result.name + ".pvd"),
                     pvd(series_of({assessment.result.name}, *moving.motion)));
}

}  // namespace

bool begins_with_motion(const assessment::PartFields& fields,
                        const mechanism::Motion& motion) {
  const auto found = std::ranges::mismatch(motion.instants, fields.times, {},
                                           &mechanism::Instant::t);
  return found.in1 == motion.instants.end();
}

void write_part_files(const assessment::PartAssessment& assessment,
                      const FieldFiles& files, double yield_strength,
                      const std::filesystem::path& folder) {
  const assessment::PartFields& fields = assessment.fields;
  const stress::FieldOutput output(
      fields.dim, fields.shape,
      fields.at(fields.peak_instant, fields.worst.subdivisions),
      worst_scalars(fields, yield_strength));
  const std::string& name = assessment.result.name;
  write_vtu(folder / (name + ".vtu"), output, stress::CellOrder::kLagrange);
  // Simplices have linear cells in either.
  if (files.linear_cells && fields.shape == mesh::CellShape::kTensor) {
    write_vtu(folder / (name + "_linear.vtu"), output,
              stress::CellOrder::kLinear);
  }
  if (fields.buckling) {
    const stress::FieldOutput shape(3, fields.buckling->shape,
                                    fields.buckling->field, {});
    write_vtu(folder / (name + "_buckling.vtu"), shape,
              stress::CellOrder::kLagrange);
  }
  report::write_file(folder / (name + "_history.csv"),
                     history_csv(fields.history));
  if (files.moving && begins_with_motion(fields, *files.moving->motion)) {
    write_frames(assessment, *files.moving, folder);
  }
}

void write_mechanism_series(const std::vector<std::string>& parts,
                            const mechanism::Motion& motion,
                            const std::filesystem::path& folder) {
  std::vector<std::string> shown;
  std::ranges::copy_if(
      parts, std::back_inserter(shown), [&](const std::string& part) {
        return std::filesystem::exists(folder / frame_name(part, 0));
      });
  if (shown.empty()) return;
  report::write_file(folder / "mechanism.pvd", pvd(series_of(shown, motion)));
}

}  // namespace clevis::app
