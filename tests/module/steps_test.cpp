// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include "module/include.hpp"
#include "module/steps.hpp"
#include "module/support.hpp"
#include "module/texts.hpp"

namespace gloam::module::steps_test {

const Spirv& module() {
    static const Spirv made = compile(
        kernel("float f(float x) { float y = 2.0; if (x > 1.0) y = x; return y * y + x; }", "f(result[1])"),
        {});
    return made;
}

Spirv after(const std::string& step, const Spirv& before = module()) {
    return taken(step, {.module = before, .glsl = [] { return kernel("", "1.0").text; }});
}

TEST(Steps, PassesAreThoseOfTheOptimizer) {
    EXPECT_EQ(after("spirv-opt -O"), optimize(module(), Optimization::performance));
    EXPECT_NE(after("spirv-opt --ssa-rewrite"), module());
}

// docs/drivers.md has both: passes that crash, or give an invalid module, in some versions of SPIRV-Tools.
TEST(Steps, OfALibraryThatCrashesOrErrsCostThemselvesAlone) {
    constexpr const char* loop_peeling = R"(#version 450
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer B { float x[]; };
void main() {
    float s = 0.0;
    for (int i = 0; i < 8; ++i) s += x[i];
    x[0] = s;
}
)";
    constexpr const char* dead_constant = R"(#version 450
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer B { int x[]; };
void main() {
    int a = 3;
    x[0] = x[1] + (a >> 1);
    x[2] = (a > 2) ? x[3] : x[4];
}
)";
    for (const auto& [text, step] :
         {std::pair{loop_peeling, "spirv-opt --relax-float-ops --loop-peeling"},
          std::pair{dead_constant,
                    "spirv-opt --eliminate-local-single-store --amd-ext-to-khr --eliminate-dead-const"}}) {
        const Spirv before = compile({"shader.comp", text}, {});
        try {
            validate(after(step, before));
        } catch (const StepError& error) {
            EXPECT_THAT(error.what(), StartsWith(step));
        }
    }
}

TEST(Steps, OfAVariantAreOneEach) {
    for (const char* name : {"shipped | spirv-opt {each}", "strict | spirv-opt --ccp | spirv-opt {each}"})
        EXPECT_THAT(message_of<std::invalid_argument>([name] { (void)variant(name); }),
                    HasSubstr("expected one step behind each bar"));
    EXPECT_EQ(variant("strict | spirv-opt --ccp | spirv-opt -O").steps.size(), 2U);
}

TEST(Steps, ATextStandsForEachPass) {
    const std::vector<std::string> each = steps_from("spirv-opt {each}");
    EXPECT_GT(each.size(), 40U);
    EXPECT_THAT(each, Contains("spirv-opt --ccp"));
    EXPECT_THAT(each, Contains("spirv-opt -O"));
    EXPECT_THAT(each, Not(Contains("spirv-opt --version")));
    EXPECT_THAT(steps_from("/opt/spirv-opt {each} {in} -o {out}"),
                Contains("/opt/spirv-opt --ccp {in} -o {out}"));
}

TEST(Steps, HavePartsThatCanBeLeftOut) {
    const std::string program = "/opt/spirv-opt --ccp --merge-blocks {in} -o {out}";
    EXPECT_THAT(parts_of(program), ElementsAre("--ccp", "--merge-blocks"));
    EXPECT_EQ(with_parts(program, {"--merge-blocks"}), "/opt/spirv-opt --merge-blocks {in} -o {out}");
    EXPECT_TRUE(parts_of("cat {in} {out}").empty());
}

// Texts that exhaust or mislead the compiler: each is a CompileError that names the text, and the next text
// compiles.

using Hostile = InFolder;

TEST_F(Hostile, IncludesFromOutsideTheRoots) {
    const auto secret = folder.write("secret.glsl", "float secret;\n");
    const std::filesystem::path home = folder.write("home/deep/top.comp", "").parent_path();
    std::filesystem::create_symlink(secret, home / "link.glsl");
    std::filesystem::create_symlink(folder.path(), home / "folder");
    for (const std::string& directive :
         {"#include \"" + secret.string() + "\"", std::string("#include \"../../secret.glsl\""),
          "#include <" + secret.string() + ">", std::string("#include <../../secret.glsl>"),
          std::string("#include \"link.glsl\""), std::string("#include \"folder/secret.glsl\"")}) {
        const source::Source source{(home / "top.comp").string(),
                                    "#version 450\n" + directive + "\nvoid main() {}\n"};
        const CompileOptions options{.include_roots = {home}};
        for (const auto& message :
             {message_of<source::CompileError>([&] { (void)compile(source, options); }),
              message_of<source::CompileError>([&] { (void)pack({source}, {}, options.include_roots); })})
            EXPECT_THAT(message, AllOf(HasSubstr(":2: include \""), HasSubstr(home.string()),
                                       HasSubstr("outside the include roots, expected a file below")))
                << directive;
        EXPECT_TRUE(include_closure(source, options.include_roots).empty()) << directive;
        const CompileOptions wide{.include_roots = {home, folder.path()}};
        if (directive.find("<..") != std::string::npos) continue;  // found in no root
        EXPECT_NO_THROW((void)compile(source, wide)) << directive;
    }
}

// #line can name any file; an include is not searched beside it.
TEST_F(Hostile, ALineDirectiveOpensNoFolder) {
    (void)folder.write("secret.glsl", "float secret;\n");
    const source::Source source{(folder.path() / "home" / "top.comp").string(),
                                "#version 450\n#line 2 \"" + (folder.path() / "x.glsl").string() +
                                    "\"\n#include \"secret.glsl\"\nvoid main() {}\n"};
    EXPECT_THROW((void)compile(source, {}), source::CompileError);
    EXPECT_THROW((void)pack({source}, {}, {}), source::CompileError);
}

TEST_F(Hostile, IncludesThatAreNestedWithoutEnd) {
    constexpr int length = 300;
    for (int i = 0; i < length; ++i)
        folder.write("i" + std::to_string(i), "#include \"i" + std::to_string(i + 1) + "\"\n");
    folder.write("i" + std::to_string(length), "\n");
    const CompileOptions options{.include_roots = {folder.path()}};
    EXPECT_EQ(include_closure({"text", "#include \"i0\"\n"}, options.include_roots).size(), length + 1U);
    EXPECT_THAT(
        message_of<source::CompileError>([&] { (void)compile(kernel("#include \"i0\"", "1.0"), options); }),
        HasSubstr("includes are nested more than 256 deep"));
}

TEST_F(Hostile, IncludesThatAreLongTogether) {
    folder.write("short", std::string(1U << 20U, ' '));
    folder.write("long", std::string(64U << 20U, ' '));
    EXPECT_THAT(message_of<std::runtime_error>([&] {
                    (void)include_closure({"text", "#include \"short\"\n#include \"long\"\n"},
                                          {folder.path()});
                }),
                AllOf(HasSubstr("long"), HasSubstr("longer than")));
}

// Reading them would not end. Folders, and files with a NUL byte: tests/tools/stories.
TEST_F(Hostile, FilesThatAreNoFiles) {
    const auto fifo = folder.path() / "fifo.glsl";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    for (const std::filesystem::path& file : {fifo, std::filesystem::path("/dev/zero")})
        EXPECT_THAT(message_of<std::runtime_error>([&] { (void)read_text(file); }),
                    AllOf(HasSubstr(file.string()), HasSubstr("no regular file")));
}

}  // namespace gloam::module::steps_test
