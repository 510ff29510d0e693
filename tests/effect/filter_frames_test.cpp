// SPDX-License-Identifier: MIT
// A filter that runs in the first frames after a cut alone: until then the frames are those of a filter that
// always runs, and from then on those without a filter, to the bit.
#include <fmt/format.h>

#include <gtest/gtest.h>

#include <cctype>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "filter_passes.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"
#include "shader/compile.hpp"

namespace gloam::effect::filter_frames_test {

// The spatial filter as the library's functions have it: one invocation a pixel, each of which fetches the
// pixels that it needs. Bindings and push constants are those of spatial_filter.comp; HALF_WIDTH is to be
// defined, and one of CONVERGENCE, GEOMETRY, BILATERAL and SAO. Dispatch ceil(size / 8) groups.
const std::string pixel_filter = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool along_y = false;
layout(constant_id = 1) const bool orthographic = false;
layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, GLOAM_HISTORY) uniform readonly image2D history_image;
layout(binding = 2, r32f) uniform writeonly image2D filtered_image;
layout(binding = 3, rgba32f) uniform readonly image2D normal_image;
layout(binding = 4, std430) readonly buffer Lists { uint unused[]; };
layout(binding = 5, r32f) uniform readonly image2D along_x_image;
layout(push_constant) uniform Parameters {
    vec2 p00_p11;
    ivec2 size;
    float sigma_pixels;
    float depth_scale;
    float c_adaptive;
    float weight_max;
    float cap;
} parameters;

#ifdef CONVERGENCE
#include "gloam/filter/convergence_filter.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/convergence.glsl"
#endif
#ifdef GEOMETRY
#include "gloam/filter/geometry_blur.glsl"
#endif
#ifdef BILATERAL
#include "gloam/filter/bilateral.glsl"
#endif
#ifdef SAO
#include "gloam/filter/sao_blur.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/background.glsl"
#endif

ivec2 filter_axis() {
    return ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
}

float depth_at(ivec2 pixel) {
    return imageLoad(depth_image, pixel).x;
}

float occlusion_at(ivec2 pixel) {
    return along_y ? imageLoad(along_x_image, pixel).x : imageLoad(history_image, pixel).x;
}

#ifdef CONVERGENCE
float most = 1.0;

float convergence_at(ivec2 pixel) {
    return gloam_convergence(imageLoad(history_image, pixel).y, parameters.weight_max);
}

vec2 gloam_fetch_occlusion_convergence(ivec2 pixel) {
    return vec2(occlusion_at(pixel), min(convergence_at(pixel), most));
}

vec3 gloam_fetch_position(ivec2 pixel) {
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    return gloam_camera_position(pixel, depth_at(pixel), camera);
}

float filtered(ivec2 pixel) {
    float own = convergence_at(pixel);
    most = own > 0.0 ? max(parameters.cap, 1.0) * own : 1.0;
    float depth = orthographic ? 1.0 : depth_at(pixel);
    float sigma = gloam_filter_sigma(depth, 1.0 / abs(parameters.p00_p11.y), float(parameters.size.y),
                                     parameters.sigma_pixels);
    return gloam_convergence_filter(pixel, filter_axis(), parameters.size, HALF_WIDTH, parameters.c_adaptive, sigma);
}
#else
float gloam_fetch_occlusion(ivec2 pixel) {
    return occlusion_at(pixel);
}
#endif

#ifdef GEOMETRY
float gloam_fetch_depth(ivec2 pixel) {
    return depth_at(pixel) / parameters.depth_scale;
}

vec3 gloam_fetch_normal(ivec2 pixel) {
    return imageLoad(normal_image, pixel).xyz;
}

float filtered(ivec2 pixel) {
    return gloam_geometry_blur(pixel, filter_axis(), parameters.size, HALF_WIDTH, vec2(10.0, 0.5));
}
#endif

#ifdef BILATERAL
float gloam_fetch_depth(ivec2 pixel) {
    return depth_at(pixel);
}

float filtered(ivec2 pixel) {
    return gloam_bilateral_filter(pixel, HALF_WIDTH * filter_axis(), parameters.size, parameters.sigma_pixels,
                                  parameters.depth_scale);
}
#endif

#ifdef SAO
float filtered(ivec2 pixel) {
    float center = depth_at(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, occlusion_at(pixel));
    for (int tap = -min(HALF_WIDTH, 4); tap <= min(HALF_WIDTH, 4); ++tap) {
        ivec2 at = pixel + 2 * tap * filter_axis();
        if (at.x < 0 || at.y < 0 || at.x >= parameters.size.x || at.y >= parameters.size.y) continue;
        if (gloam_is_background(depth_at(at))) continue;
        float weight = gloam_sao_blur_weight(tap, (depth_at(at) - center) / parameters.depth_scale, 1.0);
        mean = gloam_weighted_mean_add(mean, occlusion_at(at), weight);
    }
    return gloam_weighted_mean_value(mean, occlusion_at(pixel));
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(filtered_image, pixel, vec4(filtered(pixel)));
}
)";

constexpr gpu::Extent extent{83, 45};
constexpr std::size_t filtered_frames = 3;

class FilterFrames : public OnDevice<testing::Test> {
  protected:
    static Settings settings_of(Filter filter, float frames) {
        Settings settings = with_radius(preset_named("fast").settings,
                                        static_cast<float>(scene::make_scene("moving").ao_radius));
        settings.filter = filter;
        settings.filter_frames = frames;
        settings.remap_b = 0.9F;  // the remapped images have skips of their own
        return settings;
    }

    [[nodiscard]] scene::GBuffer view(int frame) const {
        return scene::rasterize(device_, passes_, scene::make_scene("moving"), extent,
                                {.frame = frame, .motion = true});
    }

    // Frames of a camera that moves, then stands still until nothing changes, then is cut.
    [[nodiscard]] std::vector<Frame> run(const Settings& settings) const {
        AmbientOcclusion& effect = effect_for(extent);
        std::vector<Frame> frames;
        effect.begin(view(0), settings);
        frames.push_back(effect.next());
        for (int i = 1; i < 3; ++i) {
            effect.advance(view(i));
            frames.push_back(effect.next());
        }
        for (int i = 0; i < 4; ++i) frames.push_back(effect.next(2));
        effect.begin(view(1), settings);
        for (int i = 0; i < 5; ++i) frames.push_back(effect.next());
        return frames;
    }

    void expect_switch(Settings first) const {
        const std::vector<Frame> found = run(first);
        first.filter_frames = every_frame;
        const std::vector<Frame> always = run(first);
        first.filter = Filter::none;
        const std::vector<Frame> never = run(first);
        constexpr std::size_t cut = 7;
        for (std::size_t i = 0; i < found.size(); ++i) {
            SCOPED_TRACE(i);
            const bool filtered = i % cut < filtered_frames;
            const bool full = first.resolution == Resolution::full;
            EXPECT_TRUE(!full || bits_of(found[i].occlusion) == bits_of(never[i].occlusion));
            EXPECT_EQ(bits_of(found[i].filtered), bits_of((filtered ? always : never)[i].filtered));
            EXPECT_TRUE(filtered || found[i].work.tiles_filtered == 0);
            EXPECT_FALSE(filtered && bits_of(always[i].filtered) == bits_of(never[i].filtered));
        }
    }
};

TEST_F(FilterFrames, AreTheFirstAfterACut) {
    expect_switch(settings_of(Filter::convergence, static_cast<float>(filtered_frames)));
}

// Tiles that have settled are left out of the frame in which the filter stops, and show what is not filtered.
TEST_F(FilterFrames, EndInASettledViewAsWell) {
    Settings settings = settings_of(Filter::bilateral, static_cast<float>(filtered_frames));
    settings.freeze = true;
    settings.weight_max = 3.0F;  // one frame's samples
    expect_switch(settings);
}

TEST_F(FilterFrames, AreTheFirstAtHalfTheResolutionAsWell) {
    Settings settings = settings_of(Filter::convergence, static_cast<float>(filtered_frames));
    settings.resolution = Resolution::half;
    expect_switch(settings);
    std::vector<std::string> turns;
    for (const PlannedPass& pass : plan_of(settings, {.tiles = true}).passes)
        if (pass.name.starts_with("upsample"))
            turns.push_back(pass.name + (pass.turn == Turn::early ? " early" : ""));
    EXPECT_EQ(turns, (std::vector<std::string>{"upsample", "upsample_filtered early"}));
}

TEST_F(FilterFrames, ArePlanned) {
    for (const bool remapped : {false, true}) {
        Settings settings = preset_named("fast").settings;
        settings.filter_frames = 2.5F;
        settings.output = remapped ? OutputFormat::r8 : OutputFormat::r32f;
        const Plan plan = plan_of(settings, {.tiles = true});
        EXPECT_EQ(plan.filter_frames, 3U);
        EXPECT_EQ(plan.result, remapped ? "filtered_mapped" : "filtered");
        EXPECT_EQ(plan.later_result, remapped ? "mapped" : "history_after");
        EXPECT_EQ(plan.result_unit, 1.0F);
        EXPECT_EQ(plan.later_unit == 1.0F, remapped);
        for (const PlannedPass& pass : plan.passes) {
            const bool of_filter = pass.name.find("filter") != std::string::npos;
            EXPECT_EQ(pass.turn == Turn::early, of_filter) << pass.name;
        }
    }
    EXPECT_EQ(plan_of(preset_named("paper").settings, {}).filter_frames, 0U);
}

// The spatial filter, which filters several pixels at a time and reads what they share once, against the
// library's functions pixel by pixel: the same to the bit.

constexpr float inf = std::numeric_limits<float>::infinity();

// Surfaces at two depths with holes between them, accumulated samples and occlusion of all kinds.
Field rough_field(glm::ivec2 size) {
    Field field = random_field(size, 0.3F);
    numeric::Random random(11);
    for (std::size_t i = 0; i < field.depth.size(); ++i) {
        const double kind = random.unit();
        if (kind < 0.1) field.depth[i] = kind < 0.05 ? inf : 0.0F;
        if (kind > 0.8) field.depth[i] *= 2.0F;
        if (kind > 0.7 && kind < 0.72) field.occlusion[i] = 0.0F;
        field.samples.push_back(kind < 0.3 ? 0.0F
                                           : static_cast<float>(static_cast<int>(150.0 * random.unit())));
    }
    return field;
}

FilterConstants constants_for(int half_width, bool capped) {
    FilterConstants constants;
    constants.sigma_pixels = 0.25F * static_cast<float>(2 * half_width + 1);
    constants.c_adaptive = 0.7F;
    if (capped) constants.cap = 1.0F;
    return constants;
}

// Filter, taps on each side, precision of the history, kind of the camera.
using Case = std::tuple<std::string, int, HistoryPrecision, bool>;

class FilterRows : public OnDevice<testing::TestWithParam<Case>> {
  protected:
    // A frame of the case's settings.
    [[nodiscard]] Moment moment() const {
        const auto& [filter, half_width, precision, orthographic] = GetParam();
        Settings settings;
        set(settings, "filter", filter);
        settings.filter_half_width = half_width;
        settings.precision = precision;
        Moment moment{.settings = settings};
        moment.view.camera = orthographic ? scene::CameraFrame{} : scene::make_frame({}, 1.0);
        return moment;
    }

    [[nodiscard]] FilterPair rows() const {
        return {pipeline_of(device_, passes_, filter_source(moment(), false)),
                pipeline_of(device_, passes_, filter_source(moment(), true)),
                {tile_side * filter_tiles, tile_side}};
    }

    [[nodiscard]] FilterPair pixels() const {
        const shader::SpirvCache cache(variable("GLOAM_CACHE_DIR"));
        const shader::Spirv spirv =
            cache.compile({.name = "pixel_filter", .text = text()},
                          {.include_roots = {GLOAM_GLSL_DIR},
                           .variant = {.optimization = shader::Optimization::performance}});
        return {pass(spirv, false), pass(spirv, true), {tile_side, tile_side}};
    }

    [[nodiscard]] std::string text() const {
        std::string filter;
        for (const char c : std::get<0>(GetParam())) filter += static_cast<char>(std::toupper(c));
        const bool rounds = moment().settings.precision == HistoryPrecision::float16;
        const std::size_t end = pixel_filter.find('\n') + 1;
        return pixel_filter.substr(0, end) +
               fmt::format("#define GLOAM_HISTORY {}\n#define HALF_WIDTH {}\n#define {}\n",
                           rounds ? "rgba16f" : "rgba32f", moment().settings.filter_half_width, filter) +
               pixel_filter.substr(end);
    }

    [[nodiscard]] gpu::ComputePipeline pass(const shader::Spirv& spirv, bool along_y) const {
        using enum gpu::BindingKind;
        return {device_,
                {.spirv = spirv,
                 .bindings = {storage_image, storage_image, storage_image, storage_image, storage_buffer,
                              storage_image},
                 .push_constant_bytes = sizeof(FilterConstants),
                 .constants = {{.id = 0, .bits = along_y ? 1U : 0U},
                               {.id = 1, .bits = moment().view.camera.orthographic() ? 1U : 0U}}}};
    }
};

// Images smaller than a row, smaller than a window, and of tiles that are not whole; more than a group's
// tiles.
TEST_P(FilterRows, GiveWhatTheLibraryGivesForEachPixel) {
    const FilterPair of_rows = rows();
    const FilterPair of_pixels = pixels();
    const bool rounds = moment().settings.precision == HistoryPrecision::float16;
    const gpu::Format history = rounds ? gpu::Format::rgba16f : gpu::Format::rgba32f;
    for (const glm::ivec2 size : {glm::ivec2(3, 7), glm::ivec2(21, 13), glm::ivec2(69, 34)}) {
        const Field field = rough_field(size);
        for (const bool capped : {false, true}) {
            const FilterConstants constants = constants_for(moment().settings.filter_half_width, capped);
            EXPECT_EQ(run_filter(device_, of_rows, field, constants, history),
                      run_filter(device_, of_pixels, field, constants, history))
                << size.x << " x " << size.y << (capped ? ", capped" : "");
        }
    }
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    const auto& [filter, half_width, precision, orthographic] = info.param;
    return fmt::format("{}_{}_{}{}", filter, half_width,
                       precision == HistoryPrecision::float16 ? "half" : "full",
                       orthographic ? "_orthographic" : "");
}

constexpr auto full = HistoryPrecision::float32;
constexpr auto half = HistoryPrecision::float16;

// Rows of 8 pixels, of 4, and windows whose rows are not held; what all filters share, in one of them.
INSTANTIATE_TEST_SUITE_P(Every, FilterRows,
                         testing::Combine(testing::Values("convergence", "geometry", "bilateral", "sao"),
                                          testing::Values(2, 9), testing::Values(full),
                                          testing::Values(false)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Convergence, FilterRows,
                         testing::Values(Case{"convergence", 0, full, false},
                                         Case{"convergence", 3, full, true},
                                         Case{"convergence", 2, half, false}),
                         name_of);

}  // namespace gloam::effect::filter_frames_test
