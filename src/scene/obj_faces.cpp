#include "scene/obj_faces.h"

#include <span>

#include "error.h"
#include "scene/polygon_triangles.h"

namespace vernier {
namespace {

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& what) {
  throw Error(ErrorKind::refused, file + ": line " + std::to_string(line) + ": " + what);
}

void check_index(const std::string& file, std::size_t line, const char* what, int index, std::size_t count) {
  if (index < -1 || index >= static_cast<std::int64_t>(count)) {
    refuse(file, line,
           std::string(what) + " " + std::to_string(std::int64_t{index} + 1) + " is beyond the " +
               std::to_string(count) + " of the file");
  }
}

void check_corner(const std::string& file, std::size_t line, const ObjCorner& corner, const ObjGeometry& geometry) {
  if (corner.position == -1) refuse(file, line, "a vertex index counts back before the first vertex");
  check_index(file, line, "vertex", corner.position, geometry.positions.size());
  check_index(file, line, "texture vertex", corner.uv, geometry.uvs.size());
  check_index(file, line, "normal", corner.normal, geometry.normals.size());
}

/// Cuts the faces of a part, in file order, the order in which the filter counted them.
class FaceCutter {
 public:
  FaceCutter(const std::string& file, const ObjPart& part, const CarriedState& state, const ObjGeometry& geometry)
      : file_(file), part_(part), state_(state), geometry_(geometry) {}

  /// One shape after the other.
  std::vector<ObjShape> cut() {
    std::vector<ObjShape> shapes;
    for (const tinyobj::shape_t& shape : part_.shapes) shapes.push_back(cut_shape(shape));
    return shapes;
  }

 private:
  ObjShape cut_shape(const tinyobj::shape_t& source) {
    const ObjStatements& statements = part_.statements;
    ObjShape shape{source.name, {}};
    std::size_t first = 0;
    for (std::size_t face = 0; face < source.mesh.material_ids.size(); ++face) {
      const std::size_t count = statements.face_corner_counts.at(face_);
      const std::span<const tinyobj::index_t> indices = std::span(source.mesh.indices).subspan(first, count);
      const int number = source.mesh.material_ids[face];
      ObjTriangle pattern;
      pattern.material = face_ < statements.first_material_face
                             ? state_.material
                             : state_.material_of_number.at(static_cast<std::size_t>(number));
      pattern.smoothing_group =
          face_ < statements.first_smoothing_face ? state_.smoothing_group : source.mesh.smoothing_group_ids[face];
      add_face(indices, pattern, shape.triangles);
      first += count;
      ++face_;
    }
    return shape;
  }

  void add_face(std::span<const tinyobj::index_t> indices, ObjTriangle pattern, std::vector<ObjTriangle>& triangles) {
    corners_.clear();
    points_.clear();
    cuts_.clear();
    for (const tinyobj::index_t& index : indices) {
      corners_.push_back({index.vertex_index, index.texcoord_index, index.normal_index});
      check_corner(file_, state_.lines + part_.statements.face_lines[face_], corners_.back(), geometry_);
      points_.push_back(geometry_.positions[static_cast<std::size_t>(corners_.back().position)]);
    }
    append_polygon_triangles(points_, cuts_);
    for (const PolygonTriangle& cut : cuts_) {
      for (std::size_t i = 0; i < 3; ++i) pattern.corners[i] = corners_[cut[i]];
      triangles.push_back(pattern);
    }
  }

  const std::string& file_;
  const ObjPart& part_;
  const CarriedState& state_;
  const ObjGeometry& geometry_;
  std::size_t face_ = 0;
  std::vector<ObjCorner> corners_;
  std::vector<glm::dvec3> points_;
  std::vector<PolygonTriangle> cuts_;
};

}  // namespace

std::vector<ObjShape> cut_faces(const std::string& file, const ObjPart& part, const CarriedState& state,
                                const ObjGeometry& geometry) {
  return FaceCutter(file, part, state, geometry).cut();
}

}  // namespace vernier
