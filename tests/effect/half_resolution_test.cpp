// SPDX-License-Identifier: MIT
// The setting `resolution` = half: the half-size image is the same scene, what comes back to full size is of
// the right surface, and everything else works with it.
#include "effect/errors.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::half_resolution_test {

class HalfSize : public OnDevice<testing::Test> {
  public:
    static constexpr gpu::Extent extent{83, 46};

  protected:
    [[nodiscard]] static Settings half(Settings settings, float radius = 0.5F) {
        settings.resolution = Resolution::half;
        return with_radius(settings, radius);
    }

    [[nodiscard]] scene::GBuffer view(const std::string& scene, int frame = 0,
                                      scene::DrawOptions options = {.motion = true},
                                      gpu::Extent size = extent) const {
        options.frame = frame;
        return drawn(scene, size, options);
    }

    [[nodiscard]] std::vector<scene::GBuffer> views(const std::string& scene, int count,
                                                    int first = 0) const {
        std::vector<scene::GBuffer> all;
        for (int i = 0; i < count; ++i) all.push_back(view(scene, first + i));
        return all;
    }
};

// The pixels of a view, with (0, 0) the centre of the first one.
struct Pixels {
    explicit Pixels(const View& view)
        : scale(view.camera.p00_p11()),
          sides(view.extent.width, view.extent.height),
          orthographic(view.camera.orthographic()) {}

    [[nodiscard]] glm::dvec2 ray(glm::dvec2 at) const { return ((at + 0.5) / sides * 2.0 - 1.0) / scale; }
    [[nodiscard]] glm::dvec3 point(glm::dvec2 at, double depth) const {
        return {orthographic ? ray(at) : ray(at) * depth, -depth};
    }
    [[nodiscard]] glm::dvec2 of(glm::dvec3 point) const {
        const glm::dvec2 ray = orthographic ? glm::dvec2(point) : glm::dvec2(point) / -point.z;
        return (ray * scale + 1.0) / 2.0 * sides - 0.5;
    }
    // Depth of the plane through a point at another pixel.
    [[nodiscard]] double depth(glm::dvec3 normal, glm::dvec3 point, glm::dvec2 at) const {
        return glm::dot(normal, point) / glm::dot(normal, glm::dvec3(ray(at), -1.0));
    }

    glm::dvec2 scale;
    glm::dvec2 sides;
    bool orthographic;
};

Pixels half_pixels(const View& view) {
    return Pixels(working_view(view, Resolution::half));
}

// A point of the view and the same point of the half-size view are seen at the same place, now and in the
// frame before.
TEST(HalfView, ShowsTheSamePointsAtTheSamePlaces) {
    for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
        for (const gpu::Extent size :
             {gpu::Extent{64, 36}, gpu::Extent{65, 37}, gpu::Extent{64, 37}, gpu::Extent{1, 2}}) {
            const scene::Camera camera{.projection = projection, .view_height = 3.0};
            scene::Camera before = camera;
            before.eye = {0.3, -0.2, 0.4};
            before.target = {0.5, 0.1, -2.0};
            const double aspect = static_cast<double>(size.width) / static_cast<double>(size.height);
            const View now{scene::make_frame(camera, aspect, before), size, {}};
            const View then{scene::make_frame(before, aspect), size, {}};
            const glm::dmat4 between(*now.camera.previous_from_current);
            const glm::dmat4 half_between(half_previous_from_current(now, then));
            for (const double depth : {0.5, 2.0, 30.0}) {
                for (const glm::dvec2 at : {glm::dvec2(0, 0), glm::dvec2(7, 3), glm::dvec2(20, 17)}) {
                    const glm::dvec3 full = between * glm::dvec4(Pixels(now).point(2.0 * at, depth), 1.0);
                    const glm::dvec3 halved =
                        half_between * glm::dvec4(half_pixels(now).point(at, depth), 1.0);
                    EXPECT_NEAR(halved.z, full.z, 1e-5 * depth);
                    EXPECT_LT(glm::length(2.0 * half_pixels(then).of(halved) - Pixels(then).of(full)), 1e-3)
                        << size.width << " x " << size.height << " at depth " << depth;
                }
            }
        }
    }
}

// What halve_inputs.comp has written.
struct Halved {
    explicit Halved(const Step& pass)
        : depth(image_of(pass, 4).download()),
          normal(vectors_of(image_of(pass, 5).download())),
          previous(vectors_of(image_of(pass, 6).download())),
          layer(channel(image_of(pass, 7).download(), 0)) {}

    std::vector<float> depth;
    std::vector<glm::vec3> normal;
    std::vector<glm::vec3> previous;
    std::vector<float> layer;
};

// Returns the number of pixels with a surface.
std::size_t expect_every_second_pixel(const Halved& halved, const scene::GBuffer& full, const View& before) {
    const View given{full.camera, full.extent, {}};
    const Pixels pixels(given);
    const Pixels halves = half_pixels(given);
    const std::uint32_t columns = half_of(full.extent).width;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < halved.depth.size(); ++i) {
        const glm::dvec2 at(i % columns, i / columns);
        const std::size_t source = 2 * (i / columns) * full.extent.width + 2 * (i % columns);
        EXPECT_EQ(bits_of({halved.depth[i], halved.layer[i]}),
                  bits_of({full.depth[source], full.layers[0][source]}));
        if (!std::isfinite(halved.depth[i])) continue;
        ++seen;
        EXPECT_NEAR(glm::length(halved.normal[i]), 1.0F, 1e-6F);
        // The surface's plane has the same depth under the next half-size pixel as under that one's source.
        const double depth = double{halved.depth[i]};
        const double next = halves.depth(glm::dvec3(halved.normal[i]), halves.point(at, depth), at + 1.0);
        const double source_next =
            pixels.depth(glm::dvec3(full.normal[source]), pixels.point(2.0 * at, depth), 2.0 * at + 2.0);
        EXPECT_NEAR(next / source_next, 1.0, 3e-5) << at.x << ' ' << at.y;
        // Where the point was, in pixels.
        const glm::dvec3 was(halved.previous[i]);
        const glm::dvec3 source_was(full.previous_position[source]);
        EXPECT_EQ(was.z, source_was.z);
        EXPECT_LT(glm::length(2.0 * half_pixels(before).of(was) - Pixels(before).of(source_was)), 1e-3);
    }
    return seen;
}

TEST_F(HalfSize, InputsAreThoseOfEverySecondPixel) {
    for (const gpu::Extent size : {gpu::Extent{64, 46}, gpu::Extent{83, 45}, gpu::Extent{45, 83}}) {
        const std::vector<scene::GBuffer> both{view("moving", 20, {.motion = true, .layers = 2}, size),
                                               view("moving", 21, {.motion = true, .layers = 2}, size)};
        Settings settings = half({});
        settings.own.layers = 2;
        AmbientOcclusion effect(device_, passes_, size);
        effect.begin(both[0], settings);
        (void)effect.next();
        std::size_t seen = 0;
        effect.watch([&](const Step& pass, bool after) {
            if (pass.name == "halve_inputs" && after)
                seen = expect_every_second_pixel(Halved(pass), both[1], {both[0].camera, size, {}});
        });
        effect.advance(both[1]);
        (void)effect.next();
        EXPECT_GT(seen, pixels_of(half_of(size)) / 2);
    }
}

// The range of the half-size pixels around a pixel that are at or behind the column `edge`.
std::pair<float, float> range_around(const std::vector<float>& of_half, std::size_t x, std::size_t y,
                                     std::size_t edge) {
    const gpu::Extent size = half_of(HalfSize::extent);
    float least = 1.0F;
    float most = 0.0F;
    for (const std::size_t v : {y / 2, std::min((y + 1) / 2, std::size_t{size.height - 1})}) {
        for (const std::size_t u : {x / 2, std::min((x + 1) / 2, std::size_t{size.width - 1})}) {
            if (2 * u < edge) continue;
            least = std::min(least, of_half[v * size.width + u]);
            most = std::max(most, of_half[v * size.width + u]);
        }
    }
    return {least, most};
}

// A near plane that covers a part of a wall, with its edge at an even and at an odd column. Nothing is in
// front of the near one, which therefore is open to its last pixel; beside it the wall is not.
TEST_F(HalfSize, PixelsAtAnEdgeAreOfTheirSurface) {
    for (const bool orthographic : {false, true}) {
        for (const unsigned edge : {40U, 41U}) {
            scene::GBuffer scene = view_of(extent, orthographic, [](glm::dvec2) { return 4.0; });
            for (std::size_t i = 0; i < scene.depth.size(); ++i)
                if (i % extent.width < edge) scene.depth[i] = 3.0F;
            Settings settings = half({}, 2.0F);
            settings.filter = Filter::none;
            AmbientOcclusion effect(device_, passes_, extent);
            std::vector<float> of_half;
            effect.watch([&](const Step& pass, bool) {
                if (pass.name == "upsample") of_half = channel(image_of(pass, 2).download(), 0);
            });
            effect.begin(scene, settings);
            const std::vector<float> shown = effect.next().filtered;
            for (std::size_t i = 0; i < shown.size(); ++i) {
                const std::size_t x = i % extent.width;
                if (x < edge) {
                    ASSERT_EQ(shown[i], 0.0F) << x;
                    continue;
                }
                EXPECT_TRUE(x != edge || shown[i] > 0.1F) << shown[i];
                const auto [least, most] = range_around(of_half, x, i / extent.width, edge);
                EXPECT_TRUE(shown[i] >= least && shown[i] <= most) << x << ' ' << i / extent.width;
            }
        }
    }
}

// The pixels that the half-size pixels stand for have their values, and so has a constant image.
TEST_F(HalfSize, SourcesKeepTheirValues) {
    for (const char* preset : {"tssao-paper", "balanced"}) {
        Settings settings = half(preset_named(preset).settings, 0.3F);
        std::vector<float> of_half;
        AmbientOcclusion effect(device_, passes_, extent);
        effect.watch([&](const Step& pass, bool) {
            if (pass.name == "upsample") of_half = image_of(pass, 2).download();
        });
        effect.begin(view("room"), settings);
        const std::vector<float> shown = effect.next().filtered;
        const std::size_t channels = of_half.size() / pixels_of(half_of(extent));
        const float unit = settings.precision == HistoryPrecision::packed ? 1.0F / 32768.0F : 1.0F;
        for (std::size_t y = 0; y < extent.height; y += 2)
            for (std::size_t x = 0; x < extent.width; x += 2)
                ASSERT_EQ(shown[y * extent.width + x],
                          (channels == 1 ? 1.0F : unit) *
                              of_half[channels * (y / 2 * half_of(extent).width + x / 2)]);
        EXPECT_GT(*std::ranges::max_element(shown), 0.15F);
    }
}

// The history follows the surfaces as well as at full size.
TEST_F(HalfSize, HistoryFollowsTheViews) {
    for (const char* name : {"room", "moving"}) {
        const auto share = [&](Resolution resolution) {
            Settings settings = with_radius(Settings{}, 0.3F);
            settings.resolution = resolution;
            const Frame last = run(views(name, 4, 20), settings).back();
            std::size_t kept = 0;
            for (const float each : last.kept) kept += each > 0.0F ? 1 : 0;
            return static_cast<double>(kept) / static_cast<double>(last.kept.size());
        };
        const double full = share(Resolution::full);
        EXPECT_GT(full, 0.5);
        EXPECT_NEAR(share(Resolution::half), full, 0.02) << name;
    }
    // A view that does not move keeps all of it.
    for (const gpu::Extent size : {extent, gpu::Extent{64, 46}}) {
        std::vector<scene::GBuffer> of_size(3, view("room", 0, {}, size));
        for (scene::GBuffer& each : of_size) each.camera.previous_from_current = glm::mat4(1.0F);
        const std::vector<Frame> frames = run(of_size, half({}));
        for (const float kept : frames.back().kept) ASSERT_EQ(kept, 64.0F);
    }
}

// What is remapped and rounded is what would have been shown otherwise.
TEST_F(HalfSize, DisplayIsMappedAtFullSize) {
    const std::vector<scene::GBuffer> one{view("room")};
    for (const Filter filter : {Filter::none, Filter::convergence}) {
        Settings settings = half({}, 0.3F);
        settings.filter = filter;
        const std::vector<float> plain = run(one, settings).front().filtered;
        settings.output = OutputFormat::r8;
        settings.remap_b = 0.9F;
        settings.remap_c = 1.5F;
        const std::vector<float> shown = run(one, settings).front().filtered;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            const double visibility = std::pow(0.9 * (1.0 - double{plain[i]}), 1.5);
            const double expected = std::isfinite(one[0].depth[i]) ? 1.0 - visibility : 0.0;
            ASSERT_NEAR(double{shown[i]}, expected, 0.5 / 255.0 + 1e-5);
        }
    }
}

// The smallest images, and sides of each kind.
TEST_F(HalfSize, ImagesOfAnySize) {
    for (const gpu::Extent size : {gpu::Extent{1, 1}, gpu::Extent{2, 1}, gpu::Extent{1, 2}, gpu::Extent{3, 2},
                                   gpu::Extent{16, 16}, gpu::Extent{17, 33}, gpu::Extent{130, 7}}) {
        for (const char* preset : {"tssao-paper", "balanced"}) {
            std::vector<scene::GBuffer> all;
            for (int i = 0; i < 2; ++i) all.push_back(view("room", i, {.motion = true}, size));
            const std::vector<Frame> frames = run(all, half(preset_named(preset).settings, 0.3F));
            for (const Frame& frame : frames) {
                EXPECT_EQ(frame.extent, size);
                EXPECT_EQ(frame.filtered.size(), pixels_of(size));
                for (const float value : frame.filtered) ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << value;
            }
        }
    }
}

// The setting `resolution` = half beside all others.

// Whatever settings there are beside it. The difference to the full size is that of single samples a block.
struct Beside {
    const char* name;
    std::vector<std::pair<const char*, const char*>> settings;
    double most = 0.08;  // root mean square difference of the full size
};

class HalfSizeBeside : public HalfSize, public testing::WithParamInterface<Beside> {
  protected:
    // Three views of a moving scene, with the inputs that the case names.
    [[nodiscard]] std::vector<scene::GBuffer> given(const Settings& settings) const {
        const std::string name = GetParam().name;
        std::vector<scene::GBuffer> all;
        for (int i = 0; i < 3; ++i) {
            all.push_back(
                view("moving", 20 + i,
                     {.motion = true, .layers = settings.own.layers, .guard = double{settings.guard}}));
            if (name == "no_normals") all.back().normal.clear();
            if (name == "stored")  // as an engine with a depth buffer and world-space normals has it
                all.back().stored =
                    scene::stored_inputs(all.back(), scene::encoding_named("buffer", "world"));
        }
        return all;
    }
};

TEST_P(HalfSizeBeside, IsNearTheFullSize) {
    Settings settings = with_radius(Settings{}, 0.4F);
    settings.samples = 64;
    for (const auto& [name, value] : GetParam().settings) set(settings, name, value);
    const std::vector<scene::GBuffer> all = given(settings);
    const std::vector<Frame> full = run(all, settings);
    settings.resolution = Resolution::half;
    const std::vector<Frame> halved = run(all, settings);
    expect_same_images(halved, run(all, settings));  // twice the same
    for (std::size_t i = 0; i < full.size(); ++i) {
        EXPECT_EQ(halved[i].extent, full[i].extent);
        for (const auto& [image, name] : images_of_frame)
            ASSERT_EQ((halved[i].*image).size(), (full[i].*image).size()) << name;
        for (const float value : halved[i].filtered) ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << value;
        EXPECT_GT(*std::ranges::max_element(halved[i].filtered), 0.05F);
        EXPECT_LT(errors_of(halved[i].filtered, full[i].filtered).rmse, GetParam().most) << "frame " << i;
        EXPECT_GT(errors_of(halved[i].filtered, full[i].filtered).rmse, 0.0) << "frame " << i;
        EXPECT_LT(errors_of(halved[i].occlusion, full[i].occlusion).rmse, 3 * GetParam().most)
            << "frame " << i;
    }
    // And back.
    settings.resolution = Resolution::full;
    expect_same_images(run(all, settings), full, {&Frame::filtered});
}

INSTANTIATE_TEST_SUITE_P(
    Of, HalfSizeBeside,
    testing::Values(
        Beside{"defaults", {}}, Beside{"no_filter", {{"filter", "none"}}},
        Beside{"geometry", {{"filter", "geometry"}}}, Beside{"bilateral", {{"filter", "bilateral"}}},
        Beside{"sao_filter", {{"filter", "sao"}}}, Beside{"alone", {{"filter", "none"}, {"history", "off"}}},
        Beside{"alone_r8", {{"filter", "none"}, {"history", "off"}, {"output", "r8"}}},
        Beside{"remap", {{"remap_b", "0.9"}, {"remap_c", "1.5"}}},
        Beside{"remap_r16f", {{"remap_a", "0.05"}, {"filter", "none"}, {"output", "r16f"}}},
        Beside{"r8", {{"output", "r8"}}}, Beside{"layers", {{"layers", "2"}}},
        Beside{"packed", {{"precision", "packed"}, {"filter", "none"}}}, Beside{"guard", {{"guard", "0.1"}}},
        Beside{"guard_unshaded", {{"guard", "0.1"}, {"guard_history", "off"}}}, Beside{"no_normals", {}},
        Beside{"stored", {}}, Beside{"mssao", {{"method", "mssao"}}, 0.2},
        Beside{"dual_resolution", {{"method", "dual_resolution"}}, 0.1},
        Beside{"separable", {{"method", "separable"}}, 0.1},
        Beside{"sao_chain", {{"method", "sao_chain"}}, 0.1}, Beside{"sweep", {{"method", "sweep"}}, 0.1}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace gloam::effect::half_resolution_test
