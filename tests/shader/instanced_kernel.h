#pragma once

#include "shader/shader.h"

namespace vernier::shader {

/// Kernels for a scene with instances, while it lives.
class InstancedKernel {
 public:
  InstancedKernel() { INSTANCED = true; }
  ~InstancedKernel() { INSTANCED = false; }
  InstancedKernel(const InstancedKernel&) = delete;
  InstancedKernel& operator=(const InstancedKernel&) = delete;
};

}  // namespace vernier::shader
