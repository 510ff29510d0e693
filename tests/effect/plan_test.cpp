// SPDX-License-Identifier: MIT
// The plan is what the effect does: the same passes in the same order, over images of the same size.
#include "effect/plan.hpp"
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
    const scene::GBuffer first = rasterized("room", extent, {.frame = 0});
    const scene::GBuffer second = rasterized("room", extent, {.frame = 1});
    for (const char* method : {"hemisphere", "mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const char* preset :
             {"tssao-paper", "balanced", "balanced, half", "balanced, frames alone", "tssao-paper, half"}) {
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

// What C++ and shaders share has one layout: names, types and offsets of push constants and buffers, and
// numbers of specialization constants, as the compiled passes have them.

class Layouts : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] shader::ModuleInterface interface_of(const PassSource& source) const {
        return shader::reflect(passes_.compile(source.file, source.defines, source.replaced));
    }

    void expect_pushed(const PassSource& source, std::size_t bytes,
                       const std::vector<std::string>& members) const {
        const shader::ModuleInterface found = interface_of(source);
        ASSERT_TRUE(found.push_constants.has_value()) << source.file;
        EXPECT_EQ(lines_of(found.push_constants->members), members) << source.file;
        EXPECT_EQ(found.push_constants->size, bytes) << source.file;
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

TEST_F(Layouts, OcclusionPass) {
    using T = OcclusionParameters;
    expect_pushed(occlusion(), sizeof(T),
                  {MEMBER(T, p00_p11),
                   MEMBER(T, size),
                   MEMBER(T, border),
                   MEMBER(T, radius),
                   MEMBER(T, bias),
                   MEMBER(T, c_spatial),
                   MEMBER(T, weight_max),
                   MEMBER(T, c_rot),
                   MEMBER(T, least_radius),
                   MEMBER(T, shade_border),
                   MEMBER(T, skip_background),
                   MEMBER(T, invalidation),
                   MEMBER(T, change_tolerance),
                   MEMBER(T, weight_small),
                   MEMBER(T, confidence_factor),
                   MEMBER(T, still),
                   MEMBER(T, freeze),
                   MEMBER(T, samples_distance),
                   MEMBER(T, samples_radius),
                   MEMBER(T, samples_least),
                   MEMBER(T, radius_cap),
                   MEMBER(T, smoothing),
                   MEMBER(T, c_filter),
                   MEMBER(T, bias_depth),
                   MEMBER(T, displacement_unit)});
}

TEST_F(Layouts, PreparationPasses) {
    using T = PreparationParameters;
    const PassSource source = preparation_source({}, "half_resolution.comp");
    expect_pushed(source, sizeof(T),
                  {MEMBER(T, p00_p11), MEMBER(T, size), MEMBER(T, border), MEMBER(T, radius), MEMBER(T, bias),
                   MEMBER(T, c_spatial), MEMBER(T, weight_max), MEMBER(T, c_rot), MEMBER(T, least_radius),
                   MEMBER(T, orthographic), MEMBER(T, shade_border), MEMBER(T, samples_distance),
                   MEMBER(T, samples_radius), MEMBER(T, samples_least), MEMBER(T, radius_cap),
                   MEMBER(T, bias_depth), MEMBER(T, level)});
}

TEST_F(Layouts, ReprojectionFilterAndMap) {
    using R = ReprojectionParameters;
    expect_pushed(reprojection_source({}), sizeof(R),
                  {MEMBER(R, previous_from_current), MEMBER(R, p00_p11), MEMBER(R, previous_p00_p11),
                   MEMBER(R, size), MEMBER(R, tolerance), MEMBER(R, displacement_unit)});
    using F = FilterParameters;
    for (const Filter filter : {Filter::convergence, Filter::geometry, Filter::bilateral, Filter::sao}) {
        Moment moment;
        moment.settings.filter = filter;
        expect_pushed(filter_source(moment, false), sizeof(F),
                      {MEMBER(F, p00_p11), MEMBER(F, size), MEMBER(F, sigma_pixels), MEMBER(F, depth_scale),
                       MEMBER(F, c_adaptive), MEMBER(F, weight_max), MEMBER(F, cap)});
    }
    using M = RemapParameters;
    expect_pushed(remap_source({}, false), sizeof(M),
                  {MEMBER(M, size), MEMBER(M, a), MEMBER(M, b), MEMBER(M, c)});
    using H = HalveParameters;
    expect_pushed(halve_source({}), sizeof(H),
                  {MEMBER(H, p00_p11), MEMBER(H, previous_p00_p11), MEMBER(H, size)});
    using U = UpsampleParameters;
    expect_pushed(upsample_source({}, true), sizeof(U),
                  {MEMBER(U, size), MEMBER(U, a), MEMBER(U, b), MEMBER(U, c)});
    using N = NormalParameters;
    expect_pushed({.file = "normals_from_depth.comp"}, sizeof(N),
                  {MEMBER(N, p00_p11), MEMBER(N, size), MEMBER(N, orthographic)});
    using S = SampleTableParameters;
    const std::string points = method_named("hemisphere").points;
    expect_pushed(sample_table_source(points), sizeof(S), {MEMBER(S, first), MEMBER(S, last)});
}

TEST_F(Layouts, PassesOverTiles) {
    using S = SelectParameters;
    expect_pushed(
        {.file = "tiles/select.comp"}, sizeof(S),
        {MEMBER(S, size), MEMBER(S, band), MEMBER(S, written), MEMBER(S, background), MEMBER(S, settled)});
    using F = SelectFilteredParameters;
    expect_pushed({.file = "tiles/select_filtered.comp"}, sizeof(F), {MEMBER(F, size), MEMBER(F, reach)});
}

TEST_F(Layouts, Directions) {
    using D = DirectionalParameters;
    for (const char* file :
         {"bent_normals.comp", "bent_gather.comp", "direct_light.comp", "bounced_light.comp"})
        expect_pushed({.file = file}, sizeof(D),
                      {MEMBER(D, p00_p11), MEMBER(D, size), MEMBER(D, radius), MEMBER(D, bias),
                       MEMBER(D, samples), MEMBER(D, orthographic), MEMBER(D, world_from_view)});
}

TEST_F(Layouts, Buffers) {
    using M = MethodValues;
    const std::vector<LaidOut> method = buffer_of(occlusion(), "MethodSettings");
    ASSERT_EQ(method.size(), 1U);
    EXPECT_EQ(method[0].size, sizeof(M));
    EXPECT_EQ(lines_of(method[0].members),
              (std::vector{MEMBER(M, range), MEMBER(M, epsilon), MEMBER(M, intensity), MEMBER(M, thickness),
                           MEMBER(M, angle_bias), MEMBER(M, mip_distance), MEMBER(M, steps),
                           MEMBER(M, disagreement), MEMBER(M, feature_thickness), MEMBER(M, layers)}));
    using S = TileState;
    const std::vector<LaidOut> states = buffer_of({.file = "tiles/select.comp"}, "StatesAfter");
    ASSERT_EQ(states.size(), 1U);
    EXPECT_EQ(states[0].stride, sizeof(S));
    EXPECT_EQ(lines_of(states[0].members),
              (std::vector{MEMBER(S, flags), MEMBER(S, missed), MEMBER(S, pixels)}));
    using L = TileList;
    const std::vector<LaidOut> lists = buffer_of({.file = "tiles/select.comp"}, "TileLists");
    ASSERT_EQ(lists.size(), 2U);
    EXPECT_EQ(lists[0].sizes, std::vector<unsigned>{header_lists});
    EXPECT_EQ(lists[0].stride, sizeof(L));
    EXPECT_EQ(lists[1].offset, header_lists * sizeof(L));
    EXPECT_EQ(lines_of(lists[0].members),
              (std::vector{MEMBER(L, columns), MEMBER(L, rows), MEMBER(L, layers), MEMBER(L, tiles)}));
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
