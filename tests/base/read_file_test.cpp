// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "support/files.hpp"

namespace gloam::base {
namespace read_file_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ReadFile, IsEveryByte) {
    const test::TemporaryDirectory scratch;
    const auto path = scratch.path() / "a";
    const std::string bytes("a\0b\r\n\xff", 6);
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_EQ(read_file(path), bytes);
    EXPECT_EQ(read_file(path, bytes.size()), bytes);
}

TEST(ReadFile, WhatCannotBeReadIsNamed) {
    const test::TemporaryDirectory scratch;
    EXPECT_THAT([&] { (void)read_file(scratch.path() / "none"); },
                ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("none"), HasSubstr("No such file"))));
    EXPECT_THAT([&] { (void)read_file(scratch.path()); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr(scratch.path().string()), HasSubstr("Is a directory"))));
}

TEST(ReadFile, ADeviceWithoutEndIsTooLong) {
    EXPECT_THAT([] { (void)read_file("/dev/zero", 100'000); },
                ThrowsMessage<std::runtime_error>(HasSubstr("/dev/zero: it is longer than 100000 bytes")));
}

}  // namespace read_file_test
}  // namespace gloam::base
