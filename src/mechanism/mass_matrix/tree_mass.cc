#include "mechanism/mass_matrix/tree_mass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

// Of W Wᵀ of a joint's rows, as in NormalCholesky.
constexpr double kSafePivot = 1e-8;

inline double dot(const double* a, const double* b, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

/// Lower triangle of a, in place, with the inverse of its diagonal.
/// @return the smallest pivot over what stood there, or `scales`.
template <int kMost>
double cholesky(double (&a)[kMost][kMost], int n, const double* scales) {
  double smallest = 1.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      a[i][j] = (a[i][j] - dot(a[i], a[j], j)) * a[j][j];
    }
    const double pivot = a[i][i] - dot(a[i], a[i], i);
    const double ratio = pivot / scales[i];
    if (!(ratio > kSafePivot)) return 0.0;
    smallest = std::min(smallest, ratio);
    a[i][i] = 1.0 / std::sqrt(pivot);
  }
  return smallest;
}

/// x ← L⁻¹ x.
template <int kMost>
void solve_lower(const double (&L)[kMost][kMost], int n, double* x) {
  for (int i = 0; i < n; ++i) x[i] = (x[i] - dot(L[i], x, i)) * L[i][i];
}

/// x ← L⁻ᵀ x.
template <int kMost>
void solve_upper(const double (&L)[kMost][kMost], int n, double* x) {
  for (int i = n - 1; i >= 0; --i) {
    x[i] *= L[i][i];
    for (int j = 0; j < i; ++j) x[j] -= L[i][j] * x[i];
  }
}

/// To length 1.
template <int kWidth, typename Row>
void scale(Row& row) {
  const double square =
      dot(row.body, row.body, kWidth) + dot(row.parent, row.parent, kWidth);
  row.scale = square > 0.0 ? 1.0 / std::sqrt(square) : 1.0;
  for (int c = 0; c < kWidth; ++c) {
    row.body[c] *= row.scale;
    row.parent[c] *= row.scale;
  }
}

/// Whether every body hangs on one joint at most that leads to the ground;
/// puts the body behind each one before it.
bool order_outwards(const SolvingFrame& frame, std::vector<TreeLink>& links) {
  const std::size_t bodies = frame.placement.size() - 1;
  std::vector<bool> reached(bodies + 1, false), used(frame.joints.size());
  reached[0] = true;
  const auto grow = [&] {
    bool found = false;
    for (std::size_t j = 0; j < frame.joints.size(); ++j) {
      if (used[j]) continue;
      int a = frame.joints[j].a, b = frame.joints[j].b;
      if (reached[static_cast<std::size_t>(b)]) std::swap(a, b);
      if (!reached[static_cast<std::size_t>(a)]) continue;
      if (reached[static_cast<std::size_t>(b)]) return false;  // a loop
      reached[static_cast<std::size_t>(b)] = used[j] = found = true;
      links.push_back({b - 1, a - 1, static_cast<int>(j), {}});
    }
    return found;
  };
  while (links.size() < bodies) {
    while (grow()) {
    }
    if (std::ranges::find(reached, false) == reached.end()) break;
    const auto next = std::ranges::find(reached, false) - reached.begin();
    reached[static_cast<std::size_t>(next)] = true;  // hangs on nothing
    links.push_back({static_cast<int>(next) - 1, -1, -1, {}});
  }
  return links.size() == bodies &&
         std::ranges::count(used, true) == std::ssize(frame.joints);
}

}  // namespace

std::vector<TreeLink> tree_links(const SolvingFrame& frame,
                                 const std::vector<int>& joint_of_row) {
  std::vector<TreeLink> links;
  if (!frame.couplings.empty() || !order_outwards(frame, links)) {
    return {};
  }
  for (TreeLink& link : links) {
    for (std::size_t row = 0; row < joint_of_row.size(); ++row) {
      if (joint_of_row[row] != link.joint) continue;
      link.rows.push_back(static_cast<int>(row));
    }
    if (link.rows.size() > 6) return {};  // drives contradict the joint
  }
  std::ranges::reverse(links);
  return links;
}

TreeMass::TreeMass(std::vector<TreeLink> links, int width)
    : links_(std::move(links)),
      width_(width),
      work_(links_.size()),
      link_of_body_(links_.size()) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    rows_ += static_cast<int>(links_[k].rows.size());
    link_of_body_[index(links_[k].body)] = static_cast<int>(k);
  }
  rows_of_.resize(index(rows_));
  gap_.setZero(rows_);
  reaction_.setZero(rows_);
  change_.setZero(width * static_cast<Eigen::Index>(links_.size()));
}

bool TreeMass::factor() {
  return width_ == 3 ? factor_links<3>() : factor_links<6>();
}

template <int kWidth>
bool TreeMass::factor_links() {
  smallest_pivot_ = 1.0;
  for (Link& link : work_) link.is_free = true;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (!factor_link<kWidth>(k)) return false;
  }
  return true;
}

template <int kWidth>
bool TreeMass::factor_link(std::size_t k) {
  const std::vector<int>& rows = links_[k].rows;
  const int n = static_cast<int>(rows.size());
  Link& link = work_[k];
  if (!link.is_free) {
    double scales[kMost];
    for (int i = 0; i < kWidth; ++i) scales[i] = 1.0;  // M is, at least
    if (cholesky(link.inertia, kWidth, scales) == 0.0) return false;
  }
  double lengths[kMost];
  for (int i = 0; i < n; ++i) {
    Row& row = rows_of_[index(rows[index(i)])];
    scale<kWidth>(row);
    lengths[i] = 1.0;
    double* w = link.body[i];
    std::copy_n(row.body, kWidth, w);
    if (!link.is_free) solve_lower(link.inertia, kWidth, w);
    for (int j = 0; j <= i; ++j) {
      link.joint[i][j] = dot(w, link.body[j], kWidth);
    }
  }
  const double pivot = cholesky(link.joint, n, lengths);
  smallest_pivot_ = std::min(smallest_pivot_, pivot);
  if (pivot == 0.0) return false;
  if (links_[k].parent >= 0) add_to_parent<kWidth>(k);
  return true;
}

template <int kWidth>
void TreeMass::add_to_parent(std::size_t k) {
  const std::vector<int>& rows = links_[k].rows;
  const int n = static_cast<int>(rows.size());
  Link& link = work_[k];
  for (int i = 0; i < n; ++i) {
    double* v = link.parent[i];
    std::copy_n(rows_of_[index(rows[index(i)])].parent, kWidth, v);
    for (int j = 0; j < i; ++j) {
      const double factor = link.joint[i][j];
      for (int c = 0; c < kWidth; ++c) v[c] -= factor * link.parent[j][c];
    }
    for (int c = 0; c < kWidth; ++c) v[c] *= link.joint[i][i];
  }
  Link& parent = work_[index(link_of_body_[index(links_[k].parent)])];
  if (parent.is_free) {
    parent.is_free = false;
    for (int i = 0; i < kWidth; ++i) {
      for (int j = 0; j <= i; ++j) parent.inertia[i][j] = i == j ? 1.0 : 0.0;
    }
  }
  for (int r = 0; r < n; ++r) {
    const double* v = link.parent[r];
    for (int i = 0; i < kWidth; ++i) {
      for (int j = 0; j <= i; ++j) parent.inertia[i][j] += v[i] * v[j];
    }
  }
}

template <int kWidth>
void TreeMass::solve_links(const VectorXd& gamma, VectorXd& forces,
                           VectorXd& lambda) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const TreeLink& at = links_[k];
    const int n = static_cast<int>(at.rows.size());
    Link& link = work_[k];
    double* force = forces.data() + kWidth * at.body;
    if (!link.is_free) solve_lower(link.inertia, kWidth, force);
    for (int i = 0; i < n; ++i) {
      const int row = at.rows[index(i)];
      link.left[i] = rows_of_[index(row)].scale * gamma[row] -
                     dot(link.body[i], force, kWidth);
    }
    solve_lower(link.joint, n, link.left);
    if (at.parent < 0) continue;
    double* on_parent = forces.data() + kWidth * at.parent;
    for (int i = 0; i < n; ++i) {
      for (int c = 0; c < kWidth; ++c) {
        on_parent[c] += link.parent[i][c] * link.left[i];
      }
    }
  }
  for (std::size_t k = links_.size(); k-- > 0;) {
    const TreeLink& at = links_[k];
    const int n = static_cast<int>(at.rows.size());
    Link& link = work_[k];
    double* a = forces.data() + kWidth * at.body;
    if (at.parent >= 0) {
      const double* of_parent = forces.data() + kWidth * at.parent;
      for (int i = 0; i < n; ++i) {
        link.left[i] -= dot(link.parent[i], of_parent, kWidth);
      }
    }
    solve_upper(link.joint, n, link.left);
    for (int i = 0; i < n; ++i) {
      const int row = at.rows[index(i)];
      lambda[row] = rows_of_[index(row)].scale * link.left[i];
      for (int c = 0; c < kWidth; ++c) a[c] += link.body[i][c] * link.left[i];
    }
    if (!link.is_free) solve_upper(link.inertia, kWidth, a);
  }
}

void TreeMass::solve(const VectorXd& gamma, VectorXd& forces,
                     VectorXd& lambda) {
  if (width_ == 3) {
    solve_links<3>(gamma, forces, lambda);
  } else {
    solve_links<6>(gamma, forces, lambda);
  }
}

void TreeMass::refine(const VectorXd& gamma, VectorXd& a, VectorXd& lambda) {
  for (const TreeLink& at : links_) {
    for (const int i : at.rows) {
      const Row& row = rows_of_[index(i)];
      double moved = dot(row.body, a.data() + width_ * at.body, width_);
      if (at.parent >= 0) {
        moved += dot(row.parent, a.data() + width_ * at.parent, width_);
      }
      gap_[i] = gamma[i] - moved / row.scale;
    }
  }
  change_.setZero();
  solve(gap_, change_, reaction_);
  a.head(change_.size()) += change_;
  lambda.head(rows_) += reaction_;
}

}  // namespace clevis::mechanism
