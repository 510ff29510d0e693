// SPDX-License-Identifier: MIT
// The filters that the setting `filter` chooses from. The pass filters several pixels at a time and reads
// what they share once: beside the library's functions, pixel by pixel, it is the same to the bit. What these
// functions do is shown in tests/glsl/filter_test.cpp. And the filters in the effect.
#include <fmt/format.h>

#include <cctype>

#include "backend/vulkan/commands.hpp"
#include "effect/errors.hpp"
#include "effect/internal/passes.hpp"
#include "effect/settings.hpp"
#include "numeric/random.hpp"
#include "on_device.hpp"
#include "shader/compile.hpp"

namespace gloam::effect::filters_test {

// The spatial filter as the library's functions have it: one invocation a pixel, each of which fetches the
// pixels that it needs. Bindings and push constants are those of spatial_filter.comp; HALF_WIDTH is to be
// defined, and one of CONVERGENCE, GEOMETRY, BILATERAL and SAO. Dispatch ceil(size / 8) groups.
const std::string pixel_filter = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool along_y = false;
layout(constant_id = 1) const bool orthographic = false;
layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, rgba32f) uniform readonly image2D history_image;
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

// A pass along x and one along y, and how many pixels a group of either takes.
struct FilterPair {
    gpu::ComputePipeline along_x;
    gpu::ComputePipeline along_y;
    glm::uvec2 pixels_of_group;
};

// Filter, taps on each side, whether the camera is orthographic.
using Case = std::tuple<std::string, int, bool>;

class FilterRows : public OnDevice<testing::TestWithParam<Case>> {
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

    // The field's occlusion after the pass along x and then along y.
    [[nodiscard]] std::vector<float> filtered(const FilterPair& pair, const Field& field,
                                              FilterParameters parameters) const {
        const gpu::Extent extent{static_cast<std::uint32_t>(field.size.x),
                                 static_cast<std::uint32_t>(field.size.y)};
        using enum gpu::Format;
        gpu::Image depth(device_, extent, r32f);
        gpu::Image source(device_, extent, rgba32f);
        gpu::Image half(device_, extent, r32f);
        gpu::Image normal(device_, extent, rgba32f);
        gpu::Image result(device_, extent, r32f);
        depth.upload(field.depth);
        std::vector<float> texels;
        std::vector<float> normals;
        for (std::size_t i = 0; i < field.depth.size(); ++i) {
            texels.insert(texels.end(), {field.occlusion[i], field.samples[i], 7.0F, field.depth[i]});
            normals.insert(normals.end(), {field.normal[i].x, field.normal[i].y, field.normal[i].z, 0.0F});
        }
        source.upload(texels);
        normal.upload(normals);
        parameters.p00_p11 = {1.0F, -1.0F};
        parameters.size = field.size;
        parameters.weight_max = 100.0F;
        const glm::uvec2 groups = (glm::uvec2(field.size) + pair.pixels_of_group - 1U) / pair.pixels_of_group;
        const gpu::Buffer no_list(device_, 128);
        gpu::Commands commands(device_);
        const auto run = [&](const gpu::ComputePipeline& pass, const gpu::Image& from, const gpu::Image& to) {
            const std::vector<gpu::Resource> resources{depth, source, to, normal, no_list, from};
            commands.dispatch(pass, resources, {groups.x, groups.y, 1},
                              std::as_bytes(std::span(&parameters, 1)));
        };
        run(pair.along_x, result, half);
        run(pair.along_y, half, result);
        commands.submit();
        return result.download();
    }

  private:
    [[nodiscard]] static std::string text() {
        std::string filter;
        for (const char c : std::get<0>(GetParam())) filter += static_cast<char>(std::toupper(c));
        const std::size_t end = pixel_filter.find('\n') + 1;
        return pixel_filter.substr(0, end) +
               fmt::format("#define HALF_WIDTH {}\n#define {}\n", moment().settings.filter_half_width,
                           filter) +
               pixel_filter.substr(end);
    }

    [[nodiscard]] gpu::ComputePipeline pass(const shader::Spirv& spirv, bool along_y) const {
        using enum gpu::BindingKind;
        return {device_,
                {.spirv = spirv,
                 .bindings = {storage_image, storage_image, storage_image, storage_image, storage_buffer,
                              storage_image},
                 .push_constant_bytes = sizeof(FilterParameters),
                 .constants = {{.id = 0, .bits = along_y ? 1U : 0U},
                               {.id = 1, .bits = moment().view.camera.orthographic() ? 1U : 0U}}}};
    }
};

// Images smaller than a row, smaller than a window, and of tiles that are not whole; more than a group's
// tiles.
TEST_P(FilterRows, GiveWhatTheLibraryGivesForEachPixel) {
    const FilterPair of_rows = rows();
    const FilterPair of_pixels = pixels();
    FilterParameters parameters{.sigma_pixels = 0.25F * static_cast<float>(2 * std::get<1>(GetParam()) + 1),
                                .depth_scale = 0.1F,
                                .c_adaptive = 0.7F};
    for (const glm::ivec2 size : {glm::ivec2(3, 7), glm::ivec2(21, 13), glm::ivec2(69, 34)}) {
        const Field field = rough_field(size);
        for (const float cap : {1e18F, 1.0F}) {
            parameters.cap = cap;
            const std::vector<float> result = filtered(of_rows, field, parameters);
            EXPECT_TRUE(
                same_bits(result, filtered(of_pixels, field, parameters), static_cast<std::size_t>(size.x)))
                << size.x << " x " << size.y << ", cap " << cap;
            EXPECT_EQ(result == field.occlusion, std::get<1>(GetParam()) == 0);
        }
    }
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    const auto& [filter, half_width, orthographic] = info.param;
    return fmt::format("{}_{}{}", filter, half_width, orthographic ? "_orthographic" : "");
}

// No neighbours, rows of 8 pixels, of 4, and windows whose rows are not held; what all filters share, in one
// of them.
INSTANTIATE_TEST_SUITE_P(Every, FilterRows,
                         testing::Combine(testing::Values("convergence", "geometry", "bilateral", "sao"),
                                          testing::Values(0, 2, 9), testing::Values(false)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Convergence, FilterRows, testing::Values(Case{"convergence", 3, true}), name_of);

class SaoFilter : public FilterRows {};

// Along a row at one depth: nine taps, every other pixel, with the paper's weights.
TEST_P(SaoFilter, ReadsEveryOtherPixelFourTimes) {
    Field field{.size = {25, 1},
                .occlusion = std::vector(25, 0.0F),
                .depth = std::vector(25, 3.0F),
                .normal = std::vector(25, glm::vec3(0, 0, 1)),
                .samples = std::vector(25, 50.0F)};
    field.occlusion[12] = 1.0F;
    const std::vector<float> result = filtered(rows(), field, {.sigma_pixels = 1.5F, .depth_scale = 0.1F});
    const std::vector<double> g{0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
    const double sum = g[0] + 2.0 * (1.2 + g[1] + g[2] + g[3] + g[4]);
    for (std::size_t x = 0; x < 25; ++x) {
        const std::size_t apart = std::max<std::size_t>(x, 12) - std::min<std::size_t>(x, 12);
        const bool is_tap = apart % 2 == 0 && apart <= 8;
        const bool sees_all = x >= 8 && x + 8 < 25;
        const double weight = apart == 0 ? g[0] : is_tap ? 0.3 + g[apart / 2] : 0.0;
        EXPECT_EQ(result[x] > 0.0F, is_tap) << x;
        EXPECT_TRUE(!sees_all || std::abs(double{result[x]} - weight / sum) < 1e-6) << x << ": " << result[x];
    }
}

INSTANTIATE_TEST_SUITE_P(The, SaoFilter, testing::Values(Case{"sao", 64, false}), name_of);

class FiltersInTheEffect : public OnDevice<testing::TestWithParam<std::string>> {};

// Of few samples: with many there is less to smooth than there is to blur.
TEST_P(FiltersInTheEffect, BringTheCornerNearerToItsClosedForm) {
    const scene::GBuffer view = rasterized("corner", {160, 90});
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
        views.push_back(rasterized("moving", {75, 41}, {.frame = frame, .motion = true}));
    for (const auto precision : {HistoryPrecision::float32, HistoryPrecision::packed}) {
        std::vector<Frame> last;
        for (const char* filter : {GetParam().c_str(), "none"}) {
            Settings chosen = with_radius(Settings{}, static_cast<float>(scene.ao_radius));
            chosen.precision = precision;
            chosen.table_size = 2048;
            set(chosen, "filter", filter);
            last.push_back(run(views, chosen).back());
        }
        expect_same_images(last[0], last[1], {&Frame::occlusion, &Frame::convergence});
        EXPECT_EQ(last[1].filtered, last[1].occlusion);
        EXPECT_NE(last[0].filtered, last[0].occlusion);
    }
}

INSTANTIATE_TEST_SUITE_P(Every, FiltersInTheEffect,
                         testing::Values("convergence", "geometry", "bilateral", "sao"),
                         [](const auto& name) { return name.param; });

}  // namespace gloam::effect::filters_test
