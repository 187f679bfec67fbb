#include "verify/mutations.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <string_view>

#include "verify/image_cases.h"

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

// The catalogue has 56 hard cases; its table is tests/numerics/README.md, a row for each case of the program.
TEST(VerifyCases, are_the_table_of_the_catalogue) {
  std::ifstream file(VERNIER_SOURCE_DIR "/tests/numerics/README.md");
  const std::string table((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::set<int> numbers;
  for (const VerifyCase& one : verify_cases()) {
    numbers.insert(one.number);
    const std::regex row("\n\\| " + std::to_string(one.number) + " \\|[^|\n]*\\| `" + one.name + "` \\| " + one.oracle +
                         " \\|");
    EXPECT_TRUE(std::regex_search(table, row)) << one.number << " " << one.name << " " << one.oracle;
  }
  EXPECT_EQ(numbers.size(), 56u);
  EXPECT_EQ(*numbers.rbegin(), 56);
  const std::regex any_row("\n\\| [0-9]");
  const std::sregex_iterator rows(table.begin(), table.end(), any_row);
  EXPECT_EQ(static_cast<std::size_t>(std::distance(rows, std::sregex_iterator())), verify_cases().size());
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
  for (std::uint32_t fault = MUTATION_NONE; fault < MUTATION_COUNT; ++fault) EXPECT_TRUE(seen.count(fault)) << fault;
}

// What validate_scene leaves out never reaches a shader, and two devices differ by what one of them does alone.
constexpr std::array<std::string_view, 2> kPicturesWithoutFault{"singular_transform", "driver_difference"};

TEST(Mutations, have_every_kind_of_picture_for_a_witness) {
  std::set<std::string_view> witnesses(kPicturesWithoutFault.begin(), kPicturesWithoutFault.end());
  for (const Mutation& one : mutations()) witnesses.insert(one.cases.begin(), one.cases.end());
  for (const VerifyCase& one : kImageCases) EXPECT_TRUE(witnesses.count(one.name)) << one.name;
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
