// SPDX-License-Identifier: MIT
// The plan is what the effect does: the same passes in the same order, over images of the same size.
#include "effect/plan.hpp"

#include <nlohmann/json.hpp>  // repeats a macro for each argument

#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "support/laid_out.hpp"

namespace gloam::effect::plan_test {

using shader::LaidOut;

class PlanTest : public OnDevice<testing::Test> {};

std::vector<std::string> names_of(const std::vector<PassTime>& times) {
    std::vector<std::string> names;
    for (const PassTime& time : times) names.push_back(time.pass);
    return names;
}

// Of a frame in which everything runs, over the whole image.
Settings without_tiles(Settings settings) {
    settings.skip_settled = settings.skip_filtered = settings.skip_background = false;
    return settings;
}

TEST_F(PlanTest, IsWhatAFrameRuns) {
    const gpu::Extent extent{33, 17};
    const scene::GBuffer first = drawn("room", extent, {.frame = 0});
    const scene::GBuffer second = drawn("room", extent, {.frame = 1});
    for (const char* method : {"hemisphere", "mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const char* preset : {"tssao-paper", "tssao-paper, frames alone", "tssao-paper, half"}) {
            const bool alone = std::string_view(preset).ends_with("alone");
            const bool half = std::string_view(preset).ends_with("half");
            const std::string_view named =
                std::string_view(preset).substr(0, std::string_view(preset).find(','));
            Settings settings = without_tiles(with_method(preset_named(std::string(named)).settings, method));
            settings.history = !alone;
            if (half) settings.resolution = Resolution::half;
            settings.remap_b = 2.0F;
            AmbientOcclusion& effect = effect_for(extent);
            effect.begin(first, settings);
            (void)effect.next(1);
            effect.advance(second);
            std::vector<std::string> ran = names_of(effect.next(1).times);
            std::erase(
                ran, "remap");  // of the unfiltered occlusion, which nobody is shown where there is a filter
            std::erase(ran, "sample_table");
            std::vector<std::string> planned;
            for (const PlannedPass& pass : plan_of(settings, {.view = extent}).passes)
                if (pass.turn != Turn::once) planned.push_back(pass.name);
            std::erase(planned, "remap");
            EXPECT_EQ(planned, ran) << method << " " << preset;
        }
    }
}

TEST_F(PlanTest, ImagesHaveTheSizeThatTheMethodPrepares) {
    for (const char* method : {"mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const gpu::Extent extent : {gpu::Extent{640, 360}, gpu::Extent{33, 17}, gpu::Extent{1, 1}}) {
            for (const Resolution resolution : {Resolution::full, Resolution::half}) {
                Settings settings = with_method({}, method);
                settings.resolution = resolution;
                const gpu::Extent read = resolution == Resolution::half ? half_of(extent) : extent;
                const Preparation preparation = preparation_of(settings, read).value();
                const Plan plan = plan_of(settings, {.view = extent});
                std::size_t next = 0;
                for (const PlannedImage& image : plan.images) {
                    const std::uint32_t d = image.divisor;
                    if (d == 0) continue;
                    EXPECT_EQ(image.extent.width, (extent.width + d - 1) / d) << image.name;
                    EXPECT_EQ(image.extent.height, (extent.height + d - 1) / d) << image.name;
                }
                for (const PlannedPass& pass : plan.passes) {
                    if (next == preparation.passes.size() || pass.name != preparation.passes[next].name)
                        continue;
                    const gpu::Extent needed = preparation.passes[next++].invocations;
                    const auto [x, y] = pass.pixels;
                    EXPECT_GE((extent.width + x - 1) / x * 8, needed.width) << pass.name;
                    EXPECT_GE((extent.height + y - 1) / y * 8, needed.height) << pass.name;
                }
                EXPECT_EQ(next, preparation.passes.size());
            }
        }
    }
}

// Passes over half-size images have groups of as many pixels of the half-size view.
TEST_F(PlanTest, GroupsCoverTheHalfSizeView) {
    Settings settings;
    settings.resolution = Resolution::half;
    for (const bool tiles : {false, true}) {
        const Plan plan = plan_of(settings, {.view = {35, 18}, .tiles = tiles, .normals = false});
        EXPECT_EQ(plan.tile, 16U);
        EXPECT_EQ(plan.result, "upsampled");
        std::size_t full = 0;
        for (const PlannedPass& pass : plan.passes) {
            full += pass.divisor == 1 && pass.turn != Turn::once ? 1 : 0;
            if (pass.pixels[0] == 0) continue;
            EXPECT_EQ(pass.pixels[1] % 16, pass.name == "normals_from_depth" ? 8U : 0U) << pass.name;
            EXPECT_EQ(pass.divisor, pass.name == "normals_from_depth" || pass.name == "halve_inputs" ||
                                            pass.name == "upsample"
                                        ? 1U
                                        : 2U)
                << pass.name;
        }
        EXPECT_EQ(full, 3U);
        const auto size = [&](const char* name) {
            const auto found = std::ranges::find(plan.images, name, &PlannedImage::name);
            return found == plan.images.end() ? gpu::Extent{} : found->extent;
        };
        EXPECT_EQ(size("depth"), (gpu::Extent{35, 18}));
        EXPECT_EQ(size("half_depth"), (gpu::Extent{18, 9}));
        EXPECT_EQ(size("history_after"), (gpu::Extent{18, 9}));
        EXPECT_EQ(size("upsampled"), (gpu::Extent{35, 18}));
    }
}

// Of the push constants the view's are what an engine must give, all others are the settings'.
TEST_F(PlanTest, TellsWhatIsTheViews) {
    const Plan plan = plan_of({}, {});
    for (const PlannedPass& pass : plan.passes) {
        if (pass.name != "ambient_occlusion") continue;
        ASSERT_EQ(pass.of_view.size(), pass.parameters.size());
        const auto any = [&](std::size_t first, std::size_t bytes) {
            return std::find(pass.of_view.begin() + static_cast<std::ptrdiff_t>(first),
                             pass.of_view.begin() + static_cast<std::ptrdiff_t>(first + bytes),
                             true) != pass.of_view.begin() + static_cast<std::ptrdiff_t>(first + bytes);
        };
        EXPECT_TRUE(any(0, 4) && any(4, 4));    // p00_p11
        EXPECT_TRUE(any(8, 4) && any(12, 4));   // size
        EXPECT_TRUE(any(16, 4) && any(20, 4));  // border
        constexpr std::size_t radius = offsetof(OcclusionParameters, radius);
        EXPECT_FALSE(any(radius, offsetof(OcclusionParameters, still) - radius));  // to confidence_factor
    }
}

TEST_F(PlanTest, RefusesWhatSettingsRefuse) {
    Settings settings;
    settings.samples = 0;
    EXPECT_THROW((void)plan_of(settings, {}), std::invalid_argument);
}

// The lines of all members of a struct, in their order.
#define LINE_OF_MEMBER(name) MEMBER(Struct, name),
#define LINES_OF(Type, ...)                                                          \
    ([] {                                                                            \
        using Struct = Type;                                                         \
        return std::vector<std::string>{                                             \
            NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(LINE_OF_MEMBER, __VA_ARGS__))}; \
    }())

// What C++ and shaders share has one layout: names, types and offsets of push constants and buffers, and
// numbers of specialization constants, as the compiled passes have them.
class Layouts : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] shader::ModuleInterface interface_of(const PassSource& source) const {
        return shader::reflect(passes_.compile(source.file, source.defines, source.replaced));
    }

    template <class Parameters>
    void expect_pushed(const PassSource& source, const std::vector<std::string>& members) const {
        const shader::ModuleInterface found = interface_of(source);
        ASSERT_TRUE(found.push_constants.has_value()) << source.file;
        EXPECT_EQ(lines_of(found.push_constants->members), members) << source.file;
        EXPECT_EQ(found.push_constants->size, sizeof(Parameters)) << source.file;
    }

    [[nodiscard]] std::vector<LaidOut> buffer_of(const PassSource& source, const std::string& block) const {
        for (const shader::Binding& binding : interface_of(source).bindings)
            if (binding.block && binding.block->name == block) return binding.block->members;
        ADD_FAILURE() << source.file << " has no buffer " << block;
        return {};
    }
};

PassSource occlusion() {
    return occlusion_source({.counting = Counting::each_group});
}

TEST_F(Layouts, SamplesAndWhatIsPreparedForThem) {
    expect_pushed<OcclusionParameters>(
        occlusion(),
        LINES_OF(OcclusionParameters, p00_p11, size, border, radius, bias, c_spatial, weight_max, c_rot,
                 least_radius, shade_border, skip_background, invalidation, change_tolerance, weight_small,
                 confidence_factor, still, freeze, samples_distance, samples_radius, samples_least,
                 radius_cap, smoothing, c_filter, bias_depth, displacement_unit));
    expect_pushed<PreparationParameters>(
        preparation_source({}, "half_resolution.comp"),
        LINES_OF(PreparationParameters, p00_p11, size, border, radius, bias, c_spatial, weight_max, c_rot,
                 least_radius, orthographic, shade_border, samples_distance, samples_radius, samples_least,
                 radius_cap, bias_depth, level));
    expect_pushed<SampleTableParameters>(sample_table_source(method_named("hemisphere").points),
                                         LINES_OF(SampleTableParameters, first, last));
}

TEST_F(Layouts, ReprojectionFilterAndMap) {
    expect_pushed<ReprojectionParameters>(reprojection_source({}),
                                          LINES_OF(ReprojectionParameters, previous_from_current, p00_p11,
                                                   previous_p00_p11, size, tolerance, displacement_unit));
    for (const Filter filter : {Filter::convergence, Filter::geometry, Filter::bilateral, Filter::sao}) {
        Moment moment;
        moment.settings.filter = filter;
        expect_pushed<FilterParameters>(filter_source(moment, false),
                                        LINES_OF(FilterParameters, p00_p11, size, sigma_pixels, depth_scale,
                                                 c_adaptive, weight_max, cap));
    }
    expect_pushed<RemapParameters>(remap_source({}, false), LINES_OF(RemapParameters, size, a, b, c));
    expect_pushed<HalveParameters>(halve_source({}),
                                   LINES_OF(HalveParameters, p00_p11, previous_p00_p11, size));
    expect_pushed<UpsampleParameters>(upsample_source({}, true), LINES_OF(UpsampleParameters, size, a, b, c));
    expect_pushed<NormalParameters>({.file = "normals_from_depth.comp"},
                                    LINES_OF(NormalParameters, p00_p11, size, orthographic));
}

TEST_F(Layouts, TilesAndDirections) {
    expect_pushed<SelectParameters>({.file = "tiles/select.comp"},
                                    LINES_OF(SelectParameters, size, band, written, background, settled));
    expect_pushed<SelectFilteredParameters>({.file = "tiles/select_filtered.comp"},
                                            LINES_OF(SelectFilteredParameters, size, reach));
    for (const char* file :
         {"bent_normals.comp", "bent_gather.comp", "direct_light.comp", "bounced_light.comp"})
        expect_pushed<DirectionalParameters>(
            {.file = file}, LINES_OF(DirectionalParameters, p00_p11, size, radius, bias, samples,
                                     orthographic, world_from_view));
}

TEST_F(Layouts, Buffers) {
    const std::vector<LaidOut> method = buffer_of(occlusion(), "MethodSettings");
    ASSERT_EQ(method.size(), 1U);
    EXPECT_EQ(method[0].size, sizeof(MethodValues));
    EXPECT_EQ(lines_of(method[0].members),
              LINES_OF(MethodValues, range, epsilon, intensity, thickness, angle_bias, mip_distance, steps,
                       disagreement, feature_thickness, layers));
    const std::vector<LaidOut> states = buffer_of({.file = "tiles/select.comp"}, "StatesAfter");
    ASSERT_EQ(states.size(), 1U);
    EXPECT_EQ(states[0].stride, sizeof(TileState));
    EXPECT_EQ(lines_of(states[0].members), LINES_OF(TileState, flags, missed, pixels));
    const std::vector<LaidOut> lists = buffer_of({.file = "tiles/select.comp"}, "TileLists");
    ASSERT_EQ(lists.size(), 2U);
    EXPECT_EQ(lists[0].sizes, std::vector<unsigned>{header_lists});
    EXPECT_EQ(lists[0].stride, sizeof(TileList));
    EXPECT_EQ(lists[1].offset, header_lists * sizeof(TileList));
    EXPECT_EQ(lines_of(lists[0].members), LINES_OF(TileList, columns, rows, layers, tiles));
}

// Engines have sampled images, and OpenGL ES 3.1 lets no pass read an image of four channels that it writes.
TEST_F(Layouts, NoImageIsReadAndWritten) {
    std::set<std::string> seen;
    for (const char* method :
         {"dual_resolution", "sao_chain", "separable", "mssao", "volumetric_area", "disc_proxy_two"}) {
        Settings settings = with_method({}, method);
        settings.remap_b = 2.0F;
        if (reads(method_named(method), "layers")) settings.own.layers = 2;
        settings.resolution = method == std::string("mssao") ? Resolution::half : Resolution::full;
        const PlanOptions options{.moving_objects = true, .tiles = true, .normals = false};
        for (const PlannedPass& pass : plan_of(settings, options).passes) {
            for (const shader::Binding& binding : interface_of(pass.source).bindings) {
                const bool stored = binding.type == shader::BindingType::storage_image;
                EXPECT_TRUE(!stored || (binding.writes && !binding.reads))
                    << pass.source.file << " " << binding.name;
            }
            seen.insert(pass.source.file);
        }
    }
    EXPECT_EQ(seen.size(), 17U);
}

// A constant that a pass is given exists in it. The optimiser removes those that a method does not use, so
// those of several methods count; the preparation passes share theirs.
TEST_F(Layouts, SpecializationConstants) {
    std::map<std::string, std::set<std::uint32_t>> given;
    std::map<std::string, std::set<std::uint32_t>> known;
    for (const char* method :
         {"hemisphere", "gtao", "hbao_study", "sao", "separable", "mssao", "dual_resolution"}) {
        Settings settings = with_method({}, method);
        settings.remap_b = 2.0F;
        settings.resolution = method == std::string("sao") ? Resolution::half : Resolution::full;
        for (const PlannedPass& pass : plan_of(settings, {.tiles = true}).passes) {
            const std::string& file = pass.source.file;
            const std::string key = file.starts_with("preparation/") ? "preparation" : file;
            const shader::ModuleInterface found = interface_of(pass.source);
            for (const auto& constant : found.constants) known[key].insert(constant.id);
            for (const auto& constant : pass.source.constants) given[key].insert(constant.id);
            EXPECT_EQ(found.push_constants->size, pass.parameters.size()) << method << " " << pass.name;
        }
    }
    EXPECT_EQ(given.size(), 7U);
    for (const auto& [file, constants] : given)
        for (const std::uint32_t constant : constants) EXPECT_THAT(known[file], Contains(constant)) << file;
}

}  // namespace gloam::effect::plan_test
