// SPDX-License-Identifier: MIT
#include "support/lab.hpp"

namespace gloam::check::pass_test {

Lab pass_lab() {
    return test::make_lab(std::string(FIXTURES) + "/passes");
}

Lab interpreted_lab() {
    return Lab(
        {.device = std::string(interpreter_name), .include_roots = {std::string(FIXTURES) + "/passes"}});
}

Image picture(glm::ivec2 size = {13, 9}) {
    return make_image<glm::vec4>(size, [](glm::ivec2 p) {
        return glm::vec4(p.x, p.y, p.x * p.y, 1.0F + static_cast<float>((7 * p.x + 3 * p.y) % 5));
    });
}

// The mean of the square of `picture`, in double.
auto mean_of(const Image& image, int radius) {
    return [&image, radius](glm::ivec2 pixel) {
        glm::dvec4 sum(0.0);
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x)
                sum += glm::dvec4(image.at<glm::vec4>(pixel + glm::ivec2(x, y)));
        return sum / ((2.0 * radius + 1.0) * (2.0 * radius + 1.0));
    };
}

PassInputs box_inputs(const Image& image, int radius, unsigned fault = 0) {
    return {{"source", image}, {"radius", radius}, {"fault", fault}};
}

std::string text_of(const ImageComparison& comparison) {
    std::ostringstream text;
    text << comparison;
    return text.str();
}

TEST(Pass, IsItsClosedForm) {
    const Lab lab = pass_lab();
    const Image source = picture();
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 2));
    EXPECT_EQ(out.unwritten(), "");
    EXPECT_EQ(out.image("result").size, glm::ivec2(13, 9));
    const ImageComparison comparison = out.image("result").compare(mean_of(source, 2), {.ulp = 2});
    EXPECT_TRUE(comparison) << comparison;
    EXPECT_THAT(text_of(comparison), HasSubstr("117 pixels are as expected"));
}

TEST(Pass, FindsABorderPixelThatIsSkipped) {
    const Lab lab = pass_lab();
    const Image source = picture();
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 1, 1));
    EXPECT_EQ(out.unwritten(), "box.comp: result: 1 of 117 pixels were not written, the first (12, 8)\n");
    const ImageComparison comparison = out.image("result").compare(mean_of(source, 1), {.ulp = 2});
    EXPECT_FALSE(comparison);
    EXPECT_EQ(comparison.unwritten, 1U);
    EXPECT_EQ(comparison.story,
              "box.comp: result: 1 of 117 pixels outside 2 ulp; not written 1, the first (12, 8)\n");
    EXPECT_TRUE(std::isnan(out.image("result").at<glm::vec4>({12, 8}).x));
}

TEST(Pass, FindsSwappedChannelsAndNamesTheWorstPixel) {
    const Lab lab = pass_lab();
    const Image source = picture({4, 3});
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 0, 2));
    const ImageComparison comparison = out.image("result").compare(source, {.absolute = 1.5});
    EXPECT_EQ(comparison.outside, 4U);
    EXPECT_EQ(comparison.worst, glm::ivec2(3, 0));
    EXPECT_THAT(comparison.story, StartsWith("box.comp: result: 4 of 12 pixels outside 1.5 absolute\n"
                                             "  pixel (3, 0) component 2: got 3 (0x40400000), expected 0 "
                                             "(0x00000000): 2.14087e+45 ulp, 3 absolute\n"
                                             "  pixel (3, 2) component 0: got 6 "));
}

TEST(Pass, FindsAnOffsetOfOne) {
    const Lab lab = pass_lab();
    const Image source = picture();
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 0, 3));
    EXPECT_EQ(out.image("result").compare(source).outside, 12U * 9U);  // the last column reads itself
    EXPECT_TRUE(Pass(lab, "box.comp").run(box_inputs(source, 0)).image("result").compare(source));
}

TEST(Pass, CountsNanAndInfinity) {
    const Lab lab = pass_lab();
    Image source = picture({4, 3});
    source.words[0] = 0x7FC00000U;
    source.words[9] = 0x7F800000U;
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 0));
    EXPECT_TRUE(out.image("result").compare(source));
    const ImageComparison comparison = out.image("result").compare(picture({4, 3}), {.ulp = 1});
    EXPECT_THAT(comparison.story, HasSubstr("2 of 12 pixels outside 1 ulp; NaN 1, infinite 1"));
    EXPECT_FALSE(out.image("result").compare(picture({4, 3}), {.similarity = 0.1}));
}

TEST(Pass, IsJudgedBySimilarity) {
    const Lab lab = pass_lab();
    const Image source = make_image<glm::vec4>({32, 32}, [](glm::ivec2 p) {
        return glm::vec4(0.5F + 0.25F * std::sin(0.2F * static_cast<float>(p.x + p.y)));
    });
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 1));
    EXPECT_TRUE(out.image("result").compare(source, {.similarity = 0.99}));
    const Image flat = make_image<glm::vec4>({32, 32}, [](glm::ivec2) { return glm::vec4(0.5F); });
    const ImageComparison comparison = out.image("result").compare(flat, {.similarity = 0.99});
    EXPECT_THAT(comparison.story,
                HasSubstr("1024 of 1024 pixels outside a similarity of 0.99, similarity 0."));
    EXPECT_THAT(comparison.story, HasSubstr("\n  pixel ("));
}

TEST(Pass, HasProperties) {
    const Lab lab = pass_lab();
    const Pass box(lab, "box.comp");
    const PassInputs identity = box_inputs(picture(), 0);
    const PassInputs mean = box_inputs(picture(), 1);
    EXPECT_TRUE(box.idempotent(identity, "source", "result"));
    EXPECT_THAT(box.idempotent(mean, "source", "result", {.ulp = 2}).story,
                StartsWith("not idempotent: box.comp: result: "));
    for (const Mirror mirror : {Mirror::x, Mirror::y, Mirror::transpose})
        EXPECT_TRUE(box.symmetric(mirror, mean, "source", "result", {.ulp = 4}));
    EXPECT_THAT(box.symmetric(Mirror::x, box_inputs(picture(), 1, 3), "source", "result", {.ulp = 4}).story,
                StartsWith("not symmetric: box.comp: result: "));
    EXPECT_TRUE(box.symmetric(Mirror::y, box_inputs(picture(), 1, 3), "source", "result", {.ulp = 4}));
    EXPECT_TRUE(box.keeps_energy(identity, "source", "result", 0.0));
    EXPECT_TRUE(box.keeps_energy(mean, "source", "result", 1e-6));
    EXPECT_THAT(box.keeps_energy(box_inputs(picture(), 2), "source", "result", 1e-6).story,
                HasSubstr("energy is not kept: component 3 of \"source\" sums to "));
    EXPECT_THAT(box.keeps_energy(box_inputs(picture(), 0, 1), "source", "result", 1e-6).story,
                HasSubstr("not written"));
    expect_error<std::invalid_argument>([&] { (void)box.idempotent(identity, "sauce", "result"); },
                                        {"sauce"});
}

TEST(Pass, MirrorsImages) {
    const Image image = make_image<int>({3, 2}, [](glm::ivec2 p) { return 10 * p.y + p.x; });
    EXPECT_EQ(mirrored(image, Mirror::x).at<int>({0, 1}), 12);
    EXPECT_EQ(mirrored(image, Mirror::y).at<int>({0, 1}), 0);
    EXPECT_EQ(mirrored(image, Mirror::transpose).size, glm::ivec2(2, 3));
    EXPECT_EQ(mirrored(image, Mirror::transpose).at<int>({1, 2}), 12);
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

void expect_blocks(const Lab& lab) {
    const PassResult out = Pass(lab, "blocks.comp").run(block_inputs(), {.groups = {2, 1, 1}});
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

TEST(Pass, HasBlocksOfEveryKind) {
    expect_blocks(pass_lab());
    expect_blocks(interpreted_lab());
}

Image checkers(bool linear) {
    Image image = make_image<glm::vec4>(
        {4, 4}, [](glm::ivec2 p) { return glm::vec4(static_cast<float>((p.x + p.y) % 2)); });
    if (linear) image.sampling = Image::Sampling{.linear = true, .wrap = backend::Wrap::edge};
    return image;
}

void expect_magnified(const Lab& lab) {
    const Pass magnify(lab, "magnify.comp");
    const PassOptions twice{.size = {8, 8}};
    const PassResult nearest = magnify.run({{"picture", checkers(false)}}, twice);
    const auto near = [](glm::ivec2 p) { return glm::dvec4((p.x / 2 + p.y / 2) % 2); };
    EXPECT_TRUE(nearest.image("large").compare(near));
    const PassResult linear = magnify.run({{"picture", checkers(true)}}, twice);
    EXPECT_NEAR(linear.image("large").at<glm::vec4>({1, 0}).x, 0.25F, 1.0 / 255.0);
    const auto number = [](glm::ivec2 p) { return static_cast<unsigned>(8 * p.y + p.x); };
    EXPECT_TRUE(linear.image("number").compare(number));
    const ImageComparison wrong =
        linear.image("number").compare([](glm::ivec2 p) { return static_cast<unsigned>(8 * p.y); });
    EXPECT_THAT(wrong.story, HasSubstr("56 of 64 pixels outside exact\n"
                                       "  pixel (7, 0): got 7 (0x00000007), expected 0: 7 absolute\n"));
}

TEST(Pass, HasSamplersAndSmallFormats) {
    expect_magnified(pass_lab());
    expect_magnified(interpreted_lab());
}

void expect_layers(const Lab& lab) {
    Image layers = make_image<glm::vec4>({2, 2}, [](glm::ivec2) { return glm::vec4(7.0F); });
    const Image second = make_image<glm::vec4>(
        {2, 2}, [](glm::ivec2 p) { return glm::vec4(static_cast<float>(p.x + 2 * p.y)); });
    layers.words.insert(layers.words.end(), second.words.begin(), second.words.end());
    layers.sampling = Image::Sampling{.depth = 2};
    const PassResult out =
        Pass(lab, "layers.comp").run({{"layers", layers}, {"First.scale", 0.5F}, {"Second.scale", 0.1F}});
    const auto halves = [](glm::ivec2 p) { return glm::dvec2(0.5 * (p.x + 2 * p.y), 0x1.998p-4); };
    const ImageComparison same = out.image("result").compare(halves);
    EXPECT_TRUE(same) << same;
}

TEST(Pass, HasLayersAndTellsBlocksApart) {
    expect_layers(pass_lab());
    expect_layers(interpreted_lab());
}

void expect_faces(const Lab& lab) {
    Image sky = make_image<float>({1, 1}, [](glm::ivec2) { return 1.0F; });
    for (int face = 1; face < 6; ++face) sky.words.push_back(to_word(static_cast<float>(face + 1)));
    sky.sampling = Image::Sampling{.depth = 6};
    Image depths = make_image<float>({1, 1}, [](glm::ivec2) { return 0.5F; });
    depths.sampling = Image::Sampling{.compare = backend::Compare::greater};
    const PassResult out = Pass(lab, "cube.comp").run({{"sky", sky}, {"depths", depths}}, {.size = {6, 1}});
    const auto faces = [](glm::ivec2 p) { return glm::dvec2(p.x + 1, p.x > 2 ? 1 : 0); };
    const ImageComparison same = out.image("result").compare(faces);
    EXPECT_TRUE(same) << same;
}

TEST(Pass, ReadsCubesAndCompares) {
    expect_faces(pass_lab());
    expect_faces(interpreted_lab());
}

PassInputs triangle() {
    return {{"corner", std::vector<glm::vec2>{{-1, -1}, {0, -1}, {-1, 7}}},
            {"value", std::vector<float>{3, 3, 3}},
            {"offset", glm::vec2(0)}};
}

TEST(Pass, OfTheInterpreterIsThatOfTheDevice) {
    const Lab lab = interpreted_lab();
    const Image source = picture();
    const PassResult out = Pass(lab, "box.comp").run(box_inputs(source, 2));
    EXPECT_TRUE(out.image("result").compare(mean_of(source, 2), {.ulp = 2}));
    const Lab device = pass_lab();
    EXPECT_TRUE(out.image("result").compare(
        Pass(device, "box.comp").run(box_inputs(source, 2)).image("result"), {.ulp = 4}));
    EXPECT_EQ(Pass(lab, "box.comp").run(box_inputs(source, 1, 1)).image("result").compare(source).unwritten,
              1U);
    expect_error<backend::Fault>(
        [&] {
            (void)Pass(lab, "racy.comp").run({{"numbers", std::array<float, 4>{}}}, {.groups = {1, 1, 1}});
        },
        {"racy.comp: a race: invocation 1", "word 1 of \"Numbers\"", "racy.comp:9"});
    EXPECT_THROW((void)Pass(lab, "corners.vert", "shade.frag").run(triangle(), {.size = {4, 4}}),
                 backend::Unsupported);
    expect_error<backend::Fault>(
        [&] {
            (void)Pass(lab, "outside.comp").run({{"result", make_image<float>({3, 3}, [](auto) {
                                                      return 0;
                                                  })}});
        },
        {"outside.comp: texel 3 of the 3 of \"result\"", "outside.comp:3"});
}

TEST(Pass, SharesMemoryInAGroup) {
    const Lab device = pass_lab();
    const Lab interpreted({.device = "interpreter", .include_roots = device.options().include_roots});
    for (const Lab* lab : {&device, &interpreted}) {
        const PassResult out =
            Pass(*lab, "shared.comp")
                .run({{"numbers", std::array{4.0F, 3.0F, 2.0F, 1.0F}}}, {.groups = {1, 1, 1}});
        EXPECT_EQ(out.values<float>("numbers"), std::vector<float>(4, 4.0F)) << lab->info().name;
    }
}

TEST(Pass, DrawsTheWholeImage) {
    const Lab lab = pass_lab();
    const Image scene = picture({6, 4});
    const Image depths = make_image<float>({6, 4}, [](glm::ivec2 p) { return p.x; });
    const PassResult out =
        Pass(lab, "whole.vert", "tone.frag").run({{"scene", scene}, {"exposure", 0.5}, {"depths", depths}});
    EXPECT_EQ(out.unwritten(), "");
    const auto tone = [&](glm::ivec2 p) {
        const glm::dvec3 light = 0.5 * glm::dvec3(scene.at<glm::vec4>(p));
        return light / (1.0 + light);
    };
    EXPECT_TRUE(out.image("color").compare(tone, {.ulp = 4}));
    const auto depth = [](glm::ivec2 p) { return p.x + (p.x + 0.5) / 6.0; };
    const ImageComparison interpolated = out.image("depth").compare(depth, {.absolute = 1e-5});
    EXPECT_TRUE(interpolated) << interpolated;
}

TEST(Pass, DrawsTrianglesOfVertices) {
    const Lab lab = pass_lab();
    const Pass pass(lab, "corners.vert", "shade.frag");
    const PassResult out = pass.run(triangle(), {.size = {4, 4}});
    EXPECT_THAT(out.unwritten(), HasSubstr("brightness: 8 of 16 pixels were not written, the first (2, 0)"));
    const PassResult cleared = pass.run(triangle(), {.size = {4, 4}, .background = 0.5F});
    EXPECT_TRUE(cleared.image("brightness").compare([](glm::ivec2 p) { return p.x < 2 ? 3.0 : 0.5; }));
}

void expect_normals(const Lab& lab) {
    const Image wall = make_image<float>({8, 6}, [](glm::ivec2) { return 2.0F; });
    const PassResult out = Pass(lab, "passes/normals_from_depth.comp")
                               .run({{"depth_image", wall},
                                     {"p00_p11", glm::vec2(1.5F, -2.0F)},
                                     {"size", glm::ivec2(8, 6)},
                                     {"orthographic", 0U}});
    const auto to_the_eye = [](glm::ivec2) { return glm::dvec4(0, 0, 1, 0); };
    EXPECT_TRUE(out.image("normal_image").compare(to_the_eye));
}

TEST(Pass, OfTheLibraryIsRunAsItIs) {
    expect_normals(test::make_lab());
    expect_normals(Lab({.device = std::string(interpreter_name), .include_roots = {GLOAM_GLSL_DIR}}));
}

}  // namespace gloam::check::pass_test
