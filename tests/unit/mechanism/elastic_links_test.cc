// Reactions that equilibrium leaves open, shared by links that give way.
// Source: docs/theory.md, "Reactions".
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/bennett.h"

namespace clevis::mechanism {
namespace {

using namespace testing;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Eigen::Matrix3d cross_matrix(const Vector3d& p) {
  Eigen::Matrix3d S;
  S << 0.0, -p.z(), p.y(), p.z(), 0.0, -p.x(), -p.y(), p.x(), 0.0;
  return S;
}

/// Joints of a body, at the joints themselves.
LinkCompliance at_joints(const MechanismDefinition& m, int body) {
  LinkCompliance link;
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    const JointDefinition& joint = m.joints[j];
    if (joint.body_a != body && joint.body_b != body) continue;
    link.joints.push_back(static_cast<int>(j));
    link.points.push_back(
        (joint.body_b == body ? joint.frame_b : joint.frame_a).p_LJ);
  }
  const auto n = static_cast<Index>(6 * link.joints.size());
  link.matrix = MatrixXd::Zero(n, n);
  return link;
}

/// A link whose points give way together, without symmetry.
LinkCompliance some_link(const MechanismDefinition& m, int body) {
  LinkCompliance link = at_joints(m, body);
  const Index n = link.matrix.rows();
  MatrixXd A(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < n; ++k) {
      A(i, k) = std::sin(1.0 + 3.7 * static_cast<double>(i) +
                         1.3 * static_cast<double>(k * k)) *
                1e-4;
    }
  }
  link.matrix = A.transpose() * A;
  return link;
}

MechanismDefinition elastic_bennett() {
  MechanismDefinition m = bennett({}, 1.2);
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    m.bodies[b].compliance = some_link(m, static_cast<int>(b));
  }
  return m;
}

/// Largest change of a reaction over the largest force, over a motion.
double difference(const MechanismDefinition& a, const MechanismDefinition& b) {
  const SimulationSettings settings{.duration = 1.0, .instants = 7};
  const Motion p = simulate(a, settings), q = simulate(b, settings);
  double worst = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < p.instants.size(); ++i) {
    for (std::size_t j = 0; j < a.joints.size(); ++j) {
      const auto w = p.instants[i].joints[j].components();
      worst =
          std::max(worst, (w - q.instants[i].joints[j].components()).norm());
      largest = std::max(largest, w.norm());
    }
  }
  return worst / largest;
}

// Where only the links give way, each at its pins as much as the joints did,
// the shares are the same.
TEST(ElasticLinks, TakeTheJointsPlace) {
  MechanismDefinition joints = bennett({}, 1.2), links = joints;
  constexpr double kRigid = 1e-9;  // of what the links give
  std::vector<bool> taken(joints.joints.size(), false);
  const auto give = [&](std::size_t j, double factor) {
    const double c = 1e-9 * (1.0 + static_cast<double>(j)) * factor;
    return JointCompliance{Vector3d::Constant(c), Vector3d::Constant(5.0 * c)};
  };
  for (std::size_t b = 0; b < links.bodies.size(); ++b) {
    LinkCompliance link = at_joints(links, static_cast<int>(b));
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const auto j = static_cast<std::size_t>(link.joints[k]);
      if (taken[j]) continue;
      taken[j] = true;
      const auto c = give(j, 1.0);
      link.matrix.diagonal().segment<6>(6 * static_cast<Index>(k)) << c.force,
          c.moment;
    }
    links.bodies[b].compliance = link;
  }
  for (std::size_t j = 0; j < joints.joints.size(); ++j) {
    joints.joints[j].compliance = give(j, 1.0);
    links.joints[j].compliance = give(j, kRigid);
    EXPECT_TRUE(taken[j]);
  }
  EXPECT_LT(difference(joints, links), 1e-7);
  EXPECT_GT(difference(bennett({}, 1.2), joints), 1e-2);
}

// A wrench is the same about any point.
TEST(ElasticLinks, PointsDoNotMatter) {
  const MechanismDefinition m = elastic_bennett();
  MechanismDefinition moved = m;
  for (BodyDefinition& body : moved.bodies) {
    LinkCompliance& link = *body.compliance;
    MatrixXd shift = MatrixXd::Identity(link.matrix.rows(), link.matrix.cols());
    for (std::size_t k = 0; k < link.points.size(); ++k) {
      const Vector3d by(0.03, -0.02 * static_cast<double>(k), 0.05);
      link.points[k] += by;
      // moment about the old point = about the new one + by × force
      shift.block<3, 3>(6 * static_cast<Index>(k) + 3,
                        6 * static_cast<Index>(k)) = cross_matrix(by);
    }
    link.matrix = shift.transpose() * link.matrix * shift;
  }
  EXPECT_LT(difference(m, moved), 1e-10);
  EXPECT_GT(difference(m, bennett({}, 1.2)), 1e-2);
}

// Equilibrium fixes the resultant on a link, so that what depends on the
// resultant alone shares nothing; the drive's effort counts in it.
TEST(ElasticLinks, RigidMotionOfALinkDoesNotMatter) {
  const MechanismDefinition m = elastic_bennett();
  MechanismDefinition more = m;
  for (BodyDefinition& body : more.bodies) {
    LinkCompliance& link = *body.compliance;
    MatrixXd resultant = MatrixXd::Zero(6, link.matrix.cols());
    for (std::size_t k = 0; k < link.points.size(); ++k) {
      const Index at = 6 * static_cast<Index>(k);
      resultant.block<6, 6>(0, at).setIdentity();
      resultant.block<3, 3>(3, at) = cross_matrix(link.points[k]);
    }
    link.matrix += 1e-9 * resultant.transpose() *
                   Eigen::Matrix<double, 6, 1>(1.0, 2.0, 3.0, 50.0, 60.0, 70.0)
                       .asDiagonal() *
                   resultant;
  }
  EXPECT_LT(difference(m, more), 1e-8);
}

/// A link on two hinges to the ground, skew to one another.
MechanismDefinition skew_link() {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kSpatial;
  BodyDefinition link;
  link.name = link.place = "link";
  link.mass_properties = {1.0, Vector3d::Zero(),
                          0.01 * Eigen::Matrix3d::Identity()};
  link.placement.R_WL =
      Eigen::AngleAxisd(0.4, Vector3d(1.0, 2.0, -1.0).normalized())
          .toRotationMatrix();
  link.placement.p_WL = {0.2, -0.1, 0.3};
  m.bodies = {link};
  for (const double x : {-0.1, 0.1}) {
    JointDefinition hinge;
    hinge.name = x < 0.0 ? "A" : "B";
    hinge.type = JointType::kRevolute;
    hinge.body_b = 0;
    hinge.frame_b.p_LJ = {x, 0.0, 0.0};
    hinge.frame_b.R_LJ =
        Eigen::AngleAxisd(5.0 * x, Vector3d::UnitX()).toRotationMatrix();
    hinge.frame_a.p_LJ =
        link.placement.p_WL + link.placement.R_WL * hinge.frame_b.p_LJ;
    hinge.frame_a.R_LJ = link.placement.R_WL * hinge.frame_b.R_LJ;
    hinge.compliance =
        JointCompliance{Vector3d::Constant(1e-9), Vector3d::Constant(1e-7)};
    m.joints.push_back(hinge);
  }
  return m;
}

// A force on a link strains it as a joint there that carries the force: of the
// same link, a body welded to it on which the force acts.
TEST(ElasticLinks, ForcesStrainThemAsAJointWould) {
  const Vector3d at(0.03, 0.02, -0.01);  // in L
  ConstantForce force;
  force.name = "push";
  force.f_W = {300.0, -900.0, 500.0};
  MechanismDefinition by_joint = skew_link();
  BodyDefinition puck;
  puck.name = puck.place = "puck";
  puck.mass_properties = {1e-3, Vector3d::Zero(),
                          1e-9 * Eigen::Matrix3d::Identity()};
  const Pose& pose = by_joint.bodies[0].placement;
  puck.placement.R_WL = pose.R_WL;
  puck.placement.p_WL = pose.p_WL + pose.R_WL * at;
  by_joint.bodies.push_back(puck);
  JointDefinition weld;
  weld.name = "F";
  weld.type = JointType::kWeld;
  weld.body_a = 0;
  weld.body_b = 1;
  weld.frame_a.p_LJ = at;
  by_joint.joints.push_back(weld);
  by_joint.bodies[0].compliance = some_link(by_joint, 0);
  const LinkCompliance all = *by_joint.bodies[0].compliance;

  MechanismDefinition by_force = skew_link();
  LinkCompliance& link = by_force.bodies[0].compliance.emplace();
  link.joints = {0, 1};
  link.points = {all.points[0], all.points[1]};
  link.matrix = all.matrix.topLeftCorner(12, 12);
  const Vector3d point(-0.02, 0.05, 0.04);  // where its wrench is known about
  MatrixXd shift = MatrixXd::Identity(6, 6);
  shift.bottomLeftCorner<3, 3>() = cross_matrix(point - at);
  link.loads = {{0, point}};
  link.by_load = all.matrix.topRightCorner(12, 6) * shift;

  force.point = {1, Vector3d::Zero()};
  by_joint.elements = {force};
  force.point = {0, at};
  by_force.elements = {force};
  MechanismDefinition without = by_force;
  without.bodies[0].compliance->loads.clear();
  without.bodies[0].compliance->by_load.resize(0, 0);
  const auto reactions = [](const MechanismDefinition& m) {
    const Motion motion = simulate(m, {.duration = 1.0, .instants = 2});
    EXPECT_FALSE(motion.instants[1].joints[0].unique);
    VectorXd both(12);
    both << motion.instants[1].joints[0].components(),
        motion.instants[1].joints[1].components();
    return both;
  };
  const VectorXd wanted = reactions(by_joint);
  EXPECT_LT((reactions(by_force) - wanted).norm(), 1e-9 * wanted.norm());
  EXPECT_GT((reactions(without) - wanted).norm(), 1e-2 * wanted.norm());
}

// Doubling a link's compliance changes a reaction at most by its spread.
TEST(ElasticLinks, SpreadBoundsTheChangeToFirstOrder) {
  const MechanismDefinition m = elastic_bennett();
  const auto first = [](const MechanismDefinition& d) {
    return simulate(d, {.duration = 1.0, .instants = 2}).instants[0];
  };
  const Instant at = first(m);
  constexpr double h = 1e-4;
  std::array<Eigen::Matrix<double, 6, 1>, 4> sum;
  sum.fill(Eigen::Matrix<double, 6, 1>::Zero());
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    MechanismDefinition more = m, less = m;
    more.bodies[b].compliance->matrix *= std::exp(h);
    less.bodies[b].compliance->matrix *= std::exp(-h);
    const Instant p = first(more), q = first(less);
    for (std::size_t j = 0; j < 4; ++j) {
      sum[j] +=
          (p.joints[j].components() - q.joints[j].components()).cwiseAbs() *
          std::numbers::ln2 / (2.0 * h);
    }
  }
  for (std::size_t j = 0; j < 4; ++j) {
    for (Index k = 0; k < 6; ++k) {
      // the rest: the joints' own compliances, here below 1 % of the links'
      const double spread = at.joints[j].spread[static_cast<std::size_t>(k)];
      EXPECT_GE(spread, sum[j][k] * (1.0 - 1e-5) - 1e-9);
      EXPECT_LE(spread, 1.2 * sum[j][k] + 0.05 * sum[j].norm());
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
