// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shader/include.hpp"
#include "shader/language.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace flatten_test {

using Files = std::vector<std::filesystem::path>;

using test::fixture;
using test::message_of;
using test::TempDir;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string flat(const std::vector<std::string>& names) {
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names) files.push_back(fixture(name));
    return flatten(files, {FIXTURES});
}

std::string error_of(const std::string& name) {
    return message_of<std::runtime_error>([&] { static_cast<void>(flat({name})); });
}

TEST(Flatten, PutsDependenciesFirstAndDropsTheScaffolding) {
    EXPECT_EQ(flat({"math/hypot.glsl"}),
              "// SPDX-License-Identifier: MIT\n"
              "\n"
              "// x squared.\n"
              "float fx_square(float x) {\n"
              "    return x * x;\n"
              "}\n"
              "\n"
              "// Length of (x, y).\n"
              "float fx_hypot(float x, float y) {\n"
              "    return sqrt(fx_square(x) + fx_square(y));\n"
              "}\n");
}

TEST(Flatten, HoldsEachFileOnceInAnyOrder) {
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"math/hypot.glsl", "math/square.glsl", "math/hypot.glsl",
                                   "math/neighbour.glsl"},
          std::vector<std::string>{"math/neighbour.glsl", "math/../math/square.glsl", "math/hypot.glsl"}}) {
        const std::string text = flat(names);
        EXPECT_EQ(text.find("float fx_square("), text.rfind("float fx_square("));
        EXPECT_EQ(text.find("SPDX"), text.rfind("SPDX"));
        EXPECT_THAT(text, AllOf(HasSubstr("fx_cube"), HasSubstr("fx_hypot")));
    }
}

TEST(Flatten, CompilesInEveryLanguage) {
    for (const Language language : {Language::vulkan450, Language::gl330, Language::es300, Language::es310})
        EXPECT_NO_THROW(check_compiles(
            {"flat", flat({"math/hypot.glsl", "math/neighbour.glsl", "fetch.glsl", "types.glsl"})}, language,
            {}));
}

TEST(Flatten, KeepsWhatIsNotScaffolding) {
    EXPECT_EQ(flat({"pack/odd.glsl"}),
              "// SPDX-License-Identifier: MIT\n"
              "\n"
              "/* This comment stays,\n"
              "#include \"pack/conditional.glsl\"\n"
              "   and so does its second half. */\n"
              "\n"
              "// Before the include.\n"
              "const float FX_HALF = 0.5;\n"
              "\n"
              "// x squared.\n"
              "float fx_square(float x) {\n"
              "    return x * x;\n"
              "}\n"
              "\n"
              "// Length of (x, y).\n"
              "float fx_hypot(float x, float y) {\n"
              "    return sqrt(fx_square(x) + fx_square(y));\n"
              "}\n"
              "\n"
              "#ifdef FX_NEVER\n"
              "#define FX_SCALE 3.0\n"
              "#else\n"
              "#define FX_SCALE 2.0\n"
              "#endif\n"
              "\n"
              "// Uses all of it.\n"
              "float fx_odd(float x) {\n"
              "    return FX_SCALE * fx_hypot(x, FX_HALF);\n"
              "}\n");
    EXPECT_NO_THROW(check_compiles({"flat", flat({"pack/odd.glsl"})}, Language::es300, {}));
}

TEST(Flatten, OtherConditionsAreNoGuards) {
    const TempDir dir;
    for (const char* text : {"#ifndef A\n#define A 2.0\n#endif\nfloat f() { return A; }\n",  // code after it
                             "#ifndef A\n#define B\n#endif\n",                               // another name
                             "#ifndef A\n#define A\nfloat x;\n#else\nfloat y;\n#endif\n",  // a second branch
                             "#ifndef A\n#define A\n#endif\n#ifndef B\n#define B\n#endif\n"}) {  // ends early
        EXPECT_EQ(flatten(Files{dir.write("f.glsl", text)}, {}), text);
    }
}

TEST(Flatten, OtherExtensionsMoveToTheTop) {
    const TempDir dir;
    const auto first = dir.write("a.glsl", "// SPDX-License-Identifier: MIT\nfloat a;\n");
    const auto second = dir.write("b.glsl", "# extension GL_X : enable // why\n#version 450\nfloat b;\n");
    EXPECT_EQ(flatten(Files{first, second}, {}),
              "// SPDX-License-Identifier: MIT\n#extension GL_X : enable\n\nfloat a;\n\nfloat b;\n");
}

TEST(Flatten, EveryLicenceStaysOnce) {
    const TempDir dir;
    const auto mit = dir.write("a.glsl", "// SPDX-License-Identifier: MIT\nfloat a;\n");
    const auto other = dir.write("b.glsl", "// SPDX-License-Identifier: Apache-2.0\r\nfloat b;\r\n");
    const auto again = dir.write("c.glsl", "// SPDX-License-Identifier: MIT \nfloat c;\n");
    EXPECT_EQ(flatten(Files{mit, other, again}, {}),
              "// SPDX-License-Identifier: MIT\n// SPDX-License-Identifier: Apache-2.0\n\n"
              "float a;\n\nfloat b;\n\nfloat c;\n");
}

TEST(Flatten, NothingMakesNothing) {
    const TempDir dir;
    EXPECT_EQ(flatten(Files{}, {}), "");
    EXPECT_EQ(flatten(Files{dir.write("empty.glsl", "")}, {}), "");
}

TEST(Flatten, RefusesAnIncludeUnderACondition) {
    EXPECT_THAT(
        error_of("pack/conditional.glsl"),
        AllOf(StartsWith(fixture("pack/conditional.glsl").string() + ":6: "), HasSubstr("math/square.glsl")));
}

TEST(Flatten, RefusesCycles) {
    EXPECT_THAT(error_of("cycle/a.glsl"),
                AllOf(HasSubstr("include cycle: " + fixture("cycle/a.glsl").string()),
                      HasSubstr("cycle/b.glsl -> ")));
    EXPECT_THAT(error_of("cycle/self.glsl"), HasSubstr("include cycle"));
}

TEST(Flatten, NamesWhatIsMissing) {
    EXPECT_THAT(error_of("broken/missing.glsl"),
                AllOf(StartsWith(fixture("broken/missing.glsl").string() + ":4: "),
                      HasSubstr("broken/nowhere.glsl")));
    EXPECT_THAT(error_of("none.glsl"), HasSubstr(fixture("none.glsl").string()));
}

}  // namespace flatten_test
}  // namespace gloam::shader
