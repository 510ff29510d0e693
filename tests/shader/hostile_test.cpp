// SPDX-License-Identifier: MIT
// Texts that exhaust or mislead the compiler: each is a CompileError that names the text, and the next text
// compiles.
#include <sys/stat.h>

#include "shader/include.hpp"
#include "shader/pack.hpp"
#include "support.hpp"
#include "support/matchers.hpp"

namespace gloam::shader::hostile_test {

using test::kernel;
using test::message_of;
using test::TemporaryDirectory;

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

TEST(Hostile, AnExpressionThatIsTooDeep) {
    const Source source{"bad.comp", "#version 450\nfloat f(float x) { return " + repeated("x-", 200'000) +
                                        "x; }\nvoid main() { f(1.0); }\n"};
    const std::string why = "bad.comp: the compiler ended by signal 11";
    EXPECT_THAT(message_of<CompileError>([&] { (void)compile(source, {}); }), StartsWith(why));
    EXPECT_THAT(message_of<CompileError>([&] { (void)functions(source, {}); }), StartsWith(why));
    EXPECT_NO_THROW((void)compile(kernel("", "1.0"), {})) << "the next text is another process's";
}

TEST(Hostile, MacrosThatDouble) {
    std::string macros = "#define M0 x\n";
    for (int i = 1; i <= 40; ++i) {
        const std::string inner = "M" + std::to_string(i - 1);
        macros += "#define M" + std::to_string(i) + " " + inner + " + " + inner + "\n";
    }
    const Source source{"bad.comp", "#version 450\n" + macros + "float f(float x) { return M40; }\n"};
    const std::string why = "bad.comp: the compiler takes more than ";
    EXPECT_THAT(message_of<CompileError>([&] { (void)functions(source, {}); }), StartsWith(why));
    EXPECT_THAT(message_of<CompileError>([&] { (void)pack({source}, {}, {}); }), StartsWith(why));
}

TEST(Hostile, IncludesFromOutsideTheRoots) {
    const TemporaryDirectory dir;
    const auto secret = dir.write("secret.glsl", "float secret;\n");
    const std::filesystem::path home = dir.write("home/deep/top.comp", "").parent_path();
    std::filesystem::create_symlink(secret, home / "link.glsl");
    std::filesystem::create_symlink(dir.path(), home / "folder");
    for (const std::string& directive :
         {"#include \"" + secret.string() + "\"", std::string("#include \"../../secret.glsl\""),
          "#include <" + secret.string() + ">", std::string("#include <../../secret.glsl>"),
          std::string("#include \"link.glsl\""), std::string("#include \"folder/secret.glsl\"")}) {
        const Source source{(home / "top.comp").string(),
                            "#version 450\n" + directive + "\nvoid main() {}\n"};
        const CompileOptions options{.include_roots = {home}};
        for (const auto& message :
             {message_of<CompileError>([&] { (void)compile(source, options); }),
              message_of<CompileError>([&] { (void)pack({source}, {}, options.include_roots); })})
            EXPECT_THAT(message, AllOf(HasSubstr(":2: include \""), HasSubstr(home.string()),
                                       HasSubstr("outside the include roots, expected a file below")))
                << directive;
        EXPECT_TRUE(include_closure(source.text, options.include_roots, home).empty()) << directive;
        const CompileOptions wide{.include_roots = {home, dir.path()}};
        if (directive.find("<..") != std::string::npos) continue;  // found in no root
        EXPECT_NO_THROW((void)compile(source, wide)) << directive;
    }
}

// #line can name any file; an include is not searched beside it.
TEST(Hostile, ALineDirectiveOpensNoFolder) {
    const TemporaryDirectory dir;
    (void)dir.write("secret.glsl", "float secret;\n");
    const Source source{(dir.path() / "home" / "top.comp").string(),
                        "#version 450\n#line 2 \"" + (dir.path() / "x.glsl").string() +
                            "\"\n#include \"secret.glsl\"\nvoid main() {}\n"};
    EXPECT_THROW((void)compile(source, {}), CompileError);
    EXPECT_THROW((void)pack({source}, {}, {}), CompileError);
}

TEST(Hostile, IncludesThatAreNestedWithoutEnd) {
    const TemporaryDirectory dir;
    constexpr int length = 3000;
    for (int i = 0; i < length; ++i)
        dir.write("i" + std::to_string(i), "#include \"i" + std::to_string(i + 1) + "\"\n");
    dir.write("i" + std::to_string(length), "\n");
    const CompileOptions options{.include_roots = {dir.path()}};
    EXPECT_EQ(include_closure("#include \"i0\"\n", options.include_roots).size(), length + 1U);
    EXPECT_THAT(message_of<CompileError>([&] { (void)compile(kernel("#include \"i0\"", "1.0"), options); }),
                HasSubstr("includes are nested more than 256 deep"));
}

TEST(Hostile, IncludesThatAreLongTogether) {
    const TemporaryDirectory dir;
    std::string all;
    for (int i = 0; i < 5; ++i) {
        dir.write("i" + std::to_string(i), std::string(15U << 20U, ' '));
        all += "#include \"i" + std::to_string(i) + "\"\n";
    }
    EXPECT_THAT(message_of<std::runtime_error>([&] { (void)include_closure(all, {dir.path()}); }),
                AllOf(HasSubstr("i4"), HasSubstr("longer than")));
}

TEST(Hostile, FilesThatAreNoText) {
    const TemporaryDirectory dir;
    const auto why = [](const std::filesystem::path& file) {
        const std::string message = message_of<std::runtime_error>([&] { (void)read_text(file); });
        EXPECT_THAT(message, HasSubstr(file.string()));
        return message;
    };
    EXPECT_THAT(why(dir.write("utf16.glsl", std::string("\xff\xfe"
                                                        "f\0",
                                                        4))),
                HasSubstr("NUL"));
    EXPECT_THAT(why(dir.write("long.glsl", std::string((64U << 20U) + 1, ' '))), HasSubstr("longer than"));
    const auto fifo = dir.path() / "fifo.glsl";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    EXPECT_THAT(why(fifo), HasSubstr("no regular file"));
    EXPECT_THAT(why("/dev/zero"), HasSubstr("no regular file"));
}

}  // namespace gloam::shader::hostile_test
