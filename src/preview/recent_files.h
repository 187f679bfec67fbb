#pragma once

#include <string>
#include <vector>

namespace vernier {

/// Where the scenes opened last are noted: $XDG_STATE_HOME/vernier/recent or $HOME/.local/state/vernier/recent, the
/// first that is set to an absolute path. Empty, which means nowhere, when neither is.
std::string recent_files_path();

/// The paths in `file`, the last one first; none where it cannot be read or is not named.
std::vector<std::string> read_recent_files(const std::string& file);

/// `files` with `opened` in front, once, and at most ten of them.
std::vector<std::string> with_recent(std::vector<std::string> files, const std::string& opened);

/// Writes `files` into `file`, whole or not at all, and makes its folder. That it cannot is no error: nothing hangs on
/// it.
void write_recent_files(const std::string& file, const std::vector<std::string>& files);

}  // namespace vernier
