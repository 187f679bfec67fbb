#include "scene/parse_obj.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "error.h"
#include "math/parallel_for.h"
#include "scene/obj_faces.h"
#include "scene/obj_part.h"

namespace vernier {
namespace {

template <int N>
void append_vectors(const std::vector<double>& numbers, std::vector<glm::vec<N, double>>& result) {
  const std::size_t first = result.size();
  result.resize(first + numbers.size() / N);
  for (std::size_t i = first; i < result.size(); ++i) {
    for (int c = 0; c < N; ++c) result[i][c] = numbers[(i - first) * N + static_cast<std::size_t>(c)];
  }
}

void append_arrays(const std::vector<ObjPart>& parts, ObjGeometry& geometry) {
  bool colored = false;
  for (const ObjPart& part : parts) {
    append_vectors(part.arrays.vertices, geometry.positions);
    append_vectors(part.arrays.texcoords, geometry.uvs);
    append_vectors(part.arrays.normals, geometry.normals);
    colored |= std::ranges::any_of(part.arrays.colors, [](double c) { return c != 1.0; });
  }
  if (!colored) return;
  for (const ObjPart& part : parts) append_vectors(part.arrays.colors, geometry.colors);
}

/// Numbers the materials of all parts by their first use, and says what each part goes on with.
std::vector<CarriedState> carry_states(const std::vector<ObjPart>& parts, ObjGeometry& geometry) {
  std::map<std::string, int> numbers;
  std::vector<CarriedState> states;
  CarriedState state;
  for (const ObjPart& part : parts) {
    const ObjStatements& statements = part.statements;
    state.material_of_number.clear();
    for (const std::string& name : statements.material_names) {
      const auto [found, is_new] = numbers.emplace(name, static_cast<int>(geometry.material_names.size()));
      if (is_new) geometry.material_names.push_back(name);
      state.material_of_number.push_back(found->second);
    }
    states.push_back(state);
    state.lines += statements.lines;
    if (part.last_material >= 0)
      state.material = state.material_of_number[static_cast<std::size_t>(part.last_material)];
    if (statements.first_smoothing_face != kNoFace) state.smoothing_group = part.last_smoothing_group;
  }
  return states;
}

/// Appends the shapes of the parts, of which one may go on in the next.
void append_shapes(const std::vector<ObjPart>& parts, std::vector<std::vector<ObjShape>> shapes_of_parts,
                   ObjGeometry& geometry) {
  std::string name;   // of the last `g` or `o`
  bool open = false;  // the last shape goes on
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t first_group_face = parts[i].statements.first_group_face;
    std::size_t face = 0;
    for (std::size_t k = 0; k < shapes_of_parts[i].size(); ++k) {
      ObjShape& shape = shapes_of_parts[i][k];
      if (face < first_group_face && open) {
        std::vector<ObjTriangle>& before = geometry.shapes.back().triangles;
        before.insert(before.end(), shape.triangles.begin(), shape.triangles.end());
      } else {
        if (face < first_group_face) shape.name = name;
        geometry.shapes.push_back(std::move(shape));
      }
      open = true;
      face += parts[i].shapes[k].mesh.material_ids.size();
    }
    if (first_group_face == kNoFace) continue;
    name = parts[i].last_shape;
    open = parts[i].last_shape_has_faces;
  }
}

/// Adds what a part of the file, `lines_before` from its start, has beside its geometry.
void append_statements(const ObjStatements& part, std::size_t lines_before, ObjStatements& sum) {
  for (const std::string& library : part.material_libraries) {
    if (std::ranges::find(sum.material_libraries, library) == sum.material_libraries.end())
      sum.material_libraries.push_back(library);
  }
  if (sum.thin_element_count == 0) sum.thin_element_line = lines_before + part.thin_element_line;
  sum.thin_element_count += part.thin_element_count;
  if (sum.short_face_count == 0) sum.short_face_line = lines_before + part.short_face_line;
  sum.short_face_count += part.short_face_count;
  std::vector<std::pair<std::size_t, std::string>> unknown;
  for (const auto& [keyword, line] : part.unknown_keywords) unknown.emplace_back(lines_before + line, keyword);
  std::ranges::sort(unknown);
  for (const auto& [line, keyword] : unknown) {
    if (sum.unknown_keywords.size() < kUnknownKeywordCount) sum.unknown_keywords.emplace(keyword, line);
  }
}

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

ObjGeometry join_parts(const std::string& file, const std::vector<ObjPart>& parts) {
  ObjGeometry geometry;
  append_arrays(parts, geometry);
  const std::vector<CarriedState> states = carry_states(parts, geometry);
  std::vector<std::vector<ObjShape>> shapes(parts.size());
  parallel_for(static_cast<unsigned>(parts.size()), parts.size(),
               [&](std::size_t i) { shapes[i] = cut_faces(file, parts[i], states[i], geometry); });
  append_shapes(parts, std::move(shapes), geometry);
  ObjStatements statements;
  for (std::size_t i = 0; i < parts.size(); ++i) append_statements(parts[i].statements, states[i].lines, statements);
  geometry.material_libraries = statements.material_libraries;
  note_left_out(statements, geometry);
  return geometry;
}

/// Whether parts cannot be read by themselves: indices that count back do so over all that stands before.
bool belong_together(const std::vector<ObjPart>& parts) {
  std::size_t libraries = 0;
  for (const ObjPart& part : parts) libraries += part.statements.material_libraries.size();
  return libraries > kMaxLibraries ||
         std::ranges::any_of(parts, [](const ObjPart& part) { return part.statements.counts_back; });
}

std::optional<ObjGeometry> parse_in_parts(const std::string& file, std::string_view text, std::size_t part_count) {
  const std::vector<std::string_view> texts = split_obj(text, part_count);
  std::vector<ObjPart> parts(texts.size());
  try {
    parallel_for(static_cast<unsigned>(texts.size()), texts.size(),
                 [&](std::size_t i) { parts[i] = read_obj_part(file, texts[i]); });
    if (belong_together(parts)) return std::nullopt;
    return join_parts(file, parts);
  } catch (const Error&) {
    return std::nullopt;  // read as a whole the first fault comes first, with its line in the file
  }
}

}  // namespace

ObjGeometry parse_obj(const std::string& file, std::string_view text, std::size_t part_count) {
  if (part_count > 1) {
    if (std::optional<ObjGeometry> geometry = parse_in_parts(file, text, part_count)) return std::move(*geometry);
  }
  std::vector<ObjPart> whole;
  whole.push_back(read_obj_part(file, text));
  return join_parts(file, whole);
}

}  // namespace vernier
