// SPDX-License-Identifier: MIT
#include "shader/include.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "support.hpp"

namespace gloam::shader {
namespace include_test {

using test::fixture;
using test::message_of;
using test::TempDir;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::filesystem::path> paths(const std::vector<IncludedFile>& files) {
    std::vector<std::filesystem::path> result;
    for (const IncludedFile& file : files) result.push_back(file.path);
    return result;
}

TEST(Include, ReadsATextWhole) {
    const TempDir dir;
    EXPECT_EQ(read_text(dir.write("a.glsl", "one\r\ntwo")), "one\r\ntwo");
    EXPECT_EQ(read_text(dir.write("empty.glsl", "")), "");
    EXPECT_EQ(read_text(dir.write("marked.glsl", "\xef\xbb\xbfone")), "one");
}

TEST(Include, UnreadableTextIsNamed) {
    const TempDir dir;
    const auto read = [](const std::filesystem::path& file) {
        return message_of<std::runtime_error>([&] { static_cast<void>(read_text(file)); });
    };
    EXPECT_THAT(read(dir.path() / "none.glsl"), HasSubstr((dir.path() / "none.glsl").string()));
    EXPECT_THAT(read(dir.path()), AllOf(HasSubstr(dir.path().string()), HasSubstr("folder")));
}

TEST(Include, FilesThatWereReadAreListedOnceEach) {
    const TempDir dir;
    const auto file = dir.write("a.glsl", "");
    const char* before = std::getenv("GLOAM_DEPENDENCIES_OUTPUT");
    const std::optional<std::string> kept = before ? std::optional<std::string>(before) : std::nullopt;
    const auto list = dir.path() / "list";
    ::setenv("GLOAM_DEPENDENCIES_OUTPUT", list.c_str(), 1);
    static_cast<void>(read_text(file));
    static_cast<void>(read_text(dir.path() / "." / "a.glsl"));
    ::setenv("GLOAM_DEPENDENCIES_OUTPUT", (dir.path() / "none" / "list").c_str(), 1);
    EXPECT_EQ(read_text(file), "") << "a list that cannot be written stops nothing";
    if (kept) ::setenv("GLOAM_DEPENDENCIES_OUTPUT", kept->c_str(), 1);
    if (!kept) ::unsetenv("GLOAM_DEPENDENCIES_OUTPUT");
    EXPECT_EQ(read_text(list), std::filesystem::canonical(file).string() + "\n");
}

TEST(Include, OwnFolderComesBeforeTheRootsAndTheyInOrder) {
    const TempDir dir;
    const auto own = dir.write("own/a.glsl", "");
    const auto first = dir.write("first/a.glsl", "");
    const auto second = dir.write("second/a.glsl", "");
    const auto last = dir.write("second/b.glsl", "");
    const std::vector roots{first.parent_path(), second.parent_path(), dir.path()};
    EXPECT_EQ(resolve_include("a.glsl", own.parent_path(), roots), own);
    EXPECT_EQ(resolve_include("a.glsl", {}, roots), first);
    EXPECT_EQ(resolve_include("b.glsl", own.parent_path(), roots), last);
    EXPECT_EQ(resolve_include("../own/a.glsl", {}, roots), own);
    EXPECT_THAT(
        message_of<std::runtime_error>(
            [&] { (void)resolve_include("../own/a.glsl", {}, {first.parent_path()}); }),
        HasSubstr("outside the include roots, expected a file below " + first.parent_path().string()));
}

TEST(Include, MissingIncludeListsWhereItLooked) {
    const auto message = message_of<std::runtime_error>(
        [] { static_cast<void>(resolve_include("x/y.glsl", "/from", {"/one", "/two"})); });
    EXPECT_THAT(message, AllOf(HasSubstr("\"x/y.glsl\""), HasSubstr("/from/x/y.glsl"),
                               HasSubstr("/one/x/y.glsl"), HasSubstr("/two/x/y.glsl")));
    EXPECT_THROW(static_cast<void>(resolve_include("x", {}, {})), std::runtime_error);
}

TEST(Include, AFolderIsNoInclude) {
    EXPECT_THROW(static_cast<void>(resolve_include("math", {}, {FIXTURES})), std::runtime_error);
}

TEST(IncludeClosure, HoldsEachFileOnceInOrderOfMention) {
    const auto files = include_closure(
        "#include \"broken/outer.glsl\"\n#include \"math/square.glsl\"\n#include \"math/hypot.glsl\"\n",
        {FIXTURES});
    EXPECT_THAT(paths(files), ElementsAre(fixture("broken/outer.glsl"), fixture("math/square.glsl"),
                                          fixture("broken/inner.glsl"), fixture("math/hypot.glsl")));
    for (const IncludedFile& file : files) EXPECT_EQ(file.text, read_text(file.path));
}

TEST(IncludeClosure, LooksInTheFolderOfTheIncluder) {
    EXPECT_THAT(paths(include_closure("#include \"neighbour.glsl\"\n", {}, fixture("math"))),
                ElementsAre(fixture("math/neighbour.glsl"), fixture("math/square.glsl")));
    EXPECT_TRUE(include_closure("#include \"neighbour.glsl\"\n", {FIXTURES}).empty());
    EXPECT_TRUE(include_closure("#include <neighbour.glsl>\n", {}, fixture("math")).empty());
}

TEST(IncludeClosure, EndsOnCycles) {
    EXPECT_THAT(
        paths(include_closure("#include \"cycle/a.glsl\"\n#include \"cycle/self.glsl\"\n", {FIXTURES})),
        ElementsAre(fixture("cycle/a.glsl"), fixture("cycle/b.glsl"), fixture("cycle/self.glsl")));
}

TEST(IncludeClosure, SeesPastConditionsButNotIntoComments) {
    EXPECT_THAT(paths(include_closure("#if 0\n#include \"math/square.glsl\"\n#endif\n"
                                      "// #include \"math/hypot.glsl\"\n/*\n#include \"fetch.glsl\"\n*/\n",
                                      {FIXTURES})),
                ElementsAre(fixture("math/square.glsl")));
}

TEST(IncludeClosure, LeavesMissingFilesOut) {
    EXPECT_THAT(paths(include_closure("#include \"broken/missing.glsl\"\n", {FIXTURES})),
                ElementsAre(fixture("broken/missing.glsl"), fixture("math/square.glsl")));
}

}  // namespace include_test
}  // namespace gloam::shader
