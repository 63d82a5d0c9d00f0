// Included once per instruction set by lane_kernels_*.cc, which define
// CLEVIS_LANES, the namespace. No library headers: see lane_kernels.h.
#include "elasticity/lanes/lane_kernels.h"

namespace clevis::elasticity::lanes::CLEVIS_LANES {
namespace {

#define CLEVIS_INLINE inline __attribute__((always_inline))

template <typename Real>
struct Register;
template <>
struct Register<double> {
  typedef double type __attribute__((vector_size(64)));
};
template <>
struct Register<float> {
  typedef float type __attribute__((vector_size(64)));
};

/// out[r] = Σ_k matrix[r * row + k * column] in[k].
template <int Rows, int Columns, int row, int column, typename Real, typename V>
CLEVIS_INLINE void multiply(const Real* matrix, const V* in, V* out) {
#pragma GCC unroll 8
  for (int r = 0; r < Rows; ++r) {
    V sum = matrix[r * row] * in[0];
#pragma GCC unroll 8
    for (int k = 1; k < Columns; ++k) {
      sum += matrix[r * row + k * column] * in[k];
    }
    out[r] = sum;
  }
}

template <int Count, int stride, typename V>
CLEVIS_INLINE void load(const V* from, V* line) {
#pragma GCC unroll 8
  for (int k = 0; k < Count; ++k) line[k] = from[k * stride];
}

template <int Count, int stride, typename V>
CLEVIS_INLINE void store(const V* line, V* to) {
#pragma GCC unroll 8
  for (int k = 0; k < Count; ++k) to[k * stride] = line[k];
}

/// A tensor of Nz × Ny × Nx (z slowest) with direction `axis` contracted from
/// In to Out values; `before` and `after` are the sizes of the slower and
/// faster directions. matrix entry (out, in) at out * row + in * column.
template <int before, int In, int Out, int after, int row, int column,
          typename Real, typename V>
CLEVIS_INLINE void contract(const Real* matrix, const V* in, V* out) {
  for (int b = 0; b < before; ++b) {
    for (int a = 0; a < after; ++a) {
      V line[In];
      V result[Out];
      load<In, after>(in + b * In * after + a, line);
      multiply<Out, In, row, column>(matrix, line, result);
      store<Out, after>(result, out + b * Out * after + a);
    }
  }
}

/// Adds to a node that was written before, stores to one that was not.
template <typename V, typename Real>
CLEVIS_INLINE V* place(int code, int nodes, Real* y, Real* ghost) {
  const int at = code < 0 ? ~code : code;
  Real* base = at < nodes ? y + static_cast<long>(at) * kNode<Real>
                          : ghost + static_cast<long>(at - nodes) * kNode<Real>;
  return reinterpret_cast<V*>(base);
}

template <typename V, typename Real>
CLEVIS_INLINE const V* node(const Real* x, int at) {
  return reinterpret_cast<const V*>(x + static_cast<long>(at) * kNode<Real>);
}

/// Stress power at a quadrature point: g[3 c + a] = ∂u_c/∂ξ_a in, its dual
/// det(J) w Σ_d σ_cd ∂ξ_a/∂x_d out.
template <typename Real, typename V>
CLEVIS_INLINE void point_stress(const Real* m, Real lambda, Real mu, V* g) {
  V h[9];
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c) {
#pragma GCC unroll 3
    for (int d = 0; d < 3; ++d) {
      h[3 * c + d] =
          g[3 * c] * m[d] + g[3 * c + 1] * m[3 + d] + g[3 * c + 2] * m[6 + d];
    }
  }
  const Real l = lambda * m[9];
  const Real s = mu * m[9];
  const V pressure = l * (h[0] + h[4] + h[8]);
  const V xx = pressure + (2 * s) * h[0];
  const V yy = pressure + (2 * s) * h[4];
  const V zz = pressure + (2 * s) * h[8];
  const V xy = s * (h[1] + h[3]);
  const V xz = s * (h[2] + h[6]);
  const V yz = s * (h[5] + h[7]);
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) {
    const Real* t = m + 3 * a;
    g[a] = xx * t[0] + xy * t[1] + xz * t[2];
    g[3 + a] = xy * t[0] + yy * t[1] + yz * t[2];
    g[6 + a] = xz * t[0] + yz * t[1] + zz * t[2];
  }
}

template <typename Real, int N, int Q>
struct Cell {
  using V = typename Register<Real>::type;
  static constexpr int kPoints = Q * Q * Q;
  const ApplyArguments<Real>& a;
  // Values at the points, then the dual of in-plane gradients; derivatives
  // along z, then their dual.
  V values[3][kPoints];
  V along_z[3][kPoints];

  /// Nodes to points, x first; the lines along z also give ∂/∂z. Relative to
  /// the first node: a translation has no strain but costs digits.
  CLEVIS_INLINE void evaluate(const int* nodes) {
    for (int c = 0; c < 3; ++c) {
      const V origin = node<V>(a.x, nodes[0])[c];
      V by_x[N * N * Q];
      V by_xy[N * Q * Q];
      for (int line = 0; line < N * N; ++line) {
        V in[N];
#pragma GCC unroll 8
        for (int i = 0; i < N; ++i)
          in[i] = node<V>(a.x, nodes[line * N + i])[c] - origin;
        multiply<Q, N, N, 1>(a.interpolation, in, by_x + line * Q);
      }
      contract<N, N, Q, Q, N, 1>(a.interpolation, by_x, by_xy);
      for (int at = 0; at < Q * Q; ++at) {
        V in[N];
        V out[Q];
        V slope[Q];
        load<N, Q * Q>(by_xy + at, in);
        multiply<Q, N, N, 1>(a.interpolation, in, out);
        multiply<Q, Q, Q, 1>(a.derivative, out, slope);
        store<Q, Q * Q>(out, values[c] + at);
        store<Q, Q * Q>(slope, along_z[c] + at);
      }
    }
  }

  /// One plane of points: gradients, stress, duals.
  CLEVIS_INLINE void plane(int k, const Real* metric) {
    V by_x[3][Q * Q];
    V by_y[3][Q * Q];
    const int start = k * Q * Q;
    for (int c = 0; c < 3; ++c) {
      contract<Q, Q, Q, 1, Q, 1>(a.derivative, values[c] + start, by_x[c]);
      contract<1, Q, Q, Q, Q, 1>(a.derivative, values[c] + start, by_y[c]);
    }
    for (int at = 0; at < Q * Q; ++at) {
      V g[9];
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c) {
        g[3 * c] = by_x[c][at];
        g[3 * c + 1] = by_y[c][at];
        g[3 * c + 2] = along_z[c][start + at];
      }
      point_stress(metric + (start + at) * kMetric, a.lambda, a.mu, g);
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c) {
        by_x[c][at] = g[3 * c];
        by_y[c][at] = g[3 * c + 1];
        along_z[c][start + at] = g[3 * c + 2];
      }
    }
    for (int c = 0; c < 3; ++c) {
      V along_x[Q * Q];
      contract<Q, Q, Q, 1, 1, Q>(a.derivative, by_x[c], along_x);
      for (int i = 0; i < Q; ++i) {
        V in[Q];
        V out[Q];
        load<Q, Q>(by_y[c] + i, in);
        multiply<Q, Q, 1, Q>(a.derivative, in, out);
#pragma GCC unroll 8
        for (int j = 0; j < Q; ++j) {
          values[c][start + j * Q + i] = out[j] + along_x[j * Q + i];
        }
      }
    }
  }

  /// Transpose of evaluate().
  CLEVIS_INLINE void integrate(const int* codes) {
    for (int c = 0; c < 3; ++c) {
      V by_xy[N * Q * Q];
      V by_x[N * N * Q];
      for (int at = 0; at < Q * Q; ++at) {
        V dual[Q];
        V sum[Q];
        V out[N];
        load<Q, Q * Q>(along_z[c] + at, dual);
        multiply<Q, Q, 1, Q>(a.derivative, dual, sum);
#pragma GCC unroll 8
        for (int k = 0; k < Q; ++k) sum[k] += values[c][k * Q * Q + at];
        multiply<N, Q, 1, N>(a.interpolation, sum, out);
        store<N, Q * Q>(out, by_xy + at);
      }
      contract<N, Q, N, Q, 1, N>(a.interpolation, by_xy, by_x);
      for (int line = 0; line < N * N; ++line) {
        V out[N];
        multiply<N, Q, 1, N>(a.interpolation, by_x + line * Q, out);
#pragma GCC unroll 8
        for (int i = 0; i < N; ++i) {
          const int code = codes[line * N + i];
          V* to = place<V>(code, a.nodes, a.y, a.ghost) + c;
          if (code < 0) {
            *to = out[i];
          } else {
            *to += out[i];
          }
        }
      }
    }
  }
};

template <typename Real, int N, int Q>
void apply(const ApplyArguments<Real>& a) {
  constexpr long kNodes = N * N * N;
  Cell<Real, N, Q> cell{a, {}, {}};
  for (long c = a.begin; c < a.end; ++c) {
    cell.evaluate(a.gather + c * kNodes);
    const Real* metric = a.metric + c * cell.kPoints * kMetric;
    for (int k = 0; k < Q; ++k) cell.plane(k, metric);
    cell.integrate(a.scatter + c * kNodes);
  }
}

/// target(fine) = P source(coarse), each fine node by its first cell.
template <int N, int M>
void prolong(const TransferArguments& a) {
  using V = Register<float>::type;
  for (long cell = a.begin; cell < a.end; ++cell) {
    const int* from = a.coarse_gather + cell * M * M * M;
    const int* to = a.fine_scatter + cell * N * N * N;
    for (int c = 0; c < 3; ++c) {
      V in[M * M * M];
      V by_x[M * M * N];
      V by_xy[M * N * N];
      V out[N * N * N];
      for (int i = 0; i < M * M * M; ++i) in[i] = node<V>(a.source, from[i])[c];
      contract<M * M, M, N, 1, M, 1>(a.interpolation, in, by_x);
      contract<M, M, N, N, M, 1>(a.interpolation, by_x, by_xy);
      contract<1, M, N, N * N, M, 1>(a.interpolation, by_xy, out);
      for (int i = 0; i < N * N * N; ++i) {
        if (to[i] >= 0 || ~to[i] >= a.fine_nodes) continue;
        place<V>(to[i], a.fine_nodes, a.target, a.ghost)[c] = out[i];
      }
    }
  }
}

/// target(coarse) = Pᵀ source(fine).
template <int N, int M>
void restrict_to(const TransferArguments& a) {
  using V = Register<float>::type;
  for (long cell = a.begin; cell < a.end; ++cell) {
    const int* from = a.fine_scatter + cell * N * N * N;
    const int* to = a.coarse_scatter + cell * M * M * M;
    for (int c = 0; c < 3; ++c) {
      V in[N * N * N];
      V by_z[M * N * N];
      V by_yz[M * M * N];
      V out[M * M * M];
      for (int i = 0; i < N * N * N; ++i) {
        const bool ours = from[i] < 0 && ~from[i] < a.fine_nodes;
        in[i] = ours ? node<V>(a.source, ~from[i])[c] : V{};
      }
      contract<1, N, M, N * N, 1, M>(a.interpolation, in, by_z);
      contract<M, N, M, N, 1, M>(a.interpolation, by_z, by_yz);
      contract<M * M, N, M, 1, 1, M>(a.interpolation, by_yz, out);
      for (int i = 0; i < M * M * M; ++i) {
        V* target = place<V>(to[i], a.coarse_nodes, a.target, a.ghost) + c;
        if (to[i] < 0) {
          *target = out[i];
        } else {
          *target += out[i];
        }
      }
    }
  }
}

void subtract(const SmoothArguments& a) {
  using V = Register<float>::type;
  for (long at = 3L * a.begin; at < 3L * a.end; ++at) {
    reinterpret_cast<V*>(a.residual)[at] -=
        reinterpret_cast<const V*>(a.change)[at];
  }
}

template <bool has_change, bool keeps, bool fresh, bool add_old>
void smooth_nodes(const SmoothArguments& a) {
  using V = Register<float>::type;
  for (long n = a.begin; n < a.end; ++n) {
    V* residual = reinterpret_cast<V*>(a.residual) + 3 * n;
    V* step = reinterpret_cast<V*>(a.step) + 3 * n;
    V* solution = reinterpret_cast<V*>(a.solution) + 3 * n;
    const V* change = reinterpret_cast<const V*>(a.change) + 3 * n;
    const float* b = a.blocks + 6 * n;
    V r[3];
    for (int c = 0; c < 3; ++c) {
      r[c] = residual[c];
      if (has_change) residual[c] = r[c] = r[c] - change[c];
    }
    V s[3] = {a.gain * (b[0] * r[0] + b[1] * r[1] + b[2] * r[2]),
              a.gain * (b[1] * r[0] + b[3] * r[1] + b[4] * r[2]),
              a.gain * (b[2] * r[0] + b[4] * r[1] + b[5] * r[2])};
    for (int c = 0; c < 3; ++c) {
      if (keeps) s[c] += a.keep * step[c];
      V sum = s[c];
      if (add_old) sum += step[c];
      if (!fresh) sum += solution[c];
      step[c] = s[c];
      solution[c] = sum;
    }
  }
}

void smooth(const SmoothArguments& a) {
  if (a.fresh) {
    smooth_nodes<false, false, true, false>(a);
  } else if (a.add_old) {
    smooth_nodes<true, false, false, true>(a);
  } else {
    smooth_nodes<true, true, false, false>(a);
  }
}

typedef float HalfRegister __attribute__((vector_size(32)));
using Lanes = Register<double>::type;

CLEVIS_INLINE HalfRegister* half(float* z, long at) {
  return reinterpret_cast<HalfRegister*>(z + at * kLanes<float>);
}

void product(const CgArguments& a) {
  Lanes sum{};
  for (long at = 3L * a.begin; at < 3L * a.end; ++at) {
    sum += reinterpret_cast<const Lanes*>(a.p)[at] *
           reinterpret_cast<const Lanes*>(a.kp)[at];
  }
  *reinterpret_cast<Lanes*>(a.sum) += sum;
}

void advance(const CgArguments& a) {
  const Lanes factor = *reinterpret_cast<const Lanes*>(a.factor);
  Lanes sum{};
  for (long at = 3L * a.begin; at < 3L * a.end; ++at) {
    reinterpret_cast<Lanes*>(a.x)[at] +=
        factor * reinterpret_cast<const Lanes*>(a.p)[at];
    const Lanes r = reinterpret_cast<Lanes*>(a.r)[at] -
                    factor * reinterpret_cast<const Lanes*>(a.kp)[at];
    reinterpret_cast<Lanes*>(a.r)[at] = r;
    sum += r * r;
    *half(a.z, at) = __builtin_convertvector(r, HalfRegister);
  }
  *reinterpret_cast<Lanes*>(a.sum) += sum;
}

void products(const CgArguments& a) {
  Lanes with_r{};
  Lanes with_kp{};
  for (long at = 3L * a.begin; at < 3L * a.end; ++at) {
    const Lanes z = __builtin_convertvector(*half(a.z, at), Lanes);
    with_r += z * reinterpret_cast<const Lanes*>(a.r)[at];
    with_kp += z * reinterpret_cast<const Lanes*>(a.kp)[at];
  }
  reinterpret_cast<Lanes*>(a.sum)[0] += with_r;
  reinterpret_cast<Lanes*>(a.sum)[1] += with_kp;
}

void direction(const CgArguments& a) {
  const Lanes factor = *reinterpret_cast<const Lanes*>(a.factor);
  for (long at = 3L * a.begin; at < 3L * a.end; ++at) {
    Lanes& p = reinterpret_cast<Lanes*>(a.p)[at];
    p = __builtin_convertvector(*half(a.z, at), Lanes) + factor * p;
  }
}

template <typename Real, typename Row>
void fill_apply(Row* row) {
  row[0][0] = apply<Real, 2, 2>;
  row[0][1] = apply<Real, 2, 3>;
  row[1][0] = apply<Real, 3, 3>;
  row[1][1] = apply<Real, 3, 4>;
  row[2][0] = apply<Real, 4, 4>;
  row[2][1] = apply<Real, 4, 5>;
  row[3][0] = apply<Real, 5, 5>;
  row[3][1] = apply<Real, 5, 6>;
}

#undef CLEVIS_INLINE

}  // namespace

void get(Kernels& kernels) {
  fill_apply<double>(kernels.apply_double);
  fill_apply<float>(kernels.apply_float);
  kernels.prolong[1] = prolong<3, 2>;
  kernels.prolong[2] = prolong<4, 3>;
  kernels.prolong[3] = prolong<5, 3>;
  kernels.restrict_to[1] = restrict_to<3, 2>;
  kernels.restrict_to[2] = restrict_to<4, 3>;
  kernels.restrict_to[3] = restrict_to<5, 3>;
  kernels.subtract = subtract;
  kernels.smooth = smooth;
  kernels.product = product;
  kernels.advance = advance;
  kernels.products = products;
  kernels.direction = direction;
}

}  // namespace clevis::elasticity::lanes::CLEVIS_LANES
