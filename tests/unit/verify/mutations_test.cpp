#include "verify/mutations.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace vernier {
namespace {

TEST(VerifyCases, have_unique_names_and_rising_numbers) {
  std::set<std::string> names;
  int number = 0;
  for (const VerifyCase& one : verify_cases()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_GE(one.number, number) << one.name;
    EXPECT_EQ(find_case(one.name), &one);
    number = one.number;
  }
  EXPECT_EQ(find_case("no_such_case"), nullptr);
}

TEST(Mutations, differ_from_robust_by_one_thing) {
  const CaseSetup robust;
  std::set<std::string> names;
  for (const Mutation& one : mutations()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(find_mutation(one.name), &one);
    EXPECT_FALSE(one.cases.empty()) << one.name;
    EXPECT_NE(one.levels != robust.levels, one.mutation != MUTATION_NONE) << one.name;
    const CaseSetup with_fault = seeded(robust, one);
    EXPECT_EQ(with_fault.levels, one.levels);
    EXPECT_EQ(with_fault.mutation, one.mutation);
  }
  EXPECT_EQ(find_mutation("all"), nullptr) << "is a word of the command line";
}

TEST(Mutations, cover_every_seeded_fault_there_is) {
  std::set<std::uint32_t> seen;
  for (const Mutation& one : mutations()) seen.insert(one.mutation);
  for (std::uint32_t fault = MUTATION_NONE; fault <= MUTATION_NARROW_SUM; ++fault)
    EXPECT_TRUE(seen.count(fault)) << fault;
}

TEST(Mutations, are_caught_when_a_case_breaks_its_target) {
  CaseReport good, bad;
  good.held = true;
  const std::vector<CaseReport> one_of_two{good, bad};
  EXPECT_TRUE(is_caught(one_of_two));
  EXPECT_FALSE(is_caught({&good, 1}));
  EXPECT_FALSE(is_caught({}));
}

}  // namespace
}  // namespace vernier
