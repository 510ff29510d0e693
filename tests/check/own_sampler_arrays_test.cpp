// SPDX-License-Identifier: MIT
// Functions that read samplers of arrays: by constants, by indices of their own, and behind a parameter.
#include "check/explain.hpp"
#include "check/fixture_functions.hpp"
#include "check/own_domain.hpp"
#include "check/reproduction.hpp"
#include "shader/include.hpp"
#include "shader/spirv.hpp"
#include "support/changed_device.hpp"

#include "support/test.hpp"

namespace gloam::check::own_sampler_arrays_test {

using testing::ElementsAre;

constexpr const char* file = "sampler_arrays.glsl";
const std::vector<const char*> by_constants{"second", "both", "passed", "id", "lit"};
const std::vector<const char*> by_indices{"picked", "picked_and_passed", "picked_in_quad", "picked_size",
                                          "summed"};
const Ranges inside{{"i", {0, 3}}, {"p", {0, 3}}};

// The interpreter in the place of a driver, which is given what drivers are given.
class Driver : public backend::Backend {
  public:
    [[nodiscard]] const backend::DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::unique_ptr<backend::Kernel> make_kernel(
        const backend::KernelProgram& program) const override {
        EXPECT_NO_THROW(shader::validate(program.spirv));
        EXPECT_THAT(shader::disassemble(program.spirv), HasSubstr(" NonUniform\n"));
        return interpreter()->make_kernel(program);
    }

  private:
    backend::DeviceInfo info_{.name = "driver", .subgroup_size = 1};
};

// For each sampler of a function an image whose texels all have its number, from 1 on.
ImageSet numbered_images(const char* name) {
    ImageSet images;
    for (const ImagePrototype& one : function_of(file, name).images) {
        Image image{.element = one.element, .size = {4, 4}, .words = {}, .sampling = Image::Sampling{}};
        image.words.assign(4 * 4 * backend::texel_words, to_word(static_cast<float>(images.size() + 1)));
        images.emplace(one.name, image);
    }
    return images;
}

// The first component for each row of inputs, of a function that returns vec4 and reads these images.
std::vector<float> results_of(const Lab& lab, const char* name, const std::vector<std::vector<Word>>& rows) {
    std::vector<Word> inputs;
    for (const std::vector<Word>& row : rows) inputs.insert(inputs.end(), row.begin(), row.end());
    const auto result = lab.kernel(file, name, function_of(file, name).signature())
                            .run(inputs, rows.size(), numbered_images(name));
    std::vector<float> first;
    for (std::size_t i = 0; i < rows.size(); ++i) first.push_back(from_word<float>(result.outputs[4 * i]));
    return first;
}

const std::vector<Word> somewhere(2, to_word(0.125F));

std::vector<float> picked_by(const std::shared_ptr<backend::Backend>& device,
                             const std::vector<int>& indices) {
    std::vector<std::vector<Word>> rows;
    for (const int i : indices) rows.push_back({static_cast<Word>(i), somewhere[0], somewhere[1]});
    return results_of(Lab(options_of(file), device), "picked", rows);
}

TEST(SamplerArrays, HaveAnImageForEachElement) {
    const auto samplers = [](const char* name) {
        std::vector<std::string> texts;
        for (const ImagePrototype& one : function_of(file, name).images)
            texts.push_back(one.sampler->type + " " + one.name);
        return texts;
    };
    EXPECT_THAT(samplers("both"), ElementsAre("sampler2D pair[0]", "sampler2D pair[1]", "sampler2D more[0]",
                                              "sampler2D more[1]"));
    EXPECT_THAT(samplers("id"), ElementsAre("isampler2D ids[0]", "isampler2D ids[1]", "isampler2D ids[2]"));
    const Lab lab(options_of(file), test::SharedDevice::get());
    std::vector<std::uint32_t> elements;
    for (const auto& image :
         reproduce(lab, question_of(lab, file, function_of(file, "passed"), {}), {.inputs = 64}).images)
        elements.push_back(image.element);
    EXPECT_THAT(elements, ElementsAre(0, 1, 2, 3, 0, 1, 0)) << "the last is more, which it does not use";
}

TEST(SamplerArrays, ConstantsAreWithinTheRules) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    for (const char* name : {"second", "both", "passed", "id", "lit", "in_quad"}) {
        const Answer answer = answer_of(lab, file, name, inside);
        EXPECT_TRUE(answer.passed()) << name << "\n" << answer;
        EXPECT_EQ(answer.undefined, 0U) << name;
    }
    const auto exchange = [](std::vector<std::vector<Word>>& images) { std::swap(images[0], images[1]); };
    const Lab changed(options_of(file),
                      std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), exchange, nullptr));
    for (const char* name : {"second", "both"})
        EXPECT_GT(answer_of(changed, file, name).outside(), 0U) << name;
    for (const shader::Variant& variant : shader::variants()) {
        const Lab other(options_of(file, variant), test::SharedDevice::get());
        const Answer answer = answer_of(other, file, "passed", {}, 96);
        EXPECT_FALSE(answer.failed()) << variant.name << "\n" << answer;
    }
}

TEST(SamplerArrays, TheInterpreterTakesAnyIndex) {
    EXPECT_THAT(picked_by(interpreter(), {3, 0, 2, 1}), ElementsAre(4.0F, 1.0F, 3.0F, 2.0F));
    EXPECT_THROW((void)picked_by(interpreter(), {0, 4}), backend::UndefinedResult);
    const Lab lab(options_of(file), interpreter());
    for (const char* name : by_indices) {
        const Answer answer = answer_of(lab, file, name, inside);
        EXPECT_TRUE(answer.passed()) << name << "\n" << answer;
        EXPECT_EQ(answer.undefined, 0U) << name;
    }
    const Answer outside = answer_of(lab, file, "picked");
    EXPECT_GT(outside.undefined, 0U);
    EXPECT_THAT(outside.first_undefined, HasSubstr("element"));
}

// A driver crashes for such an index.
TEST(SamplerArrays, ADriverGetsNoIndexOutside) {
    const auto driver = std::make_shared<Driver>();
    EXPECT_THAT(picked_by(driver, {1, 4, -1, 1'000'000'000}), ElementsAre(2.0F, 4.0F, 4.0F, 4.0F));
    const Lab lab(options_of(file), driver);
    for (const char* name : by_indices) {
        const Answer answer = answer_of(lab, file, name);
        EXPECT_EQ(answer.outside(), 0U) << name << "\n" << answer;
        EXPECT_EQ(answer.undefined > 0, std::string_view(name) != "summed") << name << "\n" << answer;
    }
}

TEST(SamplerArrays, ADeviceTakesAnyIndexOrLacksTheFeature) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    for (const char* name : by_indices) {
        try {
            const Answer answer = answer_of(lab, file, name, inside);
            EXPECT_TRUE(answer.passed()) << name << "\n" << answer;
            EXPECT_EQ(answer_of(lab, file, name).outside(), 0U) << name;
        } catch (const backend::Unsupported& error) {
            EXPECT_THAT(error.what(),
                        HasSubstr("needs shaderSampledImageArrayNonUniformIndexing, which device \""));
        }
    }
}

TEST(SamplerArrays, OpenGlTakesConstants) {
    for (const char* device : {"gl:llvmpipe-4.5", "es:llvmpipe-3.1"}) {
        LabOptions options = options_of(file);
        options.device = device;
        options.validation = false;
        const auto opengl = test::opengl_device(options.device);
        if (opengl == nullptr) GTEST_SKIP() << options.device << " is not available";
        const Lab lab(options, opengl);
        for (const char* name : by_constants) {
            const Answer answer = answer_of(lab, file, name, inside);
            EXPECT_FALSE(answer.failed()) << device << " " << name << "\n" << answer;
        }
        EXPECT_THAT(results_of(lab, "passed", {somewhere}), ElementsAre(4.0F + 6.0F)) << device;
        EXPECT_THAT([&] { (void)answer_of(lab, file, "picked"); },
                    testing::ThrowsMessage<backend::Unsupported>(HasSubstr(
                        "picked: the index into an array of samplers is not constant and may differ")));
    }
}

TEST(SamplerArrays, OtherOnesAreLeftOutWithTheReason) {
    EXPECT_THAT(reason_of(file, "of_grid"), HasSubstr("it uses \"grid\", an image or sampler"));
    EXPECT_EQ(reason_of(file, "of_too_many"), "the array \"too_many\" has more than 16 samplers");
    EXPECT_EQ(reason_of(file, "of_far_too_many"), "the array \"far_too_many\" has more than 16 samplers");
    EXPECT_THAT(reason_of(file, "of_parameter"), HasSubstr("sampler2D[2] is not supported"));
}

TEST(SamplerArrays, AreExplainedAndHaveTheirIndices) {
    const OwnFunction own = function_of(file, "picked");
    const std::string text = shader::read_text(std::filesystem::path(FIXTURES) / file);
    EXPECT_EQ(ordinary_values(own.function, text, {}).at(0).text, "0 to 3");
    const KernelSource source{
        .file = file, .function = own.function, .images = own.images, .text = own.excerpt, .team = own.team};
    const std::vector<Word> third{2, somewhere[0], somewhere[1]};
    const Explanation all = explain({}, source, third, numbered_images("picked"));
    const auto sampled = std::ranges::find(all.steps, "OpImageSample", &ExplainedStep::operation);
    ASSERT_NE(sampled, all.steps.end());
    EXPECT_EQ(sampled->value, 3.0);
    const std::vector<Word> fifth{4, somewhere[0], somewhere[1]};
    EXPECT_THROW((void)explain({}, source, fifth, numbered_images("picked")), interpreter::Error);
}

}  // namespace gloam::check::own_sampler_arrays_test
