// SPDX-License-Identifier: MIT
// Cameras whose axis is not in the middle of their image: one eye of a headset, a tile, a split screen. Their
// pictures are parts of those of larger, centred views.
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::off_centre_test {

constexpr gpu::Extent extent{96, 64};

// What is around the windows in the larger view. Their sides are halves, so that the projections are those of
// the larger view to the bit: left, right, top, bottom, a quarter.
const std::vector<scene::Border> windows{
    {0, 0, 48, 0}, {48, 0, 0, 0}, {0, 0, 0, 32}, {0, 32, 0, 0}, {48, 0, 0, 32}};

// Pixels from a pixel of the window to the sides at which the larger view is cut.
double from_cut(std::size_t pixel, gpu::Extent window, const scene::Border& around) {
    const glm::dvec2 first(pixel % window.width, pixel / window.width);
    const glm::dvec2 last = glm::dvec2(window.width, window.height) - 1.0 - first;
    const auto from = [](std::uint32_t cut, double pixels) { return cut > 0 ? pixels : double{infinity}; };
    return std::min({from(around.left, first.x), from(around.top, first.y), from(around.right, last.x),
                     from(around.bottom, last.y)});
}

class OffCentre : public OnDevice<testing::TestWithParam<std::tuple<scene::Projection, bool, const char*>>> {
  protected:
    // The larger view, with its depth as an engine stores it.
    [[nodiscard]] scene::GBuffer whole() const {
        scene::Scene scene = floor_and_wall(true);
        scene.camera.projection = std::get<0>(GetParam());
        scene.camera.reversed_z = std::get<1>(GetParam());
        scene.camera.view_height = 2.5;
        scene::GBuffer view = drawn(scene, extent);
        view.stored = stored_inputs(view, encoding_);
        return view;
    }

    const scene::Encoding encoding_{.depth_buffer = true};
};

TEST_P(OffCentre, IsThatPartOfTheCentredView) {
    const Settings settings = with_radius(preset_named(std::get<2>(GetParam())).settings, 0.25F);
    const Frame larger = run(whole(), settings, 3);
    const auto place = [](const glm::dvec3& world, double) { return 0.1 * world.x + world.y; };
    const Truth whole_truth = truth_of(whole(), 0.1, place);
    for (const scene::Border& around : windows) {
        scene::GBuffer view = whole();
        view.border = around;
        scene::GBuffer window = cropped(view);
        window.stored = stored_inputs(window, encoding_);
        EXPECT_EQ(centred(window).camera.p00_p11(), view.camera.p00_p11());
        const Frame frame = run(centred(window), settings, 3);
        ASSERT_EQ(frame.extent, window.extent);
        const std::vector<float> part = scene::cropped(view, larger.filtered);
        const Truth truth = scene::cropped(view, whole_truth);
        const Truth part_truth = truth_of(window, 0.1, place);
        const scene::PixelPositions positions(window);
        std::vector<double> near;
        for (std::size_t i = 0; i < part.size(); ++i) {
            if (!scene::is_surface(window.depth[i])) continue;
            const double filter = 2.0 * settings.filter_half_width + 4.0;
            const double nearest = double{window.depth[i]} - 0.25;
            const bool beyond =
                from_cut(i, window.extent, around) > positions.pixels_of_length(0.25, nearest) + filter;
            if (!beyond) near.push_back(std::abs(double{frame.filtered[i]} - double{part[i]}));
            if (!beyond) continue;
            ASSERT_EQ(frame.filtered[i], part[i]) << i;
            ASSERT_EQ(std::isnan(part_truth[i]), std::isnan(truth[i])) << i;
            if (std::isnan(truth[i])) continue;
            ASSERT_NEAR(part_truth[i], truth[i], 1e-5) << i;
        }
        EXPECT_LT(near.size(), part.size() * 7 / 8);
        const double sum = std::accumulate(near.begin(), near.end(), 0.0);
        EXPECT_LT(sum / static_cast<double>(near.size()), 0.001) << "0.0006: nothing blocks beyond the cut";
    }
}

INSTANTIATE_TEST_SUITE_P(Views, OffCentre,
                         testing::Combine(testing::Values(scene::Projection::perspective,
                                                          scene::Projection::orthographic),
                                          testing::Bool(), testing::Values("tssao-paper")));

}  // namespace gloam::effect::off_centre_test
