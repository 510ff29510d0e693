// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "scene/rasterize.hpp"
#include "stress/reprojected.hpp"

namespace gloam::stress {
namespace {

constexpr const char* far_away_name = "far-away";
constexpr double farthest_offset = 1e8;
constexpr double centered_uv_error = 2.4e-6;    // of gloam_reproject_clip
constexpr double centered_depth_error = 5e-7;   // of gloam_previous_depth, a part of the distances
constexpr double static_clip_error = 4e-6;      // of gloam_previous_clip_static, a part of the positions
constexpr double moving_clip_error = 8e-6;      // of gloam_previous_clip_moving, likewise
constexpr double disocclusion_epsilon = 0.01;   // of gloam_depth_consistent, the strictest in use
constexpr double farthest_point_of_scene = 60;  // from its own origin

std::vector<double> distances(double from, int steps_a_decade) {
    std::vector<double> all;
    const auto steps = static_cast<int>(std::lround(std::log10(farthest_offset / from) * steps_a_decade));
    for (int i = 0; i <= steps; ++i)
        all.push_back(from * std::pow(10.0, static_cast<double>(i) / steps_a_decade));
    return all;
}

std::size_t differing(const std::vector<check::Word>& a, const std::vector<check::Word>& b) {
    std::size_t count = a.size() == b.size() ? 0 : std::max(a.size(), b.size());
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
}

void append_centered(const Context& context, const MovedPoints& origin, Rows& rows) {
    const CenteredForm form(context.lab);
    const std::vector<check::Word> expected = form.run(origin).words();
    std::size_t changed = 0;
    double pixels = 0.0;
    double depth = 0.0;
    for (const double distance : distances(1e3, 1)) {
        const MovedPoints far = moved(origin, distance);
        const CenteredResults results = form.run(far);
        changed += differing(results.words(), expected);
        pixels = std::max(pixels, CenteredForm::pixels(far, results));
        depth = std::max(depth, CenteredForm::depth_error(far, results));
    }
    const std::string varied = "camera-centred, 1e3 to 1e8";
    rows.push_back({far_away_name, varied, "words changed", static_cast<double>(changed), 0.0});
    rows.push_back(
        {far_away_name, varied, "error, pixels at 1920 x 1080", pixels, centered_uv_error * image_width});
    rows.push_back(
        {far_away_name, varied, "previous depth off, part of the distance", depth, centered_depth_error});
}

constexpr gpu::Extent picture_extent{96, 54};

// What one shows: depth, normals and occlusion of every pixel, as words.
std::vector<check::Word> picture(const Context& context, effect::AmbientOcclusion& effect, double distance) {
    const scene::GBuffer view = scene::rasterize(context.lab.device(), context.passes,
                                                 moved_scene("corner", distance), picture_extent);
    effect.begin(view, effect::with_radius(effect::preset_named("tssao-paper").settings, 1.0F));
    (void)effect.next();
    const effect::Frame frame = effect.next();
    std::vector<check::Word> words;
    for (const float depth : view.depth) check::append_words(depth, words);
    for (const glm::vec3& normal : view.normal) check::append_words(normal, words);
    for (const float occlusion : frame.filtered) check::append_words(occlusion, words);
    return words;
}

Row whole_picture(const Context& context) {
    effect::AmbientOcclusion effect(context.lab.device(), context.passes, picture_extent);
    // Moved a little as well: what does not move at all may take another way through the rasteriser.
    const std::vector<check::Word> expected = picture(context, effect, 2.0);
    std::size_t changed = 0;
    for (const double distance : distances(1e3, 1))
        changed += differing(picture(context, effect, distance), expected);
    return {far_away_name, "scene \"corner\", 1e3 to 1e8", "words of depth, normal and occlusion changed",
            static_cast<double>(changed), 0.0};
}

// The first distance at which an error exceeds a limit; infinity where none does.
struct Break {
    const char* form;
    const char* limit_text;
    double limit;
    double distance = std::numeric_limits<double>::infinity();

    void meet(double at, double error) {
        if (!(error <= limit)) distance = std::min(distance, at);
    }
};

void append_world(const Context& context, const MovedPoints& origin, Rows& rows) {
    const WorldForm form(context.lab);
    std::vector<Break> breaks{{"static", "off by 0.1 pixel from", 0.1},
                              {"static", "off by 1 pixel from", 1.0},
                              {"moving", "off by 0.1 pixel from", 0.1},
                              {"moving", "off by 1 pixel from", 1.0}};
    Break depth{"static", "rejected by TSSAO-8 (0.01) from", disocclusion_epsilon};
    double static_part = 0.0;
    double moving_part = 0.0;
    const int steps = context.extent == Extent::full ? 20 : 2;
    for (const double distance : distances(1.0, steps)) {
        context.progress(fmt::format("{}: world coordinates at {:.3g}", far_away_name, distance));
        const MovedPoints far = moved(origin, distance);
        const ReprojectionErrors still = form.still(far);
        const ReprojectionErrors moving = form.moving(far);
        for (std::size_t i = 0; i < breaks.size(); ++i)
            breaks[i].meet(distance, i < 2 ? still.pixels : moving.pixels);
        depth.meet(distance, still.relative_depth);
        const double positions = distance + farthest_point_of_scene;
        static_part = std::max(static_part, still.clip / positions);
        moving_part = std::max(moving_part, moving.clip / positions);
        const double decade = std::log10(distance);
        if (decade > 2.5 && std::abs(decade - std::round(decade)) < 1e-9) {
            const std::string varied = fmt::format("world coordinates at {:.0e}", distance);
            rows.push_back({far_away_name, varied, "static points off, pixels", still.pixels});
            rows.push_back({far_away_name, varied, "points of an object off, pixels", moving.pixels});
            rows.push_back({far_away_name, varied, "previous depth off, relative", still.relative_depth});
        }
    }
    for (const Break& b : breaks)
        rows.push_back(
            {far_away_name, fmt::format("world coordinates, {} points", b.form), b.limit_text, b.distance});
    rows.push_back({far_away_name, "world coordinates, static points", depth.limit_text, depth.distance});
    rows.push_back({far_away_name, "world coordinates, static points", "clip-space error over the distance",
                    static_part, static_clip_error});
    rows.push_back({far_away_name, "world coordinates, moving points", "clip-space error over the distance",
                    moving_part, moving_clip_error});
}

}  // namespace

Rows far_away(const Context& context) {
    const std::size_t points = context.extent == Extent::full ? 4096 : 512;
    const MovedPoints origin = points_at_origin(points, context.seed);
    Rows rows;
    append_centered(context, origin, rows);
    rows.push_back(whole_picture(context));
    append_world(context, origin, rows);
    return rows;
}

}  // namespace gloam::stress
