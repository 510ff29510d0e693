// SPDX-License-Identifier: MIT
// The spatial filter, which filters several pixels at a time and reads what they share once, against the
// library's functions pixel by pixel: the same to the bit.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cctype>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/setting_table.hpp"
#include "filter_passes.hpp"
#include "on_device.hpp"
#include "pixel_filter.hpp"
#include "shader/cache.hpp"

namespace gloam::effect {
namespace filter_rows_test {

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

}  // namespace filter_rows_test
}  // namespace gloam::effect
