#pragma once

#include "shader/shader.h"

namespace vernier::shader {

/// Kernels for a coarse BVH (bvh/coarse.h) or any, while it lives.
class CoarseKernel {
 public:
  explicit CoarseKernel(bool coarse) { COARSE = coarse; }
  ~CoarseKernel() { COARSE = false; }
  CoarseKernel(const CoarseKernel&) = delete;
  CoarseKernel& operator=(const CoarseKernel&) = delete;
};

}  // namespace vernier::shader
