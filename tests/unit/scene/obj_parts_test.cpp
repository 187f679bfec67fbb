// An OBJ text that is read in parts is the one that is read as a whole.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "error.h"
#include "scene/obj_part.h"
#include "scene/parse_obj.h"

namespace vernier {
namespace {

constexpr int kVertices = 40, kUvs = 12, kNormals = 9;

/// Statements of every kind in any order, faces that point ahead among them, some lines joined, some ended by CR LF.
class RandomObj {
 public:
  explicit RandomObj(unsigned seed) : random_(seed) {}

  std::string text() {
    int vertices = kVertices, uvs = kUvs, normals = kNormals;
    while (vertices + uvs + normals > 0) {
      const int left = pick(vertices + uvs + normals);
      if (left < vertices) {
        --vertices;
        end_line("v " + numbers(pick(3) == 0 ? 6 : 3));
      } else if (left < vertices + uvs) {
        --uvs;
        end_line("vt " + numbers(2));
      } else {
        --normals;
        end_line("vn " + numbers(3));
      }
      for (int i = pick(4); i > 0; --i) end_line(statement());
    }
    return text_;
  }

 private:
  int pick(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

  std::string numbers(int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += std::to_string(pick(1000) / 999.0) + " ";
    return out;
  }

  std::string face() {
    const int form = pick(4);
    std::string out = "f";
    for (int corner = pick(8) == 0 ? 2 : 3 + pick(3); corner > 0; --corner) {
      out += " " + std::to_string(1 + pick(kVertices));
      if (form == 1 || form == 3) out += "/" + std::to_string(1 + pick(kUvs));
      if (form == 2) out += "/";
      if (form >= 2) out += "/" + std::to_string(1 + pick(kNormals));
    }
    return out;
  }

  std::string statement() {
    switch (pick(16)) {
      case 0:
        return "g first  second" + std::to_string(pick(3));
      case 1:
        return "g";
      case 2:
        return "o part " + std::to_string(pick(3));
      case 3:
        return "s " + std::to_string(pick(3));
      case 4:
        return pick(2) == 0 ? "s off" : "s on";
      case 5:
      case 6:
        return "usemtl paint " + std::to_string(pick(4));
      case 7:
        return "mtllib colours" + std::to_string(pick(3)) + ".mtl";
      case 8:
        return "l 1 2";
      case 9:
        return "curve" + std::to_string(pick(12)) + " 1 2";
      case 10:
        return "# nothing";
      default:
        return face();
    }
  }

  void end_line(const std::string& line) {
    const std::size_t blank = line.find(' ', 2);
    const bool joined = blank != std::string::npos && pick(10) == 0;
    text_ += joined ? line.substr(0, blank) + " \\ \n" + line.substr(blank) : line;
    text_ += pick(5) == 0 ? "\r\n" : "\n";
  }

  std::mt19937 random_;
  std::string text_;
};

void expect_equal(const ObjTriangle& a, const ObjTriangle& b) {
  for (int corner = 0; corner < 3; ++corner) {
    EXPECT_EQ(a.corners[corner].position, b.corners[corner].position);
    EXPECT_EQ(a.corners[corner].uv, b.corners[corner].uv);
    EXPECT_EQ(a.corners[corner].normal, b.corners[corner].normal);
  }
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.smoothing_group, b.smoothing_group);
}

void expect_equal(const ObjGeometry& a, const ObjGeometry& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.uvs, b.uvs);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.material_names, b.material_names);
  EXPECT_EQ(a.material_libraries, b.material_libraries);
  EXPECT_EQ(a.unsupported, b.unsupported);
  EXPECT_EQ(a.faults, b.faults);
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    EXPECT_EQ(a.shapes[i].name, b.shapes[i].name);
    ASSERT_EQ(a.shapes[i].triangles.size(), b.shapes[i].triangles.size()) << "shape " << i;
    for (std::size_t k = 0; k < a.shapes[i].triangles.size(); ++k) {
      expect_equal(a.shapes[i].triangles[k], b.shapes[i].triangles[k]);
    }
  }
}

std::string refusal(const std::string& text, std::size_t part_count) {
  try {
    parse_obj("model.obj", text, part_count);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "not refused";
}

TEST(ObjParts, any_number_of_them_gives_the_same_geometry) {
  std::size_t triangles = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const std::string text = RandomObj(seed).text();
    const ObjGeometry whole = parse_obj("model.obj", text);
    for (const ObjShape& shape : whole.shapes) triangles += shape.triangles.size();
    for (const std::size_t count : {2u, 3u, 7u, 40u}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", parts " + std::to_string(count));
      expect_equal(parse_obj("model.obj", text, count), whole);
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(triangles, 10000u);
}

TEST(ObjParts, begin_with_lines_and_leave_nothing_out) {
  const std::string text = RandomObj(5).text();
  for (const std::size_t count : {1u, 2u, 5u, 1000u}) {
    std::string joined;
    const std::vector<std::string_view> parts = split_obj(text, count);
    EXPECT_LE(parts.size(), count);
    EXPECT_GE(parts.size(), std::min<std::size_t>(count, 5));
    for (const std::string_view part : parts) {
      EXPECT_EQ(part.back(), '\n');
      joined += part;
    }
    EXPECT_EQ(joined, text);
  }
  EXPECT_TRUE(split_obj("", 3).empty());
  EXPECT_EQ(split_obj("v 1 2 3", 3).size(), 1u);
  EXPECT_EQ(split_obj("v 1 \\\n2 \\\n3", 3).size(), 1u) << "one line";
}

TEST(ObjParts, indices_that_count_back_reach_into_the_parts_before) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "v " + std::to_string(i) + " 0 0\nv 0 1 0\nv 0 0 1\nf -3 -2 -1\n";
  text += "f -150 -149 -148\n";
  expect_equal(parse_obj("model.obj", text, 4), parse_obj("model.obj", text));
  EXPECT_EQ(parse_obj("model.obj", text, 4).shapes[0].triangles.back().corners[0].position, 0);
}

TEST(ObjParts, what_is_wrong_has_its_line_in_the_file) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 100; ++i) text += "f 1 2 3\n";
  for (const char* wrong : {"f 1 2 7\n", "f 0 1 2\n", "f 1 2 x\n", "v 1 2\n"}) {
    const std::string bad = text + wrong + "f 1 2 9\n" + text;
    EXPECT_NE(refusal(bad, 1).find("line 104"), std::string::npos) << refusal(bad, 1);
    EXPECT_EQ(refusal(bad, 5), refusal(bad, 1));
  }
  std::string libraries = text;
  for (int i = 0; i < 300; ++i) libraries += "mtllib m" + std::to_string(i) + ".mtl\n";
  EXPECT_NE(refusal(libraries, 1).find("line 360: more than 256"), std::string::npos) << refusal(libraries, 1);
  EXPECT_EQ(refusal(libraries, 5), refusal(libraries, 1));
}

TEST(ObjParts, a_byte_order_mark_is_no_statement) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_equal(parse_obj("model.obj", "\xEF\xBB\xBF" + text, 2), parse_obj("model.obj", text));
}

}  // namespace
}  // namespace vernier
