// SPDX-License-Identifier: MIT
// The messages of passes.
#include "pass/pass.hpp"
#include "support/lab.hpp"

namespace gloam::check::pass_errors_test {

Lab pass_lab() {
    return test::make_lab(FIXTURES);
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
    expect_error<std::invalid_argument>([&] { (void)box.run(box_inputs()).image("source"); },
                                        {"box.comp: writes no image \"source\", expected one of: result"});
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

TEST_F(PassErrors, NameTheFileAndWhatAPassCannotHave) {
    expect_error<std::invalid_argument>([&] { Pass(lab_, "none.comp"); }, {"none.comp: "});
    expect_error<std::invalid_argument>([&] { Pass(lab_, "refused_set.comp"); },
                                        {"\"result\" has set 1 and binding 0, expected set 0"});
    expect_error<std::invalid_argument>([&] { Pass(lab_, "refused_samples.comp"); },
                                        {"\"sky\" is a sampler2DMS, expected a sampler like sampler2D"});
    const Pass layers(lab_, "layers.comp");
    expect_error<std::invalid_argument>(
        [&] { (void)layers.run({{"scale", 1.0F}}); },
        {"\"scale\" is no input", "First.scale (float), ", "Second.scale (float)"});
    const Pass box(lab_, "box.comp");
    const PassResult out = box.run(box_inputs());
    expect_error<std::invalid_argument>([&] { (void)out.image("result").compare(ramp({4, 5})); },
                                        {"box.comp: result: is 5 x 4, the reference 4 x 5"});
    const Image numbers = make_image<float>({5, 4}, [](auto) { return 1.0F; });
    expect_error<std::invalid_argument>([&] { (void)out.image("result").compare(numbers); },
                                        {"box.comp: result: is compared with float, expected vec4"});
}

}  // namespace gloam::check::pass_errors_test
