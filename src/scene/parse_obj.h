#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vernier {

/// A corner of an OBJ face: indices from 0, -1 for none.
struct ObjCorner {
  int position = -1;
  int uv = -1;
  int normal = -1;
};

/// A triangle of an OBJ face.
struct ObjTriangle {
  std::array<ObjCorner, 3> corners;
  int material = -1;                  ///< indexes ObjGeometry::material_names, -1 for none
  std::uint32_t smoothing_group = 0;  ///< 0: none
};

/// Faces under one `o` or `g`, as triangles in file order.
struct ObjShape {
  std::string name;
  std::vector<ObjTriangle> triangles;
};

/// The geometry of an OBJ file, in double as in the file. All indices of all corners are within the arrays.
struct ObjGeometry {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> colors;  ///< sRGB as in the file; empty, or one per position, white where a `v` has none
  std::vector<glm::dvec2> uvs;     ///< v upwards
  std::vector<glm::dvec3> normals;
  std::vector<ObjShape> shapes;
  std::vector<std::string> material_names;
  std::vector<std::string> material_libraries;  ///< as written
  std::vector<std::string> unsupported;         ///< one line each: what the file holds and is not read
  std::vector<std::string> faults;              ///< one line each: what was left out because it is wrong
};

/// Parses the OBJ text `text` with tinyobjloader, polygons cut into triangles. `file` names it in errors. It is read
/// in `part_count` parts at a time, each by a thread of its own; the geometry is the same for any number.
/// A number that is not finite arrives as infinity or NaN. Throws Error(refused) with line for what is no number, no
/// index, or an index that is 0 or beyond the arrays.
ObjGeometry parse_obj(const std::string& file, std::string_view text, std::size_t part_count = 1);

}  // namespace vernier
