#pragma once

#include <cstdint>
#include <map>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "scene/logical_lines.h"

namespace vernier {

/// No face.
inline constexpr std::size_t kNoFace = static_cast<std::size_t>(-1);

/// What the filter took out of an OBJ text or counted in it. Lines count from 1, faces from 0.
struct ObjStatements {
  std::size_t lines = 0;
  std::size_t first_group_face = kNoFace;               ///< the face behind the first `g` or `o`
  std::size_t first_material_face = kNoFace;            ///< behind the first usemtl
  std::size_t first_smoothing_face = kNoFace;           ///< behind the first `s`
  bool counts_back = false;                             ///< an index of a face is negative
  std::vector<std::uint32_t> face_lines;                ///< line of each face, in file order
  std::vector<std::uint32_t> face_corner_counts;        ///< corners of each face, >= 3
  std::vector<std::string> material_names;              ///< of usemtl; tinyobj's material ids index it
  std::vector<std::string> material_libraries;          ///< file names of all mtllib, as written
  std::size_t thin_element_count = 0;                   ///< lines and points
  std::size_t thin_element_line = 0;                    ///< where the first is
  std::size_t short_face_count = 0;                     ///< faces of one or two corners, left out
  std::size_t short_face_line = 0;                      ///< where the first is
  std::map<std::string, std::size_t> unknown_keywords;  ///< keyword and its first line; at most kUnknownKeywordCount
};

/// Most material libraries: each is a file to open, and no model has more.
inline constexpr std::size_t kMaxLibraries = 256;

/// Most unknown keywords that are kept by name: a binary file has no end of them.
inline constexpr std::size_t kUnknownKeywordCount = 8;

/// Hands an OBJ text to tinyobjloader line by line, with what version 2.0rc10 would read wrongly put right: lines
/// joined at a trailing backslash, numbers that are none refused and NaN and infinity passed on as infinity (it reads
/// them as 0), faces counted by corners (it keeps 8 bits of the count), names of materials and libraries kept whole (it
/// cuts them at spaces and backslashes), lines and points taken out (it copies them again at every usemtl). Behind the
/// last line comes a face of three times the first vertex, which is not counted: it tells in what shape, with what
/// material and smoothing the text ends. Reading throws Error(refused) with `file` and line for a number or an index
/// that is none.
class ObjLineFilter : public std::streambuf {
 public:
  /// `file` names the text in errors. `text` outlives the filter.
  ObjLineFilter(std::string file, std::string_view text);

  /// The line that was handed on last, from 1; a joined line has the number of its last part.
  std::size_t line() const { return lines_.last_line(); }
  /// What was seen so far.
  const ObjStatements& statements() const { return statements_; }

 protected:
  int underflow() override;

 private:
  void write(std::string_view text);
  void write_vertex(std::string_view text, std::string_view keyword, std::string_view rest);
  void write_face(std::string_view rest);
  void check_counted_back(std::string_view corner) const;
  void write_material(std::string_view name);
  void keep_libraries(std::string_view rest);
  void keep_unknown(std::string_view keyword);
  [[noreturn]] void refuse(const std::string& what) const;

  std::string file_;
  LogicalLines lines_;
  bool ended_ = false;
  std::string out_;
  std::size_t uv_count_ = 0, normal_count_ = 0;  // so far
  std::map<std::string, std::size_t, std::less<>> material_ids_;
  ObjStatements statements_;
};

}  // namespace vernier
