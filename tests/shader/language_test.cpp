// SPDX-License-Identifier: MIT
#include "shader/language.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace gloam::shader {
namespace language_test {

using test::fixture;
using test::message_of;
using testing::HasSubstr;
using testing::StartsWith;

constexpr Language all[] = {Language::vulkan450, Language::gl330, Language::es300, Language::es310,
                            Language::es320};

std::string error_of(const std::string& body, Language language) {
    return message_of<CompileError>([&] { check_compiles({"body", body}, language, {FIXTURES}); });
}

// The languages that accept the body.
std::string accepted_by(const std::string& body) {
    std::string names;
    for (const Language language : all)
        if (error_of(body, language).empty()) names += to_string(language) + " ";
    return names;
}

TEST(Language, HasANameAndIsFoundByIt) {
    for (const Language language : all) EXPECT_EQ(language_from(to_string(language)), language);
    EXPECT_EQ(to_string(Language::es310), "310es");
    for (const char* other : {"", "300", "310 es", "460", "gl330"})
        EXPECT_EQ(language_from(other), std::nullopt) << other;
}

TEST(Language, PreambleStartsWithTheVersion) {
    EXPECT_EQ(preamble(Language::vulkan450), "#version 450\n");
    EXPECT_THAT(preamble(Language::gl330), StartsWith("#version 330"));
    EXPECT_EQ(preamble(Language::es300),
              "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n");
    EXPECT_THAT(preamble(Language::es310), StartsWith("#version 310 es\nprecision highp"));
}

TEST(Language, IncludesAndUndefinedPrototypesCompileEverywhere) {
    for (const char* name : {"math/hypot.glsl", "math/neighbour.glsl", "fetch.glsl"})
        EXPECT_EQ(accepted_by("#include \"" + std::string(name) + "\"\n"), "450 330 300es 310es 320es ")
            << name;
}

TEST(Language, AnEmptyBodyCompiles) {
    EXPECT_EQ(accepted_by(""), "450 330 300es 310es 320es ");
}

TEST(Language, ABodyMayEndInAComment) {
    EXPECT_EQ(accepted_by("float f(float x) { return x; } // no newline"), "450 330 300es 310es 320es ");
}

TEST(Language, ImplicitConversionIsNotForEs) {
    EXPECT_EQ(accepted_by("float f(float x) { return x * 2; }"), "450 330 ");
}

TEST(Language, BitfieldFunctionsAreNewer) {
    EXPECT_EQ(accepted_by("uint f(uint x) { return bitfieldReverse(x); }"), "450 310es 320es ");
}

TEST(Language, DoublesAreForDesktop) {
    EXPECT_EQ(accepted_by("double f(double x) { return x; }"), "450 ");
}

TEST(Language, VulkanAloneRefusesFreeUniforms) {
    EXPECT_EQ(accepted_by("uniform float x;\nfloat f() { return x; }"), "330 300es 310es 320es ");
}

TEST(Language, RecursionCompilesNowhere) {
    EXPECT_EQ(accepted_by("float f(float x) { return f(x); }"), "");
}

TEST(Language, BodyLinesAreItsOwn) {
    for (const Language language : all)
        EXPECT_THAT(error_of("\nfloat f() {\n    return oops;\n}\n", language), StartsWith("body:3: 'oops'"))
            << to_string(language);
}

TEST(Language, ErrorsInIncludesNameTheInclude) {
    for (const Language language : all)
        EXPECT_THAT(error_of("#include \"broken/outer.glsl\"\n", language),
                    StartsWith(fixture("broken/inner.glsl").string() + ":9: "))
            << to_string(language);
    EXPECT_THAT(error_of("#include \"none.glsl\"\n", Language::es300),
                StartsWith("body:1: cannot find include"));
}

TEST(Language, UnknownLanguageIsRefused) {
    EXPECT_THROW(static_cast<void>(preamble(static_cast<Language>(99))), std::invalid_argument);
}

}  // namespace language_test
}  // namespace gloam::shader
