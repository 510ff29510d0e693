// SPDX-License-Identifier: MIT
#include "check/scalars.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace gloam::check {
namespace scalars_test {

struct Mixed {
    bool flag;
    glm::vec3 position;
    int count;
    glm::mat2 matrix;
    unsigned bits;
};

template <class T>
T round_trip(const T& value) {
    std::vector<Word> words;
    append_words(value, words);
    std::span<const Word> rest = words;
    T back = take_words<T>(rest);
    RC_ASSERT(rest.empty());
    return back;
}

TEST(Scalars, ValuesSurviveAsWords) {
    EXPECT_TRUE(rc::check("any bit pattern of a float", [](unsigned bits) {
        RC_ASSERT(std::bit_cast<unsigned>(round_trip(std::bit_cast<float>(bits))) == bits);
    }));
    EXPECT_TRUE(
        rc::check("a structure, member by member", [](bool flag, int count, unsigned bits, short x, short y) {
            const Mixed mixed{flag, glm::vec3(x, y, 1), count, glm::mat2(x, y, y, x), bits};
            const Mixed back = round_trip(mixed);
            RC_ASSERT(back.flag == flag && back.count == count && back.bits == bits);
            RC_ASSERT(back.position == mixed.position && back.matrix == mixed.matrix);
        }));
}

TEST(Scalars, TypesAreThoseOfGlsl) {
    EXPECT_EQ(shader::to_glsl(type_of<glm::mat4x3>()), "mat4x3");
    EXPECT_EQ(shader::to_glsl(type_of<glm::uvec2>()), "uvec2");
    EXPECT_EQ(type_of<double>(), type_of<float>())
        << "references calculate in double what the shader has in float";
    EXPECT_EQ(scalar_count<Mixed>(), 10U);
    EXPECT_EQ(scalars_of(type_of<Mixed>()).size(), 10U);
    EXPECT_EQ(scalars_of(type_of<Mixed>()).front(), shader::Scalar::bool_);
}

}  // namespace scalars_test
}  // namespace gloam::check
