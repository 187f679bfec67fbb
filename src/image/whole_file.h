#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vernier {

/// The file that write_whole(path) makes or replaces: what a chain of symbolic links leads to, whether it is there or
/// not. Throws Error(failed) where links lead in a circle.
std::filesystem::path written_file(const std::string& path);

/// Writes the file `path` whole or not at all: `write` gets the name of a new empty file in the same folder, which
/// replaces `path` by a rename once `write` has returned. Where anything throws, that file is removed, an existing
/// `path` keeps its bytes, and the failure leaves as Error (failed unless `write` threw another kind).
/// A symbolic link is followed, so its target is replaced. What cannot be replaced by a rename (a device, a pipe) is
/// handed to `write` itself. Throws Error(failed) with `path` and the reason for a missing folder, a folder in place
/// of the file, no permission to write, a full disk.
void write_whole(const std::string& path, const std::function<void(const std::string& file)>& write);

/// Writes `text` byte for byte as the file `path`, whole or not at all, as write_whole does. An empty text makes an
/// empty file. `/dev/stdout` is the standard output.
void write_text(const std::string& path, std::string_view text);

}  // namespace vernier
