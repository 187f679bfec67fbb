#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace vernier {

/// `json` on one line. Names in files may be in any encoding: what is not UTF-8 becomes U+FFFD.
template <typename Json>
std::string json_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The same as the text of a file, indented by two.
template <typename Json>
std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace vernier
