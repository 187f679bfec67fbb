#include "scene/texel_memory.h"

#include "error.h"
#include "math/host_memory.h"

namespace vernier {

void claim_texel_memory(MemoryClaim& claim, const std::string& name, std::uint64_t bytes) {
  check_texel_memory(name, bytes, claim.take(bytes));
}

void check_texel_memory(const std::string& name, std::uint64_t bytes, std::uint64_t there) {
  if (bytes <= there) return;
  throw MemoryError(name + ": it needs " + needed_memory_text(bytes) + " of the host's memory, " +
                    memory_there_text(there) + " are there; make the textures smaller");
}

}  // namespace vernier
