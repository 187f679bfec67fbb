// The numeric suite on two drivers: every case at the levels that promise something, and every seeded fault.
#include "gpu/device_test.h"
#include "numerics/case_at_level.h"
#include "numerics/known_failures.h"
#include "verify/image_cases.h"
#include "verify/mutations.h"

namespace vernier {
namespace {

/// All but the case that compares two devices: here the loader shows one, tests/golden/across_devices_test has both.
std::vector<CaseAtLevel> all_cases() {
  std::vector<CaseAtLevel> all;
  for (const VerifyCase& one : verify_cases()) {
    if (one.name == std::string_view("driver_difference")) continue;
    all.push_back({&one, Accuracy::robust});
    all.push_back({&one, Accuracy::exact});
  }
  return all;
}

/// Cases of kImageCases that render; the others trace rays alone.
bool is_picture(const VerifyCase& one) {
  const std::string_view name = one.name;
  return is_image_case(name) && name != "millions" && name != "instance_transform" && name != "instance_shared";
}

class NumericsTest : public DeviceTest, public testing::WithParamInterface<CaseAtLevel> {};

TEST_P(NumericsTest, meets_its_target) {
  // Eight turns of 1024 rays: every target of a case has at least one. `vernier verify --rays` takes more.
  CaseSetup setup = setup_of(GetParam(), device(), 1u << 13);
  // SwiftShader takes seconds to compile what each picture is made by: one of a kind stands for all there.
  if (is_picture(*GetParam().verify_case) && !device().description().is_llvmpipe && VERNIER_ALL_CASES == 0)
    setup.sample_count = 1;
  const bool known = is_known_failure(name_of(GetParam()), !device().description().is_llvmpipe);
  if (known) setup.sample_count = 1u << 16;  // enough that it shows
  const CaseReport report = run_case(*GetParam().verify_case, setup);
  ASSERT_EQ(report.result.not_run, "");
  EXPECT_EQ(report.held, !known) << report.verify_case->property << ": " << report.result.failures << " of "
                                 << report.result.samples << ", first " << report.result.first_failure
                                 << ", largest error " << report.result.max << " " << report.result.unit << "\n"
                                 << report.result.worst_inputs;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, NumericsTest, testing::ValuesIn(all_cases()),
                         [](const testing::TestParamInfo<CaseAtLevel>& one) { return name_of(one.param); });

/// The faults that cases of single functions and rays see; PictureWitnessTest has the others.
std::vector<Mutation> faults_of_functions() {
  std::vector<Mutation> faults(mutations().begin(), mutations().end());
  for (Mutation& one : faults) std::erase_if(one.cases, is_image_case);
  std::erase_if(faults, [](const Mutation& one) { return one.cases.empty(); });
  return faults;
}

class MutationTest : public DeviceTest, public testing::WithParamInterface<Mutation> {};

TEST_P(MutationTest, is_caught) {
  CaseSetup setup;
  setup.device = &device();
  setup.sample_count = 1u << 14;
  bool caught = false;
  // One witness is enough here; `vernier verify --mutate all` asks them all.
  for (const char* name : GetParam().cases) {
    Mutation with_witness = GetParam();
    with_witness.cases = {name};
    caught = caught || is_caught(run_mutation(with_witness, setup));
  }
  EXPECT_TRUE(caught) << GetParam().what;
}

INSTANTIATE_TEST_SUITE_P(Seeded, MutationTest, testing::ValuesIn(faults_of_functions()),
                         [](const testing::TestParamInfo<Mutation>& one) { return std::string(one.param.name); });

/// A fault, and a case of the images that names itself its witness.
struct Witness {
  Mutation mutation;
  const char* picture;
};

std::vector<Witness> picture_witnesses() {
  std::vector<Witness> witnesses;
  for (const Mutation& mutation : mutations()) {
    for (const char* name : mutation.cases) {
      if (is_image_case(name)) witnesses.push_back({mutation, name});
    }
  }
  return witnesses;
}

class PictureWitnessTest : public DeviceTest, public testing::WithParamInterface<Witness> {};

// Single functions have many cases that may notice, a kind of picture has itself: each has to see what it says it does.
TEST_P(PictureWitnessTest, sees_the_fault) {
  CaseSetup setup;
  setup.device = &device();
  // As many as NumericsTest takes, which has shown that the case holds without the fault.
  setup.sample_count = 1u << 13;
  const VerifyCase* verify_case = find_case(GetParam().picture);
  ASSERT_NE(verify_case, nullptr);
  EXPECT_FALSE(run_case(*verify_case, seeded(setup, GetParam().mutation)).held) << GetParam().mutation.what;
}

INSTANTIATE_TEST_SUITE_P(Seeded, PictureWitnessTest, testing::ValuesIn(picture_witnesses()),
                         [](const testing::TestParamInfo<Witness>& one) {
                           return std::string(one.param.picture) + "_" + one.param.mutation.name;
                         });

}  // namespace
}  // namespace vernier
