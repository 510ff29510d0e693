// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shader/compile.hpp"
#include "shader/internal/compiler_process.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace error_test {

using test::fixture;
using test::kernel;
using test::message_of;
using test::with_fixtures;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string error_of(const Source& source) {
    return message_of<CompileError>([&] { static_cast<void>(compile(source, with_fixtures())); });
}

TEST(CompileErrorMessage, NamesFileAndLineOfTheText) {
    EXPECT_EQ(error_of({"bad.comp", "#version 450\nvoid main() {\n    foo();\n}\n"}),
              "bad.comp:3: 'foo' : no matching overloaded function found");
}

TEST(CompileErrorMessage, NamesFileAndLineOfTheInclude) {
    EXPECT_EQ(error_of(kernel("#include \"broken/inner.glsl\"", "1.0")),
              fixture("broken/inner.glsl").string() + ":9: 'not_declared' : undeclared identifier");
}

TEST(CompileErrorMessage, NamesFileAndLineOfANestedInclude) {
    EXPECT_EQ(error_of(kernel("\n\n#include \"broken/outer.glsl\"", "1.0")),
              fixture("broken/inner.glsl").string() + ":9: 'not_declared' : undeclared identifier");
}

TEST(CompileErrorMessage, LinesAfterAnIncludeAreCountedRight) {
    EXPECT_THAT(
        error_of({"after.comp", "#version 450\n#include \"math/hypot.glsl\"\nvoid main() { oops = 1; }\n"}),
        StartsWith("after.comp:3: 'oops'"));
}

TEST(CompileErrorMessage, ExtensionLineDoesNotShiftLines) {
    EXPECT_THAT(error_of({"ext.comp",
                          "#version 450\n#extension GL_GOOGLE_include_directive : require\n"
                          "#include \"math/hypot.glsl\"\nvoid main() { oops = 1; }\n"}),
                StartsWith("ext.comp:4: 'oops'"));
}

TEST(CompileErrorMessage, HasOneLinePerMessage) {
    const std::string message =
        error_of({"two.comp", "#version 450\nfloat f() { return a; }\nfloat g() { return b; }\n"});
    EXPECT_THAT(message, StartsWith("two.comp:2: 'a'"));
    EXPECT_THAT(message, HasSubstr("\ntwo.comp:3: 'b'"));
    EXPECT_THAT(message, AllOf(Not(HasSubstr("ERROR")), Not(HasSubstr("No code generated")),
                               Not(testing::EndsWith("\n"))));
}

TEST(CompileErrorMessage, LeavesWarningsOut) {
    const std::string message =
        error_of({"warn.comp", "#version 450\n#extension GL_NO_such : enable\nvoid main() { oops = 1; }\n"});
    EXPECT_THAT(message, StartsWith("warn.comp:3: 'oops'"));
    EXPECT_THAT(message, Not(HasSubstr("GL_NO_such")));
}

TEST(CompileErrorMessage, MissingIncludeNamesItsPlaceAndWhereItLooked) {
    const std::string message =
        error_of({"top.comp", "#version 450\n\n#include \"no/such.glsl\"\nvoid main() {}\n"});
    EXPECT_EQ(message, "top.comp:3: cannot find include \"no/such.glsl\"; looked for " +
                           fixture("no/such.glsl").string());
}

TEST(CompileErrorMessage, MissingIncludeOfAnIncludeNamesThatFile) {
    EXPECT_THAT(error_of(kernel("#include \"broken/missing.glsl\"", "1.0")),
                AllOf(StartsWith(fixture("broken/missing.glsl").string() + ":4: "),
                      HasSubstr("\"broken/nowhere.glsl\"")));
}

TEST(CompileErrorMessage, IncludeCycleIsSpeltOut) {
    const std::string a = fixture("cycle/a.glsl").string();
    const std::string b = fixture("cycle/b.glsl").string();
    EXPECT_EQ(error_of(kernel("#include \"cycle/a.glsl\"", "1.0")),
              b + ":5: include cycle: " + a + " -> " + b + " -> " + a);
}

TEST(CompileErrorMessage, FileThatIncludesItselfIsACycle) {
    const std::string self = fixture("cycle/self.glsl").string();
    EXPECT_EQ(error_of(kernel("#include \"cycle/self.glsl\"", "1.0")),
              self + ":2: include cycle: " + self + " -> " + self);
}

TEST(CompileErrorMessage, MissingBodyNamesTheFunction) {
    EXPECT_THAT(error_of(kernel("#include \"fetch.glsl\"", "fx_twice(ivec2(0))")),
                AllOf(StartsWith("kernel: "), HasSubstr(" fx_fetch_depth()"), Not(HasSubstr("\n"))));
    EXPECT_THAT(error_of(kernel("float nothing();", "nothing()")), testing::EndsWith(" nothing()"));
}

TEST(CompileErrorMessage, RecursionNamesTheFunction) {
    EXPECT_THAT(
        error_of(kernel("float f(float x) { return f(x - 1.0); }", "f(3.0)")),
        AllOf(StartsWith("kernel: "), HasSubstr("Recursion"), HasSubstr(" f()"), Not(HasSubstr("f1;"))));
}

TEST(CompileErrorMessage, MissingMainIsAnError) {
    EXPECT_THAT(error_of({"lib.comp", "#version 450\nfloat f() { return 1.0; }\n"}),
                StartsWith("lib.comp: "));
}

TEST(CompileErrorMessage, VersionLineMustComeFirstAndSuitVulkan) {
    EXPECT_THAT(error_of({"a.comp", ""}),
                AllOf(StartsWith("a.comp:1: "), HasSubstr("#version"), HasSubstr("found none")));
    EXPECT_THAT(error_of({"a.comp", "// licence\n\nvoid main() {}\n#version 450\n"}),
                StartsWith("a.comp:3: "));
    for (const char* version : {"110", "330", "999", "310", "300 es", "450 es", "450 compatibility", "x"}) {
        const std::string message =
            error_of({"a.comp", "// c\n#version " + std::string(version) + "\nvoid main() {}\n"});
        EXPECT_THAT(message, AllOf(StartsWith("a.comp:2: "), HasSubstr("found " + std::string(version))));
    }
    for (const char* version : {"430", "450", " 460   core // c"})
        EXPECT_EQ(error_of({"a.comp", "/* c */ # version " + std::string(version) + "\nvoid main() {}\n"}),
                  "")
            << version;
    for (const char* version : {"310 es", "320  es // c"})  // ES wants it before comments, too
        EXPECT_EQ(error_of({"a.comp", "#version " + std::string(version) + "\nvoid main() {}\n"}), "")
            << version;
}

// The compiler never prints, tested in this process; glslang would, for a version that its tables do not
// know.
TEST(CompileErrorMessage, NothingIsPrinted) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    for (const Source& source :
         {Source{"a.comp", "#version 110\nvoid main() {}\n"}, Source{"a.comp", "void main() {}\n"},
          kernel("#include \"broken/outer.glsl\"", "1.0")})
        EXPECT_THROW((void)internal::compile_here(source, with_fixtures()), CompileError);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace error_test
}  // namespace gloam::shader
