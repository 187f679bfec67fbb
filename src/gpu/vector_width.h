#pragma once

#include <optional>
#include <string>

namespace vernier {

/// Nanoseconds that as many additions of vectors take.
struct AdditionTimes {
  double bits_256;
  double bits_512;
};

/// Measured on this processor: the least of several runs, 0.04 ms in all. None where it has no vectors of 512 bits.
std::optional<AdditionTimes> time_additions();

/// Whether a vector of 512 bits takes so much less than two of 256 that llvmpipe gains by it: about as long as one
/// (AMD's Zen 5, which gains 1.41) or, with two units for them instead of three, 1.5 times as long (Intel's Xeons, 1.00
/// on one and 1.07 to 1.18 on another). With units of half the width it takes twice as long.
bool are_wide_vectors_fast(const AdditionTimes& times);

/// Has llvmpipe, Mesa's driver for processors, trace 16 rays at a time instead of 8 where the processor's wide vectors
/// are fast. The driver reads that from the environment (LP_NATIVE_VECTOR_WIDTH) when it is loaded; what the caller's
/// environment says stays. The driver's cache of kernels, which does not look at the width, gets a folder of its own
/// for each that is set (MESA_SHADER_CACHE_DIR, which Mesa's other drivers go by as well). To be called before there
/// are threads and a VulkanInstance.
void choose_vector_width();

/// Takes back wide vectors that the environment asks llvmpipe for: it cannot draw triangles with them, nor, in newer
/// versions, build the trees of its ray queries. To be called in place of choose_vector_width.
void keep_vectors_narrow();

/// The name of a device without the width of its vectors, which llvmpipe tells in it, `llvmpipe (LLVM 15.0.6, 256
/// bits)`: no bit of a picture hangs on that.
std::string without_vector_width(const std::string& name);

}  // namespace vernier
