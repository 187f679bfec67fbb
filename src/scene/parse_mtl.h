#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vernier {

/// The maps of an MTL material that are read.
enum class MtlMap { diffuse, specular, ambient, emission, exponent, dissolve, bump, normal };

/// Number of values of MtlMap.
inline constexpr std::size_t kMtlMapCount = 8;

/// A map_* statement: the file as written and its options. A file name without characters: no map.
struct MtlTexture {
  std::string file;
  glm::dvec2 scale = glm::dvec2(1.0);   ///< -s
  glm::dvec2 offset = glm::dvec2(0.0);  ///< -o
  bool clamp = false;                   ///< -clamp on
  double bump_multiplier = 1.0;         ///< -bm
  char channel = '\0';                  ///< -imfchan r g b m l z; none: '\0'
};

/// A material as written; what is absent stays empty, because absent and black mean different things.
struct MtlMaterial {
  std::string name;
  std::optional<glm::dvec3> diffuse;          ///< Kd
  std::optional<glm::dvec3> specular;         ///< Ks
  std::optional<glm::dvec3> ambient;          ///< Ka
  std::optional<glm::dvec3> emission;         ///< Ke
  std::optional<glm::dvec3> transmission;     ///< Tf, Kt
  std::optional<double> exponent;             ///< Ns
  std::optional<double> ior;                  ///< Ni
  std::optional<double> opacity;              ///< d, or 1 - Tr where there is no d
  std::optional<int> illumination;            ///< illum, 0 to 9
  std::array<MtlTexture, kMtlMapCount> maps;  ///< by MtlMap
};

/// What an MTL text holds.
struct MtlLibrary {
  std::vector<MtlMaterial> materials;    ///< in file order; of two with one name the first counts
  std::vector<std::string> unsupported;  ///< one line each, "line 3: what": statements and options without effect here
  std::vector<std::string> faults;       ///< one line each: values that make no sense and were left out
};

/// Reads the text of an MTL file. tinyobjloader 2.0rc10 would not do: it cannot tell an absent value from a zero, takes
/// the file name for a number after `-s 2 2`, and knows no options after the file name. Names of materials and files
/// may have spaces. A colour of one number is grey. Statements before the first newmtl are ignored. Never throws for
/// any text; non-finite numbers are faults; each kind of unsupported statement is told once.
MtlLibrary parse_mtl(std::string_view text);

}  // namespace vernier
