// SPDX-License-Identifier: MIT
// Every method as a fragment shader of OpenGL ES 3.0: the results are those of Vulkan.
#include "backend/gl/device.hpp"
#include "effect/errors.hpp"
#include "gathers.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/draw.hpp"
#include "scene/scene.hpp"
#include "support/files.hpp"

namespace gloam::languages_test {

// A view on which a method is run in two languages: waves on a tilted plane, in front of a wall.
namespace view {

using namespace test;

const Camera camera{glm::vec2(1.8F, -2.0F), glm::ivec2(64, 48), false};

constexpr Method values{.range = 2.0F,
                        .epsilon = 0.05F,
                        .intensity = 0.2F,
                        .thickness = 1e3F,
                        .angle_bias = 0.0F,
                        .mip_distance = 0.0F,
                        .steps = 4,
                        .disagreement = 0.05F,
                        .feature_thickness = 1e18F};

float depth(glm::ivec2 p) {
    const auto x = static_cast<float>(p.x);
    const auto y = static_cast<float>(p.y);
    return p.x > 40 ? 6.5F : 5.0F + 0.01F * x + 0.2F * std::sin(0.3F * x) * std::cos(0.23F * y);
}
glm::vec3 normal(glm::ivec2 p) {
    return glm::normalize(glm::vec3(0.2F * std::cos(0.3F * static_cast<float>(p.x)), 0.1F, 1.0F));
}
// Whatever a method makes of it: tests/effect/opengl_passes_test.cpp prepares it.
glm::vec4 prepared(glm::ivec2 p) {
    return {depth(p), 0.1F * depth(p), -depth(p), 1.0F};
}

using Inputs = std::vector<GatherInputs>;

// Points all over the image, each with other samples of the sequence.
Inputs points() {
    Inputs all;
    for (int y = 4; y < camera.size.y; y += 6) {
        for (int x = 4; x < camera.size.x; x += 6) {
            const glm::vec2 ndc =
                (2.0F * glm::vec2(x, y) + 1.0F - glm::vec2(camera.size)) / glm::vec2(camera.size);
            const float d = depth({x, y});
            const auto first = static_cast<unsigned>(16 * (x + y));
            const Samples samples{.radius = 0.6F, .bias = 1e-3F, .angle = 0.7F, .first = first, .count = 16};
            all.emplace_back(glm::vec3(ndc / camera.p00_p11 * d, -d), normal({x, y}), camera, samples,
                             values);
        }
    }
    return all;
}

// The images that the method's text declares.
check::ImageSet images(const std::string& text) {
    const auto clamped = check::Border::clamp;
    check::ImageSet all{
        {"gloam_fetch_depth", check::make_image<float>(camera.size, depth, clamped)},
        {"gloam_fetch_normal", check::make_image<glm::vec3>(camera.size, normal, clamped)},
        {"gloam_fetch_prepared", check::make_image<glm::vec4>(camera.size, prepared, clamped)}};
    std::erase_if(all,
                  [&text](const auto& image) { return text.find(image.first + "(") == std::string::npos; });
    return all;
}

// Fails unless two ways to run a method give as many samples and the same occlusion at each point, and not
// the same at all points. Results are sums and numbers of samples.
void expect_alike(const std::vector<glm::vec2>& got, const std::vector<glm::vec2>& want) {
    ASSERT_EQ(got.size(), want.size());
    float largest = 0.0F;
    float spread = 0.0F;
    for (std::size_t i = 0; i < want.size(); ++i) {
        EXPECT_EQ(got[i].y, want[i].y) << "samples of point " << i;
        if (want[i].y == 0.0F) continue;
        largest = std::max(largest, std::abs(got[i].x / got[i].y - want[i].x / want[i].y));
        spread = std::max(spread, std::abs(want[i].x / want[i].y - want[0].x / want[0].y));
    }
    EXPECT_LT(largest, 1e-6F);
    EXPECT_GT(spread, 1e-3F);
    testing::Test::RecordProperty("largest", std::to_string(largest));
}

}  // namespace view

class OpenGlMethods : public testing::TestWithParam<std::string> {
  protected:
    test::MethodFunctions functions;
};

TEST_P(OpenGlMethods, GiveTheResultsOfVulkan) {
    const std::string& method = GetParam();
    std::optional<check::Lab> opengl;
    try {
        opengl.emplace(check::LabOptions{.device = "es:llvmpipe-3.0",
                                         .include_roots = {functions.folder(), GLOAM_GLSL_DIR},
                                         .cache_directory = test::cache_directory()});
    } catch (const gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    const check::Lab vulkan = functions.lab();
    const std::string file = test::MethodFunctions::file(method);
    const view::Inputs points = view::points();
    const check::ImageSet images = view::images(test::packed_method(functions, file));
    view::expect_alike(check::Function<Gather>(*opengl, file, effect::method_function)(points, images),
                       check::Function<Gather>(vulkan, file, effect::method_function)(points, images));
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlMethods, testing::ValuesIn(test::method_names()), test::parameter_name);

// The effect in one pass and its blur (gloam pack --one-pass), of a corner whose occlusion is known.
constexpr const char* engine = R"(
#define GLOAM_NORMALS_FROM_DEPTH
float gloam_fetch_depth(ivec2 pixel);
float gloam_fetch_occlusion(ivec2 pixel);
float engine_depth(ivec2 pixel, int level) { return gloam_fetch_depth(pixel); }
float engine_occlusion(ivec2 pixel) { return gloam_fetch_occlusion(pixel); }
#include "passes/one_pass/)";

TEST(OnePass, IsNearTheTruthAndItsBlurNearer) {
    const test::TemporaryDirectory folder;
    for (const std::string name : {"occlusion.glsl", "blur.glsl"}) folder.write(name, engine + name + "\"\n");
    std::optional<check::Lab> lab;
    try {
        lab.emplace(check::LabOptions{.device = "es:llvmpipe-3.0",
                                      .include_roots = {folder.path(), GLOAM_GLSL_DIR},
                                      .cache_directory = test::cache_directory()});
    } catch (const gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    using Occlusion = check::Function<float(glm::ivec2, glm::ivec2, glm::vec2, float)>;
    using Blur = check::Function<float(glm::ivec2, glm::ivec2, bool)>;
    const glm::ivec2 size(160, 90);
    const scene::GBuffer view = scene::draw(scene::make_scene("corner"), {160, 90}, {});
    const auto image_of = [&](const std::vector<float>& values) {
        return check::make_image<float>(size, [&](glm::ivec2 p) { return values[p.y * size.x + p.x]; });
    };
    std::vector<Occlusion::Inputs> pixels;
    std::vector<Blur::Inputs> in_rows;
    std::vector<Blur::Inputs> in_columns;
    for (int i = 0; i < size.x * size.y; ++i) {
        const glm::ivec2 pixel(i % size.x, i / size.x);
        pixels.emplace_back(pixel, size, view.camera.p00_p11(), 1.0F);
        in_rows.emplace_back(pixel, size, false);
        in_columns.emplace_back(pixel, size, true);
    }
    check::ImageSet images{{"gloam_fetch_depth", image_of(view.depth)},
                           {"gloam_fetch_occlusion", image_of(view.depth)}};
    const std::vector<float> raw = Occlusion(*lab, "occlusion.glsl", "occlusion_at")(pixels, images);
    const Blur blur(*lab, "blur.glsl", "blurred");
    images["gloam_fetch_occlusion"] = image_of(raw);
    images["gloam_fetch_occlusion"] = image_of(blur(in_rows, images));
    const effect::Truth truth = effect::truth_of(view, 1.0, scene::corner_occlusion_at);
    const double error = effect::errors_of(raw, truth).rmse;
    const double blurred = effect::errors_of(blur(in_columns, images), truth).rmse;
    RecordProperty("errors", std::to_string(error) + " " + std::to_string(blurred));
    EXPECT_LT(blurred, 0.025);
    EXPECT_LT(blurred, 0.4 * error);
}

}  // namespace gloam::languages_test
