#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/obj_part.h"
#include "scene/parse_obj.h"

namespace vernier {

/// What a part goes on with from those before it.
struct CarriedState {
  std::size_t lines = 0;  ///< before it
  int material = -1;      ///< indexes ObjGeometry::material_names
  std::uint32_t smoothing_group = 0;
  std::vector<int> material_of_number;  ///< [material of the part]
};

/// The shapes of `part`, one after the other, their faces cut into triangles. `geometry` has the arrays of the whole
/// file. Throws Error(refused) with line where an index is beyond them.
std::vector<ObjShape> cut_faces(const std::string& file, const ObjPart& part, const CarriedState& state,
                                const ObjGeometry& geometry);

}  // namespace vernier
