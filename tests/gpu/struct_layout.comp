#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// Writes every field of the shared structs, by name, one word after the other.
#include "shared/glsl.h"
#include "shared/instance_layout.h"
#include "shared/material_layout.h"
#include "shared/render_constants.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) uniform Render { RenderConstants render; };
layout(set = 0, binding = 1, scalar) readonly buffer Scene {
  DispatchConstants dispatch;
  DeviceMaterial material;
  DeviceTextureUse use;
  DeviceLight light;
  DeviceInstance instance;
};
layout(set = 0, binding = 2, scalar) writeonly buffer Words { uint words[]; };

#define WORD(field) words[next++] = field;
#define NUMBER(field) words[next++] = floatBitsToUint(field);
#define VEC(field) NUMBER(field.x) NUMBER(field.y) NUMBER(field.z)

void main() {
  uint next = 0u;
#include "../tests/gpu/layout_fields.h"
}
