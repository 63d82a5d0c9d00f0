#define CLEVIS_LANES avx2
#include "elasticity/lanes/lane_kernels_source.h"
