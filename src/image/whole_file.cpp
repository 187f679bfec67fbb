#include "image/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "error.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw Error(ErrorKind::failed, path + ": cannot write: " + reason);
}

std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

// The name is short and its own, so that a long `target` leaves room for it; "x" never opens a file of another writer.
fs::path create_beside(const fs::path& target, const std::string& path) {
  constexpr int kMostAttempts = 10000;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const fs::path candidate = target.parent_path() / (".vernier-partial-" + std::to_string(attempt));
    if (std::FILE* file = std::fopen(candidate.c_str(), "wbx")) {
      std::fclose(file);
      return candidate;
    }
    if (errno != EEXIST) fail(path, reason_of(errno));
  }
  fail(path, "the folder is full of unfinished files named .vernier-partial-*");
}

void write_and_rename(const fs::path& target, const std::string& path,
                      const std::function<void(const std::string&)>& write) {
  const fs::path partial = create_beside(target, path);
  try {
    write(partial.string());
    std::error_code error;
    fs::rename(partial, target, error);
    if (error) fail(path, error.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw;
  }
}

}  // namespace

fs::path written_file(const std::string& path) {
  constexpr int kMostLinks = 40;  // Linux gives up after as many
  fs::path file = path;
  std::error_code error;
  // Of a pipe the link in /dev/fd says no place that could be followed.
  if (fs::is_fifo(fs::status(file, error))) return file;
  for (int link = 0; fs::is_symlink(fs::symlink_status(file, error)); ++link) {
    if (link == kMostLinks) fail(path, reason_of(ELOOP));
    const fs::path next = fs::read_symlink(file, error);
    if (error) fail(path, error.message());
    file = file.parent_path() / next;  // an absolute `next` replaces all
  }
  return file;
}

void write_whole(const std::string& path, const std::function<void(const std::string& file)>& write) {
  if (path.empty()) fail("\"\"", "the file name is empty");
  try {
    const fs::path target = written_file(path);
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) fail(path, "it is a folder");
    // A rename would replace a write-protected file, since that only asks the folder.
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) fail(path, reason_of(errno));
    if (fs::exists(status) && !fs::is_regular_file(status)) return write(target.string());
    write_and_rename(target, path, write);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& exception) {
    fail(path, exception.what());
  }
}

void write_text(const std::string& path, std::string_view text) {
  // It may be a file that already holds what was printed, which another in its place would lose.
  if (path == "/dev/stdout") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail(path, reason_of(errno));
    return;
  }
  write_whole(path, [&](const std::string& name) {
    std::FILE* file = std::fopen(name.c_str(), "wb");
    if (!file) fail(path, reason_of(errno));
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const int write_error = errno;
    // The last buffer is written here, so this is where a full disk may show first.
    const bool closed = std::fclose(file) == 0;
    if (!written) fail(path, reason_of(write_error));
    if (!closed) fail(path, reason_of(errno));
  });
}

}  // namespace vernier
