#pragma once

#include <limits>

#include "verify/verify_case.h"

namespace vernier {

/// The bound of a case at the level of `setup`: infinity at fast, which promises nothing and is measured alone.
inline double level_bound(const CaseSetup& setup, double robust, double exact) {
  if (setup.level == Accuracy::fast) return std::numeric_limits<double>::infinity();
  return setup.level == Accuracy::exact ? exact : robust;
}

}  // namespace vernier
