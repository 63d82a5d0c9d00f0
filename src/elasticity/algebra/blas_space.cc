#include "elasticity/algebra/blas_space.h"

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <dlfcn.h>
#include <sys/mman.h>

#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {
namespace {

/// Of one thread, with what it needs to pack matrices and a rest for others.
constexpr std::size_t kWanted = std::size_t{192} << 20;  // [byte]

bool has_memory(std::size_t bytes) {
  void* space = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space == MAP_FAILED) return false;
  munmap(space, bytes);
  return true;
}

/// Lets OpenBLAS take space for that many threads. Its own functions do it;
/// another library of that interface takes what one thread needs.
void take(int threads) {
  using Allocate = void* (*)(int);
  using Free = void (*)(void*);
  const auto allocate =
      reinterpret_cast<Allocate>(dlsym(RTLD_DEFAULT, "blas_memory_alloc"));
  const auto release =
      reinterpret_cast<Free>(dlsym(RTLD_DEFAULT, "blas_memory_free"));
  if (allocate == nullptr || release == nullptr) {
    constexpr int kSize = 128;
    const Eigen::MatrixXd a = Eigen::MatrixXd::Identity(kSize, kSize);
    transposed_product(a, a);
    return;
  }
  std::vector<void*> spaces;
  for (int k = 0; k < threads; ++k) spaces.push_back(allocate(0));
  for (void* space : spaces) release(space);
}

}  // namespace

bool take_blas_space(int threads) {
  static int taken = 0;
  if (threads <= taken) return true;
  if (!has_memory(static_cast<std::size_t>(threads - taken) * kWanted)) {
    return false;
  }
  take(threads);
  taken = threads;
  return true;
}

}  // namespace clevis::elasticity
