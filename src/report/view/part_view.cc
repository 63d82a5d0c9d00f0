#include "report/view/part_view.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "report/text/json_text.h"
#include "report/text/units.h"
#include "report/view/view_numbers.h"

namespace clevis::report {
namespace {

using Eigen::Index;
using nlohmann::ordered_json;

template <std::size_t n>
ordered_json corners(const std::vector<std::array<int, n>>& pieces) {
  std::vector<std::uint32_t> numbers;
  for (const auto& piece : pieces) {
    for (const int point : piece) {
      numbers.push_back(static_cast<std::uint32_t>(point));
    }
  }
  return packed(numbers);
}

ordered_json counts(const std::vector<int>& counted) {
  return packed(std::vector<std::uint32_t>(counted.begin(), counted.end()));
}

/// In steps of a 65535th of the largest extent: what 16 bits hold.
ordered_json positions_json(const Eigen::MatrixX3d& positions) {
  constexpr double kMost = 65535.0;
  Eigen::RowVector3d low = Eigen::RowVector3d::Zero();
  double step = 1.0;
  if (positions.rows() > 0) {
    low = positions.colwise().minCoeff();
    const double extent = (positions.rowwise() - low).maxCoeff();
    if (extent > 0.0) step = extent / kMost;
  }
  std::vector<std::uint32_t> numbers;
  for (int d = 0; d < 3; ++d) {
    for (Index p = 0; p < positions.rows(); ++p) {
      numbers.push_back(static_cast<std::uint32_t>(
          std::lround((positions(p, d) - low[d]) / step)));
    }
  }
  return {{"integers", packed(numbers)},
          {"scale", millimetres(step)},
          {"origin",
           {millimetres(low[0]), millimetres(low[1]), millimetres(low[2])}}};
}

/// In 8 bits where they fit.
template <class Column>
ordered_json integers_json(const Column& column) {
  constexpr int kMost8 = 127;
  const auto fits = [](std::int16_t value) {
    return std::abs(int{value}) <= kMost8;
  };
  if (std::all_of(column.begin(), column.end(), fits)) {
    return packed(std::vector<std::int8_t>(column.begin(), column.end()));
  }
  return packed(std::vector<std::int16_t>(column.begin(), column.end()));
}

/// @param unit  of what is shown, over SI.
ordered_json field_json(const PackedField& field, double unit) {
  std::vector<float> coefficients(
      field.coefficients.data(),
      field.coefficients.data() + field.coefficients.size());
  ordered_json scale = ordered_json::array(), columns = scale;
  for (Index k = 0; k < field.scale.size(); ++k) {
    scale.push_back(field.scale[k] * unit);
    columns.push_back(integers_json(field.integers.col(k)));
  }
  return {{"columns", columns},
          {"scale", scale},
          {"coefficients", packed(coefficients)},
          {"largest_error", field.error * unit}};
}

ordered_json instants_json(const std::vector<ViewInstant>& instants) {
  ordered_json labels = ordered_json::array(), times = labels, peaks = labels,
               energies = labels;
  for (const ViewInstant& instant : instants) {
    labels.push_back(instant.label);
    times.push_back(instant.time);
    peaks.push_back(megapascals(instant.peak));
    energies.push_back(millijoules(instant.strain_energy));
  }
  return {{"label", labels},
          {"t_s", times},
          {"peak_von_mises_MPa", peaks},
          {"strain_energy_mJ", energies}};
}

ordered_json vector_json(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

ordered_json held_json(const part::Supports& supports) {
  ordered_json json = ordered_json::object();
  for (const auto& [group, held] : supports) {
    std::string axes;
    for (std::size_t d = 0; d < 3; ++d) {
      if (held[d]) axes += "xyz"[d];
    }
    json[group] = axes;
  }
  return json;
}

ordered_json case_json(const part::LoadCaseDefinition& given) {
  ordered_json pins = ordered_json::object(), pressure = pins, traction = pins;
  for (const auto& [group, force] : given.pins) {
    pins[group] = vector_json(force);
  }
  for (const auto& [group, value] : given.pressure) {
    pressure[group] = megapascals(value);
  }
  for (const auto& [group, value] : given.traction) {
    traction[group] = vector_json(value * 1e-6);
  }
  return {{"name", given.name},
          {"pins_N", pins},
          {"pressure_MPa", pressure},
          {"traction_MPa", traction},
          {"fixed", held_json(given.fixed)},
          {"held_by_pin", given.held_by_pin},
          {"acceleration_m_per_s2", vector_json(given.acceleration)},
          {"angular_velocity_rad_per_s", vector_json(given.angular_velocity)},
          {"angular_acceleration_rad_per_s2",
           vector_json(given.angular_acceleration)}};
}

ordered_json definition_json(const part::PartDefinition& part) {
  constexpr double kGiga = 1e-9;
  ordered_json seats = ordered_json::array(), cases = seats;
  for (const auto& seat : part.seats) {
    seats.push_back({{"from", seat.joint}, {"group", seat.group}});
  }
  for (const auto& seat : part.drive_seats) {
    seats.push_back({{"from", seat.drive}, {"group", seat.group}});
  }
  for (const auto& seat : part.force_seats) {
    seats.push_back({{"from", seat.force}, {"group", seat.group}});
  }
  for (const auto& given : part.cases) cases.push_back(case_json(given));
  return {{"mesh", part.mesh.filename().string()},
          {"material",
           {{"name", part.material.name},
            {"youngs_modulus_GPa", part.material.youngs_modulus * kGiga},
            {"poissons_ratio", part.material.poissons_ratio},
            {"density_kg_per_m3", part.material.density},
            {"yield_strength_MPa", megapascals(part.material.yield_strength)}}},
          {"seats", seats},
          {"cases", cases}};
}

}  // namespace

std::string part_view_json(const PartView& view) {
  const Index places = view.positions.rows();
  ordered_json json = {
      {"schema", kPartViewSchema},
      {"part", view.definition.name},
      {"body", view.body},
      {"definition", definition_json(view.definition)},
      {"places", places},
      {"positions_mm", positions_json(view.positions)},
      {"points", view.places.size()},
      {"point_places", counts(view.places)},
      {"triangles", corners(view.triangles)},
      {"cell_triangles", counts(view.cell_triangles)},
      {"outline", corners(view.outline)},
      {"faces_z_mm", nullptr},
      {"frames", instants_json(view.frames)},
      {"is_motion", view.is_motion},
      {"peak_point", view.peak_point},
      {"peak_frame", view.peak_frame},
      {"von_mises_MPa", field_json(view.stress, 1e-6)},
      {"displacement_components",
       places > 0 ? view.displacement.integers.rows() / places : 0},
      {"displacement_mm", field_json(view.displacement, 1e3)},
      {"history", instants_json(view.history)}};
  if (view.faces_z) {
    json["faces_z_mm"] = {millimetres((*view.faces_z)[0]),
                          millimetres((*view.faces_z)[1])};
  }
  refuse_non_finite(json, "part " + view.definition.name);
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) +
         "\n";
}

}  // namespace clevis::report
