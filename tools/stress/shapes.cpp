// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "stress/gathers.hpp"
#include "stress/views.hpp"

namespace gloam::stress {
namespace {

constexpr const char* shapes_name = "shapes";
constexpr float shape_radius = 0.4F;
constexpr int frames = 2;

using Size = gpu::Extent;

effect::Settings settings_for(const effect::MethodInfo& method) {
    effect::Settings settings =
        with_radius(with_method(effect::preset_named("tssao-paper").settings, method.name), shape_radius);
    settings.least_radius = 0.0F;
    return settings;
}

std::vector<Size> sizes(const Context& context) {
    const std::uint32_t limit = context.lab.device().info().max_image_size;
    std::vector<Size> all{{1, 1}, {1, 2},  {2, 1},   {5, 7},   {7, 9},     {9, 7},
                          {8, 8}, {8, 16}, {16, 16}, {17, 13}, {limit, 1}, {1, limit}};
    if (context.extent == Extent::full) {
        // One side a power of two and the other none: a pass more for a driver that compiles it for each.
        all.insert(all.end(), {{3, 1}, {1, 3}, {9, 8}, {8, 9}});
        all.insert(all.end(), {{31, 37}, {61, 67}, {127, 131}, {251, 257}, {509, 521}, {1021, 1031}});
        all.insert(all.end(), {{limit - 1, 3}, {3, limit - 1}, {limit, 8}, {8, limit}});
    }
    return all;
}

std::size_t pixels_of(Size size) {
    return std::size_t{size.width} * size.height;
}

// Pixels of one view that are not as they must be: counted, written, in [0, 1]; open where `open`.
std::size_t wrong_pixels(effect::AmbientOcclusion& effect, const scene::GBuffer& view,
                         const effect::Settings& settings, bool open) {
    effect.begin(view, settings);
    effect::Frame frame = effect.next();
    for (int i = 1; i < frames; ++i) frame = effect.next();
    std::size_t wrong = 0;
    for (const auto& image : {frame.occlusion, frame.filtered}) {
        wrong += outside_unit(image);
        if (open)
            wrong +=
                static_cast<std::size_t>(std::ranges::count_if(image, [](float v) { return v != 0.0F; }));
    }
    // Only a pixel that was written in each frame has this convergence. A sample may be lost at most, but
    // where taps that share a pixel count once. Slices of the cosine count by their weight, which is nearly 0
    // in a view so wide that it sees everything edge-on.
    constexpr float most_weight = 1.571F;  // pi / 2, rounded up
    const effect::MethodInfo& method = effect::method_named(settings.method);
    const bool weighs = method.unit == effect::SampleUnit::slice && method.measure == effect::Measure::cosine;
    const float counted = static_cast<float>(settings.samples) * frames / settings.weight_max;
    const float expected = weighs ? most_weight * counted : counted;
    const bool edge_on = weighs && view.extent.width > 1'000 * view.extent.height;
    const float least = method.takes_fewer || edge_on ? 0.0F : 0.5F * counted;
    wrong += static_cast<std::size_t>(
        std::ranges::count_if(frame.convergence, [&](float v) { return !(v > least && v <= expected); }));
    const std::size_t pixels = pixels_of(view.extent);
    return wrong + (frame.work.pixels == pixels ? 0 : 1) + (frame.occlusion.size() == pixels ? 0 : 1);
}

// How many of the attempts were not refused.
template <class Attempt>
double not_refused(const std::vector<Attempt>& attempts) {
    double accepted = 0;
    for (const Attempt& attempt : attempts) {
        try {
            attempt();
            accepted += 1;
        } catch (const std::invalid_argument&) {
        } catch (const std::runtime_error&) {
        }
    }
    return accepted;
}

void append_refusals(const Context& context, Rows& rows) {
    using Attempt = std::function<void()>;
    const gpu::Device& device = context.lab.device();
    const std::uint32_t beyond = device.info().max_image_size + 1;
    std::vector<Attempt> attempts;
    for (const Size size :
         {Size{0, 0}, Size{0, 1}, Size{1, 0}, Size{beyond, 1}, Size{1, beyond}, Size{~0U, ~0U}})
        attempts.emplace_back([&, size] { effect::AmbientOcclusion(device, context.passes, size); });
    rows.push_back({shapes_name, "sizes 0 and beyond the limit", "not refused", not_refused(attempts), 0.0});

    const auto with = [](const std::function<void(effect::Settings&)>& change) -> Attempt {
        return [change] {
            effect::Settings settings;
            change(settings);
            effect::validate(settings);
        };
    };
    attempts.clear();
    using Limits = std::numeric_limits<float>;
    for (const float bad : {0.0F, -0.0F, -1.0F, Limits::denorm_min(), Limits::max(), Limits::infinity(),
                            -Limits::infinity(), Limits::quiet_NaN()}) {
        attempts.push_back(with([bad](effect::Settings& s) { s.radius = bad; }));
        attempts.push_back(with([bad](effect::Settings& s) { s.own.range = bad; }));
        attempts.push_back(with([bad](effect::Settings& s) { s.own.epsilon = bad; }));
        attempts.push_back(with([bad](effect::Settings& s) { s.weight_max = bad; }));
    }
    for (const std::uint32_t bad : {0U, effect::most_samples + 1, ~0U})
        attempts.push_back(with([bad](effect::Settings& s) { s.samples = bad; }));
    for (const std::uint32_t bad : {0U, (1U << 24U) + 1, ~0U})
        attempts.push_back(with([bad](effect::Settings& s) { s.table_size = bad; }));
    rows.push_back({shapes_name, "radius, range, epsilon, w_max, samples, table beyond their ranges",
                    "not refused", not_refused(attempts), 0.0});
}

// Radii at the ends of what is accepted: nothing is promised of the occlusion but its range.
void append_radii(const Context& context, effect::AmbientOcclusion& effect, Rows& rows) {
    constexpr Size size{17, 13};
    effect.advance(plane(size));
    for (const float r : {2e-18F, 1e-6F, 3.0F, 1e6F, 1e18F}) {
        std::size_t wrong = 0;
        for (const effect::MethodInfo& method : methods_of(context)) {
            effect::Settings settings = settings_for(method);
            settings.radius = r;
            effect.begin(steps(size), settings);
            const effect::Frame frame = effect.next();
            wrong += outside_unit(frame.occlusion) + outside_unit(frame.filtered);
        }
        rows.push_back({shapes_name, fmt::format("radius {:g}", r), "values outside [0, 1] or NaN",
                        static_cast<double>(wrong), 0.0});
    }
}

// A plane loses no sample: each of them must be counted.
void append_counts(const Context& context, effect::AmbientOcclusion& effect, Rows& rows) {
    constexpr Size size{3, 5};
    effect.advance(plane(size));
    // tests/glsl/method_gathers_test.cpp has more counts of each method, without a pass to compile for each.
    std::vector<std::uint32_t> counts{1, 33, effect::most_samples};
    if (context.extent == Extent::full) counts.insert(counts.end(), {2, 31, 1024});
    for (const std::uint32_t samples : counts) {
        double missing = 0.0;
        for (const effect::MethodInfo& method : methods_of(context)) {
            if (method.takes_fewer) continue;  // of a few pixels all samples share some
            effect::Settings settings = settings_for(method);
            settings.samples = samples;
            settings.own.steps = 1;
            settings.weight_max = 8'388'608.0F;
            effect.begin(plane(size), settings);
            const auto expected = static_cast<double>(pixels_of(size)) *
                                  effect::samples_taken(method, samples, settings.own.steps);
            missing = std::max(missing, std::abs(expected - static_cast<double>(effect.next().work.samples)));
        }
        rows.push_back(
            {shapes_name, fmt::format("{} samples a pixel", samples), "samples missing", missing, 0.0});
    }
}

// The most samples of a frame where their Halton points take the most digits.
Row highest_points(const Gather& gather, const effect::MethodInfo& method) {
    constexpr glm::ivec2 size{3, 1};
    const auto preparation = gather_preparation(method, size, 1);
    const GatherCamera camera{{1.0F, -1.0F}, size, false};
    const GatherKernel kernel{0.4F, 0.001F, 0.0F, (1U << 24U) - effect::most_samples - 1,
                              effect::most_samples};
    const check::Image wall = check::make_image<float>(size, [](glm::ivec2) { return 3.0F; });
    const glm::vec2 sum =
        gather.with_images(gather_images(wall, preparation, 0.0F),
                           {glm::vec3(0, 0, -3), glm::vec3(0, 0, 1), camera, kernel, method_of_length(1.0F)});
    return {shapes_name, fmt::format("method {}, {} points up to 2^24", method.name, effect::most_samples),
            "samples missing", effect::samples_taken(method, effect::most_samples, 1) - double{sum.y}, 0.0};
}

void append_highest_points(const Context& context, Rows& rows) {
    for (const effect::MethodInfo& method : methods_of(context)) {
        if (method.takes_fewer) continue;
        rows.push_back(
            highest_points(Gather(context.lab, gather_file(method), effect::method_function), method));
    }
}

Row row_of(const Context& context, effect::AmbientOcclusion& effect, Size size) {
    context.progress(fmt::format("{}: {} x {}", shapes_name, size.width, size.height));
    const bool once = context.extent == Extent::brief && pixels_of(size) > 1000;
    effect.advance(plane(size));
    std::size_t wrong = 0;
    for (const effect::MethodInfo& method : methods_of(context)) {
        for (const bool normals : {true, false}) {
            scene::GBuffer flat = plane(size);
            scene::GBuffer stepped = steps(size);
            if (!normals) flat.normal.clear(), stepped.normal.clear();
            wrong += wrong_pixels(effect, flat, settings_for(method), true);
            if (once) break;
            wrong += wrong_pixels(effect, stepped, settings_for(method), false);
        }
    }
    context.lab.require_silent_validation();
    return {shapes_name, fmt::format("{} x {} pixels", size.width, size.height), "pixels wrong",
            static_cast<double>(wrong), 0.0};
}

}  // namespace

effect::AmbientOcclusion shapes_effect(const Context& context) {
    constexpr Size size{1, 1};
    effect::AmbientOcclusion effect(context.lab.device(), context.passes, size);
    effect.begin(plane(size), settings_for(methods_of(context).front()));
    return effect;
}

Row one_size(const Context& context, Size size) {
    effect::AmbientOcclusion effect = shapes_effect(context);
    return row_of(context, effect, size);
}

Rows shapes(const Context& context) {
    effect::AmbientOcclusion effect = shapes_effect(context);
    return shapes(context, effect);
}

Rows shapes(const Context& context, effect::AmbientOcclusion& effect) {
    Rows rows;
    for (const Size size : sizes(context)) rows.push_back(row_of(context, effect, size));
    append_refusals(context, rows);
    append_radii(context, effect, rows);
    append_counts(context, effect, rows);
    append_highest_points(context, rows);
    return rows;
}

}  // namespace gloam::stress
