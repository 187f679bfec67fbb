#version 460
#extension GL_EXT_scalar_block_layout : require

// Copies one texel of four words and four texels of one word to the same place of the output, times SCALE.
layout(local_size_x = 32) in;
layout(set = 0, binding = 0, rgba32ui) uniform readonly uimageBuffer wide;
layout(set = 0, binding = 1, r32ui) uniform readonly uimageBuffer narrow;
layout(set = 0, binding = 2, scalar) uniform Scale { uint scale; };
layout(set = 0, binding = 3, scalar) writeonly buffer Words { uint words[]; };

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= imageSize(wide)) return;
  uvec4 texel = imageLoad(wide, i);
  for (int k = 0; k < 4; ++k) words[8 * i + k] = texel[k] * scale;
  for (int k = 0; k < 4; ++k) words[8 * i + 4 + k] = imageLoad(narrow, 4 * i + k).x * scale;
}
