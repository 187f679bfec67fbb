#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "error.h"

/// Expects `work` to throw Error of `kind` in one line that contains `part`.
inline void expect_error(vernier::ErrorKind kind, const std::string& part, const std::function<void()>& work) {
  try {
    work();
    ADD_FAILURE() << "no error; expected one with: " << part;
  } catch (const vernier::Error& error) {
    const std::string line = error.what();
    EXPECT_EQ(error.kind(), kind) << line;
    EXPECT_NE(line.find(part), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}
