#include "scene/parse_obj.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <span>

#include "error.h"
#include "scene/obj_line_filter.h"
#include "scene/polygon_triangles.h"

namespace vernier {
namespace {

// Names here are the numbers that the filter gives to materials: the MTL files are read elsewhere.
class NumberReader : public tinyobj::MaterialReader {
 public:
  bool operator()(const std::string& name, std::vector<tinyobj::material_t>*, std::map<std::string, int>* ids,
                  std::string*, std::string*) override {
    int id = 0;
    std::from_chars(name.data(), name.data() + name.size(), id);
    ids->emplace(name, id);
    return true;
  }
};

struct ParsedObj {
  tinyobj::attrib_t arrays;
  std::vector<tinyobj::shape_t> shapes;
  ObjStatements statements;
};

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& what) {
  throw Error(ErrorKind::refused, file + ": line " + std::to_string(line) + ": " + what);
}

ParsedObj read_statements(const std::string& file, std::string text) {
  ParsedObj parsed;
  ObjLineFilter filter(file, std::move(text));
  std::istream stream(&filter);
  stream.exceptions(std::ios::badbit);  // without it the filter's errors are swallowed
  NumberReader materials;
  std::string warning;
  std::string error;
  // Triangulation stays off: it cuts concave quads along the wrong diagonal, and concave polygons away from the
  // origin wrongly.
  const bool done = tinyobj::LoadObj(&parsed.arrays, &parsed.shapes, nullptr, &warning, &error, &stream, &materials,
                                     /*triangulate=*/false, /*default_vcols_fallback=*/true);
  if (!done) refuse(file, filter.line(), "index 0 does not exist, indices count from 1 or back from -1");
  parsed.statements = filter.statements();
  return parsed;
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

template <int N>
std::vector<glm::vec<N, double>> vectors(const std::vector<double>& numbers) {
  std::vector<glm::vec<N, double>> result(numbers.size() / N);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (int c = 0; c < N; ++c) result[i][c] = numbers[i * N + static_cast<std::size_t>(c)];
  }
  return result;
}

void copy_arrays(const tinyobj::attrib_t& arrays, ObjGeometry& geometry) {
  geometry.positions = vectors<3>(arrays.vertices);
  geometry.uvs = vectors<2>(arrays.texcoords);
  geometry.normals = vectors<3>(arrays.normals);
  const bool colored = std::ranges::any_of(arrays.colors, [](double c) { return c != 1.0; });
  if (colored) geometry.colors = vectors<3>(arrays.colors);
}

// Walks the faces of all shapes in file order, the order in which the filter counted them.
class FaceCutter {
 public:
  FaceCutter(const std::string& file, const ObjStatements& statements, ObjGeometry& geometry)
      : file_(file), statements_(statements), geometry_(geometry) {}

  void add_shape(const tinyobj::shape_t& source) {
    ObjShape shape{source.name, {}};
    std::size_t first = 0;
    for (std::size_t face = 0; face < source.mesh.material_ids.size(); ++face) {
      const std::size_t count = statements_.face_corner_counts.at(face_);
      const std::span<const tinyobj::index_t> indices = std::span(source.mesh.indices).subspan(first, count);
      ObjTriangle pattern;
      pattern.material = source.mesh.material_ids[face];
      pattern.smoothing_group = source.mesh.smoothing_group_ids[face];
      add_face(indices, pattern, shape.triangles);
      first += count;
      ++face_;
    }
    if (!shape.triangles.empty()) geometry_.shapes.push_back(std::move(shape));
  }

 private:
  void add_face(std::span<const tinyobj::index_t> indices, ObjTriangle pattern, std::vector<ObjTriangle>& triangles) {
    corners_.clear();
    points_.clear();
    cuts_.clear();
    for (const tinyobj::index_t& index : indices) {
      corners_.push_back({index.vertex_index, index.texcoord_index, index.normal_index});
      check_corner(file_, statements_.face_lines[face_], corners_.back(), geometry_);
      points_.push_back(geometry_.positions[static_cast<std::size_t>(corners_.back().position)]);
    }
    append_polygon_triangles(points_, cuts_);
    for (const PolygonTriangle& cut : cuts_) {
      for (std::size_t i = 0; i < 3; ++i) pattern.corners[i] = corners_[cut[i]];
      triangles.push_back(pattern);
    }
  }

  const std::string& file_;
  const ObjStatements& statements_;
  ObjGeometry& geometry_;
  std::size_t face_ = 0;
  std::vector<ObjCorner> corners_;
  std::vector<glm::dvec3> points_;
  std::vector<PolygonTriangle> cuts_;
};

void note_left_out(const ObjStatements& statements, ObjGeometry& geometry) {
  if (statements.thin_element_count > 0) {
    geometry.unsupported.push_back("line " + std::to_string(statements.thin_element_line) +
                                   ": lines and points are not drawn (" +
                                   std::to_string(statements.thin_element_count) + ")");
  }
  if (!statements.unknown_keywords.empty()) {
    std::size_t line = SIZE_MAX;
    std::string list;
    for (const auto& [keyword, first_line] : statements.unknown_keywords) {
      line = std::min(line, first_line);
      list += (list.empty() ? "" : ", ") + keyword;
    }
    geometry.unsupported.push_back("line " + std::to_string(line) + ": statements that are not supported: " + list);
  }
  if (statements.short_face_count > 0) {
    geometry.faults.push_back("line " + std::to_string(statements.short_face_line) +
                              ": faces of fewer than 3 corners are left out (" +
                              std::to_string(statements.short_face_count) + ")");
  }
}

}  // namespace

ObjGeometry parse_obj(const std::string& file, std::string text) {
  const ParsedObj parsed = read_statements(file, std::move(text));
  ObjGeometry geometry;
  copy_arrays(parsed.arrays, geometry);
  FaceCutter cutter(file, parsed.statements, geometry);
  for (const tinyobj::shape_t& shape : parsed.shapes) cutter.add_shape(shape);
  geometry.material_names = parsed.statements.material_names;
  geometry.material_libraries = parsed.statements.material_libraries;
  note_left_out(parsed.statements, geometry);
  return geometry;
}

}  // namespace vernier
