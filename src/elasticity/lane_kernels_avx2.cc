#define CLEVIS_LANES avx2
#include "elasticity/lane_kernels_source.h"
