#pragma once

#include <cstddef>
#include <memory>
#include <new>

#include "elasticity/lanes/lane_kernels.h"

namespace clevis::elasticity {

/// kLanes displacement columns side by side: [node][component][lane], aligned
/// for the kernels. Fresh values are not set.
template <typename Real>
class LaneVector {
 public:
  static constexpr int kLanes = lanes::kLanes<Real>;

  explicit LaneVector(int nodes)
      : nodes_(nodes),
        data_(static_cast<Real*>(::operator new[](
            sizeof(Real) * lanes::kNode<Real> *
                static_cast<std::size_t>(nodes > 0 ? nodes : 1),
            kAlignment))) {}

  int nodes() const { return nodes_; }
  Real* data() { return data_.get(); }
  const Real* data() const { return data_.get(); }
  /// The lanes of one component at a node.
  Real* at(int node, int component) { return data() + offset(node, component); }
  const Real* at(int node, int component) const {
    return data() + offset(node, component);
  }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Free {
    void operator()(Real* data) const { ::operator delete[](data, kAlignment); }
  };
  static std::ptrdiff_t offset(int node, int component) {
    return static_cast<std::ptrdiff_t>(node) * lanes::kNode<Real> +
           component * kLanes;
  }

  int nodes_;
  std::unique_ptr<Real[], Free> data_;
};

}  // namespace clevis::elasticity
