#pragma once

namespace clevis::elasticity {

/// Takes the working space with which OpenBLAS serves that many threads at
/// once; it is kept, and worker processes share it. OpenBLAS itself tries for
/// ever where it gets none.
/// @pre no other thread calls OpenBLAS meanwhile.
/// @return false where memory does not suffice: fewer threads must do.
bool take_blas_space(int threads);

}  // namespace clevis::elasticity
