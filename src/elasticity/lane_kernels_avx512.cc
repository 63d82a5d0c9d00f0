#define CLEVIS_LANES avx512
#include "elasticity/lane_kernels_source.h"
