#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vernier {

/// Whether `uri` carries its content itself (RFC 2397).
bool is_data_uri(const std::string& uri);

/// The bytes a data URI carries, base64 or percent-encoded, whatever media type it names. White space within base64 is
/// skipped. Throws Error(refused) "`place`: ..." without a comma or with a character that base64 does not have.
std::vector<std::byte> decode_data_uri(const std::string& uri, const std::string& place);

/// The file a relative URI of a scene in `directory` means: percent-decoded (RFC 3986), joined to it.
/// A `%` without two hexadecimal digits stands for itself. Where no file has the decoded name but one has the
/// name as written, that one is meant: exporters forget to encode.
std::string path_from_uri(const std::string& uri, const std::string& directory);

}  // namespace vernier
