// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace gloam::base {
namespace base64_test {

std::string of(std::string_view text) {
    return base64(std::vector<unsigned char>(text.begin(), text.end()));
}

// The test vectors of RFC 4648, section 10.
TEST(Base64Test, GivesTheVectorsOfTheStandard) {
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foob"), "Zm9vYg==");
    EXPECT_EQ(of("fooba"), "Zm9vYmE=");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(Base64Test, TakesAnyByte) {
    EXPECT_EQ(base64(std::vector<unsigned char>{0xff, 0xfe, 0x00, 0xfb}), "//4A+w==");
}

}  // namespace base64_test
}  // namespace gloam::base
