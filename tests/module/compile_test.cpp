// SPDX-License-Identifier: MIT
#include "module/compile.hpp"
#include "module/include.hpp"
#include "module/support.hpp"
#include "support/environment.hpp"

namespace gloam::module::compile_test {

TEST(Compile, UnreachedFunctionsMayCallPrototypes) {
    EXPECT_NO_THROW(static_cast<void>(compile(kernel("#include \"fetch.glsl\"", "1.0"), with_fixtures())));
}

TEST(Compile, NamesItsTools) {
    EXPECT_THAT(compiler_version(),
                AllOf(HasSubstr("glslang "), HasSubstr("SPIRV-Tools "), HasSubstr("SPIRV-Cross ")));
}

TEST(Variants, AnUnknownNameListsThoseThereAre) {
    EXPECT_THAT(message_of<std::invalid_argument>([] { (void)variant("fast"); }),
                AllOf(HasSubstr("\"fast\""), HasSubstr("shipped, strict, "), HasSubstr("specialization")));
}

Spirv module_of(const std::string& name) {
    const source::Source source = kernel("float f(float x) { return x * x + x; }",
                                         "f(result[1]) - uintBitsToFloat(1u + uint(result[2]))");
    return compile(source, {.variant = variant(name)});
}

std::size_t decorated(const std::string& name, const std::string& decoration) {
    return Disassembly(module_of(name)).decorated(decoration).size();
}

TEST(Variants, EachMakesAModuleOfItsOwn) {
    EXPECT_EQ(decorated("shipped", "NoContraction"), 0u);
    EXPECT_EQ(decorated("strict", "NoContraction"), 3u);
    EXPECT_EQ(decorated("strict", "RelaxedPrecision"), 0u);
    EXPECT_EQ(decorated("relaxed", "NoContraction"), 3u);
    EXPECT_GT(decorated("relaxed", "RelaxedPrecision"), 5u);
    EXPECT_LT(module_of("optimized").size(), module_of("shipped").size());
    EXPECT_LT(module_of("small").size(), module_of("shipped").size());
    EXPECT_EQ(module_of("specialization"), module_of("shipped"));
    EXPECT_EQ(module_of("literals"), module_of("optimized"));
}

std::string error_of(const source::Source& source) {
    return message_of<source::CompileError>([&] { static_cast<void>(compile(source, with_fixtures())); });
}

struct ErrorRow {
    source::Source source;
    testing::Matcher<std::string> message;
};

TEST(CompileErrorMessage, NamesFileLineAndCause) {
    const std::string broken =
        fixture("broken/inner.glsl").string() + ":5: 'not_declared' : undeclared identifier";
    const std::string a = fixture("cycle/a.glsl").string();
    const std::string b = fixture("cycle/b.glsl").string();
    const std::string self = fixture("cycle/self.glsl").string();
    const auto text = [](const std::string& lines) {
        return source::Source{"t.comp", "#version 450\n" + lines};
    };
    const std::string oops = "void main() { oops = 1; }\n";
    const std::string hypot = "#include \"math/hypot.glsl\"\n";
    const ErrorRow rows[] = {
        {text("void main() {\n    foo();\n}\n"), "t.comp:3: 'foo' : no matching overloaded function found"},
        {kernel("#include \"broken/inner.glsl\"", "1.0"), broken},
        {kernel("\n\n#include \"broken/outer.glsl\"", "1.0"), broken},
        {text(hypot + oops), StartsWith("t.comp:3: 'oops'")},
        {text("#extension GL_GOOGLE_include_directive : require\n" + hypot + oops),
         StartsWith("t.comp:4: 'oops'")},
        {text("#extension GL_NO_such : enable\n" + oops),  // a warning
         AllOf(StartsWith("t.comp:3: 'oops'"), Not(HasSubstr("GL_NO_such")))},
        {text("float f() { return a; }\nfloat g() { return b; }\n"),
         AllOf(StartsWith("t.comp:2: 'a'"), HasSubstr("\nt.comp:3: 'b'"), Not(HasSubstr("ERROR")),
               Not(HasSubstr("No code generated")), Not(EndsWith("\n")))},
        {text("\n#include \"no/such.glsl\"\nvoid main() {}\n"),
         "t.comp:3: cannot find include \"no/such.glsl\"; looked for " + fixture("no/such.glsl").string()},
        {kernel("#include \"broken/missing.glsl\"", "1.0"),
         AllOf(StartsWith(fixture("broken/missing.glsl").string() + ":2: "),
               HasSubstr("\"broken/nowhere.glsl\""))},
        {kernel("#include \"cycle/a.glsl\"", "1.0"), b + ":1: include cycle: " + a + " -> " + b + " -> " + a},
        {kernel("#include \"cycle/self.glsl\"", "1.0"), self + ":1: include cycle: " + self + " -> " + self},
        {kernel("#include \"fetch.glsl\"", "fx_twice(ivec2(0))"),
         AllOf(StartsWith("kernel: "), HasSubstr(" fx_fetch_depth()"), Not(HasSubstr("\n")))},
        {kernel("float nothing();", "nothing()"), EndsWith(" nothing()")},
        {kernel("float f(float x) { return f(x - 1.0); }", "f(3.0)"),
         AllOf(StartsWith("kernel: "), HasSubstr("Recursion"), HasSubstr(" f()"), Not(HasSubstr("f1;")))},
        {text("float f() { return 1.0; }\n"), StartsWith("t.comp: ")}};  // no main
    for (const auto& [source, message] : rows) EXPECT_THAT(error_of(source), message) << source.text;
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

using Include = InFolder;

TEST_F(Include, ReadsATextWhole) {
    EXPECT_EQ(read_text(folder.write("a.glsl", "one\r\ntwo")), "one\r\ntwo");
    EXPECT_EQ(read_text(folder.write("empty.glsl", "")), "");
    EXPECT_EQ(read_text(folder.write("marked.glsl", "\xef\xbb\xbfone")), "one");
}

TEST_F(Include, FilesThatWereReadAreListedOnceEach) {
    const auto file = folder.write("a.glsl", "");
    const auto list = folder.path() / "list";
    {
        const ScopedVariable output("GLOAM_DEPENDENCIES_OUTPUT", list.c_str());
        static_cast<void>(read_text(file));
        static_cast<void>(read_text(folder.path() / "." / "a.glsl"));
        ::setenv("GLOAM_DEPENDENCIES_OUTPUT", (folder.path() / "none" / "list").c_str(), 1);
        EXPECT_EQ(read_text(file), "") << "a list that cannot be written stops nothing";
    }
    EXPECT_EQ(read_text(list), std::filesystem::canonical(file).string() + "\n");
}

TEST_F(Include, AFileOfAnOverlaidFolderIsReadFromTheCopy) {
    const auto changed = folder.write("original/a/changed.glsl", "one");
    const auto missing = folder.write("original/missing.glsl", "one");
    const auto outside = folder.write("changed.glsl", "one");
    (void)folder.write("copy/a/changed.glsl", "two");
    (void)folder.write("copy/changed.glsl", "two");
    const ScopedVariable shaders("GLOAM_SHADERS", (folder.path() / "copy").c_str());
    EXPECT_EQ(read_text(changed), "one") << "a copy of which folder?";
    const ScopedVariable of("GLOAM_SHADERS_OF", (folder.path() / "original").c_str());
    EXPECT_EQ(read_text(changed), "two");
    EXPECT_EQ(read_text(folder.path() / "copy" / ".." / "original" / "a" / "changed.glsl"), "two");
    EXPECT_EQ(read_text(missing), "one");
    EXPECT_EQ(read_text(outside), "one");
    const auto closure =
        include_closure({"text", "#include \"a/changed.glsl\"\n"}, {folder.path() / "original"});
    ASSERT_EQ(closure.size(), 1U);
    EXPECT_EQ(closure[0].path, changed);
    EXPECT_EQ(closure[0].text, "two");
}

TEST_F(Include, OwnFolderComesBeforeTheRootsAndTheyInOrder) {
    const auto own = folder.write("own/a.glsl", "");
    const auto first = folder.write("first/a.glsl", "");
    const auto second = folder.write("second/a.glsl", "");
    const auto last = folder.write("second/b.glsl", "");
    const std::vector roots{first.parent_path(), second.parent_path(), folder.path()};
    EXPECT_EQ(resolve_include("a.glsl", own.parent_path(), roots), own);
    EXPECT_EQ(resolve_include("a.glsl", {}, roots), first);
    EXPECT_EQ(resolve_include("b.glsl", own.parent_path(), roots), last);
    EXPECT_EQ(resolve_include("../own/a.glsl", {}, roots), own);
    EXPECT_THAT(
        message_of<std::runtime_error>(
            [&] { (void)resolve_include("../own/a.glsl", {}, {first.parent_path()}); }),
        HasSubstr("outside the include roots, expected a file below " + first.parent_path().string()));
    EXPECT_THAT(message_of<std::runtime_error>([&] { (void)resolve_include("own", "/from", roots); }),
                EndsWith("; looked for /from/own " + (roots[0] / "own ").string() +
                         (roots[1] / "own ").string() + (roots[2] / "own").string()))
        << "it is a folder";
}

// A text, its roots and its folder, and the files that it includes, each once in the order of mention.
TEST_F(Include, ClosureHasEachFileOnce) {
    const std::vector<std::filesystem::path> here{fixtures()};
    const auto math = fixture("math");
    struct Row {
        std::string text;
        std::vector<std::filesystem::path> roots;
        std::filesystem::path folder;
        std::vector<std::string> files;
    };
    const Row rows[] = {
        {"#include \"broken/outer.glsl\"\n#include \"math/square.glsl\"\n#include \"math/hypot.glsl\"\n",
         here,
         {},
         {"broken/outer.glsl", "math/square.glsl", "broken/inner.glsl", "math/hypot.glsl"}},
        {"#include \"neighbour.glsl\"\n", {}, math, {"math/neighbour.glsl", "math/square.glsl"}},
        {"#include \"neighbour.glsl\"\n", here, {}, {}},
        {"#include <neighbour.glsl>\n", {}, math, {}},
        {"#include \"cycle/a.glsl\"\n#include \"cycle/self.glsl\"\n",
         here,
         {},
         {"cycle/a.glsl", "cycle/b.glsl", "cycle/self.glsl"}},
        {"#if 0\n#include \"math/square.glsl\"\n#endif\n"
         "// #include \"math/hypot.glsl\"\n/*\n#include \"fetch.glsl\"\n*/\n",
         here,
         {},
         {"math/square.glsl"}},
        {"#include \"broken/missing.glsl\"\n", here, {}, {"broken/missing.glsl", "math/square.glsl"}}};
    for (const auto& [text, roots, in_folder, files] : rows) {
        std::vector<std::string> found;
        for (const IncludedFile& file : include_closure({(in_folder / "text").string(), text}, roots)) {
            found.push_back(std::filesystem::relative(file.path, fixtures()).string());
            EXPECT_EQ(file.text, read_text(file.path));
        }
        EXPECT_EQ(found, files) << text;
    }
}

}  // namespace gloam::module::compile_test
