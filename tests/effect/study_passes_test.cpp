// SPDX-License-Identifier: MIT
// The study's four passes on two frames of a moving camera: each as it is, on a device and on the
// interpreter, beside what the paper's equations give in double for the same images.
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <regex>

#include "pass/pass.hpp"
#include "study_definitions.hpp"
#include "support/files.hpp"
#include "support/lab.hpp"

namespace gloam::effect::study_passes_test {

const Case cases[] = {
    {.name = "AsPrinted"},
    {.name = "MovingByConfidence", .moving = true, .taps = 1, .invalidation = 2, .filter = "geometry"},
    {.name = "MovingByClamp", .orthographic = true, .moving = true, .invalidation = 1, .filter_cap = 1.5F},
    {.name = "Smoothed",
     .taps = 0,
     .smoothing = 0.25F,
     .rejects = true,
     .lattice = true,
     .filter = "bilateral"},
    {.name = "Fewer",
     .least_radius = 4.0F,
     .radius_cap = 5.0F,
     .samples_distance = 400.0F,
     .samples_radius = 6.0F,
     .samples_least = 9,
     .filter = "sao"},
    {.name = "NoneFarAway",
     .moving = true,
     .invalidation = 1,
     .bias_depth = 0.04F,
     .samples_distance = 5.0F,
     .samples_least = 0,
     .border = {2, 1}}};

struct MethodValues {
    float range, epsilon, intensity, thickness, angle_bias, mip_distance;
    unsigned steps;
    float disagreement, feature_thickness;
    int layers;
};

class StudyPasses : public testing::TestWithParam<std::tuple<Case, bool>> {
  protected:
    // Whether an image is what is wanted, to 1e-6 of it, but for ties.
    void judge(const PassImage& image, const std::function<Wanted(ivec2)>& wanted) {
        int apart = 0;
        for (int i = 0; i < size.x * size.y; ++i) {
            const ivec2 pixel(i % size.x, i / size.x);
            const Wanted one = wanted(pixel);
            const auto got =
                image.element.rows == 1 ? dvec4(image.at<double>(pixel)) : image.at<dvec4>(pixel);
            const dvec4 unit(1.0, weight_max, 1.0, std::max(1.0, one.value.w));
            bool same = true;
            for (int c = 0; c < image.element.rows; ++c)
                same = same && (got[c] == one.value[c] || std::abs(got[c] - one.value[c]) <= 1e-6 * unit[c]);
            apart += same ? 0 : 1;
            if (!same && !one.tie.empty())
                RecordProperty(fmt::format("{} {},{}", image.name, pixel.x, pixel.y), one.tie);
            EXPECT_TRUE(same || !one.tie.empty()) << fmt::format(
                "{}: pixel ({}, {}): got {:.9g} {:.9g} {} {:.9g}, expected {:.9g} {:.9g} {} {:.9g}",
                image.name, pixel.x, pixel.y, got.x, got.y, got.z, got.w, one.value.x, one.value.y,
                one.value.z, one.value.w);
        }
        EXPECT_LE(apart, 3) << image.name << ": ties are few";
    }

    // The values of a pass by their names, and those of the camera.
    template <class... Values>
    [[nodiscard]] PassResult run(const std::string& pass, const View& view, const Values&... values) const {
        PassInputs inputs{{"size", size}};
        give(inputs, "p00_p11", view.camera.p00_p11, "orthographic", view.camera.orthographic, values...);
        return Pass(lab_, pass).run(inputs);
    }
    template <class Value, class... Rest>
    static void give(PassInputs& inputs, const char* name, const Value& value, const Rest&... rest) {
        inputs.insert_or_assign(name, value);
        if constexpr (sizeof...(Rest) > 0) give(inputs, rest...);
    }

    // The history of a view; before: that of the frame before, at its pixels.
    [[nodiscard]] Image occlusion_of(const View& view, const Image* before) {
        const MethodValues method{.range = range};
        const PassResult result =
            run("passes/study/ambient_occlusion.comp", view, "depth_image", view.depth, "normal_image",
                view.normal, "layer_image", view.normal, "prepared_image", view.normal, "history_before",
                before == nullptr ? view.normal : *before, "previous_position_image", view.positions,
                "method_values", method, "keeps_history", before != nullptr, "watches_objects",
                before != nullptr && one_.invalidation > 0, "table_size", table_size, "reject_taps",
                one_.rejects, "on_lattice", one_.lattice, "samples_asked", 16U, "samples_converged", 8U,
                "border", one_.border, "radius", radius, "bias", bias, "c_spatial", c_spatial, "weight_max",
                weight_max, "c_rot", 0.5F, "least_radius", one_.least_radius, "shade_border", 0U,
                "invalidation", one_.invalidation, "change_tolerance", change_tolerance, "weight_small", 5.0F,
                "confidence_factor", confidence_factor, "samples_distance", one_.samples_distance,
                "samples_radius", one_.samples_radius, "samples_least", one_.samples_least, "radius_cap",
                one_.radius_cap, "smoothing", one_.smoothing, "bias_depth", one_.bias_depth);
        const PassImage& after = result.image("history_after");
        judge(after, [&](ivec2 pixel) { return blended(one_, view, before, pixel); });
        return after;
    }

    [[nodiscard]] Image smoothed(const View& view, const Image& history, const Image& along_x, bool along_y) {
        const std::string own = "passes/study/spatial_filter.comp";
        const std::string text = shader::read_text(std::filesystem::path(GLOAM_GLSL_DIR) / own);
        const std::string file =
            folder_.write(one_.filter + ".comp", std::regex_replace(text, std::regex("filters/convergence"),
                                                                    "passes/study/filters/" + one_.filter));
        const PassResult result =
            run(one_.filter == "convergence" ? own : file, view, "history_image", history, "normal_image",
                view.normal, "along_x_image", along_x, "along_y", along_y, "filter_half_width", half_width,
                "sigma_pixels", sigma_pixels, "filter_depth", filter_depth, "c_adaptive", c_adaptive,
                "weight_max", weight_max, "filter_cap", one_.filter_cap);
        const ivec2 axis(along_y ? 0 : 1, along_y ? 1 : 0);
        const Image& source = along_y ? along_x : history;
        judge(result.image("filtered_image"), [&](ivec2 pixel) -> Wanted {
            return {dvec4(filtered(one_, view, history, source, pixel, axis))};
        });
        return result.image("filtered_image");
    }

    const Case& one_ = std::get<0>(GetParam());
    test::TemporaryDirectory folder_;
    Lab lab_ = std::get<1>(GetParam()) ? Lab({.device = std::string(interpreter_name),
                                              .include_roots = {GLOAM_GLSL_DIR, folder_.path()}})
                                       : test::make_lab(folder_.path());
};

TEST_P(StudyPasses, AreTheEquations) {
    const glm::mat4 moved =
        glm::rotate(glm::translate(glm::mat4(1.0F), {0.21F, 0.05F, -0.33F}), 0.06F, {0.3F, 1, 0.1F});
    const Camera first{{1.2F, -1.6F}, one_.orthographic};
    const Camera second{{1.15F, -1.5F}, one_.orthographic};
    const float scale = one_.orthographic ? 0.25F : 1.0F;
    const View before = seen({first.p00_p11 * scale, first.orthographic}, glm::mat4(1.0F), dvec3(0.0));
    const View now = seen({second.p00_p11 * scale, second.orthographic}, moved,
                          one_.moving ? dvec3(0.2, 0.1, 0.3) : dvec3(0.0));
    const Image history = occlusion_of(before, nullptr);
    const PassResult result =
        run("passes/study/reproject.comp", now, "depth_image", now.depth, "previous_position_image",
            now.positions, "previous_history", history, "moving_objects", one_.moving, "taps", one_.taps,
            "previous_orthographic", one_.orthographic, "previous_from_current", now.first_from_view,
            "previous_p00_p11", before.camera.p00_p11, "depth_tolerance", 0.02F);
    const PassImage& reprojected_history = result.image("history");
    judge(reprojected_history, [&](ivec2 pixel) { return reprojected(one_, now, before, history, pixel); });
    const Image after = occlusion_of(now, &reprojected_history);
    const Image along_x = smoothed(now, after, now.depth, false);
    (void)smoothed(now, after, along_x, true);
    PassInputs inputs{{"size", size}};
    give(inputs, "depth_image", now.depth, "source_image", after, "remap_a", 0.1F, "remap_b", 0.9F, "remap_c",
         1.5F);
    const PassResult shown = Pass(lab_, "passes/study/remap.comp").run(inputs);
    judge(shown.image("mapped_image"), [&](ivec2 pixel) -> Wanted {
        const double own = after.at<dvec4>(pixel).x;
        const double mapped = 1.0 - std::pow(std::max(double{0.9F} * (1.0 - own + double{0.1F}), 0.0), 1.5);
        return {dvec4(std::isinf(now.depth.at<double>(pixel)) ? own : std::max(mapped, 0.0))};
    });
}

INSTANTIATE_TEST_SUITE_P(Frames, StudyPasses, testing::Combine(testing::ValuesIn(cases), testing::Bool()),
                         [](const auto& info) {
                             return std::get<0>(info.param).name +
                                    (std::get<1>(info.param) ? "Interpreted" : "");
                         });

}  // namespace gloam::effect::study_passes_test
