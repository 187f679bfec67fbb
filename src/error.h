#pragma once

#include <stdexcept>
#include <string>

namespace vernier {

/// What an Error means to the caller; the values are the program's exit codes.
enum class ErrorKind : int {
  failed = 1,      ///< the work was possible but failed (write error, non-finite pixel)
  usage = 2,       ///< the command line or the settings make no sense
  refused = 3,     ///< the input file is broken or asks for what is not supported
  no_device = 4,   ///< no usable Vulkan device
  device_lost = 5  ///< the device was lost during the work
};

/// A failure a user can act on. what() is one line: the input and the place in it, what is wrong, and where it
/// helps what to try, as in `scene.gltf: mesh 3, primitive 0: index 812 is beyond 600 vertices`.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind error_kind, const std::string& line) : std::runtime_error(line), kind_(error_kind) {}
  /// The kind given at construction.
  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

/// Throws Error(refused) for what is wrong at a `place`: a file, an element of it.
[[noreturn]] inline void refuse(const std::string& place, const std::string& what) {
  throw Error(ErrorKind::refused, place + ": " + what);
}

/// Refused for want of memory, which is not the input's fault: who goes on without a broken input lets this pass.
class MemoryError : public Error {
 public:
  explicit MemoryError(const std::string& line) : Error(ErrorKind::refused, line) {}
};

}  // namespace vernier
