#include "render/form_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "shader/tiny_scene.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

class FormFileTest : public testing::Test {
 protected:
  void SetUp() override {
    setenv("VERNIER_PIPELINE_CACHE", folder_.path().c_str(), 1);
    device_.pipeline_key = "a-key";
    device_.subgroup_ballot = true;
  }
  void TearDown() override { unsetenv("VERNIER_PIPELINE_CACHE"); }

  TraversalForm calibrated(TraversalForm asked = TraversalForm::automatic) const {
    return calibrated_form(device_, scene_, asked);
  }

  TemporaryFolder folder_;
  DeviceDescription device_;
  Scene scene_ = test::tiny_scene();
};

TEST_F(FormFileTest, what_was_found_is_taken_for_auto_alone) {
  EXPECT_EQ(calibrated(), TraversalForm::automatic);
  write_form(form_file(device_.pipeline_key), TraversalForm::texels_array);
  EXPECT_EQ(calibrated(), TraversalForm::texels_array);
  EXPECT_EQ(calibrated(TraversalForm::storage_array), TraversalForm::storage_array);
  device_.pipeline_key = "another driver";
  EXPECT_EQ(calibrated(), TraversalForm::automatic);
}

TEST_F(FormFileTest, what_the_device_lacks_is_not_taken) {
  const std::string file = form_file(device_.pipeline_key);
  write_form(file, TraversalForm::ray_query);
  EXPECT_EQ(calibrated(), TraversalForm::automatic);
  device_.ray_query = true;
  EXPECT_EQ(calibrated(), TraversalForm::ray_query);
  write_form(file, TraversalForm::texels_shifted);
  device_.subgroup_ballot = false;
  EXPECT_EQ(calibrated(), TraversalForm::automatic);
}

TEST_F(FormFileTest, ray_queries_leave_scenes_of_many_instances_to_our_tree) {
  write_form(form_file(device_.pipeline_key), TraversalForm::ray_query);
  device_.ray_query = true;
  // So many copies of the box are more than a million triangles.
  for (int i = 0; i < 150000; ++i) scene_.instances.push_back(scene_.instances[2]);
  EXPECT_EQ(calibrated(), TraversalForm::automatic);
  EXPECT_EQ(calibrated(TraversalForm::ray_query), TraversalForm::ray_query) << "asked for";
}

TEST_F(FormFileTest, another_file_says_nothing) {
  for (const char* text : {"", "\n", "texels", "ray-query and more\n"}) {
    std::ofstream(form_file(device_.pipeline_key)) << text;
    EXPECT_FALSE(read_form(form_file(device_.pipeline_key))) << text;
  }
  EXPECT_FALSE(read_form(folder_.path()));
  EXPECT_FALSE(read_form(""));
}

}  // namespace
}  // namespace vernier
