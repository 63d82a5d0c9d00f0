#define CLEVIS_LANES plain
#include "elasticity/lane_kernels_source.h"
