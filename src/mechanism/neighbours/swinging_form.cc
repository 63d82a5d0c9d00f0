#include "mechanism/neighbours/swinging_form.h"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "base/algebra/append_columns.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd none(Index rows) {
  return MatrixXd(rows, 0);
}

/// A light body between a spring and the damper behind it. So light that it is
/// overdamped at any frequency: at its own by 30 [kg].
double mass_between(const ElementSpring& spring) {
  constexpr double kOverdamped = 30.0;
  const double stiffness = spring.stiffness(0, 0);
  const double decay = spring.damping(0, 0) / stiffness;  // [s]
  return stiffness * decay * decay / (kOverdamped * kOverdamped);
}

}  // namespace

SwingingForm::SwingingForm(const Neighbours& neighbours,
                           const NeighbourRows& rows, const MatrixXd& wrenches)
    : wrenches_(wrenches.rows()) {
  constexpr double kLight = 1e-6;  // of the heaviest: a body of no inertia
  MatrixXd mass = rows.free.transpose() * neighbours.masses(rows.x) * rows.free;
  const double heaviest = mass.size() > 0 ? mass.diagonal().maxCoeff() : 0.0;
  mass.diagonal().array() += heaviest > 0.0 ? kLight * heaviest : 1.0;
  const Eigen::LLT<MatrixXd> root(mass);
  motions_ = root.matrixL().solve(rows.free.transpose()).transpose();
  found_ = {.held = wrenches,
            .followed = (rows.there * motions_).transpose(),
            .sprung = none(wrenches_),
            .damped = none(wrenches_),
            .sprung_there = none(motions_.cols()),
            .damped_there = none(motions_.cols())};
}

void SwingingForm::add(double inertia, const ElementDirections& along) {
  const Index own = add_motion();
  append_columns(along.body, found_.held);
  append_columns(there(along.neighbours), found_.followed);
  found_.followed(own, found_.followed.cols() - 1) -= 1.0 / std::sqrt(inertia);
}

void SwingingForm::add(const ElementSpring& spring,
                       const ElementDirections& along) {
  if (spring.relaxes) {
    add_relaxing(spring, along);
    return;
  }
  const MatrixXd stiffness = root_of(spring.stiffness);
  const MatrixXd damping = root_of(spring.damping);
  const MatrixXd beyond = there(along.neighbours);
  append_columns(along.body * stiffness, found_.sprung);
  append_columns(beyond * stiffness, found_.sprung_there);
  append_columns(along.body * damping, found_.damped);
  append_columns(beyond * damping, found_.damped_there);
}

SwingingNeighbours SwingingForm::take() {
  return std::move(found_);
}

Index SwingingForm::add_motion() {
  const Index own = found_.followed.rows();
  for (MatrixXd* rows :
       {&found_.followed, &found_.sprung_there, &found_.damped_there}) {
    rows->conservativeResize(own + 1, Eigen::NoChange);
    rows->bottomRows(1).setZero();
  }
  return own;
}

MatrixXd SwingingForm::there(const MatrixXd& of_neighbours) const {
  MatrixXd found = MatrixXd::Zero(found_.followed.rows(), of_neighbours.cols());
  found.topRows(motions_.cols()) = motions_.transpose() * of_neighbours;
  return found;
}

void SwingingForm::add_relaxing(const ElementSpring& spring,
                                const ElementDirections& along) {
  const Index own = add_motion();
  const double unit = 1.0 / std::sqrt(mass_between(spring));
  const double stiffness = std::sqrt(spring.stiffness(0, 0));
  const double damping = std::sqrt(spring.damping(0, 0));
  MatrixXd stretched = there(along.neighbours);
  stretched(own, 0) -= unit;
  MatrixXd moved = MatrixXd::Zero(stretched.rows(), 1);
  moved(own, 0) = unit;
  append_columns(stiffness * along.body, found_.sprung);
  append_columns(stiffness * stretched, found_.sprung_there);
  append_columns(MatrixXd::Zero(wrenches_, 1), found_.damped);
  append_columns(damping * moved, found_.damped_there);
}

}  // namespace clevis::mechanism
