#pragma once

#include <ostream>
#include <string>

#include "verify/verify_case.h"

namespace vernier {

/// A case of the numeric suite at a level that promises something, as tests name and run it.
struct CaseAtLevel {
  const VerifyCase* verify_case;
  Accuracy level;
};

/// The case's name with the level behind it.
inline std::string name_of(const CaseAtLevel& one) {
  return std::string(one.verify_case->name) + (one.level == Accuracy::robust ? "_robust" : "_exact");
}

/// For GoogleTest, which would print bytes.
inline void PrintTo(const CaseAtLevel& one, std::ostream* out) {
  *out << name_of(one);
}

/// Runs it on `device` with so many samples.
inline CaseSetup setup_of(const CaseAtLevel& one, const Device& device, std::uint64_t sample_count) {
  CaseSetup setup;
  setup.device = &device;
  setup.level = one.level;
  setup.levels = one.level == Accuracy::robust ? LEVELS_OF(LEVEL_ROBUST) : LEVELS_OF(LEVEL_EXACT);
  setup.sample_count = sample_count;
  return setup;
}

}  // namespace vernier
