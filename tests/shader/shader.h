#pragma once

// The text of shaders/*.glsl as C++ (shaders/README.md, "Compiled twice"). What specialization.glsl and buffers.glsl
// declare on a device stands here: specialization constants as variables, the bound buffers as vectors.

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/integer.hpp>

#include "shader/memory.h"
#include "shared/accuracy.h"
#include "shared/bindings.h"
#include "shared/bvh_record.h"
#include "shared/effects.h"
#include "shared/film_layout.h"
#include "shared/glsl.h"
#include "shared/material_layout.h"
#include "shared/render_constants.h"

// Each test uses a few of the functions only.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace vernier::shader {
namespace {

using glm::bvec3;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::uint;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using glm::abs;
using glm::bitfieldReverse;
using glm::clamp;
using glm::exp;
using glm::exp2;
using glm::findLSB;
using glm::floatBitsToInt;
using glm::floatBitsToUint;
using glm::floor;
using glm::log;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::pow;
using glm::sign;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::uvec2;

uint EFFECTS = 0xffffffffu;
constexpr uint TRAVERSAL_STACK_SIZE = 64u;
bool SHIFT_STACK = false;
uint PATH_STACK_SIZE = 18u;
bool COUNT_COST = false;
bool COUNT_EFFECTS = false;
bool LISTED_PIXELS = false;
bool INSTANCED = false;
bool COARSE = false;
bool TEST_LAST = false;
uint WORKFLOWS = ALL_WORKFLOWS;
uint LEVELS = LEVELS_OF(LEVEL_ROBUST);
uint MUTATION = MUTATION_NONE;
bool effect_on(uint effect) {
  return (EFFECTS & effect) != 0u;
}
uint level_at(uint spot) {
  return (LEVELS >> (2u * spot)) & 3u;
}
bool mutated(uint mutation) {
  return MUTATION == mutation;
}

RenderConstants render_constants() {
  return memory->render;
}
DispatchConstants dispatch_constants() {
  return memory->dispatch;
}
SteeringConstants steering_constants() {
  return memory->dispatch.steering;
}
bool scene_has_triangles() {
  return memory->dispatch.steering.triangle_count > 0u;
}
uvec4 load_record(uint i) {
  return memory->records.at(i);
}
uvec4 load_vertex(uint i) {
  return memory->vertices.at(i);
}
uvec4 load_material(uint i) {
  return memory->materials.at(i);
}
uvec4 load_light(uint i) {
  return memory->lights.at(i);
}
uvec4 load_texture(uint i) {
  return memory->textures.at(i);
}
uint load_texel(uint i) {
  return memory->texels.at(i);
}
uvec4 load_texel_quad(uint i) {
  return {load_texel(4 * i), load_texel(4 * i + 1), load_texel(4 * i + 2), load_texel(4 * i + 3)};
}
uint load_curve(uint i) {
  return load_texel(i);
}
uint load_first_triangle(uint i) {
  return memory->first_triangles.at(i);
}
uvec4 load_instance(uint i) {
  return memory->instances.at(i);
}
uvec4 load_film(uint i) {
  return {memory->film.at(4 * i), memory->film.at(4 * i + 1), memory->film.at(4 * i + 2), memory->film.at(4 * i + 3)};
}
void store_film(uint i, uvec4 block) {
  for (int k = 0; k < 4; ++k) memory->film.at(4 * i + k) = block[k];
}
uvec4 load_path(uint i) {
  return memory->paths.at(i);
}
void store_path(uint i, uvec4 block) {
  memory->paths.at(i) = block;
}
uvec4 load_sample(uint i) {
  return memory->samples.at(i);
}
void store_sample(uint i, uvec4 block) {
  memory->samples.at(i) = block;
}
uint load_pixel(uint i) {
  return memory->pixels.at(i);
}
void store_aov(uint i, uint word) {
  memory->aovs.at(i) = word;
}
void add_to_counter(uint i, uint amount) {
  memory->counters.at(i) += amount;
}
uint load_counter(uint i) {
  return memory->counters.at(i);
}
uint take_job() {
  return memory->counters.at(COUNTER_NEXT_JOB)++;
}

// The entry points include the stack first as well: the traversal calls it.
#include "traversal_stack.glsl"
// Separate blocks keep their order.
#include "accumulate_samples.glsl"
#include "primary.glsl"
#include "trace_jobs.glsl"

}  // namespace
}  // namespace vernier::shader

#pragma GCC diagnostic pop
