#include "loads/pressure/pin_pressure.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/pressure/wall_pressure.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

part::Wall wall_there(const GroupQuadrature& quadrature,
                      const Matrix3Xd& outward) {
  const Matrix3Xd areas = outward * quadrature.weights.asDiagonal();
  return {.area = quadrature.weights.sum(),
          .area_vector = areas.rowwise().sum(),
          .normal_square = areas * outward.transpose()};
}

}  // namespace

PinPressure::PinPressure(const part::Bore& bore,
                         const GroupQuadrature& quadrature,
                         const Matrix3Xd& outward)
    : bore_(bore),
      quadrature_(&quadrature),
      points_(bore, quadrature.points, outward),
      is_whole_(part::is_whole_wall(bore, wall_there(quadrature, outward))) {
  assert(outward.cols() == quadrature.points.cols());
  if (is_whole_) {
    moments_ = wall_of(bore, quadrature.points, quadrature.weights);
  }
}

Matrix3Xd PinPressure::shear(const Wrench& wrench) const {
  const double area = quadrature_->weights.sum();
  const Vector3d& axis = bore_.axis_L;
  Matrix3Xd result =
      wrench.moment.dot(axis) / (area * bore_.radius) * points_.around;
  result.colwise() += Vector3d(wrench.force.dot(axis) / area * axis);
  return result;
}

std::optional<Matrix3Xd> PinPressure::tractions(const Wrench& wrench) const {
  if (is_whole_) {
    return BearingTraction(bore_, wrench, moments_).tractions(points_);
  }
  // Of an open wall shear leaves a force across, too.
  const Matrix3Xd sheared = shear(wrench);
  const Wrench taken = resultant(*quadrature_, sheared, bore_.p_LC);
  const auto pressed = wall_pressure(*quadrature_, points_.normal,
                                     {.force = wrench.force - taken.force,
                                      .moment = wrench.moment - taken.moment},
                                     bore_.p_LC);
  if (!pressed) return std::nullopt;
  return sheared + *pressed;
}

std::optional<double> PinPressure::largest_pressure(
    const Wrench& wrench) const {
  const auto found = tractions(wrench);
  if (!found) return std::nullopt;
  return -found->cwiseProduct(points_.normal).colwise().sum().minCoeff();
}

double largest_bearing_pressure(const part::Bore& bore, const Wrench& wrench,
                                const WallMoments& wall) {
  const BearingTraction bearing(bore, wrench, wall);
  const Vector3d end = 0.5 * bore.length * bore.axis_L;
  return 2.0 / (std::numbers::pi * bore.radius) *
         std::max(bearing.line_load(bore.p_LC - end).norm(),
                  bearing.line_load(bore.p_LC + end).norm());
}

void refuse_open_wall(const std::string& place, const std::string& group,
                      const std::string& label) {
  throw Error("L002", place,
              fmt::format("{}: the pin leaves \"{}\" where it is open; its "
                          "wall only takes pressure",
                          label, group),
              "Name the faces that hold the pin there, too, or load those that "
              "take it by `traction`.");
}

}  // namespace clevis::loads
