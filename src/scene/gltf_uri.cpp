#include "scene/gltf_uri.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "error.h"

namespace vernier {
namespace {

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// -1: not of the alphabet. The URL-safe alphabet (RFC 4648, section 5) is read too.
int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

/// Whether `text` is `word`, in any case of letters (RFC 3986, 3.1).
bool is_word(std::string_view text, std::string_view word) {
  return std::ranges::equal(text, word, {}, [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
}

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_value(text[i + 1]) >= 0 && hex_value(text[i + 2]) >= 0) {
      decoded += static_cast<char>(hex_value(text[i + 1]) * 16 + hex_value(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

std::vector<std::byte> base64_decoded(std::string_view text, const std::string& place) {
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t pending = 0;
  int pending_bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int value = base64_value(c);
    if (value < 0) throw Error(ErrorKind::refused, place + ": the data URI has a character that base64 does not have");
    pending = (pending << 6) | std::uint32_t(value);
    pending_bits += 6;
    if (pending_bits >= 8) {
      pending_bits -= 8;
      bytes.push_back(static_cast<std::byte>((pending >> pending_bits) & 0xFFu));
    }
  }
  return bytes;
}

}  // namespace

bool is_data_uri(const std::string& uri) {
  return is_word(std::string_view(uri).substr(0, 5), "data:");
}

std::vector<std::byte> decode_data_uri(const std::string& uri, const std::string& place) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos) throw Error(ErrorKind::refused, place + ": the data URI has no comma");
  const std::string_view head(uri.data(), comma);
  const std::string_view body(uri.data() + comma + 1, uri.size() - comma - 1);
  constexpr std::string_view kBase64 = ";base64";
  if (head.size() >= kBase64.size() && is_word(head.substr(head.size() - kBase64.size()), kBase64)) {
    return body.find('%') == std::string_view::npos ? base64_decoded(body, place)
                                                    : base64_decoded(percent_decoded(body), place);
  }
  const std::string decoded = percent_decoded(body);
  const auto* first = reinterpret_cast<const std::byte*>(decoded.data());
  return {first, first + decoded.size()};
}

std::string path_from_uri(const std::string& uri, const std::string& directory) {
  const std::filesystem::path folder(directory);
  std::error_code failure;
  const std::filesystem::path decoded = folder / percent_decoded(uri);
  if (std::filesystem::exists(decoded, failure)) return decoded.string();
  const std::filesystem::path as_written = folder / uri;
  return (std::filesystem::exists(as_written, failure) ? as_written : decoded).string();
}

}  // namespace vernier
