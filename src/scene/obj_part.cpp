#include "scene/obj_part.h"

#include <algorithm>
#include <charconv>
#include <istream>

#include "error.h"
#include "scene/text_words.h"

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

/// Takes out the face that marks the end, which is the last one, and notes what it tells.
void take_mark(ObjPart& part) {
  tinyobj::shape_t& last = part.shapes.back();
  tinyobj::mesh_t& mesh = last.mesh;
  part.last_shape = last.name;
  part.last_material = mesh.material_ids.back();
  part.last_smoothing_group = mesh.smoothing_group_ids.back();
  mesh.indices.resize(mesh.indices.size() - 3);
  mesh.num_face_vertices.pop_back();
  mesh.material_ids.pop_back();
  mesh.smoothing_group_ids.pop_back();
  part.last_shape_has_faces = !mesh.material_ids.empty();
  if (!part.last_shape_has_faces) part.shapes.pop_back();
}

}  // namespace

ObjPart read_obj_part(const std::string& file, std::string_view text) {
  ObjPart part;
  ObjLineFilter filter(file, text);
  std::istream stream(&filter);
  stream.exceptions(std::ios::badbit);  // without it the filter's errors are swallowed
  NumberReader materials;
  std::string warning;
  std::string error;
  // Triangulation stays off: it cuts concave quads along the wrong diagonal, and concave polygons away from the
  // origin wrongly.
  const bool done = tinyobj::LoadObj(&part.arrays, &part.shapes, nullptr, &warning, &error, &stream, &materials,
                                     /*triangulate=*/false, /*default_vcols_fallback=*/true);
  if (!done) {  // newer versions see it themselves
    throw Error(ErrorKind::refused, file + ": line " + std::to_string(filter.line()) +
                                        ": a vertex index counts back before the first vertex");
  }
  part.statements = filter.statements();
  take_mark(part);
  return part;
}

std::vector<std::string_view> split_obj(std::string_view text, std::size_t count) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= count && begin < text.size(); ++i) {
    std::size_t end = i == count ? text.size() : std::max(begin, text.size() / count * i);
    do {
      end = text.find('\n', end);
      end = end == std::string_view::npos ? text.size() : end + 1;
    } while (end < text.size() && trimmed(text.substr(begin, end - 1 - begin)).ends_with('\\'));
    parts.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

}  // namespace vernier
