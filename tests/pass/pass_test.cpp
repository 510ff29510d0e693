// SPDX-License-Identifier: MIT
#include "pass/pass.hpp"

#include "backend/gl/device.hpp"
#include "support/lab.hpp"

namespace gloam::pass::pass_test {

using namespace subject;

// "": the device that tests run on.
Lab lab_on(const std::string& device) {
    if (device.empty()) return test::make_lab(FIXTURES);
    return Lab({.device = device, .include_roots = {FIXTURES}});
}

Image picture(glm::ivec2 size = {13, 9}) {
    return make_image<glm::vec4>(size, [](glm::ivec2 p) {
        return glm::vec4(p.x, p.y, p.x * p.y, 1.0F + static_cast<float>((7 * p.x + 3 * p.y) % 5));
    });
}

// The mean of the square of each pixel, in double.
Image mean_of(const Image& image, int radius) {
    return make_image<glm::vec4>(image.size, [&image, radius](glm::ivec2 pixel) {
        glm::dvec4 sum(0.0);
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x)
                sum += glm::dvec4(image.at<glm::vec4>(pixel + glm::ivec2(x, y)));
        return sum / ((2.0 * radius + 1.0) * (2.0 * radius + 1.0));
    });
}

constexpr double rounding = 2e-5;  // of values below 128

class OnEachDevice : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        try {
            lab_.emplace(lab_on(GetParam()));
        } catch (const backend::gl::Unavailable& error) {
            GTEST_SKIP() << error.what();
        }
    }

    std::optional<Lab> lab_;
};
INSTANTIATE_TEST_SUITE_P(Pass, OnEachDevice, testing::Values("", "interpreter", "gl:llvmpipe-4.5"));

PassInputs box_inputs(const Image& image, int radius, unsigned fault = 0) {
    return {{"source", image}, {"radius", radius}, {"fault", fault}};
}

TEST_P(OnEachDevice, IsAsTheReference) {
    const Image source = picture();
    const PassResult out = Pass(*lab_, "box.comp").run(box_inputs(source, 2));
    EXPECT_EQ(out.unwritten(), "");
    EXPECT_EQ(out.image("result").size, glm::ivec2(13, 9));
    const ImageComparison comparison = out.image("result").compare(mean_of(source, 2), rounding);
    EXPECT_TRUE(comparison) << comparison;
    const PassResult same = Pass(*lab_, "box.comp").run(box_inputs(source, 0));
    EXPECT_EQ(testing::PrintToString(same.image("result").compare(source)), "largest difference 0\n");
}

TEST_P(OnEachDevice, RoundsToTheFormatOfAnImage) {
    std::ifstream file(FIXTURES "/box.comp");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    text.replace(text.rfind("rgba32f"), 7, "rgb10_a2");
    const Image one = make_image<glm::vec4>({1, 1}, [](auto) { return glm::vec4(0.1, 0.2, 0.4, 0.4); });
    const Image rounded =
        make_image<glm::vec4>({1, 1}, [](auto) { return glm::vec4(102, 205, 409, 341) / 1023.0F; });
    const Pass pass(*lab_, "box.comp", module::compile({"box.comp", text}, {}));
    EXPECT_TRUE(pass.run(box_inputs(one, 0)).image("result").compare(rounded, 1e-6));
}

TEST_P(OnEachDevice, FindsABorderPixelThatIsSkipped) {
    const Image source = picture();
    const PassResult out = Pass(*lab_, "box.comp").run(box_inputs(source, 1, 1));
    EXPECT_EQ(out.unwritten(), "box.comp: result: 1 of 117 pixels were not written, the first (12, 8)\n");
    const ImageComparison comparison = out.image("result").compare(mean_of(source, 1), rounding);
    EXPECT_FALSE(comparison);
    EXPECT_EQ(comparison.outside, 1U);
    EXPECT_EQ(comparison.worst, glm::ivec2(12, 8));
    EXPECT_THAT(
        comparison.story,
        StartsWith("box.comp: result: 1 of 117 pixels differ by more than 2e-05, 1 of them not written\n"
                   "  pixel (12, 8) component 0: got nan"));
    EXPECT_TRUE(std::isnan(out.image("result").at<glm::vec4>({12, 8}).x));
}

TEST(Pass, FindsSwappedChannelsAndNamesTheWorstPixel) {
    const Lab lab = lab_on("");
    const Image source = picture({4, 3});
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 0, 2));
    const ImageComparison comparison = out.image("result").compare(source, 1.5);
    EXPECT_EQ(comparison.outside, 4U);
    EXPECT_EQ(comparison.largest, 3.0);
    EXPECT_EQ(comparison.story,
              "box.comp: result: 4 of 12 pixels differ by more than 1.5\n"
              "  pixel (3, 0) component 0: got 0 (0x00000000), expected 3 (0x40400000), difference 3\n");
}

TEST(Pass, NanAndInfinityEqualThemselvesAlone) {
    const Lab lab = lab_on("");
    Image source = picture({4, 3});
    source.words[0] = 0x7FC00000U;
    source.words[9] = 0x7F800000U;
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 0));
    EXPECT_TRUE(out.image("result").compare(source));
    const ImageComparison comparison = out.image("result").compare(picture({4, 3}), 1e30);
    EXPECT_EQ(comparison.outside, 2U);
    EXPECT_TRUE(std::isinf(comparison.largest));
}

struct Light {
    glm::vec3 color;
    float power;
};

PassInputs block_inputs() {
    return {{"turn", glm::mat2x3(1, 2, 3, 4, 5, 6)},
            {"doubled", true},
            {"weights", std::array{glm::vec2(0), glm::vec2(0), glm::vec2(1, 10)}},
            {"count", 2U},
            {"lights", std::vector<Light>{{{1, 2, 4}, 0.5F}, {{8, 16, 32}, 0.25F}}},
            {"bins", std::vector<unsigned>{5, 6, 7, 8}},
            {"7", 2U},
            {"scale", 4.0}};
}

TEST_P(OnEachDevice, HasBlocksOfEveryKind) {
    const PassResult out = Pass(*lab_, "blocks.comp").run(block_inputs(), {.groups = {2, 1, 1}});
    const glm::vec3 sum = 8.0F * (0.5F * glm::vec3(1, 2, 4) + 0.25F * glm::vec3(8, 16, 32));
    EXPECT_EQ(out.values<glm::vec3>("total"), std::vector{glm::vec3(41, 52, 63) + sum});
    EXPECT_EQ(out.values<float>("powers"), (std::vector{0.5F, 0.25F}));
    EXPECT_EQ(out.values<unsigned>("bins"), (std::vector<unsigned>{7, 8, 9, 10}));
    EXPECT_EQ(out.unwritten(), "blocks.comp: untouched: 1 of 1 words were not written\n");
    expect_error<std::invalid_argument>([&] { (void)out.values<int>("bins"); },
                                        {"\"bins\" holds uint, asked for int"});
    expect_error<std::invalid_argument>(
        [&] { (void)out.values<int>("bin"); },
        {"writes no buffer member \"bin\"", "bins, powers, total, untouched"});
}

Image checkers(bool linear) {
    Image image = make_image<glm::vec4>(
        {4, 4}, [](glm::ivec2 p) { return glm::vec4(static_cast<float>((p.x + p.y) % 2)); });
    if (linear) image.sampling = Image::Sampling{.linear = true, .wrap = backend::Wrap::edge};
    return image;
}

TEST_P(OnEachDevice, HasSamplersAndSmallFormats) {
    const Pass magnify(*lab_, "magnify.comp");
    const PassOptions twice{.size = {8, 8}};
    const PassResult nearest = magnify.run({{"picture", checkers(false)}}, twice);
    const auto near = [](glm::ivec2 p) { return glm::vec4(static_cast<float>((p.x / 2 + p.y / 2) % 2)); };
    EXPECT_TRUE(nearest.image("large").compare(make_image<glm::vec4>({8, 8}, near)));
    const PassResult linear = magnify.run({{"picture", checkers(true)}}, twice);
    EXPECT_NEAR(linear.image("large").at<glm::vec4>({1, 0}).x, 0.25F, 1.0 / 255.0);
    const auto number = [](glm::ivec2 p) { return static_cast<unsigned>(8 * p.y + p.x); };
    EXPECT_TRUE(linear.image("number").compare(make_image<unsigned>({8, 8}, number)));
    const auto first = [](glm::ivec2 p) { return static_cast<unsigned>(8 * p.y); };
    const ImageComparison wrong = linear.image("number").compare(make_image<unsigned>({8, 8}, first));
    EXPECT_THAT(wrong.story,
                HasSubstr("56 of 64 pixels differ by more than 0\n"
                          "  pixel (7, 0) component 0: got 7 (0x00000007), expected 0 (0x00000000), "));
}

TEST_P(OnEachDevice, HasLayersAndTellsBlocksApart) {
    Image layers = make_image<glm::vec4>({2, 2}, [](glm::ivec2) { return glm::vec4(7.0F); });
    const Image second = make_image<glm::vec4>(
        {2, 2}, [](glm::ivec2 p) { return glm::vec4(static_cast<float>(p.x + 2 * p.y)); });
    layers.words.insert(layers.words.end(), second.words.begin(), second.words.end());
    layers.sampling = Image::Sampling{.depth = 2};
    const PassResult out =
        Pass(*lab_, "layers.comp").run({{"layers", layers}, {"First.scale", 0.5F}, {"Second.scale", 0.1F}});
    const auto halves = [](glm::ivec2 p) { return glm::dvec2(0.5 * (p.x + 2 * p.y), 0x1.998p-4); };
    const ImageComparison same = out.image("result").compare(make_image<glm::vec2>({2, 2}, halves));
    EXPECT_TRUE(same) << same;
}

TEST_P(OnEachDevice, ReadsCubesAndCompares) {
    Image sky = make_image<float>({1, 1}, [](glm::ivec2) { return 1.0F; });
    for (int face = 1; face < 6; ++face) sky.words.push_back(to_word(static_cast<float>(face + 1)));
    sky.sampling = Image::Sampling{.depth = 6};
    Image depths = make_image<float>({1, 1}, [](glm::ivec2) { return 0.5F; });
    depths.sampling = Image::Sampling{.compare = backend::Compare::greater};
    const PassResult out = Pass(*lab_, "cube.comp").run({{"sky", sky}, {"depths", depths}}, {.size = {6, 1}});
    const auto faces = [](glm::ivec2 p) { return glm::dvec2(p.x + 1, p.x > 2 ? 1 : 0); };
    const ImageComparison same = out.image("result").compare(make_image<glm::vec2>({6, 1}, faces));
    EXPECT_TRUE(same) << same;
}

TEST(Pass, OfTheInterpreterFindsRacesAndAccessesOutside) {
    const Lab lab = lab_on("interpreter");
    expect_error<backend::Fault>(
        [&] {
            (void)Pass(lab, "racy.comp").run({{"numbers", std::array<float, 4>{}}}, {.groups = {1, 1, 1}});
        },
        {"racy.comp: a race: invocation 1", "word 1 of \"Numbers\"", "racy.comp:9"});
    expect_error<backend::Fault>(
        [&] {
            (void)Pass(lab, "outside.comp").run({{"result", make_image<float>({3, 3}, [](auto) {
                                                      return 0;
                                                  })}});
        },
        {"outside.comp: texel 3 of the 3 of \"result\"", "outside.comp:3"});
}

TEST_P(OnEachDevice, SharesMemoryInAGroup) {
    const PassResult out = Pass(*lab_, "shared.comp")
                               .run({{"numbers", std::array{4.0F, 3.0F, 2.0F, 1.0F}}}, {.groups = {1, 1, 1}});
    EXPECT_EQ(out.values<float>("numbers"), std::vector<float>(4, 4.0F));
}

// The messages of passes.

class PassErrors : public testing::Test {
  protected:
    void expect_refused(const std::string& file, const PassInputs& inputs,
                        std::initializer_list<std::string> parts, const PassOptions& options = {}) const {
        expect_error<std::invalid_argument>([&] { (void)Pass(lab_, file).run(inputs, options); }, parts);
    }
    // Of box.comp, with another input.
    void expect_box_refused(const std::string& name, const PassValue& value,
                            const std::string& message) const {
        PassInputs inputs = box_;
        inputs.insert_or_assign(name, value);
        expect_refused("box.comp", inputs, {"box.comp: " + message});
    }

    const Lab lab_ = lab_on("");
    const PassInputs box_ = box_inputs(picture({5, 4}), 0);
    const Image floats_ = make_image<float>({5, 4}, [](auto) { return 1.0F; });
    const Image numbers_ = make_image<unsigned>({3, 3}, [](auto) { return 0U; });
};

TEST_F(PassErrors, NameWhatIsUnknownOrMissing) {
    expect_box_refused("radios", 1,
                       "\"radios\" is no input, expected among: source (image of vec4), "
                       "result (image of vec4), radius (int), fault (uint)");
    expect_refused("magnify.comp", {{"large", picture({2, 2})}},
                   {"magnify.comp: \"picture\" (sampler2D) is not given; the pass takes: picture"});
    expect_refused("box.comp", {{"source", picture()}, {"fault", 0U}},
                   {"box.comp: \"radius\" (int) is not given"});
    expect_refused("outside.comp", {{"size", 1}}, {"is no input"});
    expect_refused("outside.comp", {},
                   {"\"result\" (image of float) is not given, and it is not `writeonly`"});
    expect_refused("layers.comp", {{"scale", 1.0F}},
                   {"\"scale\" is no input", "First.scale (float), ", "Second.scale (float)"});
}

TEST_F(PassErrors, NameTheExpectedType) {
    expect_box_refused("radius", 1.0F, "\"radius\" is float, expected int");
    expect_box_refused("radius", picture({2, 2}), "\"radius\" is an image, expected int");
    expect_box_refused("radius", std::vector{1, 2}, "\"radius\" is int[2], expected int");
    expect_box_refused("source", 1, "\"source\" is int, expected image of vec4");
    expect_box_refused("source", floats_,
                       "\"source\" is an image of float, expected image of vec4 (rgba32f)");
    Image cut = picture({2, 2});
    cut.words.pop_back();
    expect_box_refused("source", cut, "\"source\" is 2 x 2 with 15 words, expected 16");
    const PassOptions square{.size = {2, 2}};
    expect_refused("magnify.comp", {{"picture", numbers_}},
                   {"\"picture\" is an image of uint, expected one of vec4 for sampler2D"}, square);
    Image tenths = make_image<glm::vec4>({2, 2}, [](auto) { return glm::vec4(0.1F); });
    tenths.sampling = Image::Sampling{};
    expect_refused("magnify.comp", {{"picture", tenths}},
                   {"\"picture\" holds 0.1 (0x3dcccccd), expected floats of 16 bits"}, square);
    tenths = picture({2, 2});
    tenths.sampling = Image::Sampling{.levels = 2};
    expect_refused("magnify.comp", {{"picture", tenths}}, {"\"picture\" is", "disagree"}, square);
    expect_refused("blocks.comp", {{"lights", std::vector<glm::vec4>(2)}},
                   {"\"lights\" is vec4[2], expected Light[]"}, {.groups = {1, 1, 1}});
}

TEST_F(PassErrors, NameWhatHasNoSize) {
    expect_refused("magnify.comp", {{"picture", picture({2, 2})}, {"number", numbers_}},
                   {"magnify.comp: \"large\" has no size: \"number\" is 3 x 3, \"picture\" is 2 x 2"});
    expect_refused("shared.comp", {{"numbers", std::array<float, 4>{}}},
                   {"shared.comp: writes no image, expected PassOptions::groups"});
    expect_refused("blocks.comp", {{"3", 1.0F}, {"scale", 2.0F}}, {"\"scale\" is given twice"});
    expect_refused("blocks.comp", {{"7", 0U}}, {"is not given"});
}

TEST_F(PassErrors, NameTheFileAndWhatAPassCannotHave) {
    expect_refused("none.comp", {}, {"none.comp: "});
    expect_refused("refused_set.comp", {}, {"\"result\" has set 1 and binding 0, expected set 0"});
    expect_refused("refused_samples.comp", {},
                   {"\"sky\" is a sampler2DMS, expected a sampler like sampler2D"});
    const PassResult out = Pass(lab_, "box.comp").run(box_);
    expect_error<std::invalid_argument>([&] { (void)out.image("source"); },
                                        {"box.comp: writes no image \"source\", expected one of: result"});
    expect_error<std::invalid_argument>([&] { (void)out.image("result").compare(picture({4, 5})); },
                                        {"box.comp: result: is 5 x 4, the reference 4 x 5"});
    expect_error<std::invalid_argument>([&] { (void)out.image("result").compare(floats_); },
                                        {"box.comp: result: is compared with float, expected vec4"});
}

}  // namespace gloam::pass::pass_test
