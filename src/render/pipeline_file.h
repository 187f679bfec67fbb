#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace vernier {

/// A file of compiled pipelines that is larger is neither read nor kept: a pipeline takes some 100 KiB, and a new one
/// comes with every set of effects.
constexpr std::uint64_t kMostPipelineBytes = std::uint64_t{64} << 20;

/// What a file of compiled pipelines gave, and a line about it for the curious. No bytes: there was nothing of use.
struct StoredPipelines {
  std::vector<std::byte> bytes;
  std::string note;
};

/// Where the file `name` is kept from run to run: in $VERNIER_PIPELINE_CACHE, $XDG_CACHE_HOME/vernier or
/// $HOME/.cache/vernier, the first that is set to an absolute path. Empty, which means nowhere, when none is, or
/// VERNIER_PIPELINE_CACHE is `none`.
std::string cache_file(const std::string& name);

/// Where compiled pipelines of devices with `pipeline_key` are kept (cache_file).
std::string pipeline_file(const std::string& pipeline_key);

/// Reads `file`, if it was written by write_pipelines for this `pipeline_key`. A file that is missing, cut short,
/// damaged, of another device or driver, of another program version or too large gives no bytes: never an error. An
/// empty name gives nothing.
StoredPipelines read_pipelines(const std::string& file, const std::string& pipeline_key,
                               std::uint64_t most_bytes = kMostPipelineBytes);

/// Writes `bytes` as `file`, whole or not at all, and makes its folder. Returns a line about it. Bytes beyond
/// `most_bytes` are not written and the file is removed: the next run begins an empty one. Never an error; an empty
/// name does nothing.
std::string write_pipelines(const std::string& file, const std::string& pipeline_key, std::span<const std::byte> bytes,
                            std::uint64_t most_bytes = kMostPipelineBytes);

/// A device that finds pipelines in a file which earlier runs compiled.
class CachedDevice {
 public:
  /// Opens `description`, which list_devices(instance) gave, with what `file` holds. `instance` outlives it.
  /// `extensions` as of Device.
  CachedDevice(const VulkanInstance& instance, const DeviceDescription& description, std::string file,
               const std::vector<const char*>& extensions = {});

  const Device& device() const { return device_; }
  /// Writes the file, if pipelines have come in. Returns what came of reading and writing, for --verbose: never an
  /// error.
  std::string store() const;

 private:
  std::string file_;
  StoredPipelines stored_;
  Device device_;
};

}  // namespace vernier
