#include "elasticity/buckling/reduced_basis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <Eigen/Cholesky>

#include "base/algebra/append_columns.h"
#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ReducedBasis::ReducedBasis(const MatrixXd& sources)
    : vectors_(sources.rows(), 0), kept_(sources.rows(), 0) {
  sources_ = keep(sources);
}

ReducedBasis::Places ReducedBasis::keep(const MatrixXd& columns) {
  const Index before = kept_.cols(), n = columns.cols();
  kept_.conservativeResize(Eigen::NoChange, before + n);
  kept_.rightCols(n) = columns;
  gram_.conservativeResize(before + n, before + n);
  gram_.rightCols(n) = transposed_product(kept_, columns);
  gram_.bottomRows(n) = gram_.rightCols(n).transpose().eval();
  Places places(static_cast<std::size_t>(n));
  std::iota(places.begin(), places.end(), before);
  return places;
}

bool ReducedBasis::has_room(Index columns) const {
  constexpr double kMostBytes = 512e6;
  return 8.0 * static_cast<double>(equations()) *
             static_cast<double>(kept_.cols() + columns) <=
         kMostBytes;
}

void ReducedBasis::clear() {
  const Index sources = std::ssize(sources_);
  kept_.conservativeResize(Eigen::NoChange, sources);
  gram_.conservativeResize(sources, sources);
  vectors_.resize(Eigen::NoChange, 0);
  own_.clear();
  for (Places& places : terms_) places.clear();
}

MatrixXd ReducedBasis::beside(const MatrixXd& columns) const {
  constexpr double kDependent = 1e-6;
  const auto each = static_cast<Index>(1 + terms());  // with its images
  MatrixXd found(columns.rows(), columns.cols());
  Index n = 0;
  for (Index i = 0; i < columns.cols() && has_room(each * (n + 1)); ++i) {
    VectorXd column = columns.col(i);
    for (int pass = 0; pass < 2; ++pass) {
      column -= vectors_ * (vectors_.transpose() * column);
      column -= found.leftCols(n) * (found.leftCols(n).transpose() * column);
    }
    if (column.norm() <= kDependent * columns.col(i).norm()) continue;
    found.col(n++) = column.normalized();
  }
  return found.leftCols(n);
}

void ReducedBasis::append(const MatrixXd& vectors,
                          const std::vector<MatrixXd>& images) {
  const auto join = [](Places& places, const Places& more) {
    places.insert(places.end(), more.begin(), more.end());
  };
  join(own_, keep(vectors));
  for (std::size_t k = 0; k < images.size(); ++k) {
    join(terms_[k], keep(images[k]));
  }
  append_columns(vectors, vectors_);
}

void ReducedBasis::append_term(const MatrixXd& image) {
  terms_.push_back(keep(image));
}

ReducedBasis::Solution ReducedBasis::solve(const Action& action,
                                           const VectorXd& b) const {
  constexpr double kNothing = 1e-8;
  MatrixXd projected = gram_(own_, sources_) * action.drawn;
  for (std::size_t k = 0; k < terms(); ++k) {
    projected += action.terms[static_cast<Index>(k)] * gram_(own_, terms_[k]);
  }
  const Eigen::LLT<MatrixXd> factor(MatrixXd::Identity(size(), size()) -
                                    0.5 * (projected + projected.transpose()));
  Solution solution;
  if (factor.info() != Eigen::Success) return solution;
  solution.is_stable = true;
  const VectorXd in_basis = vectors_.transpose() * b;
  solution.amounts = factor.solve(in_basis);
  const VectorXd beside = b - vectors_ * in_basis;
  if (beside.norm() > kNothing * b.norm()) {
    solution.residual = residual(action, b, solution.amounts).norm();
    return solution;
  }
  const VectorXd kept = kept_amounts(action, in_basis, solution.amounts);
  solution.residual = std::sqrt(std::max(0.0, kept.dot(gram_ * kept)));
  return solution;
}

VectorXd ReducedBasis::kept_amounts(const Action& action, const VectorXd& rest,
                                    const VectorXd& amounts) const {
  VectorXd kept = VectorXd::Zero(kept_.cols());
  kept(own_) = rest - amounts;
  kept(sources_) = action.drawn * amounts;
  for (std::size_t k = 0; k < terms(); ++k) {
    kept(terms_[k]) = action.terms[static_cast<Index>(k)] * amounts;
  }
  return kept;
}

VectorXd ReducedBasis::residual(const Action& action, const VectorXd& b,
                                const VectorXd& amounts) const {
  return b + kept_ * kept_amounts(action, VectorXd::Zero(size()), amounts);
}

}  // namespace clevis::elasticity
