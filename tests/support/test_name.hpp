// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>

#include "support/test.hpp"

namespace gloam::test {

// A text as the name of a test's parameter, in which GoogleTest takes letters, digits and underscores only.
inline std::string test_name(std::string text) {
    std::ranges::replace_if(text, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return text;
}

}  // namespace gloam::test
