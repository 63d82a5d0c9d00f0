#include "report/page/glb_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/page/page_assets.h"
#include "report/stored/stored_numbers.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;
using Byte = std::uint8_t;
using Colour = std::array<double, 3>;

std::vector<Colour> colour_scale() {
  std::vector<Colour> colours;
  for (const auto& hex : ordered_json::parse(viewer_colours())) {
    const auto text = hex.get<std::string>();
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = std::stoi(text.substr(2 * c, 2), nullptr, 16);
    }
    colours.push_back(colour);
  }
  return colours;
}

/// glTF's colours are linear, the scale's are sRGB (IEC 61966-2-1).
Byte linear(double srgb) {
  const double share = srgb / 255.0;
  const double value =
      share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  return static_cast<Byte>(std::lround(255.0 * value));
}

void add_colour(const std::vector<Colour>& scale, double share,
                std::vector<Byte>& bytes) {
  const auto last = static_cast<double>(scale.size() - 1);
  const double at = std::clamp(share, 0.0, 1.0) * last;
  const auto low =
      static_cast<std::size_t>(std::min(std::floor(at), last - 1.0));
  const double part = at - static_cast<double>(low);
  for (std::size_t c = 0; c < 3; ++c) {
    bytes.push_back(
        linear(scale[low][c] + part * (scale[low + 1][c] - scale[low][c])));
  }
  bytes.push_back(255);
}

/// Vertices of a surface: of which point, and where.
struct Skin {
  std::vector<std::size_t> source;
  std::vector<float> positions;  ///< [m]
  std::vector<std::uint32_t> corners;

  std::uint32_t add(std::size_t point, const std::vector<double>& places,
                    double z) {
    constexpr double kMilli = 1e-3;
    source.push_back(point);
    for (const double mm : {places[3 * point], places[3 * point + 1], z}) {
      positions.push_back(static_cast<float>(kMilli * mm));
    }
    return static_cast<std::uint32_t>(source.size() - 1);
  }
};

/// Both faces and the rim of a plate told by its mid-plane.
Skin plate_skin(const JsonNode& part, const std::vector<double>& places) {
  const auto [low, high] = part.at("faces_z_mm").numbers<2>();
  const auto triangles = stored_numbers(part.at("triangles"));
  const auto outline = stored_numbers(part.at("outline"));
  const auto points = static_cast<std::uint32_t>(places.size() / 3);
  Skin skin;
  for (const double z : {low, high}) {
    for (std::size_t p = 0; p < points; ++p) skin.add(p, places, z);
  }
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const auto a = static_cast<std::uint32_t>(triangles[t]);
    const auto b = static_cast<std::uint32_t>(triangles[t + 1]);
    const auto c = static_cast<std::uint32_t>(triangles[t + 2]);
    skin.corners.insert(skin.corners.end(),
                        {a, c, b, a + points, b + points, c + points});
  }
  for (std::size_t e = 0; e < outline.size(); e += 2) {
    const auto a = static_cast<std::size_t>(outline[e]);
    const auto b = static_cast<std::size_t>(outline[e + 1]);
    const auto p = skin.add(a, places, low), q = skin.add(b, places, low);
    const auto r = skin.add(b, places, high), s = skin.add(a, places, high);
    skin.corners.insert(skin.corners.end(), {p, q, r, p, r, s});
  }
  return skin;
}

Skin skin_of(const JsonNode& part) {
  const auto places = stored_points(part);
  if (part.has("faces_z_mm")) return plate_skin(part, places);
  Skin skin;
  for (std::size_t p = 0; p < places.size() / 3; ++p) {
    skin.add(p, places, places[3 * p + 2]);
  }
  for (const double corner : stored_numbers(part.at("triangles"))) {
    skin.corners.push_back(static_cast<std::uint32_t>(corner));
  }
  return skin;
}

}  // namespace

double largest_stress(const JsonNode& part) {
  const auto stress = stored_field(part.at("von_mises_MPa"));
  return stress.size() > 0 ? std::max(0.0, stress.maxCoeff()) : 0.0;
}

ordered_json glb_mesh(const JsonNode& part, double largest, GlbBuffer& buffer) {
  const Skin skin = skin_of(part);
  const auto stress = stored_field(part.at("von_mises_MPa"));
  const auto scale = colour_scale();
  std::vector<float> values;
  std::vector<Byte> colours;
  for (const std::size_t point : skin.source) {
    const double value =
        stress.size() > 0
            ? stress.row(static_cast<Eigen::Index>(point)).maxCoeff()
            : 0.0;
    values.push_back(static_cast<float>(std::max(0.0, value)));
    add_colour(scale, largest > 0.0 ? value / largest : 0.0, colours);
  }
  using Use = GlbBuffer::Use;
  const int positions = buffer.add(skin.positions, "VEC3", Use::kVertices);
  buffer.add_bounds(positions, skin.positions, 3);
  const int corners = buffer.add(skin.corners, Use::kIndices);
  const ordered_json primitive = {
      {"attributes",
       {{"POSITION", positions},
        {"COLOR_0", buffer.add_colours(colours)},
        {"_VON_MISES_MPA", buffer.add(values, "SCALAR", Use::kVertices)}}},
      {"indices", corners},
      {"material", 0}};
  return {{"name", part.at("part").text()},
          {"primitives", ordered_json::array({primitive})}};
}

}  // namespace clevis::report
