#include "mechanism/neighbours/neighbour_inertia.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/algebra/append_columns.h"
#include "base/algebra/singular_vectors.h"
#include "base/values/index.h"
#include "mechanism/joints/cross_matrix.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kTwist = 6;
// Of rows of pure numbers, and of bodies' masses: less is round-off.
constexpr double kRoundOff = 1e-9;
// Of a spring's direction: what it does to motions that it does not swing.
constexpr double kFelt = 1e-6;

/// Rows of the body as wrenches by place, 6 places × rows.
MatrixXd wrenches_of(const Neighbours& neighbours, const NeighbourRows& rows) {
  const SolvingFrame& frame = neighbours.frame();
  const Eigen::Matrix3d R_LP = rows.x[index(neighbours.slot())].R.transpose();
  const Vector3d& p_LM = frame.p_LM[index(neighbours.slot() - 1)];
  MatrixXd all =
      MatrixXd::Zero(kTwist * std::ssize(rows.places), rows.body.rows());
  for (Index k = 0; k < rows.body.rows(); ++k) {
    const Vector3d force = R_LP * rows.body.row(k).head<3>().transpose();
    const Vector3d moment = R_LP * rows.body.row(k).tail<3>().transpose();
    auto wrench = all.col(k).segment<kTwist>(
        kTwist * static_cast<Index>(rows.place_of[index(k)]));
    wrench << force, frame.length * moment + p_LM.cross(force);
  }
  return all;
}

/// Of the neighbours' unknowns, as their masses: the moment θ' × h that turns a
/// momentum h [kg/s]. Empty: none.
MatrixXd spins_of(const Neighbours& neighbours, const Configuration& x,
                  const Instant& instant) {
  const auto& slots = neighbours.slots();
  const SolvingFrame& frame = neighbours.frame();
  const auto state_of = [&](int slot) -> const BodyState& {
    return instant.bodies[index(slot - 1)];
  };
  const Vector3d& own = state_of(neighbours.slot()).w_WL;
  const double square = frame.length * frame.length;
  MatrixXd spins =
      MatrixXd::Zero(kTwist * std::ssize(slots), kTwist * std::ssize(slots));
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const auto& given =
        neighbours.definition().bodies[index(slots[k] - 1)].mass_properties;
    const Eigen::Matrix3d& R = x[index(slots[k])].R;
    const Vector3d spin =
        frame.R_WP.transpose() * (state_of(slots[k]).w_WL - own);
    const Vector3d momentum = R * given.inertia_LCm * R.transpose() * spin;
    const Index at = kTwist * static_cast<Index>(k) + 3;
    spins.block<3, 3>(at, at) = -cross_matrix(momentum) / square;
  }
  return spins.isZero(0.0) ? MatrixXd() : spins;
}

/// A force element that yields at an instant.
struct YieldingElement {
  int number;
  const ActingElement* element;
  ElementSpring spring;
  std::size_t place{};  ///< where it acts on the body, if it does
};

/// Those on the body or its neighbours; adds the places of those on the body.
std::vector<YieldingElement> yielding_elements(const Neighbours& neighbours,
                                               const Instant& instant,
                                               NeighbourRows& rows) {
  std::vector<YieldingElement> found;
  const std::size_t count =
      std::min(instant.elements.size(), neighbours.elements().size());
  for (std::size_t e = 0; e < count; ++e) {
    if (!neighbours.elements()[e]) continue;
    const ActingElement& element = *neighbours.elements()[e];
    ElementSpring spring = element.spring(rows.x, instant.elements[e]);
    if (spring.directions.empty()) continue;
    if (neighbours.acts_on_body(element)) {
      rows.places.push_back({-1, false, static_cast<int>(e)});
    }
    found.push_back({static_cast<int>(e), &element, std::move(spring),
                     rows.places.size() - 1});
  }
  return found;
}

/// @param place  where it acts on the body, if it does.
ElementDirections directions_of(const Neighbours& neighbours,
                                const Configuration& x,
                                const ActingElement& element,
                                const std::vector<PlacedJoint::Levers>& given,
                                std::size_t place, Index wrenches) {
  const int own = neighbours.slot();
  const Eigen::Matrix3d R_LP = x[index(own)].R.transpose();
  ElementDirections found{
      MatrixXd::Zero(wrenches, std::ssize(given)),
      MatrixXd::Zero(kTwist * std::ssize(neighbours.slots()),
                     std::ssize(given))};
  const auto add = [&](int slot, const SpatialForce& force, Index column) {
    if (slot != own) {
      neighbours.add_action(slot, force, found.neighbours.col(column));
      return;
    }
    const Vector3d f = R_LP * force.v;
    auto wrench = found.body.col(column).segment<kTwist>(
        kTwist * static_cast<Index>(place));
    wrench.head<3>() += f;
    wrench.tail<3>() +=
        R_LP * force.w + neighbours.frame().p_LM[index(own - 1)].cross(f);
  };
  for (Index k = 0; k < found.body.cols(); ++k) {
    add(element.line.a, given[index(k)].a, k);
    add(element.line.b, given[index(k)].b, k);
  }
  return found;
}

/// A rotor that turns with a line of the body.
struct Rotor {
  const ActingElement* element;
  std::size_t place;  ///< where it acts on the body
};

/// Adds the places of those that have none.
std::vector<Rotor> rotors_on_body(const Neighbours& neighbours,
                                  NeighbourRows& rows) {
  std::vector<Rotor> found;
  for (std::size_t e = 0; e < neighbours.elements().size(); ++e) {
    const ActingElement* element = neighbours.elements()[e].get();
    if (element == nullptr || !(element->inertia() > 0.0) ||
        !neighbours.acts_on_body(*element)) {
      continue;
    }
    const NeighbourPlace here{-1, false, static_cast<int>(e)};
    const auto known = std::ranges::find(rows.places, here);
    found.push_back({element, index(known - rows.places.begin())});
    if (known == rows.places.end()) rows.places.push_back(here);
  }
  return found;
}

/// Inertia of rotors on the body as its places feel it: neighbours give way in
/// motions that the places do not see.
/// @param turned  directions of the rotors. @param following  of the
///   neighbours' speeds to wrenches. @param unseen  those motions.
MatrixXd weighed_by_rotors(const Neighbours& neighbours, const Configuration& x,
                           const std::vector<Rotor>& rotors,
                           const std::vector<ElementDirections>& turned,
                           const MatrixXd& following, const MatrixXd& unseen) {
  const Index count = std::ssize(rotors);
  MatrixXd felt(following.cols(), count), given(count, unseen.cols());
  for (Index k = 0; k < count; ++k) {
    const ElementDirections& along = turned[index(k)];
    const double root = std::sqrt(rotors[index(k)].element->inertia());
    felt.col(k) =
        root * (along.body + following.transpose() * along.neighbours);
    given.row(k) = root * along.neighbours.transpose() * unseen;
  }
  if (count == 0 || unseen.cols() == 0) return felt;
  MatrixXd mass = unseen.transpose() * neighbours.masses(x) * unseen;
  mass.diagonal().array() += kRoundOff * kRoundOff * mass.diagonal().maxCoeff();
  const MatrixXd series = MatrixXd::Identity(count, count) +
                          given * mass.llt().solve(given.transpose());
  return series.llt().matrixL().solve(felt.transpose()).transpose();
}

}  // namespace

NeighbourInertia neighbour_inertia(const Neighbours& neighbours,
                                   const Instant& instant) {
  NeighbourRows rows = neighbours.rows(instant);
  const auto yielding = yielding_elements(neighbours, instant, rows);
  const auto rotors = rotors_on_body(neighbours, rows);
  const MatrixXd wrenches = wrenches_of(neighbours, rows);
  NeighbourInertia found{.places = rows.places,
                         .held = wrenches,
                         .weighed = MatrixXd(wrenches.rows(), 0)};
  MatrixXd following =
      MatrixXd::Zero(kTwist * std::ssize(neighbours.slots()), wrenches.rows());
  const MatrixXd& free = rows.free;
  MatrixXd unseen = free;
  const MatrixXd seen = rows.there * free;
  Index follow = 0;
  MatrixXd followed;
  if (seen.size() > 0) {
    const SingularVectors seeing = singular_vectors(seen);
    follow = seeing.count_above(kRoundOff);
    followed = seeing.U.leftCols(follow);
    found.held = wrenches * seeing.left_rows(follow);
    unseen = free * seeing.left(follow);
  }
  if (follow > 0) {
    const MatrixXd of_followed = wrenches * followed;
    MatrixXd mass = free.transpose() * neighbours.masses(rows.x) * free;
    mass.diagonal().array() +=
        kRoundOff * kRoundOff * mass.diagonal().maxCoeff();
    const MatrixXd directions = seen.transpose() * followed;
    const MatrixXd moved = mass.llt().solve(directions);
    const Eigen::LLT<MatrixXd> root(directions.transpose() * moved);
    const MatrixXd unit = MatrixXd::Identity(follow, follow);
    // Added mass (L Lᵀ)⁻¹ = L⁻ᵀ L⁻¹ of the followed motions.
    found.weighed = of_followed * root.matrixU().solve(unit);
    // Speeds of the neighbours against unit motions that they follow.
    const MatrixXd speeds = free * moved * root.solve(unit);
    following = -speeds * of_followed.transpose();
    const MatrixXd spins = spins_of(neighbours, rows.x, instant);
    if (spins.size() > 0) {
      found.spin = following.transpose() * spins * following;
    }
  }
  std::vector<ElementDirections> turned;
  for (const auto& [element, place] : rotors) {
    turned.push_back(directions_of(neighbours, rows.x, *element,
                                   {levers_of(*element, rows.x)}, place,
                                   wrenches.rows()));
  }
  append_columns(
      weighed_by_rotors(neighbours, rows.x, rotors, turned, following, unseen),
      found.weighed);
  std::vector<ElementDirections> directions;
  for (const YieldingElement& element : yielding) {
    const ElementDirections& along = directions.emplace_back(directions_of(
        neighbours, rows.x, *element.element, element.spring.directions,
        element.place, wrenches.rows()));
    if (element.spring.relaxes ||
        (along.neighbours.transpose() * unseen).norm() >
            kFelt * along.neighbours.norm()) {
      found.left_out.push_back(element.number);
      continue;
    }
    const MatrixXd felt = along.body + following.transpose() * along.neighbours;
    append_columns(felt * root_of(element.spring.stiffness), found.sprung);
    append_columns(felt * root_of(element.spring.damping), found.damped);
  }
  if (!found.left_out.empty()) {
    SwingingForm swinging(neighbours, rows, wrenches);
    for (std::size_t k = 0; k < rotors.size(); ++k) {
      swinging.add(rotors[k].element->inertia(), turned[k]);
    }
    for (std::size_t k = 0; k < yielding.size(); ++k) {
      swinging.add(yielding[k].spring, directions[k]);
    }
    found.swinging = swinging.take();
  }
  return found;
}

}  // namespace clevis::mechanism
