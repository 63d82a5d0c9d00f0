#include "elasticity/multigrid/block_cg.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace clevis::elasticity {
namespace {

constexpr int kHalf = lanes::kLanes<double>;

template <typename Real>
void set_zero(LaneVector<Real>& v) {
  std::fill_n(v.data(),
              static_cast<std::size_t>(v.nodes()) * lanes::kNode<Real>, Real{});
}

}  // namespace

BlockCg::BlockCg(const MatrixFreeOperator<double>& stiffness,
                 PMultigrid& preconditioner, const NodeTable& nodes,
                 ThreadTeam& team)
    : stiffness_(stiffness),
      preconditioner_(preconditioner),
      nodes_(nodes),
      team_(team),
      x_{LaneVector<double>(nodes.nodes), LaneVector<double>(nodes.nodes)},
      r_{LaneVector<double>(nodes.nodes), LaneVector<double>(nodes.nodes)},
      p_{LaneVector<double>(nodes.nodes), LaneVector<double>(nodes.nodes)},
      kp_{LaneVector<double>(nodes.nodes), LaneVector<double>(nodes.nodes)},
      rounded_(nodes.nodes),
      z_(nodes.nodes),
      residual_(Lanes::Zero()) {}

/// One vector operation on a block; sums in the order of the parts.
void BlockCg::run(Step step, int block, const Lanes& factor, Lanes& first,
                  Lanes& second) {
  const auto b = static_cast<std::size_t>(block);
  const auto parts = static_cast<int>(nodes_.part_start.size()) - 1;
  struct alignas(64) Sums {
    double value[2 * kHalf]{};
  };
  std::vector<Sums> sums(static_cast<std::size_t>(parts));
  Sums factors;
  std::copy_n(factor.data() + kHalf * block, kHalf, factors.value);
  LaneVector<float>& single = step == Step::kAdvance ? rounded_ : z_;
  team_.run(parts, [&](int part) {
    const auto at = static_cast<std::size_t>(part);
    lanes::CgArguments a;
    a.begin = nodes_.part_start[at];
    a.end = nodes_.part_start[at + 1];
    a.factor = factors.value;
    a.p = p_[b].data();
    a.kp = kp_[b].data();
    a.x = x_[b].data();
    a.r = r_[b].data();
    a.z = single.data() + kHalf * block;
    a.sum = sums[at].value;
    const auto& kernels = lane_kernels();
    switch (step) {
      case Step::kProduct:
        return kernels.product(a);
      case Step::kAdvance:
        return kernels.advance(a);
      case Step::kProducts:
        return kernels.products(a);
      case Step::kDirection:
        return kernels.direction(a);
    }
  });
  first.segment<kHalf>(kHalf * block).setZero();
  second.segment<kHalf>(kHalf * block).setZero();
  for (const Sums& sum : sums) {
    for (int lane = 0; lane < kHalf; ++lane) {
      first[kHalf * block + lane] += sum.value[lane];
      second[kHalf * block + lane] += sum.value[kHalf + lane];
    }
  }
}

/// From the residual in r_ on.
int BlockCg::iterate(int blocks, double tolerance, int max_iterations) {
  Lanes norm = Lanes::Zero();
  Lanes unused = Lanes::Zero();
  Lanes rz = Lanes::Ones();
  Lanes alpha = Lanes::Zero();
  for (int b = 0; b < blocks; ++b) {
    set_zero(p_[std::size_t(b)]);
    set_zero(kp_[std::size_t(b)]);
    run(Step::kAdvance, b, alpha, norm, unused);  // rounds r, takes its norm
  }
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const auto active = (norm > tolerance * tolerance).eval();
    if (!active.any()) return iteration;
    preconditioner_.apply(rounded_, z_);
    Lanes with_r = Lanes::Zero();
    Lanes with_kp = Lanes::Zero();
    for (int b = 0; b < blocks; ++b) {
      run(Step::kProducts, b, alpha, with_r, with_kp);
    }
    // z · (r − r_before) = −α z · K p of the last step.
    const Lanes beta = (-alpha * with_kp / rz).max(0.0);
    rz = active.select(with_r, 1.0);
    Lanes energy = Lanes::Zero();
    for (int b = 0; b < blocks; ++b) {
      const auto at = std::size_t(b);
      run(Step::kDirection, b, beta, unused, unused);
      stiffness_.apply(p_[at], kp_[at]);
      run(Step::kProduct, b, beta, energy, unused);
    }
    alpha = (active && energy > 0.0).select(with_r / energy, 0.0);
    for (int b = 0; b < blocks; ++b) {
      run(Step::kAdvance, b, alpha, norm, unused);
    }
  }
  return max_iterations;
}

int BlockCg::solve(const Vectors& loads, int blocks, double tolerance,
                   int max_iterations) {
  const auto values =
      static_cast<std::size_t>(nodes_.nodes) * lanes::kNode<double>;
  for (int b = 0; b < blocks; ++b) {
    const auto at = std::size_t(b);
    set_zero(x_[at]);
    std::copy_n(loads[at].data(), values, r_[at].data());
  }
  if (blocks == 1) set_zero(rounded_);
  int iterations = 0;
  double before = 2.0;
  for (;;) {
    iterations += iterate(blocks, 0.9 * tolerance, max_iterations - iterations);
    residual_.setZero();
    for (int b = 0; b < blocks; ++b) {
      const auto at = std::size_t(b);
      stiffness_.apply(x_[at], kp_[at]);
      for (std::size_t i = 0; i < values; ++i) {
        r_[at].data()[i] = loads[at].data()[i] - kp_[at].data()[i];
      }
      // With α = 0 the products of r with itself.
      Lanes sum = Lanes::Zero();
      Lanes unused;
      run(Step::kAdvance, b, Lanes::Zero(), sum, unused);
      residual_.segment<kHalf>(kHalf * b) =
          sum.segment<kHalf>(kHalf * b).sqrt();
    }
    const double largest = residual_.maxCoeff();
    // Restarted, it refines what the recurrence lost to rounding.
    if (!(largest > tolerance) || !(largest < 0.5 * before) ||
        iterations >= max_iterations) {
      return iterations;
    }
    before = largest;
  }
}

}  // namespace clevis::elasticity
