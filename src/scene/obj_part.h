#pragma once

#include <tiny_obj_loader.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/obj_line_filter.h"

namespace vernier {

/// A part of an OBJ text as tinyobjloader reads it by itself: indices of its faces are those of the whole file.
struct ObjPart {
  tinyobj::attrib_t arrays;
  std::vector<tinyobj::shape_t> shapes;  ///< with faces, in file order
  ObjStatements statements;
  std::string last_shape;                  ///< name of the last `g` or `o`; empty without
  int last_material = -1;                  ///< of the last usemtl, indexes statements.material_names; -1 without
  std::uint32_t last_smoothing_group = 0;  ///< of the last `s`; 0 without
  bool last_shape_has_faces = false;       ///< a face follows the last `g` or `o`
};

/// Reads `text`, which begins and ends with whole lines. `file` names it in errors. Throws Error(refused) with a line
/// of the part.
ObjPart read_obj_part(const std::string& file, std::string_view text);

/// `text` in at most `count` parts of about the same size that begin where a line begins that none before is joined to.
std::vector<std::string_view> split_obj(std::string_view text, std::size_t count);

}  // namespace vernier
