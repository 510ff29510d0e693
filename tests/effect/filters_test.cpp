// SPDX-License-Identifier: MIT
// The filters that the setting `filter` chooses from: the pass beside the references, pixel by pixel, and the
// filters in the effect.
#include <fmt/format.h>

#include "effect/errors.hpp"
#include "effect/internal/passes.hpp"
#include "effect/settings.hpp"
#include "numeric/random.hpp"
#include "on_device.hpp"
#include "reference/filter.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/temporal.hpp"
#include "scene/analytic_scene.hpp"

namespace gloam::effect::filters_test {

struct Field {
    glm::ivec2 size;
    std::vector<float> occlusion;
    std::vector<float> depth;
    std::vector<glm::vec3> normal;
    std::vector<float> samples;  // accumulated
};

// Surfaces at two depths with holes of every kind between them, accumulated samples and occlusion of all
// kinds, normals that are tilted.
Field rough_field(glm::ivec2 size) {
    constexpr float holes[] = {infinity, 0.0F, -1.0F, nan};
    numeric::Random random(7);
    const auto unit = [&] { return static_cast<float>(random.unit()); };
    Field field{.size = size, .occlusion = {}, .depth = {}, .normal = {}, .samples = {}};
    for (int i = 0; i < size.x * size.y; ++i) {
        const float kind = unit();
        const float occlusion = unit();
        const float depth = (kind > 0.8F ? 2.0F : 1.0F) * (3.0F + 0.3F * unit());
        field.occlusion.push_back(kind > 0.7F && kind < 0.72F ? 0.0F : occlusion);
        field.depth.push_back(kind < 0.1F ? holes[static_cast<int>(40.0F * kind)] : depth);
        field.normal.push_back(glm::normalize(glm::vec3(0.5F * unit(), 0.0F, 1.0F)));
        field.samples.push_back(kind < 0.3F ? 0.0F : std::floor(150.0F * unit()));
    }
    return field;
}

// What the pass is given by name.
struct Numbers {
    float sigma_pixels = 1.0F;
    float filter_depth = 1.0F;
    float c_adaptive = 0.0F;
    float filter_cap = 1e18F;
};
constexpr glm::vec2 p00_p11{1.0F, -1.0F};
constexpr float weight_max = 100.0F;

// The filters of the references on a field whose occlusion is in `source`.
struct References {
    const Field& field;
    const std::vector<double>& source;
    const Numbers& parameters;
    int half_width;
    bool orthographic;

    [[nodiscard]] std::size_t index(glm::ivec2 p) const {
        return static_cast<std::size_t>(p.y * field.size.x + p.x);
    }
    [[nodiscard]] double occlusion(glm::ivec2 p) const { return source[index(p)]; }
    [[nodiscard]] double depth(glm::ivec2 p) const { return double{field.depth[index(p)]}; }
    [[nodiscard]] double convergence(glm::ivec2 p) const {
        return reference::gloam_convergence(double{field.samples[index(p)]}, double{weight_max});
    }

    [[nodiscard]] double sao(glm::ivec2 pixel, glm::ivec2 axis) const {
        using reference::gloam_is_background;
        reference::GloamWeightedMean mean = reference::gloam_weighted_mean_empty();
        for (int tap = -std::min(half_width, 4); tap <= std::min(half_width, 4); ++tap) {
            const glm::ivec2 at = pixel + 2 * tap * axis;
            if (glm::clamp(at, glm::ivec2(0), field.size - 1) != at) continue;
            if (gloam_is_background(depth(pixel)) || gloam_is_background(depth(at))) continue;
            const double apart = (depth(at) - depth(pixel)) / double{parameters.filter_depth};
            mean = reference::gloam_weighted_mean_add(mean, occlusion(at),
                                                      reference::gloam_sao_blur_weight(tap, apart, 1.0));
        }
        return reference::gloam_weighted_mean_value(mean, occlusion(pixel));
    }

    [[nodiscard]] double convergence_aware(glm::ivec2 pixel, glm::ivec2 axis) const {
        const reference::GloamCamera camera{p00_p11, field.size, orthographic};
        const double own = convergence(pixel);
        const double most = own > 0.0 ? std::max(double{parameters.filter_cap}, 1.0) * own : 1.0;
        const double sigma = reference::gloam_filter_sigma(orthographic ? 1.0 : depth(pixel), 1.0,
                                                           field.size.y, double{parameters.sigma_pixels});
        return reference::gloam_convergence_filter(
            pixel, axis, field.size, half_width, double{parameters.c_adaptive}, sigma,
            [&](glm::ivec2 p) { return glm::dvec2(occlusion(p), std::min(convergence(p), most)); },
            [&](glm::ivec2 p) { return reference::gloam_camera_position(p, depth(p), camera); });
    }

    [[nodiscard]] double at(Filter filter, glm::ivec2 pixel, glm::ivec2 axis) const {
        const double scale = double{parameters.filter_depth};
        const auto occlusions = [&](glm::ivec2 p) { return occlusion(p); };
        const auto depths = [&](glm::ivec2 p) { return depth(p); };
        if (filter == Filter::sao) return sao(pixel, axis);
        if (filter == Filter::convergence) return convergence_aware(pixel, axis);
        if (filter == Filter::bilateral)
            return reference::gloam_bilateral_filter(pixel, half_width * axis, field.size,
                                                     double{parameters.sigma_pixels}, scale, occlusions,
                                                     depths);
        return reference::gloam_geometry_blur(
            pixel, axis, field.size, half_width, {10.0, 0.5}, occlusions,
            [&](glm::ivec2 p) { return depth(p) / scale; },
            [&](glm::ivec2 p) { return glm::dvec3(field.normal[index(p)]); });
    }
};

// Filter, taps on each side, whether the camera is orthographic.
using Case = std::tuple<std::string, int, bool>;

class FilterPass : public OnDevice<testing::TestWithParam<Case>> {
  protected:
    // A frame of the case's settings.
    [[nodiscard]] static Moment moment() {
        const auto& [filter, half_width, orthographic] = GetParam();
        Settings settings;
        set(settings, "filter", filter);
        settings.filter_half_width = half_width;
        Moment moment{.settings = settings};
        moment.view.camera = orthographic ? scene::CameraFrame{} : scene::make_frame({}, 1.0);
        return moment;
    }

    // The same by the references.
    [[nodiscard]] static std::vector<double> by_reference(const Field& field, const Numbers& parameters) {
        const auto& [filter, half_width, orthographic] = GetParam();
        std::vector<double> source(field.occlusion.begin(), field.occlusion.end());
        for (const glm::ivec2 axis : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
            const References references{field, source, parameters, half_width, orthographic};
            std::vector<double> filtered;
            for (int i = 0; i < field.size.x * field.size.y; ++i)
                filtered.push_back(
                    references.at(moment().settings.filter, {i % field.size.x, i / field.size.x}, axis));
            source = std::move(filtered);
        }
        return source;
    }

    // The field's occlusion after the pass along x and then along y.
    [[nodiscard]] std::vector<float> filtered(const Field& field, const Numbers& parameters) {
        const gpu::Extent extent{static_cast<std::uint32_t>(field.size.x),
                                 static_cast<std::uint32_t>(field.size.y)};
        using enum gpu::Format;
        std::vector<float> texels;
        for (std::size_t i = 0; i < field.depth.size(); ++i)
            texels.insert(texels.end(), {field.occlusion[i], field.samples[i], 7.0F, field.depth[i]});
        resources_.image("history", extent, rgba32f).upload(texels);
        resources_.image("normal", extent, rgba32f).upload(texels_of(field.normal));
        (void)resources_.image("half", extent, r32f);
        (void)resources_.image("result", extent, r32f);
        Values values = values_of(moment());
        values.set("p00_p11", p00_p11);
        values.set("size", field.size);
        values.set("weight_max", weight_max);
        values.set("sigma_pixels", parameters.sigma_pixels);
        values.set("filter_depth", parameters.filter_depth);
        values.set("c_adaptive", parameters.c_adaptive);
        values.set("filter_cap", parameters.filter_cap);
        for (const bool y : {false, true}) {
            values.set("along_y", y);
            executor_.run("filter", filter_source(moment().settings),
                          {"history", y ? "result" : "half", "normal", y ? "half" : "result"}, values,
                          groups_for(extent), resources_, {});
        }
        return resources_.image("result").download();
    }

    Executor executor_{device_, passes_};
    Resources resources_{device_};
};

// Images smaller than a window, and of groups that are not whole.
TEST_P(FilterPass, GiveWhatTheReferencesGiveForEachPixel) {
    Numbers parameters{.sigma_pixels = 0.25F * static_cast<float>(2 * std::get<1>(GetParam()) + 1),
                       .filter_depth = 0.1F,
                       .c_adaptive = 0.7F};
    for (const glm::ivec2 size : {glm::ivec2(3, 7), glm::ivec2(21, 13), glm::ivec2(69, 34)}) {
        const Field field = rough_field(size);
        for (const float cap : {1e18F, 1.0F}) {
            parameters.filter_cap = cap;
            const std::vector<float> result = filtered(field, parameters);
            const std::vector<double> expected = by_reference(field, parameters);
            for (std::size_t i = 0; i < result.size(); ++i)
                EXPECT_NEAR(double{result[i]}, expected[i], 3e-6) << i << " of " << size.x << ", cap " << cap;
            EXPECT_EQ(result == field.occlusion, std::get<1>(GetParam()) == 0);
        }
    }
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    const auto& [filter, half_width, orthographic] = info.param;
    return fmt::format("{}_{}{}", filter, half_width, orthographic ? "_orthographic" : "");
}

INSTANTIATE_TEST_SUITE_P(Every, FilterPass,
                         testing::Combine(testing::Values("convergence", "geometry", "bilateral", "sao"),
                                          testing::Values(0, 2, 9), testing::Values(false)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Convergence, FilterPass, testing::Values(Case{"convergence", 3, true}), name_of);

class FiltersInTheEffect : public OnDevice<testing::TestWithParam<std::string>> {};

// Of few samples: with many there is less to smooth than there is to blur.
TEST_P(FiltersInTheEffect, BringTheCornerNearerToItsClosedForm) {
    const scene::GBuffer view = drawn("corner", {160, 90});
    const Truth truth = truth_of(view, 1.0, scene::corner_occlusion_at);
    AmbientOcclusion effect(device_, passes_, view.extent);
    Settings few;
    set(few, "filter", GetParam());
    few.samples = 4;
    effect.begin(view, few);
    const Frame frame = effect.next();
    EXPECT_LT(errors_of(frame.filtered, truth).rmse, 0.8 * errors_of(frame.occlusion, truth).rmse);
}

// The history never sees a filter, whatever the camera does.
TEST_P(FiltersInTheEffect, AreForDisplayOnly) {
    const scene::Scene scene = scene::make_scene("moving");
    std::vector<scene::GBuffer> views;
    for (const int frame : {0, 1, 2})
        views.push_back(drawn("moving", {75, 41}, {.frame = frame, .motion = true}));
    std::vector<Frame> last;
    for (const char* filter : {GetParam().c_str(), "none"}) {
        Settings chosen = with_radius(Settings{}, static_cast<float>(scene.ao_radius));
        set(chosen, "filter", filter);
        last.push_back(run(views, chosen).back());
    }
    expect_same_images(last[0], last[1], {&Frame::occlusion, &Frame::convergence});
    EXPECT_EQ(last[1].filtered, last[1].occlusion);
    EXPECT_NE(last[0].filtered, last[0].occlusion);
}

INSTANTIATE_TEST_SUITE_P(Every, FiltersInTheEffect,
                         testing::Values("convergence", "geometry", "bilateral", "sao"),
                         [](const auto& name) { return name.param; });

}  // namespace gloam::effect::filters_test
