#include "beam/estimates/deflection.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clevis::beam {

using Eigen::Vector3d;

namespace {

// Axial strain and curvature vector of the axis at a position [m].
struct AxisStrain {
  double s{};
  double axial{};                         // [1]
  Vector3d curvature = Vector3d::Zero();  // ε = curvature · r [1/m]
};

AxisStrain interpolated(const AxisStrain& a, const AxisStrain& b, double s) {
  const double t = (s - a.s) / (b.s - a.s);
  return {s, a.axial + t * (b.axial - a.axial),
          a.curvature + t * (b.curvature - a.curvature)};
}

// Strains at every station and seat of the line, ascending.
std::vector<AxisStrain> axis_strains(const PinLine& line,
                                     const loads::LoadHistory& history,
                                     const loads::InstantLoad& instant,
                                     double youngs_modulus) {
  std::vector<AxisStrain> stations;
  for (const Span& span : line.spans) {
    const double start = history.seats[span.from].p_LS.dot(line.direction);
    for (std::size_t k = 0; k < span.stations.size(); ++k) {
      const Station& station = span.stations[k];
      const loads::Wrench w =
          section_force(history, instant, span.beyond[k], station);
      stations.push_back(
          {start + span.positions[k],
           w.force.dot(line.direction) / (youngs_modulus * station.area()),
           station.bending_gradient(w.moment) / youngs_modulus});
    }
  }
  std::vector<AxisStrain> all = stations;
  const std::size_t n = stations.size();
  for (const std::size_t seat : line.seats) {
    const double s = history.seats[seat].p_LS.dot(line.direction);
    const auto after =
        std::ranges::lower_bound(stations, s, {}, &AxisStrain::s);
    const auto i = static_cast<std::size_t>(after - stations.begin());
    const std::size_t right = std::clamp<std::size_t>(i, 1, n - 1);
    all.push_back(interpolated(stations[right - 1], stations[right], s));
  }
  std::ranges::stable_sort(all, {}, &AxisStrain::s);
  return all;
}

struct AxisDisplacement {
  double s{};
  double along{};                      // [m]
  Vector3d across = Vector3d::Zero();  // [m]
  Vector3d slope = Vector3d::Zero();   // of across [1]
};

// along' = ε, across'' = −curvature; exact where both are linear.
std::vector<AxisDisplacement> integrate(
    const std::vector<AxisStrain>& strains) {
  std::vector<AxisDisplacement> axis{{.s = strains.front().s}};
  for (std::size_t k = 1; k < strains.size(); ++k) {
    const AxisStrain& a = strains[k - 1];
    const AxisStrain& b = strains[k];
    const double h = b.s - a.s;
    AxisDisplacement next = axis.back();
    next.s = b.s;
    next.along += 0.5 * h * (a.axial + b.axial);
    next.across +=
        h * next.slope - h * h / 6.0 * (2.0 * a.curvature + b.curvature);
    next.slope -= 0.5 * h * (a.curvature + b.curvature);
    axis.push_back(next);
  }
  return axis;
}

const AxisDisplacement& at_position(const std::vector<AxisDisplacement>& axis,
                                    double s) {
  return *std::ranges::min_element(axis, {}, [s](const AxisDisplacement& d) {
    return std::abs(d.s - s);
  });
}

/// What the axis does not move against: a point, and another or the slope
/// there.
struct Reference {
  double at{};  ///< along the axis [m]
  std::optional<double> guided;
};

/// By the groups that hold the part; where the line does not pass through them,
/// by the line's first seats, bearing ones before others.
Reference reference_of(const PinLine& line, const loads::LoadHistory& history,
                       const loads::HoldingGroups& hold) {
  const auto position = [&](std::size_t seat) {
    return history.seats[seat].p_LS.dot(line.direction);
  };
  std::vector<double> at;
  for (const std::string& group : hold) {
    const auto seat = std::ranges::find(line.seats, group, [&](std::size_t i) {
      return loads::holder_of(history.seats, i);
    });
    if (seat != line.seats.end()) at.push_back(position(*seat));
  }
  if (hold.size() == 1 && at.size() == 1) return {at[0], std::nullopt};
  if (at.size() == 2) return {at[0], at[1]};
  std::vector<std::size_t> seats = line.seats;
  std::ranges::sort(seats, {}, [&](std::size_t i) {
    const bool face = history.seats[i].kind != loads::SeatKind::kBearing;
    return std::pair(face, i);
  });
  return {position(seats[0]), position(seats[1])};
}

}  // namespace

double beam_deflection(const PinLine& line, const loads::LoadHistory& history,
                       const loads::HoldingGroups& hold,
                       double youngs_modulus) {
  std::size_t count = 0;
  for (const Span& span : line.spans) count += span.stations.size();
  if (count < 2) return 0.0;
  const Reference reference = reference_of(line, history, hold);
  const double s_1 = reference.at;
  double largest = 0.0;
  for (const loads::InstantLoad& instant : history.instants) {
    const std::vector<AxisDisplacement> axis =
        integrate(axis_strains(line, history, instant, youngs_modulus));
    const AxisDisplacement& held = at_position(axis, s_1);
    Vector3d tilt = held.slope;
    if (reference.guided) {
      const double s_2 = *reference.guided;
      const AxisDisplacement& guided = at_position(axis, s_2);
      tilt = s_2 == s_1 ? Vector3d(Vector3d::Zero())
                        : Vector3d((guided.across - held.across) / (s_2 - s_1));
    }
    for (const AxisDisplacement& d : axis) {
      const Vector3d across = d.across - held.across - (d.s - s_1) * tilt;
      largest =
          std::max(largest, std::hypot(d.along - held.along, across.norm()));
    }
  }
  return largest;
}

}  // namespace clevis::beam
