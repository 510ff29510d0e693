// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"
#include "effect/errors.hpp"
#include "judge/function.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/draw.hpp"
#include "scene/scene.hpp"
#include "support/files.hpp"
#include "support/lab.hpp"

namespace gloam::one_pass_test {

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
    std::optional<subject::Lab> lab;
    try {
        lab.emplace(subject::LabOptions{.device = "es:llvmpipe-3.0",
                                        .include_roots = {folder.path(), GLOAM_GLSL_DIR},
                                        .cache_directory = test::cache_directory()});
    } catch (const backend::gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    using Occlusion = judge::Function<float(glm::ivec2, glm::ivec2, glm::vec2, float)>;
    using Blur = judge::Function<float(glm::ivec2, glm::ivec2, bool)>;
    const glm::ivec2 size(160, 90);
    const scene::GBuffer view = scene::draw(scene::make_scene("corner"), {160, 90}, {});
    const auto image_of = [&](const std::vector<float>& values) {
        return subject::make_image<float>(size, [&](glm::ivec2 p) { return values[p.y * size.x + p.x]; });
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
    subject::ImageSet images{{"gloam_fetch_depth", image_of(view.depth)},
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

}  // namespace gloam::one_pass_test
