#include "app/processes/displacement_match.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Cholesky>

#include "assessment/job/model_traits.h"
#include "base/messages/errors.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/solid/solid_solve.h"
#include "mesh/cells/topology.h"
#include "stress/field/stress_history.h"

namespace clevis::app {
namespace {

using assessment::PartJob;

/// Points of clevis's field by position: the same point from two cells has
/// the same displacement.
class PointMap {
 public:
  explicit PointMap(double tolerance) : tolerance_(tolerance) {}

  void add(const Eigen::Vector3d& at, std::size_t cell, Eigen::Index point) {
    places_.try_emplace(key(at), cell, point);
  }
  /// Cell and point at a position; nullptr if there is none.
  const std::pair<std::size_t, Eigen::Index>* find(
      const Eigen::Vector3d& at) const {
    const Key here = key(at);
    for (int n = 0; n < 27; ++n) {  // a point may fall into the next bucket
      const auto found = places_.find(
          {here[0] + n % 3 - 1, here[1] + n / 3 % 3 - 1, here[2] + n / 9 - 1});
      if (found != places_.end()) return &found->second;
    }
    return nullptr;
  }

 private:
  using Key = std::array<long, 3>;
  Key key(const Eigen::Vector3d& at) const {
    return {std::lround(at[0] / tolerance_), std::lround(at[1] / tolerance_),
            std::lround(at[2] / tolerance_)};
  }
  double tolerance_;
  std::map<Key, std::pair<std::size_t, Eigen::Index>> places_;
};

/// Displacements without the rigid motion that fits them best.
Eigen::VectorXd deformation(const Eigen::MatrixXd& modes,
                            const Eigen::VectorXd& displacement) {
  const Eigen::VectorXd rigid = (modes.transpose() * modes)
                                    .ldlt()
                                    .solve(modes.transpose() * displacement);
  return displacement - modes * rigid;
}

double largest_norm(const Eigen::VectorXd& displacement) {
  return displacement.reshaped(3, displacement.size() / 3)
      .colwise()
      .norm()
      .maxCoeff();
}

/// clevis's displacements at the nodes of a deck, which are lattice points of
/// its cells: 3 × nodes.
Eigen::VectorXd at_nodes(const stress::InstantField& field,
                         const Eigen::Matrix3Xd& nodes, double size) {
  constexpr double kTolerance = 1e-6;
  PointMap points(kTolerance * size);
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index p = 0; p < field.points[c].rows(); ++p) {
      points.add(field.points[c].row(p).transpose(), c, p);
    }
  }
  Eigen::VectorXd result(3 * nodes.cols());
  for (Eigen::Index n = 0; n < nodes.cols(); ++n) {
    const auto* place = points.find(nodes.col(n));
    if (place == nullptr) {
      throw Error("X001", "CalculiX's deck",
                  "one of its nodes is no point of the mesh",
                  "Please report this scene.");
    }
    result.segment<3>(3 * n) =
        field.displacement[place->first].row(place->second).transpose();
  }
  return result;
}

}  // namespace

double displacement_difference(const PartJob& job,
                               const loads::LoadHistory& history,
                               const calculix::Model& model, int split,
                               const std::vector<calculix::StepResult>& steps) {
  const auto& set = job.load_sets.front();
  // Tetrahedra in the space of C3D10: nothing but digits may differ.
  const int degree =
      job.mesh.shape == mesh::CellShape::kTensor
          ? assessment::traits_of(assessment::ModelKind::kSolid).highest_degree
          : 2;
  const auto basis = elasticity::solve<3>(
      {job.mesh, job.part.material, history, set.fixed, job.part.name}, degree);
  const double size = mesh::size_of(job.mesh);
  const Eigen::MatrixXd modes = elasticity::rigid_modes<3>(
      model.nodes, model.nodes.rowwise().mean(), size);
  double difference = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // Elements have nodes at half of their edges.
    const auto field = stress::instant_field<3>(basis, job.part.material,
                                                2 * split, static_cast<int>(i));
    Eigen::VectorXd ours = at_nodes(field, model.nodes, size);
    Eigen::VectorXd theirs = steps[i].displacement.reshaped();
    if (set.fixed.empty()) {
      ours = deformation(modes, ours);
      theirs = deformation(modes, theirs);
    }
    difference = std::max(difference, largest_norm(ours - theirs));
    scale = std::max(scale, largest_norm(ours));
  }
  return scale > 0.0 ? difference / scale : 0.0;
}

}  // namespace clevis::app
