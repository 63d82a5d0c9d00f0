#define CLEVIS_LANES plain
#include "elasticity/lanes/lane_kernels_source.h"
