#pragma once

#include "scene/text/name_index.h"

namespace clevis::scene {

/// Names of the entities that other tables refer to, as far as they are read.
struct Names {
  NameIndex materials{"material"};
  NameIndex parts{"part"};
  NameIndex bodies{"body"};
  NameIndex joints{"joint"};
  NameIndex couplings{"coupling"};
  NameIndex drives{"driven joint"};  ///< by the joint's name
  NameIndex forces{"force"};
  NameIndex markers{"marker"};
  NameIndex bearings{"bearing"};
  NameIndex transmissions{"transmission"};
  NameIndex ejectors{"ejector"};
};

}  // namespace clevis::scene
