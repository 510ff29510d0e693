// SPDX-License-Identifier: MIT
#include "report/failures.hpp"
#include "report/rows.hpp"

namespace gloam::report::failures_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

KernelReplay replay(std::vector<KernelReplay::Output> outputs) {
    return {.comments = {"a comment"},
            .assembly = "; SPIR-V\nOpName %BLEND \"BLEND\"\n",
            .inputs = {0x3f800000U, 7U},
            .images = {},
            .outputs = std::move(outputs)};
}

KernelReplay::Output number(double low, double high, bool nan = false) {
    return {.is_float = true, .allowed = {{.low = low, .high = high, .nan = nan}}, .comment = "c"};
}

KernelReplay::Output integer(double value) {
    return {.is_float = false, .allowed = {{.low = value, .high = value}}, .comment = "c"};
}

// The EXPECT lines, and nothing else.
std::vector<std::string> expectations(const KernelReplay::Output& output) {
    std::istringstream lines(to_amber(replay({output})));
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("EXPECT") && line.find(" IDX 0 ") != std::string::npos) found.push_back(line);
    }
    return found;
}

// A check of the script's grammar, as far as to_amber() uses it: every name is declared once before it is
// used, every block ends, every number is one that Amber reads as what it is meant to be.
class Grammar {
  public:
    explicit Grammar(const std::string& script) : lines_(script) {
        expect(next() == "#!amber", "the first line");
        for (std::string line = next(); !done_; line = next()) statement(line);
    }

    std::set<std::string> buffers;
    std::set<std::string> pipelines;
    int runs = 0;

  private:
    std::string next() {
        for (std::string line; std::getline(lines_, line);) {
            if (first_ || (!line.empty() && line[0] != '#')) {
                first_ = false;
                return line;
            }
        }
        done_ = true;
        return {};
    }

    static std::vector<std::string> words_of(const std::string& line) {
        std::istringstream stream(line);
        std::vector<std::string> words;
        for (std::string word; stream >> word;) words.push_back(word);
        return words;
    }

    static void expect(bool condition, const std::string& what) { EXPECT_TRUE(condition) << what; }

    void statement(const std::string& line) {
        const std::vector<std::string> words = words_of(line);
        if (words[0] == "SHADER") {
            expect(line == "SHADER compute kernel SPIRV-ASM TARGET_ENV spv1.5", line);
            std::string code;
            while (next() != "END" && !done_) {
            }
            expect(!done_, "the shader ends");
        } else if (words[0] == "BUFFER") {
            buffer(words);
        } else if (words[0] == "PIPELINE") {
            pipeline(words);
        } else if (words[0] == "RUN") {
            expect(words.size() == 5 && pipelines.contains(words[1]), line);
            ++runs;
        } else {
            expectation(words, line);
        }
    }

    void buffer(const std::vector<std::string>& words) {
        expect(words.size() >= 5 && words[2] == "DATA_TYPE", words[1]);
        expect(buffers.insert(words[1]).second, words[1] + " is new");
        types_[words[1]] = words[3];
        if (words[4] == "SIZE") {
            expect(words.size() == 8 && words[6] == "FILL" && std::stoi(words[5]) > 0, words[1]);
            return;
        }
        expect(words.size() == 5 && words[4] == "DATA", words[1]);
        std::size_t values = 0;
        for (std::string line = next(); line != "END" && !done_; line = next()) {
            for (const std::string& value : words_of(line)) {
                expect(value.size() == 10 && value.starts_with("0x"), value);
                ++values;
            }
        }
        expect(values > 0 && !done_, words[1] + " has values and an end");
    }

    void pipeline(const std::vector<std::string>& words) {
        expect(words.size() == 3 && words[1] == "compute" && pipelines.insert(words[2]).second, words.back());
        std::vector<std::string> attach = words_of(next());
        for (; attach.size() > 5 && attach[2] == "SPECIALIZE";
             attach.erase(attach.begin() + 2, attach.begin() + 7)) {
            ASSERT_GE(attach.size(), 7U);
            expect(attach[4] == "AS" && attach[5] == "uint32", "SPECIALIZE");
        }
        expect(attach == std::vector<std::string>{"ATTACH", "kernel"}, "ATTACH");
        for (std::string line = next(); line != "END" && !done_; line = next()) {
            const std::vector<std::string> bind = words_of(line);
            expect(bind.size() >= 5 && bind[0] == "BIND" && bind[1] == "BUFFER" && buffers.contains(bind[2]),
                   line);
        }
        expect(!done_, "the pipeline ends");
    }

    void expectation(const std::vector<std::string>& words, const std::string& line) {
        static const std::set<std::string> comparators{"EQ", "NE", "GE", "LE", "GT", "LT"};
        ASSERT_EQ(words.size(), 6U) << line;
        expect(words[0] == "EXPECT" && words[2] == "IDX" && comparators.contains(words[4]), line);
        expect(buffers.contains(words[1]) && runs > 0 && std::stoi(words[3]) % 4 == 0, line);
        const bool is_float = types_[words[1]] == "float";
        expect(words[5] == "nan" || is_float == (words[5].find('.') != std::string::npos), line);
    }

    std::istringstream lines_;
    std::map<std::string, std::string> types_;
    bool first_ = true;
    bool done_ = false;
};

TEST(Amber, AFloatLiesInItsRangeAndIsNoNaN) {
    EXPECT_THAT(expectations(number(0.25, 0.5)),
                ElementsAre("EXPECT floats IDX 0 NE nan", "EXPECT floats IDX 0 GE 0.250000000",
                            "EXPECT floats IDX 0 LE 0.500000000"));
    EXPECT_THAT(expectations(number(-0.125, 3.0, true)),
                ElementsAre("EXPECT floats IDX 0 GE -0.125000000", "EXPECT floats IDX 0 LE 3.00000000"));
}

TEST(Amber, EndsBetweenTwoFloatsAreRoundedInwards) {
    // 0.1 in double lies between two floats: 0.0999999940 and 0.100000001.
    EXPECT_THAT(expectations(number(0.1, 0.1 + 1e-12)),
                ElementsAre("EXPECT floats IDX 0 NE nan", "EXPECT floats IDX 0 GE 0.100000001",
                            "EXPECT floats IDX 0 LE 0.0999999940"));
}

TEST(Amber, InfinityAndNaNAreSaidWithoutTheirWords) {
    EXPECT_THAT(expectations(number(infinity, infinity)),
                ElementsAre("EXPECT floats IDX 0 NE nan", "EXPECT floats IDX 0 GT 3.40282347e+38"));
    EXPECT_THAT(expectations(number(-infinity, -infinity)),
                ElementsAre("EXPECT floats IDX 0 NE nan", "EXPECT floats IDX 0 LT -3.40282347e+38"));
    EXPECT_THAT(expectations(number(1.0, infinity)),
                ElementsAre("EXPECT floats IDX 0 NE nan", "EXPECT floats IDX 0 GE 1.00000000"));
    EXPECT_THAT(expectations(number(-infinity, infinity)), ElementsAre("EXPECT floats IDX 0 NE nan"));
    EXPECT_THAT(expectations(number(infinity, -infinity, true)), ElementsAre("EXPECT floats IDX 0 EQ nan"));
    EXPECT_TRUE(expectations(number(-infinity, infinity, true)).empty());
}

TEST(Amber, IntegersAreExactWords) {
    EXPECT_THAT(expectations(integer(7)), ElementsAre("EXPECT words IDX 0 EQ 7"));
    EXPECT_THAT(expectations(integer(-1)), ElementsAre("EXPECT words IDX 0 EQ 4294967295"));
    EXPECT_THAT(expectations(integer(4294967295.0)), ElementsAre("EXPECT words IDX 0 EQ 4294967295"));
}

TEST(Amber, AFunctionOfFloatsAndIntegersIsRunOnceForEachView) {
    const std::string script = to_amber(replay({number(0, 1), integer(3), number(2, 2)}));
    const Grammar grammar(script);
    EXPECT_EQ(grammar.runs, 2);
    EXPECT_THAT(script, HasSubstr("EXPECT floats IDX 8 GE 2.00000000"));
    EXPECT_THAT(script, HasSubstr("EXPECT words IDX 4 EQ 3"));
    EXPECT_THAT(script, HasSubstr("EXPECT floats IDX 12 EQ 1.0"));  // the canary
    EXPECT_THAT(script, HasSubstr("EXPECT words IDX 12 EQ 1065353216"));
    EXPECT_EQ(Grammar(to_amber(replay({number(0, 1)}))).runs, 1);
    EXPECT_EQ(Grammar(to_amber(replay({integer(1)}))).runs, 1);
}

TEST(Amber, ImagesAreBoundBehindTheKernelsOwnBuffers) {
    KernelReplay with_images = replay({number(0, 1)});
    with_images.images = {{.name = "depth", .words = std::vector<std::uint32_t>(12, 5U)},
                          {.name = "normal", .words = {1U, 1U, 0U, 9U}}};
    const std::string script = to_amber(with_images);
    const Grammar grammar(script);
    EXPECT_TRUE(grammar.buffers.contains("image1"));
    EXPECT_THAT(script, HasSubstr("BIND BUFFER image1 AS storage DESCRIPTOR_SET 0 BINDING 4"));
    EXPECT_THAT(script, HasSubstr("# normal: width"));
    EXPECT_THAT(script, HasSubstr("EXPECT faults IDX 0 EQ 0"));
}

TEST(Amber, SpecializationConstantsAreTheInputs) {
    KernelReplay specialized = replay({number(0, 1)});
    specialized.specialized = true;
    const std::string script = to_amber(specialized);
    const Grammar grammar(script);
    EXPECT_THAT(script,
                HasSubstr("ATTACH kernel SPECIALIZE 0 AS uint32 1065353216 SPECIALIZE 1 AS uint32 7\n"));
}

TEST(Amber, WhatWasNotJudgedMustOnlyEnd) {
    const std::string script = to_amber(replay({{.is_float = true, .allowed = {}, .comment = "not judged"}}));
    const Grammar grammar(script);
    EXPECT_THAT(script, HasSubstr("# output 0: not judged"));
    EXPECT_THAT(script, Not(HasSubstr("EXPECT floats IDX 0")));
    EXPECT_THAT(script, HasSubstr("EXPECT floats IDX 4 EQ 1.0"));
}

TEST(Amber, TheShaderEndsWhereItShould) {
    const std::string script = to_amber(replay({number(0, 1)}));
    const std::size_t begin = script.find("; SPIR-V");
    const std::size_t end = script.find("END", begin);
    EXPECT_THAT(script.substr(begin, end - begin), HasSubstr("%BLEnd \"BLEnd\""));
}

TEST(Amber, AFunctionWithoutInputsHasABufferAllTheSame) {
    KernelReplay none = replay({number(0, 1)});
    none.inputs.clear();
    const Grammar grammar(to_amber(none));
    EXPECT_TRUE(grammar.buffers.contains("inputs"));
}

TEST(FailureText, TellsAllThatAReportNeeds) {
    const check::Answer row = failing_row();
    check::Sample smallest = *row.worst;
    smallest.values = "float 1 (0x3f800000)";
    const std::string text = failure_text(report_of("GPU", {}).device, row, smallest, "");
    for (const char* part : {"EQ-1: f of gloam/f.glsl, variant strict", "line one", "float 1 (0x3f800000)",
                             "float 0.5 (0x3f000000)", "3 x 3", "got 0x7fc00000", "want 0.1",
                             "permitted 0 (0x0p+0) to 0.25 (0x1p-2), or NaN", "GPU", "driver 1.2",
                             "Vulkan 1.3.0", "precision rules", "4 ulp or 1e-07 absolute",
                             "gloam check EQ-1 --variant strict", "amber -v 1.2 -t spv1.5 repro.amber"}) {
        EXPECT_THAT(text, HasSubstr(part));
    }
}

TEST(FailureText, OfACheckThatDidNotRunGivesTheReason) {
    check::Answer row = passing_row("EQ-2");
    row.reason = check::Reason::hang;
    row.error = "not finished after 5 s";
    const std::string text = failure_text(report_of("GPU", {}).device, row, std::nullopt, "A note.");
    EXPECT_THAT(text, HasSubstr("hang: not finished after 5 s"));
    EXPECT_THAT(text, HasSubstr("A note."));
    EXPECT_THAT(text, Not(HasSubstr("input  ")));
}

TEST(FailureText, NamesVersionsAndTheWholeCommand) {
    const std::string text =
        failure_text(report_of("GPU", {}).device, failing_row(), std::nullopt, "",
                     {.command = "gloam check EQ-1 --seed 7", .versions = "gloam 1, glslang 2"});
    EXPECT_THAT(text, HasSubstr("Run it again: gloam check EQ-1 --seed 7\n"));
    EXPECT_THAT(text, HasSubstr("Versions: gloam 1, glslang 2"));
}

TEST(FailureText, WholeNumbersAreWrittenAsOneWritesThem) {
    check::Answer row = failing_row();
    row.worst->want.assign(row.worst->want.size(), 129'708'002.0);
    const std::string text = failure_text(report_of("GPU", {}).device, row, std::nullopt, "");
    EXPECT_THAT(text, HasSubstr("want 129708002"));
    EXPECT_THAT(text, Not(HasSubstr("129708002 (0x1.eecbf88p+26)")));
}

TEST(ShellWord, IsOneWordForAShell) {
    EXPECT_EQ(shell_word("HALTON-base2"), "HALTON-base2");
    EXPECT_EQ(shell_word("llvmpipe (LLVM 15.0.6, 256 bits)"), "'llvmpipe (LLVM 15.0.6, 256 bits)'");
    EXPECT_EQ(shell_word("it's; $(id)"), "'it'\\''s; $(id)'");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("a\n\x1b'b"), R"($'a\x0a\x1b\'b')");
}

TEST(Slug, IsFitForAFolder) {
    EXPECT_EQ(slug("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe-llvm-15-0-6-256-bits");
    EXPECT_EQ(slug("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(slug("Zwölf"), "zw-lf");
    EXPECT_EQ(slug("//"), "unnamed");
    EXPECT_EQ(slug(""), "unnamed");
}

ShaderReplay shader_replay(bool compute) {
    return {
        .glsl = "#version 310 es\nvoid main() {}\n",
        .compute = compute,
        .version = "GL ES >= 3.1",
        .glsl_version = "GLSL ES >= 3.10",
        .kernel = {
            .comments = {"a comment"},
            .assembly = {},
            .inputs = {0x3f800000U, 0xffffffffU},
            .images = {{.name = "fetch", .words = {1U, 1U, 0U, 9U}}},
            .outputs = {
                {.is_float = true, .allowed = {{.low = 0.5, .high = 2, .nan = false}}, .comment = "c"},
                {.is_float = false, .allowed = {{.low = -1, .high = -1, .nan = false}}, .comment = "d"}}}};
}

TEST(ShaderTest, AComputeShaderIsProbed) {
    const std::string text = to_shader_test(shader_replay(true));
    EXPECT_THAT(text,
                StartsWith("# a comment\n\n[require]\nGL ES >= 3.1\nGLSL ES >= 3.10\n\n[compute shader]\n"
                           "#version 310 es\n"));
    EXPECT_THAT(text, AllOf(HasSubstr("ssbo 0 8\nssbo 0 subdata int 0 1065353216\nssbo 0 subdata int 4 -1\n"),
                            HasSubstr("ssbo 1 12\n"), HasSubstr("ssbo 3 16\nssbo 3 subdata int 0 1\n"),
                            HasSubstr("compute 1 1 1\n")));
    EXPECT_THAT(text, AllOf(HasSubstr("probe ssbo float 1 0 >= 0.5\nprobe ssbo float 1 0 <= 2\n"),
                            HasSubstr("probe ssbo uint 1 4 == 0xffffffff\n"),
                            HasSubstr("probe ssbo uint 1 8 == 0x3f800000\n"),
                            HasSubstr("probe ssbo uint 2 0 == 0x0\n")));
}

TEST(ShaderTest, WhatIsNotJudgedIsNotProbed) {
    ShaderReplay one = shader_replay(true);
    one.kernel.outputs.front().allowed.clear();
    EXPECT_THAT(to_shader_test(one), Not(HasSubstr("probe ssbo float")));
    one.kernel.outputs.front().allowed = {{.low = 1, .high = 2, .nan = true}};
    EXPECT_THAT(to_shader_test(one), Not(HasSubstr("probe ssbo float")));
    one.kernel.outputs.front().allowed = {{.low = 1, .high = infinity, .nan = false}};
    EXPECT_THAT(to_shader_test(one), AllOf(HasSubstr("probe ssbo float 1 0 >= 1\n"), Not(HasSubstr("<="))));
}

TEST(ShaderTest, AFragmentShaderDrawsGreen) {
    const std::string text = to_shader_test(shader_replay(false));
    EXPECT_THAT(text, AllOf(HasSubstr("[vertex shader]\n#version 310 es\n"), HasSubstr("[fragment shader]\n"),
                            HasSubstr("uniform uint gloam_kernel_inputs[1] 4294967295\n"),
                            HasSubstr("uniform uint gloam_kernel_image0[3] 9\n"),
                            HasSubstr("draw rect -1 -1 2 2\nprobe all rgba 0.0 1.0 0.0 1.0\n"),
                            Not(HasSubstr("ssbo"))));
}

}  // namespace gloam::report::failures_test
