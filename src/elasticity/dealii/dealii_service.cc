#include "elasticity/dealii/dealii_service.h"

#include "elasticity/engine_library/engine_library.h"

namespace clevis::elasticity {

void serve_dealii() {
  engine_function<DealiiServiceEntry>(kDealiiServe)();
}

void dismiss_dealii() {
  engine_function<DealiiServiceEntry>(kDealiiDismiss)();
}

int dealii_lanes() {
  return engine_function<DealiiLanesEntry>(kDealiiLanes)();
}

}  // namespace clevis::elasticity
