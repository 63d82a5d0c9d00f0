#include "mechanism/reactions/other_sharings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "base/values/index.h"
#include "mechanism/constraints/constraint_system.h"
#include "mechanism/constraints/solving_frame.h"
#include "mechanism/reactions/body_motion.h"
#include "mechanism/reactions/equilibrium.h"
#include "mechanism/reactions/largest_reaction.h"
#include "mechanism/reactions/unshared_strains.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Compliance of a joint's forces or moments, as a coordinate of the box.
struct Coordinate {
  std::size_t joint{};
  bool is_moment{};
  double factor{};  ///< to either side of what it is
};

/// One corner: per coordinate whether it is soft.
using Corner = std::vector<bool>;

/// Whether a component of a joint is open and matters at some instant.
bool is_open(const Motion& motion, std::size_t joint, std::size_t component,
             double negligible) {
  return std::ranges::any_of(motion.instants, [&](const Instant& instant) {
    const JointReaction& reaction = instant.joints[joint];
    if (reaction.unique_components[component]) return false;
    const auto k = static_cast<Eigen::Index>(component);
    return reaction.spread[component] > negligible ||
           std::abs(reaction.components()[k]) > negligible;
  });
}

/// Whether pressure on further faces strains an elastic link: what it does to
/// the sharing is left out.
bool is_loaded_elsewhere(const std::vector<int>& loaded, BodyIndex body) {
  return std::ranges::find(loaded, body) != loaded.end();
}

bool is_loaded_elsewhere(const std::vector<int>& loaded,
                         const JointDefinition& joint) {
  return is_loaded_elsewhere(loaded, joint.body_a) ||
         is_loaded_elsewhere(loaded, joint.body_b);
}

/// Joints of a link that give way as much as it does, at least.
void soften_joints(const LinkCompliance& link,
                   std::vector<JointDefinition>& joints) {
  for (std::size_t k = 0; k < link.joints.size(); ++k) {
    auto& compliance = joints[index(link.joints[k])].compliance;
    if (!compliance) continue;  // it may be anything
    const auto own =
        link.matrix.diagonal().segment<6>(6 * static_cast<Eigen::Index>(k));
    compliance->force = compliance->force.cwiseMax(own.head<3>().maxCoeff());
    compliance->moment = compliance->moment.cwiseMax(own.tail<3>().maxCoeff());
  }
}

/// Without the links that pressure strains so: how those share is not
/// known, so that joints alone do, of any compliance about that of the link.
MechanismDefinition without_links(const std::vector<int>& loaded,
                                  const MechanismDefinition& given) {
  MechanismDefinition definition = given;
  for (const int body : loaded) {
    auto& compliance = definition.bodies[index(body)].compliance;
    soften_joints(*compliance, definition.joints);
    compliance.reset();
  }
  return definition;
}

bool has_elastic_links(const MechanismDefinition& definition) {
  return std::ranges::any_of(definition.bodies, [](const BodyDefinition& body) {
    return body.compliance.has_value();
  });
}

double range_of(const MechanismDefinition& definition,
                const std::vector<int>& loaded, std::size_t joint) {
  const JointDefinition& of = definition.joints[joint];
  if (is_loaded_elsewhere(loaded, of)) return kUnknownCompliance;
  if (of.compliance) return kGivenCompliance;
  return has_elastic_links(definition) ? kBesideElasticLinks
                                       : kUnknownCompliance;
}

std::vector<Coordinate> open_coordinates(const MechanismDefinition& definition,
                                         const std::vector<int>& loaded,
                                         const Motion& motion, double length) {
  std::vector<Coordinate> coordinates;
  const auto beside = reactions_beside(definition.joints, motion, length);
  for (std::size_t j = 0; j < definition.joints.size(); ++j) {
    const double force = kNegligibleReaction * beside[j];
    for (const bool is_moment : {false, true}) {
      const std::size_t first = is_moment ? 3 : 0;
      const double negligible = is_moment ? force * length : force;
      if (is_open(motion, j, first, negligible) ||
          is_open(motion, j, first + 1, negligible) ||
          is_open(motion, j, first + 2, negligible)) {
        coordinates.push_back({j, is_moment, range_of(definition, loaded, j)});
      }
    }
  }
  return coordinates;
}

/// All corners of `count` coordinates.
std::vector<Corner> all_corners(std::size_t count) {
  std::vector<Corner> corners;
  for (std::size_t bits = 0; bits < (std::size_t{1} << count); ++bits) {
    Corner& corner = corners.emplace_back(count);
    for (std::size_t i = 0; i < count; ++i) corner[i] = (bits >> i & 1U) != 0;
  }
  return corners;
}

/// Each coordinate against the rest, each joint, and of not too many joints
/// each two and three: those that hold a body alone, where the rest gives way.
std::vector<Corner> some_corners(const std::vector<Coordinate>& coordinates) {
  constexpr std::size_t kMostOfTwo = 10, kMostOfThree = 6;  // joints
  std::vector<Corner> corners;
  const auto add = [&](auto is_apart) {
    for (const bool soft : {false, true}) {
      Corner& corner = corners.emplace_back(coordinates.size());
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        corner[i] = is_apart(i) == soft;
      }
    }
  };
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    add([&](std::size_t k) {
      return k == i;
    });
    const std::size_t joint = coordinates[i].joint;
    if (i > 0 && coordinates[i - 1].joint == joint) {
      add([&](std::size_t k) {
        return coordinates[k].joint == joint;
      });
    }
  }
  std::vector<std::size_t> joints;
  for (const Coordinate& coordinate : coordinates) {
    if (joints.empty() || joints.back() != coordinate.joint) {
      joints.push_back(coordinate.joint);
    }
  }
  if (joints.size() > kMostOfTwo) return corners;
  for (std::size_t a = 0; a < joints.size(); ++a) {
    for (std::size_t b = a + 1; b < joints.size(); ++b) {
      add([&](std::size_t k) {
        return coordinates[k].joint == joints[a] ||
               coordinates[k].joint == joints[b];
      });
      if (joints.size() > kMostOfThree) continue;
      for (std::size_t c = b + 1; c < joints.size(); ++c) {
        add([&](std::size_t k) {
          return coordinates[k].joint == joints[a] ||
                 coordinates[k].joint == joints[b] ||
                 coordinates[k].joint == joints[c];
        });
      }
    }
  }
  return corners;
}

/// Compliances of all joints in the same ratio share as before.
bool changes_nothing(const std::vector<Coordinate>& coordinates,
                     const Corner& corner, bool has_links) {
  if (has_links) return false;
  return std::ranges::all_of(coordinates, [&](const Coordinate& coordinate) {
    const auto i = static_cast<std::size_t>(&coordinate - coordinates.data());
    return corner[i] == corner[0] && coordinate.factor == coordinates[0].factor;
  });
}

/// Solves the reactions of a motion's instants anew.
struct Sharer {
  explicit Sharer(MechanismDefinition given)
      : definition(std::move(given)),
        frame(definition),
        system(frame, definition.drives,
               frame.planar ? Motions::kInPlane : Motions::kSpatial,
               ConstraintSystem::Drives::kAll),
        equilibrium(definition, frame, system) {}
  Sharer(const Sharer&) = delete;
  Sharer& operator=(const Sharer&) = delete;

  Configuration configuration(const Instant& instant) const {
    Configuration x = frame.placement;
    for (std::size_t i = 0; i < instant.bodies.size(); ++i) {
      const Pose& pose = instant.bodies[i].pose;
      BodyPlacement& body = x[i + 1];
      body.R = frame.R_WP.transpose() * pose.R_WL;
      body.q = Eigen::Quaterniond(body.R);
      body.p = frame.R_WP.transpose() * (pose.p_WL + pose.R_WL * frame.p_LM[i]);
    }
    return x;
  }

  /// Velocities and accelerations of the points M, by slot.
  std::array<std::vector<Twist>, 2> rates(const Instant& instant) const {
    std::array<std::vector<Twist>, 2> result;
    result[0].resize(instant.bodies.size() + 1);
    result[1] = result[0];
    const auto R_PW = frame.R_WP.transpose();
    for (std::size_t i = 0; i < instant.bodies.size(); ++i) {
      const BodyState& body = instant.bodies[i];
      const Vector3d arm = body.pose.R_WL * frame.p_LM[i];
      result[0][i + 1] = {R_PW * (body.v_WLo + body.w_WL.cross(arm)),
                          R_PW * body.w_WL};
      result[1][i + 1] = {R_PW * (body.a_WLo + body.alpha_WL.cross(arm) +
                                  body.w_WL.cross(body.w_WL.cross(arm))),
                          R_PW * body.alpha_WL};
    }
    return result;
  }

  /// Wrenches of force elements about the points M, by slot.
  std::vector<SpatialForce> applied(const Instant& instant,
                                    const Configuration& x) const {
    std::vector<Twist> result(x.size());
    const auto R_PW = frame.R_WP.transpose();
    for (const ElementState& element : instant.elements) {
      for (const ElementAction& action : element.actions) {
        if (action.body == kGround) continue;
        const auto slot = index(action.body) + 1;
        const Vector3d f = R_PW * action.f_W;
        result[slot].v += f;
        result[slot].w +=
            R_PW * action.t_W + (R_PW * action.p_W - x[slot].p).cross(f);
      }
    }
    return result;
  }

  /// Components along axes of the solving frame.
  Motion shared(const Motion& motion) const {
    Motion result = motion;
    for (Instant& instant : result.instants) {
      const Configuration x = configuration(instant);
      const auto placed = system.place(x);
      numerics::JacobianFactor factor;
      factor.compute(system.jacobian(placed), nullptr, frame.rank_threshold());
      const auto [twists, accelerations] = rates(instant);
      put_forces(frame, system, placed,
                 equilibrium.solve(x, placed, factor, twists, accelerations,
                                   applied(instant, x), instant.elements),
                 instant);
    }
    return result;
  }

  MechanismDefinition definition;
  SolvingFrame frame;
  ConstraintSystem system;
  Equilibrium equilibrium;
};

}  // namespace

struct OtherSharings::Solver : Sharer {
  static constexpr std::size_t kMostCoordinates = 6;  // 64 corners

  Solver(const MechanismDefinition& given, const Motion& motion_of)
      : Solver(unshared_strains(given, motion_of, SolvingFrame(given).length)
                   .loaded,
               given, motion_of) {}

  Solver(const std::vector<int>& loaded, const MechanismDefinition& given,
         const Motion& motion_of)
      : Sharer(without_links(loaded, given)),
        motion(motion_of),
        coordinates(open_coordinates(given, loaded, motion, frame.length)) {
    corners = coordinates.size() <= kMostCoordinates
                  ? all_corners(coordinates.size())
                  : some_corners(coordinates);
    std::erase_if(corners, [&](const Corner& corner) {
      return corner.empty() ||
             changes_nothing(coordinates, corner, has_elastic_links(given));
    });
    for (const Coordinate& coordinate : coordinates) {
      const JointDefinition& joint = definition.joints[coordinate.joint];
      leaves_forces_out |= is_loaded_elsewhere(loaded, joint);
      auto& names = joint.compliance ? given_names : unknown_names;
      if (names.empty() || names.back() != joint.name) {
        names.push_back(joint.name);
      }
    }
    for (const JointModel& joint : frame.joints) {
      compliances.push_back(joint.compliance);
    }
  }

  void set(const Corner& corner) {
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const Coordinate& c = coordinates[i];
      const double factor = corner[i] ? c.factor : 1.0 / c.factor;
      Vector6& compliance = frame.joints[c.joint].compliance;
      const Vector6& before = compliances[c.joint];
      if (c.is_moment) {
        compliance.tail<3>() = factor * before.tail<3>();
      } else {
        compliance.head<3>() = factor * before.head<3>();
      }
    }
  }

  Motion shared(const Corner& corner) {
    set(corner);
    return Sharer::shared(motion);
  }

  const Motion& motion;
  std::vector<Coordinate> coordinates;
  std::vector<Corner> corners;
  std::vector<Vector6> compliances;
  std::vector<std::string> unknown_names, given_names;
  bool leaves_forces_out = false;
};

OtherSharings::OtherSharings(const MechanismDefinition& definition,
                             const Motion& motion)
    : solver_(std::make_unique<Solver>(definition, motion)) {}
OtherSharings::~OtherSharings() = default;
OtherSharings::OtherSharings(OtherSharings&&) noexcept = default;
OtherSharings& OtherSharings::operator=(OtherSharings&&) noexcept = default;

std::size_t OtherSharings::size() const {
  return solver_->corners.size();
}

Motion OtherSharings::motion(std::size_t index) const {
  return solver_->shared(solver_->corners[index]);
}

bool OtherSharings::is_complete() const {
  return solver_->coordinates.size() <= Solver::kMostCoordinates;
}

const std::vector<std::string>& OtherSharings::unknown() const {
  return solver_->unknown_names;
}

const std::vector<std::string>& OtherSharings::given() const {
  return solver_->given_names;
}

bool OtherSharings::leaves_forces_out() const {
  return solver_->leaves_forces_out;
}

Motion shared_anew(const MechanismDefinition& definition,
                   const Motion& motion) {
  return Sharer(definition).shared(motion);
}

void forget_negligible(const std::vector<JointDefinition>& joints,
                       double length, Motion& motion) {
  if (motion.instants.empty()) return;
  const auto beside = reactions_beside(joints, motion, length);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double force = kNegligibleReaction * beside[j];
    bool matters = false;
    for (std::size_t k = 0; k < 6; ++k) {
      matters |= is_open(motion, j, k, k < 3 ? force : force * length);
    }
    if (matters) continue;
    for (auto* instants : {&motion.instants, &motion.repeats}) {
      for (Instant& instant : *instants) {
        instant.joints[j].unique = true;
        instant.joints[j].unique_components.fill(true);
      }
    }
  }
}

}  // namespace clevis::mechanism
