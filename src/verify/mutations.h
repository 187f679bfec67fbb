#pragma once

#include <span>
#include <string>
#include <vector>

#include "verify/run_cases.h"

namespace vernier {

/// A known fault that the suite has to catch.
struct Mutation {
  const char* name;                ///< for --mutate
  const char* what;                ///< what is wrong then, one line
  std::uint32_t levels;            ///< of the spots, everything else at robust
  std::uint32_t mutation;          ///< MUTATION_*
  std::vector<const char*> cases;  ///< those that should notice, the likeliest first
};

/// All faults that can be seeded.
std::span<const Mutation> mutations();

/// The fault called `name`; nullptr when there is none.
const Mutation* find_mutation(const std::string& name);

/// The names of all faults, separated by commas.
std::string mutation_names();

/// `setup` with the fault seeded, the targets those of robust.
CaseSetup seeded(const CaseSetup& setup, const Mutation& mutation);

/// Runs the mutation's cases with the fault seeded, but those that break their target without it as well: they can
/// witness nothing. A case that is not part of this build is left out.
std::vector<CaseReport> run_mutation(const Mutation& mutation, const CaseSetup& setup);

/// Whether a case broke its target.
bool is_caught(std::span<const CaseReport> reports);

}  // namespace vernier
