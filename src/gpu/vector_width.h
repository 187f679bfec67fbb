#pragma once

#include <string>

namespace vernier {

/// Whether the processor has vectors of 512 bits (AVX-512 with its VL part) and the system keeps them.
bool has_wide_vectors();

/// Has llvmpipe, Mesa's driver for processors, trace 16 rays at a time instead of 8 where the processor has wide
/// vectors: that pays even where they take twice as long as narrow ones (AMD's Zen 4). The driver reads that from the
/// environment (LP_NATIVE_VECTOR_WIDTH) when it is loaded; what the caller's environment says stays. The driver's cache
/// of kernels, which does not look at the width, gets a folder of its own for each that is set (MESA_SHADER_CACHE_DIR,
/// which Mesa's other drivers go by as well). To be called before there are threads and a VulkanInstance.
void choose_vector_width();

/// Takes back wide vectors that the environment asks llvmpipe for: it cannot draw triangles with them, nor, in newer
/// versions, build the trees of its ray queries. To be called in place of choose_vector_width.
void keep_vectors_narrow();

/// The name of a device without the width of its vectors, which llvmpipe tells in it, `llvmpipe (LLVM 15.0.6, 256
/// bits)`: no bit of a picture hangs on that.
std::string without_vector_width(const std::string& name);

}  // namespace vernier
