#pragma once

#include <glm/glm.hpp>
#include <string>

namespace vernier {

/// Why a window has no picture of `size` pixels, as words of an error; empty where it may.
std::string picture_fault(glm::ivec2 size);

}  // namespace vernier
