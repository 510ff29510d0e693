// SPDX-License-Identifier: MIT
// Anybody's shader file: no reference, no C++ signature.
#include "judge/function.hpp"
#include "subject/fixture_functions.hpp"
#include "support/lab.hpp"

namespace gloam::subject::own_function_test {

using namespace judge;

class OwnFunctionTest : public testing::Test {
  protected:
    static OwnFunctions functions_of(const std::string& file, const std::vector<std::string>& names = {}) {
        return own_functions(options_of(file), names);
    }
    static std::vector<std::string> names_of(const OwnFunctions& functions) {
        std::vector<std::string> names;
        for (const OwnFunction& own : functions.found) names.push_back(own.name);
        return names;
    }
};

TEST_F(OwnFunctionTest, AreTakenOutOfAWholeShaderAndNamedWithOrWithoutTheirTypes) {
    const OwnFunctions functions = functions_of("foreign.frag");
    EXPECT_THAT(names_of(functions), ElementsAre("luma(vec3)", "luma(vec4)", "tone", "seen", "edge", "cut",
                                                 "sampled", "twice_tone"));
    EXPECT_EQ(functions.left_out.size(), 4U);
    for (const Skipped& left_out : functions.left_out)
        EXPECT_EQ(left_out.is_error, left_out.name == "broken(float)");
    EXPECT_THAT(names_of(functions_of("foreign.frag", {"luma"})), ElementsAre("luma(vec3)", "luma(vec4)"));
    EXPECT_THAT(names_of(functions_of("foreign.frag", {"luma( vec4 )", "tone(float)"})),
                ElementsAre("luma(vec4)", "tone"));
    EXPECT_THAT([] { (void)functions_of("foreign.frag", {"luma(vec2)"}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("no function luma(vec2)")));
}

TEST_F(OwnFunctionTest, OfAWholeShaderAreCalledFromCpp) {
    const Lab whole = test::make_lab(FIXTURES);
    const Function<float(float)> tone(whole, "foreign.frag", "tone");
    EXPECT_EQ(tone(1.0F), 0.5F);
    EXPECT_TRUE(tone.check_rules({uniform(0, 1)}, {.inputs = 64}).passed());
    EXPECT_EQ((Function<float(glm::vec4)>(whole, "foreign.frag", "luma")(glm::vec4(0.0F))), 0.0F);
    EXPECT_THROW((void)(Function<float(float)>(whole, "foreign.frag", "nowhere")), std::exception);
}

struct Judged {
    const char* file;
    std::vector<const char*> names;
    std::size_t in_variants = 0;  // so many of the names in every variant, with fewer inputs
    Ranges ranges = {};
    std::size_t inputs = 256;
};

const std::vector<Judged> judged{
    {"own.glsl", {"own_root", "own_scaled", "own_mean", "own_array"}, 4},
    {"arrays.glsl", {"array_swapped", "array_split", "array_dot", "array_transposed"}, 2},
    {"types.glsl", {"advance", "split", "reverse_uints", "transpose_matrix"}, 2},
    {"uniforms.glsl",
     {"lamp", "store", "pixel", "graded", "shade", "sum", "place", "value_at", "facing"},
     3,
     {{"i", {0, 15}}}},
    {"numbers.glsl", {"halves_changed", "halves_inside", "half_sum", "half_vectors"}, 2, {}, 512},
    {"own_images.glsl",
     {"counted", "pair", "loaded", "height", "blurred", "filled", "signed_least"},
     2,
     {{"p", {0, 3}}}},
    {"samplers.glsl",
     {"sampled", "at_level", "biased", "twice", "two", "graded", "moved", "gathered", "id", "inside", "sheet",
      "sized", "levels", "projected", "cubes_sized"},
     3},
    {"samplers.glsl", {"offset"}, 0, {{"p", {0, 3}}}},
    // lavapipe 22.3.6 ends with a fault for some directions that have infinite components.
    {"samplers.glsl",
     {"one_of_cubes", "of_cube", "cube_at_level", "cube_graded", "cube_gathered", "cube_count"},
     1,
     {{"p", {-1, 1}}},
     512},
    {"samplers.glsl", {"shadow_at_level", "of_shadow", "shadow_projected", "shadow_gathered"}, 1, {}, 512},
    {"quads.frag",
     {"soft_edge", "cut_out", "edge_width", "slopes", "face_normal", "in_one_branch", "in_some_iterations",
      "across_the_screen"},
     2,
     {},
     512},
    {"groups.comp", {"group_sum", "place", "how_many", "subgroup_sum"}, 0, {}, 128}};

TEST_F(OwnFunctionTest, AreWithinTheRulesOnEachDevice) {
    for (const auto& [file, names, in_variants, ranges, inputs] : judged) {
        const Lab driver(options_of(file), test::SharedDevice::get());
        const Lab interpreted(options_of(file), interpreter_backend());
        for (const char* name : names)
            for (const Lab* each : {&driver, &interpreted}) {
                const Answer answer = answer_of(*each, file, name, ranges, inputs);
                EXPECT_TRUE(answer.passed()) << each->info().name << " " << name << "\n" << answer;
                EXPECT_TRUE(answer.undefined == 0U || inputs != 256) << name;
            }
    }
    EXPECT_EQ(function_of("groups.comp", "group_sum").team.size, (std::array<std::uint32_t, 3>{16, 2, 1}));
    EXPECT_EQ(function_of("totals.glsl", "group_total").team.size, (std::array<std::uint32_t, 3>{64, 1, 1}))
        << "a comment that names the layout is none";
}

// A quad has no kernel with constants. With constants each few inputs of images are a module of their own.
TEST_F(OwnFunctionTest, AreJudgedByTheRulesInEveryVariant) {
    for (const module::Variant& variant : module::variants()) {
        const bool constants = variant.constants != module::Variant::Constants::none;
        for (const auto& [file, names, in_variants, ranges, inputs] : judged) {
            const Lab other(options_of(file, variant), test::SharedDevice::get());
            for (const char* name : std::span(names).first(in_variants)) {
                SCOPED_TRACE(variant.name + " " + name);
                const OwnFunction own = function_of(file, name);
                const std::size_t few = !constants ? 64 : own.images.empty() ? 16 : 4;
                const auto answer = [&] { return answer_of(other, file, name, ranges, few); };
                if (constants && own.team.kind == backend::Team::Kind::quad) {
                    EXPECT_THROW((void)answer(), backend::Unsupported);
                    continue;
                }
                const Answer got = answer();
                EXPECT_FALSE(got.failed()) << got;
                EXPECT_EQ(got.criterion, Criterion::rules);
                EXPECT_GT(got.by_rules, 0U);
                EXPECT_GT(got.judged(), 0U);
            }
        }
    }
}

// What cannot be checked has a part of the reason behind "not: " where it begins.
TEST_F(OwnFunctionTest, OthersAreLeftOutWithTheReason) {
    constexpr std::string_view mark = "  // not: ";
    for (const char* file :
         {"arrays.glsl", "foreign.frag", "groups.comp", "large.comp", "numbers.glsl", "own_images.glsl",
          "references.comp", "samplers.glsl", "uniforms.glsl", "unrunnable.frag"}) {
        std::map<std::string, std::string> reasons;
        std::istringstream lines(module::read_text(std::filesystem::path(FIXTURES) / file));
        for (std::string line; std::getline(lines, line);)
            if (const std::size_t at = line.find(mark); at != std::string::npos) {
                const std::string head = line.substr(0, line.find('('));
                reasons[head.substr(head.rfind(' ') + 1)] = line.substr(at + mark.size());
            }
        const std::vector<Skipped> left_out = functions_of(file).left_out;
        EXPECT_EQ(left_out.size(), reasons.size()) << file;
        for (const auto& [name, why, is_error] : left_out)
            EXPECT_THAT(why, HasSubstr(reasons.at(name.substr(0, name.find('('))))) << file << " " << name;
    }
    EXPECT_THAT(functions_of("uniforms.glsl", {"increments"}).left_out.at(0).why, HasSubstr("atomicAdd at"));
}

struct Drawn {
    const char* file;
    const char* name;
    Ranges ranges;
    std::vector<Range> words;
};

TEST_F(OwnFunctionTest, DrawFromTheirRanges) {
    const Range low{0, 1};
    const Range high{2, 3};
    const Drawn rows[] = {
        {"own.glsl", "own_root", {{"p", high}, {"q", low}}, {high, low}},
        {"arrays.glsl", "array_dot", {{"a", high}, {"b", low}}, {high, high, high, high, low, low, low, low}},
        {"uniforms.glsl", "timed", {{"t", low}, {"iTime", high}}, {low, high}}};
    for (const auto& [file, name, ranges, words] : rows) {
        const Lab other(options_of(file), test::SharedDevice::get());
        const Question question = question_of(other, function_of(file, name), ranges);
        EXPECT_TRUE(question.defined) << name << ": every input has a range";
        const Domain::Inputs inputs = question.domain.draw(100, 1);
        ASSERT_EQ(inputs.width, words.size()) << name;
        for (std::size_t i = 0; i < inputs.words.size(); ++i) {
            const Range& range = words[i % words.size()];
            const double word = from_word<float>(inputs.words[i]);
            EXPECT_TRUE(range.low <= word && word <= range.high) << name << " " << word;
        }
    }
    const Answer result = answer_of("own.glsl", "own_root", {{"p", high}, {"q", low}});
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_EQ(result.unbounded, 0U);
    EXPECT_GT(result.guarantee.ulp, 10.0) << "it cancels";
}

// Functions of a user's files, with any other content: they run unchanged, or a message states why not.

class ForeignCode : public testing::Test {
  protected:
    template <class Type>
    [[nodiscard]] Function<Type> kernel(const std::string& function, const std::string& file = "names.glsl") {
        return {lab_, file, function};
    }

    template <class Type>
    void expect_refused(const std::string& function, const std::string& named,
                        const std::string& file = "bindings.glsl") {
        EXPECT_THAT([&] { (void)kernel<Type>(function, file); },
                    testing::ThrowsMessage<std::invalid_argument>(
                        AllOf(HasSubstr(function), HasSubstr(named), HasSubstr("bindings of its own"))))
            << function;
    }

  private:
    Lab lab_ = test::make_lab(FIXTURES);
};

TEST_F(ForeignCode, BindingsOfTheirOwnAreNamed) {
    expect_refused<float(glm::vec2)>("reads_texture", "image or sampler \"texture_at_0\"");
    expect_refused<float(glm::vec2)>("reads_other_texture", "texture_at_7");
    expect_refused<float(float)>("reads_uniform", "uniform buffer \"Settings\"");
    expect_refused<float(int)>("reads_buffer", "storage buffer \"Values\"");
    expect_refused<float(int)>("reads_array", "\"pair\"");
    expect_refused<float(int)>("reads_length", "Values");
    expect_refused<float(int, float)>("writes_buffer", "Values");
    expect_refused<float(glm::ivec2)>("reads_image", "picture");
    expect_refused<float(float)>("calls", "Settings");
    EXPECT_EQ((kernel<float(float)>("uses_none", "bindings.glsl")(3.0F)), 6.0F) << "it uses none of them";
    EXPECT_THROW((void)kernel<float(float)>("reads_pushed", "push.glsl"), std::exception);
}

TEST_F(ForeignCode, NoNameCollidesWithOurs) {
    EXPECT_EQ(kernel<float(float)>("argument0")(1.0F), 2.0F);
    EXPECT_EQ(kernel<float(float)>("output_at")(1.0F), 3.0F);
    EXPECT_EQ(kernel<float(float)>("kernel_index")(1.0F), 4.0F);
    EXPECT_EQ(kernel<unsigned()>("kernel_input")(), 4U);
    EXPECT_EQ(kernel<float(float)>("kernel_inputs")(1.0F), 5.0F);
    EXPECT_EQ(kernel<float(float)>("result")(1.0F), 6.0F);
    struct Size {
        float x;
    };
    EXPECT_EQ(kernel<Size(Size)>("value")(Size{1.0F}).x, 7.0F);
    // Nor does a macro behind a function replace it.
    EXPECT_EQ(kernel<float(float)>("replaced")(1.0F), 8.0F);
    EXPECT_EQ(kernel<float(float)>("twice")(4.0F), 8.0F);
}

}  // namespace gloam::subject::own_function_test
