#pragma once

#include <gtest/gtest.h>

#include <string>

#include "error.h"

namespace vernier {

/// Expects that `call` throws Error(usage) with `part` in its line.
template <typename Call>
void expect_usage_error(const std::string& part, Call&& call) {
  try {
    call();
    ADD_FAILURE() << "accepted; expected an error with `" << part << "`";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace vernier
