#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/pack_scene.h"
#include "shared/film_layout.h"
#include "shared/render_constants.h"

namespace vernier::shader {

/// What shaders/buffers.glsl binds on a device, as plain vectors. Indices outside throw std::out_of_range.
struct Memory {
  RenderConstants render{};
  DispatchConstants dispatch{};
  std::vector<glm::uvec4> records, vertices, materials, lights, textures, paths, samples, instances;
  std::vector<std::uint32_t> texels, first_triangles, film, counters, aovs, pixels;
};

/// The memory the running thread's shader functions read and write. The test owns it.
inline thread_local Memory* memory = nullptr;

/// Lets the shader functions work on `bound` while it lives.
class BoundMemory {
 public:
  explicit BoundMemory(Memory& bound) : before_(memory) { memory = &bound; }
  ~BoundMemory() { memory = before_; }
  BoundMemory(const BoundMemory&) = delete;
  BoundMemory& operator=(const BoundMemory&) = delete;

 private:
  Memory* before_;
};

/// `words` four by four, as a texel buffer shows them.
inline std::vector<glm::uvec4> texels_of(std::span<const std::uint32_t> words) {
  std::vector<glm::uvec4> texels(words.size() / 4);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    texels[i] = {words[4 * i], words[4 * i + 1], words[4 * i + 2], words[4 * i + 3]};
  }
  return texels;
}

inline std::vector<glm::uvec4> record_texels(const Bvh& bvh) {
  std::vector<std::uint32_t> words;
  for (const BvhRecord& record : bvh.records) words.insert(words.end(), record.begin(), record.end());
  return texels_of(words);
}

/// The arrays of a packed scene; camera and settings are set already.
inline Memory memory_of(const PackedScene& packed) {
  Memory filled;
  filled.render = packed.constants;
  filled.dispatch.steering = packed.steering;
  filled.records = record_texels(packed.bvh);
  filled.vertices = texels_of(packed.vertices);
  filled.materials = texels_of(packed.materials);
  filled.lights = texels_of(packed.lights);
  filled.textures = texels_of(packed.textures);
  filled.texels = packed.texels;
  filled.first_triangles = packed.first_triangles;
  filled.instances = texels_of(packed.instances);
  filled.counters.assign(COUNTER_COUNT, 0u);
  return filled;
}

}  // namespace vernier::shader
