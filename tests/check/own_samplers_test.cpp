// SPDX-License-Identifier: MIT
// Functions that read samplers: of their file, and as parameters.
#include <fmt/format.h>

#include "backend/sampled.hpp"
#include "check/explain.hpp"
#include "check/fixture_functions.hpp"
#include "check/reproduction.hpp"
#include "module/include.hpp"
#include "support/changed_device.hpp"

#include "support/test.hpp"

namespace gloam::check::own_samplers_test {

using testing::ElementsAre;

constexpr const char* file = "samplers.glsl";

// A device whose images are changed before it reads them.
std::shared_ptr<backend::Backend> with_texels(void (*change)(std::span<Word> texels)) {
    const auto before = [change](std::vector<std::vector<Word>>& images) {
        for (std::vector<Word>& words : images)
            change(std::span(words).subspan(backend::sampled_header_words));
    };
    return std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), before, nullptr);
}

// A device that is given other samplers than it was asked for.
using Change = void (*)(backend::SampledHeader&);
std::shared_ptr<backend::Backend> distorted(Change change) {
    const auto before = [change](std::vector<std::vector<Word>>& images) {
        for (std::vector<Word>& words : images) {
            backend::SampledHeader header = backend::sampled_header(words);
            change(header);
            const auto as_words = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
            std::ranges::copy(as_words, words.begin());
        }
    };
    return std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), before, nullptr);
}

const Ranges directions{{"p", {-1, 1}}};

TEST(OwnSamplers, AreGlobalsAndParameters) {
    const auto samplers = [](const char* name) {
        std::vector<std::string> texts;
        for (const ImagePrototype& one : function_of(file, name).images)
            texts.push_back(one.sampler + " " + one.name);
        return texts;
    };
    EXPECT_THAT(samplers("sampled"), ElementsAre("sampler2D tex"));
    EXPECT_THAT(samplers("twice"), ElementsAre("sampler2D image", "sampler2D renamed"));
    EXPECT_THAT(samplers("two"), ElementsAre("sampler2D a", "sampler2D b"));
    EXPECT_THAT(samplers("offset"), ElementsAre("isampler2D offsets", "isampler2D more_offsets"));
}

TEST(OwnSamplers, ATexelOutsideIsTheInputsFault) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    const Answer fetched = answer_of(lab, file, "fetched", {{"p", {0, 3}}});
    EXPECT_TRUE(fetched.passed()) << fetched;
    const Answer beside = answer_of(lab, file, "fetched_beside", {{"p", {1, 2}}});
    EXPECT_TRUE(beside.passed()) << beside;
    const Answer outside = answer_of(lab, file, "fetched");
    EXPECT_GT(outside.undefined, 0U) << "texels outside are the input's fault";
    EXPECT_EQ(outside.outside(), 0U) << outside;
}

TEST(OwnSamplers, AWrongSamplerIsNoticed) {
    using Header = backend::SampledHeader;
    using backend::Compare;
    using backend::Wrap;
    struct Plant {
        const char* what;
        Change change;
        bool shadow = false;
    };
    const Plant plants[] = {
        {"filter", [](Header& h) { h.linear = 1 - h.linear; }},
        {"wrap", [](Header& h) { h.wrap = h.wrap == Wrap::edge ? Wrap::repeat : Wrap::edge; }},
        {"border", [](Header& h) { h.wrap = Wrap::border; }},
        {"another way",
         [](Header& h) {
             h.compare = h.compare == Compare::less_equal ? Compare::greater_equal : Compare::less_equal;
         },
         true},
        {"an equal depth",
         [](Header& h) {
             h.compare = h.compare == Compare::less_equal ? Compare::less : Compare::less_equal;
         },
         true},
        {"filter of depths", [](Header& h) { h.linear = 1 - h.linear; }, true}};
    for (const auto& [what, change, shadow] : plants) {
        const Lab lab(options_of(file), distorted(change));
        const Answer answer = shadow ? answer_of(lab, file, "shadow_at_level", {{"p", {0, 1}}}, 1024)
                                     : answer_of(lab, file, "sampled", {{"uv", {-1, 2}}});
        EXPECT_GT(answer.outside(), 0U) << what;
    }
    // The same device, unchanged, is right.
    const Lab right(options_of(file), distorted([](Header&) {}));
    EXPECT_EQ(answer_of(right, file, "sampled", {{"uv", {-1, 2}}}).outside(), 0U);
}

// The rules of OpenGL 4.5 are those of Vulkan.
TEST(OwnSamplers, OpenGlReadsTheSameImages) {
    LabOptions options = options_of(file);
    options.device = "gl:llvmpipe-4.5";
    options.validation = false;
    const auto opengl = test::opengl_device(options.device);
    if (opengl == nullptr) GTEST_SKIP() << options.device << " is not available";
    const Lab lab(options, opengl);
    for (const char* name :
         {"at_level", "graded", "gathered", "cube_at_level", "cube_gathered", "one_of_cubes", "cube_count",
          "shadow_at_level", "shadow_gathered", "sized", "levels"}) {
        const bool of_cube = std::string_view(name).find("cube") != std::string_view::npos;
        const Answer answer = answer_of(lab, file, name, of_cube ? directions : Ranges{}, 512);
        EXPECT_TRUE(answer.passed()) << name << "\n" << answer;
    }
    EXPECT_THROW((void)answer_of(lab, file, "sampled"), backend::Unsupported) << "a quad";
    const auto change = [](std::vector<std::vector<Word>>& images) {
        for (std::vector<Word>& words : images) words[6] = 1 - words[6];  // SampledHeader::linear
    };
    const Lab changed(options, std::make_shared<test::ChangedDevice>(opengl, change, nullptr));
    for (const char* name : {"cube_at_level", "shadow_at_level"})
        EXPECT_GT(answer_of(changed, file, name, directions, 512).outside(), 0U) << name;
}

TEST(OwnSamplers, AWrongFaceOrEdgeOfACubeIsNoticed) {
    const auto outside = [](void (*change)(std::span<Word>), const char* name) {
        const Lab lab(options_of(file), with_texels(change));
        return answer_of(lab, file, name, directions, 1024).outside();
    };
    // The faces +x and -x of the largest level.
    const auto exchanged = [](std::span<Word> texels) {
        const std::size_t face = texels.size() / backend::cube_faces / 2;
        std::ranges::swap_ranges(texels.first(face), texels.subspan(face, face));
    };
    // A texel at a corner, where three faces meet.
    const auto first = [](std::span<Word> texels) { texels[0] = to_word(60.0F); };
    for (const char* name : {"cube_at_level", "of_cube"}) {
        EXPECT_GT(outside(exchanged, name), 100U) << name;
        EXPECT_GT(outside(first, name), 0U) << name;
        EXPECT_EQ(outside([](std::span<Word>) {}, name), 0U) << name;
    }
}

TEST(OwnSamplers, ScenariosDifferInFilterEdgesAndLevels) {
    std::vector<std::string> names;
    for (const ImageScenario& scenario : random_scenarios(function_of(file, "sampled").images)) {
        names.push_back(scenario.name);
        numeric::Random random(1);
        for (const auto& [name, image] : scenario.make(scenario.size, random)) {
            ASSERT_TRUE(image.sampling) << name;
            for (const Word word : image.words) {
                const auto value = from_word<float>(word) * 64.0F;
                ASSERT_EQ(value, std::floor(value)) << "16 bits represent it";
            }
        }
    }
    EXPECT_THAT(names, ElementsAre("5 x 4, random, linear, repeat", "4 x 4, random, linear, edge, 3 levels",
                                   "5 x 4, random, nearest, mirrored, 2 levels"));
}

TEST(OwnSamplers, AReproductionSaysWhichImagesAreSampled) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    const Reproduction all =
        reproduce(lab, question_of(lab, file, function_of(file, "twice"), {}), {.inputs = 64});
    ASSERT_EQ(all.images.size(), 2U);
    EXPECT_TRUE(all.images[0].bound && all.images[1].bound);
    EXPECT_EQ(all.team, backend::quad_team);
    EXPECT_NO_THROW((void)backend::sampled_header(all.images[0].words));
    EXPECT_THAT(all.glsl, HasSubstr("sampler2D image;"));
}

// What a story of a failure shows.
TEST(OwnSamplers, AnExplanationHasItsSamplers) {
    const OwnFunction own = function_of(file, "twice");
    const KernelSource source{
        .file = file, .function = own.function, .images = own.images, .text = own.excerpt, .team = own.team};
    numeric::Random random(1);
    const ImageScenario scenario = random_scenarios(own.images).front();
    const std::vector<Word> quad(8, to_word(0.25F));
    const Explanation all = explain({}, source, quad, scenario.make(scenario.size, random));
    EXPECT_GT(std::ranges::count(all.steps, "OpImageSample", &ExplainedStep::operation), 0);
    EXPECT_THROW((void)explain({}, source, quad, {}), std::invalid_argument);
}

}  // namespace gloam::check::own_samplers_test
