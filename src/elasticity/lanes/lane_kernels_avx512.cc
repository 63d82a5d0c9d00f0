#define CLEVIS_LANES avx512
#include "elasticity/lanes/lane_kernels_source.h"
