// SPDX-License-Identifier: MIT
// The messages of passes, and golden images.
#include "base/image_files.hpp"
#include "support/files.hpp"
#include "support/lab.hpp"

namespace gloam::check::pass_errors_test {

Lab pass_lab() {
    return test::make_lab(std::string(FIXTURES) + "/passes");
}

Image ramp(glm::ivec2 size) {
    return make_image<glm::vec4>(size,
                                 [](glm::ivec2 p) { return 0.125F * glm::vec4(p.x, p.y, p.x + p.y, 1); });
}

PassInputs box_inputs() {
    return {{"source", ramp({5, 4})}, {"radius", 0}, {"fault", 0U}};
}

class PassErrors : public testing::Test {
  protected:
    void expect_refused(const std::string& file, const std::string& name, const PassValue& value,
                        std::initializer_list<std::string> parts, const PassOptions& options = {}) {
        PassInputs inputs = file == "box.comp" ? box_inputs() : PassInputs{};
        inputs.insert_or_assign(name, value);
        const Pass pass(lab_, file);
        expect_error<std::invalid_argument>([&] { (void)pass.run(inputs, options); }, parts);
    }

    Lab lab_ = pass_lab();
};

TEST_F(PassErrors, NameWhatIsUnknownOrMissing) {
    expect_refused("box.comp", "radios", 1,
                   {"box.comp: \"radios\" is no input, expected among: source (image of vec4), "
                    "result (image of vec4), radius (int), fault (uint)"});
    expect_refused("magnify.comp", "large", ramp({2, 2}),
                   {"magnify.comp: \"picture\" (sampler2D) is not given; the pass takes: picture"});
    PassInputs inputs = box_inputs();
    inputs.erase("radius");
    const Pass box(lab_, "box.comp");
    expect_error<std::invalid_argument>([&] { (void)box.run(inputs); },
                                        {"box.comp: \"radius\" (int) is not given"});
    expect_refused("outside.comp", "size", 1, {"is no input"});
    const Pass outside(lab_, "outside.comp");
    expect_error<std::invalid_argument>(
        [&] { (void)outside.run({}); },
        {"\"result\" (image of float) is not given, and it is not `writeonly`"});
    expect_error<std::invalid_argument>([&] { (void)box.run(box_inputs()).image("results"); },
                                        {"box.comp: writes no image \"results\", expected one of: result"});
}

TEST_F(PassErrors, NameTheExpectedType) {
    expect_refused("box.comp", "radius", 1.0F, {"box.comp: \"radius\" is float, expected int"});
    expect_refused("box.comp", "radius", ramp({2, 2}), {"\"radius\" is an image, expected int"});
    expect_refused("box.comp", "radius", std::vector{1, 2}, {"\"radius\" is int[2], expected int"});
    expect_refused("box.comp", "source", 1, {"\"source\" is int, expected image of vec4"});
    expect_refused("box.comp", "source", make_image<float>({2, 2}, [](auto) { return 0.0F; }),
                   {"\"source\" is an image of float, expected image of vec4 (rgba32f)"});
    Image cut = ramp({2, 2});
    cut.words.pop_back();
    expect_refused("box.comp", "source", cut, {"\"source\" is 2 x 2 with 15 words, expected 16"});
    expect_refused("magnify.comp", "picture", make_image<unsigned>({2, 2}, [](auto) { return 0U; }),
                   {"\"picture\" is an image of uint, expected one of vec4 for sampler2D"}, {.size = {2, 2}});
    Image tenths = make_image<glm::vec4>({2, 2}, [](auto) { return glm::vec4(0.1F); });
    tenths.sampling = Image::Sampling{};
    expect_refused("magnify.comp", "picture", tenths,
                   {"\"picture\" holds 0.1 (0x3dcccccd), expected floats of 16 bits"}, {.size = {2, 2}});
    tenths = ramp({2, 2});
    tenths.sampling = Image::Sampling{.levels = 2};
    expect_refused("magnify.comp", "picture", tenths, {"\"picture\" is", "disagree"}, {.size = {2, 2}});
    expect_refused("blocks.comp", "lights", std::vector<glm::vec4>(2),
                   {"\"lights\" is vec4[2], expected Light[]"}, {.groups = {1, 1, 1}});
}

TEST_F(PassErrors, NameWhatHasNoSize) {
    const Pass magnify(lab_, "magnify.comp");
    expect_error<std::invalid_argument>(
        [&] {
            (void)magnify.run({{"picture", ramp({2, 2})},
                               {"number", make_image<unsigned>({3, 3}, [](auto) { return 0U; })}});
        },
        {"magnify.comp: \"large\" has no size: \"number\" is 3 x 3, \"picture\" is 2 x 2"});
    const Pass shared(lab_, "shared.comp");
    expect_error<std::invalid_argument>([&] { (void)shared.run({{"numbers", std::array<float, 4>{}}}); },
                                        {"shared.comp: writes no image, expected PassOptions::groups"});
    const Pass blocks(lab_, "blocks.comp");
    expect_error<std::invalid_argument>([&] { (void)blocks.run({{"3", 1.0F}, {"scale", 2.0F}}); },
                                        {"\"scale\" is given twice"});
    expect_error<std::invalid_argument>([&] { (void)blocks.run({{"7", 0U}}); }, {"is not given"});
}

TEST_F(PassErrors, NameTheVertices) {
    const Pass pass(lab_, "corners.vert", "shade.frag");
    const auto refused = [&](const PassInputs& inputs, std::initializer_list<std::string> parts) {
        expect_error<std::invalid_argument>([&] { (void)pass.run(inputs, {.size = {2, 2}}); }, parts);
    };
    const PassValue corners = std::vector<glm::vec2>(3);
    refused({{"corner", std::vector<glm::vec3>(3)}}, {"\"corner\" is vec3[3], expected vec2[]"});
    refused({{"corner", corners}, {"value", std::vector<float>(2)}, {"offset", glm::vec2(0)}},
            {"\"value\" has 2 vertices, \"corner\" has 3"});
    refused(
        {{"corner", std::vector<glm::vec2>(4)}, {"value", std::vector<float>(4)}, {"offset", glm::vec2(0)}},
        {"4 vertices, expected triangles of three each"});
    refused({{"corner", corners}, {"value", std::vector<float>(3)}},
            {"corners.vert and shade.frag: \"offset\" (vec2) is not given"});
}

TEST_F(PassErrors, NameTheFileAndWhatAPassCannotHave) {
    expect_error<std::invalid_argument>([&] { Pass(lab_, "none.comp"); }, {"none.comp: "});
    expect_error<std::invalid_argument>([&] { Pass(lab_, "refused_set.comp"); },
                                        {"\"result\" has set 1 and binding 0, expected set 0"});
    expect_error<std::invalid_argument>([&] { Pass(lab_, "refused_samples.comp"); },
                                        {"\"sky\" is a sampler2DMS, expected a sampler like sampler2D"});
    expect_error<std::invalid_argument>(
        [&] { Pass(lab_, "whole.vert", "refused_integers.frag"); },
        {"\"number\" is a colour output of uint at location 0, expected floats"});
    const Pass layers(lab_, "layers.comp");
    expect_error<std::invalid_argument>(
        [&] { (void)layers.run({{"scale", 1.0F}}); },
        {"\"scale\" is no input", "First.scale (float), ", "Second.scale (float)"});
    EXPECT_THROW(Pass(lab_, "tone.frag"), shader::CompileError);
    const Pass box(lab_, "box.comp");
    const PassResult out = box.run(box_inputs());
    expect_error<std::invalid_argument>([&] { (void)out.image("result").compare(ramp({4, 5})); },
                                        {"box.comp: result: is 5 x 4, the reference 4 x 5"});
    expect_error<std::invalid_argument>([&] { (void)out.image("result").compare([](auto) { return 1.0; }); },
                                        {"box.comp: result: is compared with float, expected vec4"});
}

// The pass's output, compared with a golden file in a folder of its own.
class GoldenImages : public PassErrors {
  protected:
    [[nodiscard]] ImageComparison compared(const PassImage& image, const ImageBudget& budget = {}) const {
        return is_golden(image, folder_.path() / "box.pfm", budget, folder_.path());
    }
    [[nodiscard]] PassImage output(unsigned fault = 0) const {
        PassInputs inputs = box_inputs();
        inputs.insert_or_assign("fault", fault);
        return Pass(lab_, "box.comp").run(inputs).image("result");
    }
    [[nodiscard]] bool wrote(const std::string& name) const {
        return std::filesystem::exists(folder_.path() / name);
    }
    void update(const PassImage& image) const {
        const test::ScopedVariable once("GLOAM_UPDATE_GOLDEN", "1");
        EXPECT_TRUE(compared(image));
    }

    test::TemporaryDirectory folder_;
};

TEST_F(GoldenImages, AreWrittenOnlyWhenAskedFor) {
    const ImageComparison missing = compared(output());
    EXPECT_THAT(missing.story, AllOf(HasSubstr("box.comp: result: the golden image cannot be compared"),
                                     HasSubstr("box.pfm"), HasSubstr("GLOAM_UPDATE_GOLDEN=1")));
    EXPECT_FALSE(wrote("box.pfm"));
    EXPECT_TRUE(wrote("box.actual.pfm"));
    update(output());
    EXPECT_TRUE(compared(output()));
    EXPECT_EQ(test::read_file(folder_.path() / "box.pfm"),
              test::read_file(folder_.path() / "box.actual.pfm"));
}

TEST_F(GoldenImages, ShowDifferences) {
    update(output());
    const std::string kept = test::read_file(folder_.path() / "box.pfm");
    const ImageComparison swapped = compared(output(2), {.ulp = 1});
    EXPECT_THAT(swapped.story,
                AllOf(StartsWith("golden image "), HasSubstr("pixels outside 1 ulp\n  pixel (0, 3)"),
                      HasSubstr("box.difference.png")));
    for (const char* name : {"box.actual.png", "box.difference.png"})
        EXPECT_THAT(test::read_file(folder_.path() / name), StartsWith("\x89PNG")) << name;
    EXPECT_EQ(test::read_file(folder_.path() / "box.pfm"), kept);
    EXPECT_TRUE(compared(output(2), {.absolute = 0.5}));
}

TEST_F(GoldenImages, AreNotReplacedByWhatWasNotWritten) {
    const test::ScopedVariable always("GLOAM_UPDATE_GOLDEN", "1");
    EXPECT_FALSE(compared(output(1)));
    EXPECT_FALSE(wrote("box.pfm"));
}

TEST_F(GoldenImages, OfAnotherSizeOrMalformedFail) {
    (void)folder_.write("box.pfm", base::to_pfm(std::vector<float>(20), 5, 4, 1));
    EXPECT_THAT(compared(output()).story,
                HasSubstr("box.pfm is 5 x 4 with 1 channels, expected 5 x 16 with 1\n"));
    (void)folder_.write("box.pfm", "P6 5 4 255\n");
    EXPECT_THAT(compared(output()).story,
                HasSubstr("box.pfm: not a PFM: expected it to begin with Pf or PF\n"));
}

TEST_F(GoldenImages, KeepEveryBit) {
    PassImage color{
        make_image<glm::vec3>({2, 1}, [](glm::ivec2 p) { return glm::vec3(p.x, -0.0F, NAN); }), "color", {}};
    update(color);
    EXPECT_THAT(test::read_file(folder_.path() / "box.pfm"), StartsWith("Pf\n2 3\n"));
    EXPECT_TRUE(compared(color));
    PassImage number{
        make_image<unsigned>({2, 1}, [](glm::ivec2 p) { return 0x7F800001U + static_cast<unsigned>(p.x); }),
        "number",
        {}};
    update(number);
    EXPECT_TRUE(compared(number));
    ++number.words[0];
    EXPECT_EQ(compared(number).outside, 1U);
}

}  // namespace gloam::check::pass_errors_test
