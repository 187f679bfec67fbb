#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "gpu/describe_devices.h"
#include "verify/level_cost.h"
#include "verify/mutations.h"

namespace vernier {

/// A line per case for people, under a head line with the names of the columns.
std::string case_table_head();
/// One line: number, case, oracle, samples, failures, bound of their rate where there are none, p50, p99 and largest
/// error with unit, seconds, verdict.
std::string case_line(const CaseReport& report);

/// Of a case that broke its target: the sample, its inputs, and the command that makes it again. `arguments` are those
/// that chose device and level, "" or with a leading space.
std::string failure_text(const CaseReport& report, const CaseSetup& setup, const std::string& arguments);

/// How many of the rays aimed at edges and corners of closed meshes got out, beside what Embree's own test asks of it.
struct LeakCount {
  std::uint64_t rays = 0;
  std::uint64_t leaks = 0;
};

/// Over the cases of edges, vertices, far meshes and needles among `reports`; 0 of 0 where none of them ran.
LeakCount count_leaks(std::span<const CaseReport> reports);

/// One line of it; "" where there were no such rays.
std::string leak_line(const LeakCount& count);

/// What the levels cost, a line per spot.
std::string level_cost_table(std::span<const LevelCost> costs);

/// {"schema": 1, "device": ..., "level", "seed", "samples_per_case", "held", "cases": [...], "watertight": ...,
/// "level_costs": [...]} of a run; device as in `vernier devices --json`. What was not measured is left out.
nlohmann::json verify_json(const DeviceReport& device, const CaseSetup& setup, std::span<const CaseReport> reports,
                           std::span<const LevelCost> costs);

/// One line: fault, caught or missed, by which case after how many samples.
std::string mutation_line(const Mutation& mutation, std::span<const CaseReport> reports);

/// {"schema": 1, "device": ..., "seed", "caught", "mutations": [...]}, a row of `reports` per row of `seeded_faults`.
nlohmann::json mutations_json(const DeviceReport& device, const CaseSetup& setup,
                              std::span<const Mutation> seeded_faults,
                              std::span<const std::vector<CaseReport>> reports);

}  // namespace vernier
