// SPDX-License-Identifier: MIT
#include "report/failures.hpp"
#include "support/test.hpp"

namespace gloam::report::failures_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Expected {
    KernelReplay::Output output;
    numeric::Bounds allowed;
};

KernelReplay replay(const std::vector<Expected>& all) {
    KernelReplay made{.comments = {"a comment"},
                      .assembly = "; SPIR-V\nOpName %BLEND \"BLEND\"\n",
                      .inputs = {0x3f800000U, 7U},
                      .images = {},
                      .outputs = {},
                      .outcomes = {{}}};
    for (const Expected& one : all) {
        made.outputs.push_back(one.output);
        made.outcomes.front().push_back(one.allowed);
    }
    return made;
}

Expected number(double low, double high, bool nan = false) {
    return {{.is_float = true, .found = 0x7fc00000U, .comment = "c"}, {.low = low, .high = high, .nan = nan}};
}

Expected integer(double low, double high) {
    return {{.is_float = false, .found = 99U, .comment = "c"}, {.low = low, .high = high, .nan = false}};
}
Expected integer(double value) {
    return integer(value, value);
}

// A number and an integer that are permitted together: 0 and 1, or 1 and 2, or 4 and 1.
KernelReplay three_outcomes(float found, std::uint32_t integer_found) {
    KernelReplay made = replay({number(0, 0), integer(1)});
    made.outcomes.push_back({numeric::Bounds::point(1), numeric::Bounds::point(2)});
    made.outcomes.push_back({numeric::Bounds::point(4), numeric::Bounds::point(1)});
    made.outputs[0].found = std::bit_cast<std::uint32_t>(found);
    made.outputs[1].found = integer_found;
    return made;
}

// The EXPECT lines for the first output, and nothing else.
std::vector<std::string> expectations(const KernelReplay& of) {
    std::istringstream lines(to_amber(of));
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("EXPECT") && line.find(" IDX 0 ") != std::string::npos) found.push_back(line);
    }
    return found;
}
std::vector<std::string> expectations(const Expected& output) {
    return expectations(replay({output}));
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

TEST(Amber, ARangeOfIntegersIsOneOfWordsUnlessItCrossesZero) {
    EXPECT_THAT(expectations(integer(3, 5)),
                ElementsAre("EXPECT words IDX 0 GE 3", "EXPECT words IDX 0 LE 5"));
    EXPECT_THAT(expectations(integer(-2, -1)),
                ElementsAre("EXPECT words IDX 0 GE 4294967294", "EXPECT words IDX 0 LE 4294967295"));
    EXPECT_THAT(expectations(integer(-2, 1)), IsEmpty());
    EXPECT_THAT(expectations(integer(0, infinity)),
                ElementsAre("EXPECT words IDX 0 GE 0", "EXPECT words IDX 0 LE 4294967295"));
}

// A script has no word for "or".
TEST(Amber, OfSeveralOutcomesTheHullIsExpectedAndNotWhatFailedBetweenThem) {
    EXPECT_THAT(expectations(three_outcomes(2.5F, 2)),
                ElementsAre("EXPECT floats IDX 0 NE nan", "EXPECT floats IDX 0 GE 0.00000000",
                            "EXPECT floats IDX 0 LE 4.00000000", "EXPECT floats IDX 0 NE 2.50000000"));
    // 1 is permitted, but not with 1.
    EXPECT_THAT(expectations(three_outcomes(1.0F, 1)), Not(Contains("EXPECT floats IDX 0 NE 1.00000000")));
    const std::string script = to_amber(three_outcomes(2.5F, 2));
    const Grammar grammar(script);
    EXPECT_THAT(script, HasSubstr("# one of 3 outcomes is allowed (report.txt); this expects their hull\n"));
    EXPECT_THAT(script, HasSubstr("EXPECT words IDX 4 GE 1\nEXPECT words IDX 4 LE 2\n"));
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
    KernelReplay not_judged = replay({number(0, 1)});
    not_judged.outputs.front().comment = "not judged";
    not_judged.outcomes.clear();
    const std::string script = to_amber(not_judged);
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

ShaderReplay shader_replay(bool compute) {
    return {.glsl = "#version 310 es\nvoid main() {}\n",
            .compute = compute,
            .version = "GL ES >= 3.1",
            .glsl_version = "GLSL ES >= 3.10",
            .kernel = {.comments = {"a comment"},
                       .assembly = {},
                       .inputs = {0x3f800000U, 0xffffffffU},
                       .images = {{.name = "fetch", .words = {1U, 1U, 0U, 9U}}},
                       .outputs = {{.is_float = true, .found = 0x40800000U, .comment = "c"},
                                   {.is_float = false, .found = 2U, .comment = "d"}},
                       .outcomes = {
                           {{.low = 0.5, .high = 2, .nan = false}, {.low = -1, .high = -1, .nan = false}}}}};
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
    one.kernel.outcomes.front().front() = {.low = 1, .high = 2, .nan = true};
    EXPECT_THAT(to_shader_test(one), Not(HasSubstr("probe ssbo float")));
    one.kernel.outcomes.front().front() = {.low = 1, .high = infinity, .nan = false};
    EXPECT_THAT(to_shader_test(one), AllOf(HasSubstr("probe ssbo float 1 0 >= 1\n"), Not(HasSubstr("<="))));
    one.kernel.outcomes.clear();
    EXPECT_THAT(to_shader_test(one), Not(HasSubstr("probe ssbo float")));
}

TEST(ShaderTest, OfSeveralOutcomesTheHullIsProbedAndNotWhatFailedBetweenThem) {
    ShaderReplay three = shader_replay(true);
    three.kernel = three_outcomes(2.5F, 3);
    EXPECT_THAT(to_shader_test(three),
                AllOf(HasSubstr("probe ssbo float 1 0 >= 0\nprobe ssbo float 1 0 <= 4\n"
                                "probe ssbo uint 1 0 != 0x40200000\n"),
                      HasSubstr("probe ssbo uint 1 4 >= 0x1\nprobe ssbo uint 1 4 <= 0x2\n")));
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
