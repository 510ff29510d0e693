// SPDX-License-Identifier: MIT
// What docs/compatibility.md promises of C++ in 0.2: the package test compiles it against the installed
// headers. Names may be added with those of a later version; nothing here may change before 0.3.
#include <gloam/base/version.hpp>
#include <gloam/check/matchers.hpp>
#include <gloam/shader_test.hpp>

namespace {

using namespace gloam::check;

LabOptions options() {
    LabOptions all{.device = "interpreter",
                   .validation = false,
                   .include_roots = {std::filesystem::path("shaders")},
                   .cache_directory = "cache",
                   .variant = {}};
    all.timeout = std::chrono::milliseconds{1000};
    return all;
}

Domain domain() {
    return {uniform(0, 1).and_special().and_near({0.5}),
            log_uniform(1, 2).only_as_drawn(),
            signed_log_uniform(1, 2),
            any_float(),
            integers(0, 7).and_near_integers({3}),
            log_integers(7),
            booleans(),
            vector(3, uniform(0, 1)),
            vector({uniform(0, 1), uniform(1, 2)}),
            unit_vector(3),
            vector_of_length(2, uniform(0, 1)),
            image_pixel(),
            image_size(),
            either(uniform(0, 1), uniform(2, 3)),
            constant(1.0F).and_value(2.0F)};
}

std::string function(const Lab& lab) {
    const Function<float(glm::vec2, int&, Out<float>)> several(lab, "f.glsl", "several");
    const std::tuple<float, int, float> outputs = several(glm::vec2(1.0F), 2);
    const Function<float(float)> f(lab, "f.glsl", "f");
    const float y = f(0.5F);
    const Budget budget{.ulp = 1, .absolute = 1e-6, .backward_ulp = 1, .of_largest_component = true};
    const RunOptions run{.inputs = 64, .seed = 2, .coverage = true};
    const Answer answer = f.compare([](double x) { return x; }, domain(), budget, run);
    EXPECT_TRUE(answer.passed() && !answer.failed() && answer.outcome() == Outcome::ok) << answer;
    EXPECT_THAT(f.check_rules(domain()), Passes());
    EXPECT_THAT(y, WithinUlp(0.5, 2));
    const PropertyResult holds = f.property(domain(), [](float x, float value) { return value <= x; });
    EXPECT_TRUE(holds) << holds;
    const Audit audit = f.audit(domain(), {.inputs = 64, .seed = 3});
    const std::size_t counts = answer.inputs() + answer.outside() + answer.judged() + audit.findings.size();
    return to_text(audit) + to_text(f.explain(0.5F), 3) + answer.not_judged_because() +
           std::to_string(std::get<1>(outputs) + static_cast<int>(counts));
}

void teams(const Lab& lab) {
    const Function<float(float)> over_quad(lab, "f.glsl", "over_quad");
    const Function<Quad<float>(Quad<float>)> quad(lab, "f.glsl", "quad");
    const Function<Group<float, 64>(Group<float, 64>)> group(lab, "f.glsl", "group");
    const Function<std::array<float, 4>(std::array<float, 4>)> array(lab, "f.glsl", "array");
}

std::string pass(const Lab& lab, const Image& picture) {
    const Pass drawn(lab, "a.vert", "b.frag");
    const Pass blur(lab, "blur.comp");
    const PassInputs inputs{{"source", picture}, {"radius", 2}, {"weights", std::vector<float>{1.0F}}};
    const PassOptions how{.size = {4, 4}, .groups = {1, 1, 1}, .vertices = 3, .background = 0.0F};
    const PassResult out = blur.run(inputs, how);
    const PassImage& image = out.image("result");
    const ImageBudget budget{.ulp = 1, .absolute = 0.1, .similarity = 0.9};
    EXPECT_TRUE(image.compare(picture, budget)) << image.compare([](glm::ivec2) { return 1.0; });
    EXPECT_TRUE(is_golden(image, "golden.pfm", budget, "folder"));
    EXPECT_TRUE(blur.idempotent(inputs, "source", "result", budget, how));
    EXPECT_TRUE(blur.symmetric(Mirror::transpose, inputs, "source", "result", budget, how));
    EXPECT_TRUE(blur.keeps_energy(inputs, "source", "result", 1e-6, how));
    return out.unwritten() + std::to_string(out.values<float>("sums").size() + image.size.x);
}

}  // namespace

TEST(Api, OfVersion02) {
    const Lab lab(options());
    teams(lab);
    EXPECT_NE(function(lab), pass(lab, Image{}) + gloam::base::version());
}
