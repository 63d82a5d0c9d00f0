#pragma once

/// Kernels of the matrix-free path with load columns in the SIMD lanes.
///
/// A vector is [node][component][lane]: kLanes columns side by side, one
/// 64-byte register per value. The kernels are compiled once per instruction
/// set (lane_kernels_*.cc) from one source and chosen at run time; this header
/// is plain data, so that no inline function of the library is compiled with
/// an instruction set that the machine may not have.
namespace clevis::elasticity::lanes {

template <typename Real>
inline constexpr int kLanes = 64 / static_cast<int>(sizeof(Real));

/// Values per node: three components.
template <typename Real>
inline constexpr int kNode = 3 * kLanes<Real>;

/// Numbers per quadrature point: J^-1 by rows (∂ξ_a/∂x_d at 3 a + d), then
/// det J times the weight.
inline constexpr int kMetric = 10;

/// y = K x over the cells [begin, end).
///
/// A node's first cell stores, later ones add: `scatter` holds ~place for the
/// first, place for the others. Places beyond the nodes are `ghost`, where a
/// part of the mesh keeps what belongs to nodes of an earlier part.
template <typename Real>
struct ApplyArguments {
  int begin{}, end{};
  const int* gather{};          ///< cells × N³, lexicographic
  const int* scatter{};         ///< likewise
  const Real* metric{};         ///< cells × Q³ × kMetric
  const Real* interpolation{};  ///< Q × N, nodes to points
  const Real* derivative{};     ///< Q × Q, of the points' own polynomials
  Real lambda{}, mu{};          ///< [Pa]
  const Real* x{};
  Real* y{};
  Real* ghost{};
  int nodes{};
};

/// Between the nodes of two degrees on the same cells, single precision. A
/// fine node belongs to the first cell of all that has it.
struct TransferArguments {
  int begin{}, end{};
  const int* fine_scatter{};
  const int* coarse_gather{};
  const int* coarse_scatter{};
  const float* interpolation{};  ///< N fine × M coarse
  const float* source{};
  float* target{};
  float* ghost{};  ///< of the coarse nodes, restriction only
  int fine_nodes{}, coarse_nodes{};
};

/// One step of a smoother at the nodes [begin, end): residual −= change, then
/// step = keep * step + gain * B residual and solution += step, where B holds
/// the upper triangle (xx, xy, xz, yy, yz, zz) of a 3 × 3 block per node.
struct SmoothArguments {
  int begin{}, end{};
  const float* blocks{};
  const float* change{};  ///< null: nothing
  float keep{}, gain{};   ///< keep = 0: the old step is not read
  bool fresh{};           ///< the old solution is zero and not read
  bool add_old{};         ///< the old step joins the solution (keep = 0)
  float* residual{};
  float* step{};
  float* solution{};
};

/// Steps of conjugate gradients at the nodes [begin, end), double, one column
/// a lane; `z` is the half of a single-precision vector that these lanes are
/// (kLanes<float> apart).
struct CgArguments {
  int begin{}, end{};
  const double* factor{};  ///< per lane
  double* p{};
  double* kp{};
  double* x{};
  double* r{};
  float* z{};
  double* sum{};  ///< 2 × lanes, added to
};

/// One instruction set's kernels.
struct Kernels {
  template <typename Real>
  using Apply = void (*)(const ApplyArguments<Real>&);
  using Transfer = void (*)(const TransferArguments&);
  using Cg = void (*)(const CgArguments&);
  /// By degree − 1 and points − degree − 1.
  Apply<double> apply_double[4][2]{};
  Apply<float> apply_float[4][2]{};
  Transfer prolong[4]{};      ///< to degree index + 1
  Transfer restrict_to[4]{};  ///< from degree index + 1: transposed prolong
  void (*subtract)(const SmoothArguments&){};  ///< the first half of a step
  void (*smooth)(const SmoothArguments&){};
  Cg product{};    ///< sum += p · kp
  Cg advance{};    ///< x += factor p, r −= factor kp; sum += r · r; z = r
  Cg products{};   ///< sum += z · r, then z · kp
  Cg direction{};  ///< p = z + factor p
};
/// The next degree of the hierarchy.
constexpr int coarser_degree(int degree) {
  return degree > 2 ? 2 : 1;
}

namespace avx512 {
void get(Kernels& kernels);
}
namespace avx2 {
void get(Kernels& kernels);
}
namespace plain {
void get(Kernels& kernels);
}

}  // namespace clevis::elasticity::lanes
