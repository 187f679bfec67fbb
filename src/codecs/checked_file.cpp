#include "codecs/checked_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace vernier {

namespace {

// "+": the TIFF library reads its own directory back. Whoever opens a pipe so is its own reader, and waits for nobody.
const char* mode_for(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_fifo(path, ignored) ? "wb" : "w+b";
}

}  // namespace

CheckedFile::CheckedFile(const std::string& path)
    : IOProxy(path, Write), file_(std::fopen(path.c_str(), mode_for(path))) {
  if (!file_) note_failure();
}

CheckedFile::~CheckedFile() {
  finish();
}

const std::string& CheckedFile::finish() {
  if (file_ && std::fclose(file_) != 0) note_failure();
  file_ = nullptr;
  return failure_;
}

void CheckedFile::note_failure() {
  if (failure_.empty()) failure_ = std::generic_category().message(errno);
}

bool CheckedFile::seek(int64_t offset) {
  if (offset < 0) return false;
  m_pos = offset;
  // Always a real seek: C asks for one between reading and writing.
  if (failure_.empty() && fseeko(file_, offset, SEEK_SET) != 0) note_failure();
  return true;
}

std::size_t CheckedFile::read(void* buffer, std::size_t size) {
  if (!failure_.empty()) return 0;
  seek(m_pos);
  const std::size_t count = std::fread(buffer, 1, size, file_);
  seek(m_pos + static_cast<int64_t>(count));
  return count;
}

std::size_t CheckedFile::write(const void* buffer, std::size_t size) {
  if (failure_.empty() && std::fwrite(buffer, 1, size, file_) != size) note_failure();
  m_pos += static_cast<int64_t>(size);
  end_ = std::max(end_, m_pos);
  return size;
}

std::size_t CheckedFile::pread(void* buffer, std::size_t size, int64_t offset) {
  const int64_t position = m_pos;
  seek(offset);
  const std::size_t count = read(buffer, size);
  seek(position);
  return count;
}

std::size_t CheckedFile::pwrite(const void* buffer, std::size_t size, int64_t offset) {
  const int64_t position = m_pos;
  seek(offset);
  write(buffer, size);
  seek(position);
  return size;
}

}  // namespace vernier
