#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdint>
#include <cstdio>
#include <string>

namespace vernier {

/// A new file that an image codec writes through, and that remembers the first failure. Several codecs never ask
/// whether a write worked (PNG, HDR), others end the process when one fails while they shut down (EXR); so from the
/// first failure on this file claims that all is well, and the owner asks finish.
class CheckedFile : public OIIO::Filesystem::IOProxy {
 public:
  /// Opens `path` for writing and empties it. A failure shows in finish.
  explicit CheckedFile(const std::string& path);
  ~CheckedFile() override;
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;

  /// Closes the file. Returns the reason of the first failure since it was opened, an empty text when all bytes have
  /// reached the file. A second call returns the same.
  const std::string& finish();

  const char* proxytype() const override { return "checked"; }
  bool seek(int64_t offset) override;
  std::size_t read(void* buffer, std::size_t size) override;
  std::size_t write(const void* buffer, std::size_t size) override;
  std::size_t pread(void* buffer, std::size_t size, int64_t offset) override;
  std::size_t pwrite(const void* buffer, std::size_t size, int64_t offset) override;
  std::size_t size() const override { return static_cast<std::size_t>(end_); }

 private:
  void note_failure();

  std::FILE* file_ = nullptr;
  int64_t end_ = 0;
  std::string failure_;
};

}  // namespace vernier
