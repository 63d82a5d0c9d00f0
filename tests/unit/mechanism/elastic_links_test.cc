// Reactions that equilibrium leaves open, shared by links that give way.
// Source: docs/theory.md, "Reactions".
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/bennett.h"

namespace clevis::mechanism {
namespace {

using namespace testing;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

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
