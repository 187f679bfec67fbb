#include "scene/parse_mtl.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

const MtlTexture& map_of(const MtlLibrary& library, MtlMap map) {
  return library.materials.at(0).maps[static_cast<std::size_t>(map)];
}

TEST(ParseMtl, AbsentIsNotZero) {
  const MtlLibrary library = parse_mtl("newmtl a\nKd 0 0 0\n");
  EXPECT_EQ(library.materials.at(0).diffuse, glm::dvec3(0.0));
  EXPECT_FALSE(library.materials.at(0).ambient.has_value());
  EXPECT_FALSE(library.materials.at(0).illumination.has_value());
}

TEST(ParseMtl, MarkAndContinuedLines) {
  const MtlLibrary library = parse_mtl("\xEF\xBB\xBFnewmtl a\nKd 1 \\\n 0 0.5\n");
  EXPECT_EQ(library.materials.at(0).name, "a");
  EXPECT_EQ(library.materials.at(0).diffuse, glm::dvec3(1.0, 0.0, 0.5));
}

TEST(ParseMtl, OptionsMayHaveFewerNumbersThanAllowed) {
  const MtlLibrary library = parse_mtl("newmtl a\nmap_Kd -s 2 3 -o 0.5 a file.png\n");
  EXPECT_EQ(map_of(library, MtlMap::diffuse).file, "a file.png");
  EXPECT_EQ(map_of(library, MtlMap::diffuse).scale, glm::dvec2(2.0, 3.0));
  EXPECT_EQ(map_of(library, MtlMap::diffuse).offset, glm::dvec2(0.5, 0.0));
  EXPECT_TRUE(library.unsupported.empty());
}

TEST(ParseMtl, OptionsMayFollowTheName) {
  const MtlLibrary library = parse_mtl("newmtl a\nbump -imfchan r stone-wall.png -bm 1.5 -clamp on\n");
  const MtlTexture& bump = map_of(library, MtlMap::bump);
  EXPECT_EQ(bump.file, "stone-wall.png");
  EXPECT_EQ(bump.channel, 'r');
  EXPECT_EQ(bump.bump_multiplier, 1.5);
  EXPECT_TRUE(bump.clamp);
  const MtlLibrary dashed = parse_mtl("newmtl a\nmap_Kd my - stone.png -s 2 2 1\n");
  EXPECT_EQ(map_of(dashed, MtlMap::diffuse).file, "my - stone.png");
  EXPECT_EQ(map_of(dashed, MtlMap::diffuse).scale, glm::dvec2(2.0));
}

TEST(ParseMtl, OptionsWithoutEffectHereAreTold) {
  const MtlLibrary library =
      parse_mtl("newmtl a\nmap_Kd -t 1 1 1 -mm 0 2 -blendu off -mm 0 1 a.png\nmap_Ks -mm 0 1 -t 0 0 0 b.png\n");
  EXPECT_EQ(library.unsupported,
            (std::vector<std::string>{"line 2: map_Kd -t is not supported", "line 2: map_Kd -mm is not supported"}));
}

TEST(ParseMtl, ModelsBeyondTheTextAreUnsupported) {
  const MtlLibrary library = parse_mtl("newmtl a\nillum 9\nnewmtl b\nillum 10\nnewmtl c\nillum -1\n");
  EXPECT_EQ(library.materials.at(0).illumination, 9);
  EXPECT_FALSE(library.materials.at(1).illumination.has_value());
  EXPECT_FALSE(library.materials.at(2).illumination.has_value());
  EXPECT_EQ(library.unsupported,
            (std::vector<std::string>{"line 4: illum 10 is not supported", "line 6: illum -1 is not supported"}));
}

TEST(ParseMtl, SenselessNumbersAreLeftOut) {
  const MtlLibrary library = parse_mtl("Kd 1 1 1\nnewmtl a\nKd nan 0 0\nNs x\nNi inf\nKs -1 0.5 0.5\nillum\nmap_Kd\n");
  ASSERT_EQ(library.materials.size(), 1u);
  EXPECT_FALSE(library.materials[0].diffuse.has_value());
  EXPECT_FALSE(library.materials[0].exponent.has_value());
  EXPECT_FALSE(library.materials[0].ior.has_value());
  EXPECT_EQ(library.materials[0].specular, glm::dvec3(0.0, 0.5, 0.5));
  EXPECT_EQ(library.faults.size(), 5u);
}

TEST(ParseMtl, HalfAColourIsNone) {
  const MtlLibrary library = parse_mtl("newmtl a\nKd 1 0,5 0.25\nKs 0.5\nKa 0.5 0.25 # grey\n");
  EXPECT_FALSE(library.materials.at(0).diffuse.has_value());
  EXPECT_EQ(library.materials[0].specular, glm::dvec3(0.5)) << "one number is a grey";
  EXPECT_EQ(library.materials[0].ambient, glm::dvec3(0.5, 0.25, 0.25));
  EXPECT_EQ(library.faults, std::vector<std::string>{"line 2: Kd is not a finite number and is left out"});
}

TEST(ParseMtl, DefaultsThatAreSpeltOutAreNotTold) {
  EXPECT_TRUE(parse_mtl("newmtl a\nmap_Kd -cc off a.png\n").unsupported.empty());
  EXPECT_EQ(parse_mtl("newmtl a\nmap_Kd -cc on a.png\n").unsupported.size(), 1u);
}

TEST(ParseMtl, GarbageGivesFewPrintableLines) {
  std::string text = "newmtl a\n";
  for (int i = 0; i < 1000; ++i) text += std::string("\x01\xff") + std::to_string(i) + " x\r\n";
  const MtlLibrary library = parse_mtl(text);
  EXPECT_EQ(library.unsupported.size(), 16u);
  for (const std::string& line : library.unsupported) {
    for (const char c : line) EXPECT_TRUE(c >= ' ' && c <= '~');
  }
}

}  // namespace
}  // namespace vernier
