// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

namespace gloam::base {
namespace json_bounds_test {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

std::string object_of(std::size_t members) {
    return "{" + repeated(R"("a": [1, 2], )", members - 1) + R"("b": 0})";
}

TEST(JsonBounds, DepthEndsAtItsBound) {
    const JsonBounds bounds{.depth = 10};
    EXPECT_NO_THROW(require_bounded_json(repeated("[", 10) + repeated("]", 10), bounds));
    EXPECT_THAT([&] { require_bounded_json("\n\n" + repeated("[", 11), bounds); },
                ThrowsMessage<std::runtime_error>(HasSubstr("line 3: nested more than 10 deep")));
    EXPECT_THAT([&] { require_bounded_json(repeated("{\"a\":", 11), bounds); },
                ThrowsMessage<std::runtime_error>(HasSubstr("nested")));
}

TEST(JsonBounds, WhatIsClosedDoesNotCount) {
    EXPECT_NO_THROW(require_bounded_json("[" + repeated("[],", 100'000) + "[]]", {.depth = 2}));
}

TEST(JsonBounds, BracketsInStringsAreText) {
    EXPECT_NO_THROW(require_bounded_json(R"(["[[[[\"[[[[", "\\", "{{{"])", {.depth = 1}));
    EXPECT_THROW(require_bounded_json(R"(["\\", [[)", {.depth = 1}), std::runtime_error);
}

TEST(JsonBounds, AnObjectHasSoManyMembers) {
    EXPECT_NO_THROW(require_bounded_json(object_of(100), {.members = 100}));
    EXPECT_THAT([] { require_bounded_json(object_of(101), {.members = 100}); },
                ThrowsMessage<std::runtime_error>(HasSubstr("more than 100 members")));
}

TEST(JsonBounds, BytesEndAtTheirBound) {
    EXPECT_NO_THROW(require_bounded_json("[1,2]", {.bytes = 5}));
    EXPECT_THAT([] { require_bounded_json("[1, 2]", {.bytes = 5}); },
                ThrowsMessage<std::runtime_error>(HasSubstr("6 bytes of JSON, expected at most 5")));
}

TEST(JsonBounds, WhatIsNoJsonIsLeftToTheParser) {
    for (const char* text : {"", "]]]]", "\"", "\"\\", "}{", "nonsense"})
        EXPECT_NO_THROW(require_bounded_json(text)) << text;
}

}  // namespace json_bounds_test
}  // namespace gloam::base
