#include "scene/texel_memory.h"

#include <atomic>

#include "error.h"
#include "math/host_memory.h"

namespace vernier {
namespace {

std::atomic<std::uint64_t> claimed_bytes{0};

}  // namespace

void check_texel_memory(const std::string& name, std::uint64_t bytes, std::uint64_t others,
                        std::optional<std::uint64_t> there) {
  if (!there || bytes + others <= *there) return;
  const std::string beside = others > 0 ? " beside " + needed_memory_text(others) + " of others" : "";
  throw MemoryError(name + ": its texels need " + needed_memory_text(bytes) + " of the host's memory" + beside + ", " +
                    memory_there_text(*there) + " are there; make the textures smaller");
}

TexelClaim::~TexelClaim() {
  claimed_bytes -= bytes_;
}

void TexelClaim::take(const std::string& name, std::uint64_t bytes) {
  bytes_ = bytes;
  check_texel_memory(name, bytes, claimed_bytes.fetch_add(bytes), host_memory_there());
}

}  // namespace vernier
