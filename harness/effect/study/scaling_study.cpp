// SPDX-License-Identifier: MIT
#include "effect/study/scaling_study.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/work.hpp"
#include "effect/methods.hpp"
#include "effect/study/configuration_study.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

constexpr std::uint32_t usual_samples = 16;

// One timed configuration: a value of the quantity that grows.
struct Case {
    double value = 0.0;
    scene::Scene scene;
    gpu::Extent extent;
    Settings settings;     // for the scene's radius
    bool history = false;  // the second frame of a moving view; otherwise a single frame
};

struct Sweep {
    std::string of;
    std::vector<Case> cases;
    bool counts_open = false;
};

double pixels_of(gpu::Extent extent) {
    return static_cast<double>(extent.width) * static_cast<double>(extent.height);
}

// The scene with `count` objects: copies of its objects, each slightly displaced.
scene::Scene with_objects(const scene::Scene& base, std::size_t count) {
    scene::Scene scene = base;
    scene.objects.clear();
    for (std::size_t i = 0; i < count; ++i) {
        scene::MovingObject object = base.objects[i % base.objects.size()];
        const double aside = 0.15 * static_cast<double>(i / base.objects.size());
        object.transform = [inner = object.transform, aside](int frame) {
            glm::dmat4 transform = inner(frame);
            transform[3][0] += aside;
            transform[3][2] -= aside;
            return transform;
        };
        scene.objects.push_back(std::move(object));
    }
    return scene;
}

// Builds the sweeps of a method.
class Sweeps {
  public:
    explicit Sweeps(const ScalingOptions& options)
        : options_(options), scene_(scene::make_scene("moving")), base_(options.sizes.front()) {}

    [[nodiscard]] std::vector<Sweep> all() const {
        std::vector<Sweep> sweeps{pixels(false)};
        if (method_named(options_.method).open_proof != OpenProof::none) sweeps.push_back(pixels(true));
        for (Sweep& sweep : std::vector{samples(), radius(), filter_width(), objects()})
            sweeps.push_back(std::move(sweep));
        return sweeps;
    }

  private:
    [[nodiscard]] Settings settings(std::uint32_t samples, double radius) const {
        return with_radius(measured_settings(options_.method, samples, false), static_cast<float>(radius));
    }

    [[nodiscard]] Case usual(double value, const Settings& settings) const {
        return {.value = value, .scene = scene_, .extent = base_, .settings = settings};
    }

    [[nodiscard]] Sweep pixels(bool skip_open) const {
        Sweep sweep{.of = skip_open ? "pixels, open tiles skipped" : "pixels", .counts_open = true};
        for (const gpu::Extent size : options_.sizes) {
            const double radius = scene_.ao_radius * base_.height / size.height;
            sweep.cases.push_back(usual(pixels_of(size), settings(usual_samples, radius)));
            sweep.cases.back().extent = size;
            sweep.cases.back().settings.skip_open = skip_open;
        }
        return sweep;
    }

    [[nodiscard]] Sweep samples() const {
        Sweep sweep{.of = "samples"};
        for (const std::uint32_t count : {4U, 8U, 16U, 32U, 64U, 128U})
            sweep.cases.push_back(usual(count, settings(count, scene_.ao_radius)));
        return sweep;
    }

    [[nodiscard]] Sweep radius() const {
        Sweep sweep{.of = "radius in pixels"};
        const scene::Camera& camera = scene_.camera;
        const double pixels_per_unit =
            0.5 * base_.height / std::tan(0.5 * camera.fovy_rad) / glm::length(camera.target - camera.eye);
        for (const double factor : {0.25, 0.5, 1.0, 2.5, 5.0}) {
            const double radius = factor * scene_.ao_radius;
            sweep.cases.push_back(usual(radius * pixels_per_unit, settings(usual_samples, radius)));
        }
        return sweep;
    }

    [[nodiscard]] Sweep filter_width() const {
        Sweep sweep{.of = "filter half width"};
        for (const int half_width : {1, 2, 3, 4, 6, 8}) {
            Settings wide = settings(usual_samples, scene_.ao_radius);
            wide.filter_half_width = half_width;
            sweep.cases.push_back(usual(half_width, wide));
        }
        return sweep;
    }

    [[nodiscard]] Sweep objects() const {
        Sweep sweep{.of = "moving objects"};
        for (const std::size_t count :
             {std::size_t{1}, std::size_t{2}, std::size_t{4}, std::size_t{8}, std::size_t{16}}) {
            sweep.cases.push_back(
                usual(static_cast<double>(count), settings(usual_samples, scene_.ao_radius)));
            sweep.cases.back().scene = with_objects(scene_, count);
            sweep.cases.back().history = true;
        }
        return sweep;
    }

    const ScalingOptions& options_;
    scene::Scene scene_;
    gpu::Extent base_;
};

// The views of a case, rendered once.
struct Views {
    scene::GBuffer first;
    std::optional<scene::GBuffer> second;
};

// The time of a frame of a case, and the share of its tiles that were found open.
struct Timing {
    double ms = 0.0;
    double open = 0.0;
};

class Timer {
  public:
    Timer(const gpu::Device& device, const scene::PassLibrary& passes) : device_(&device), passes_(passes) {}

    [[nodiscard]] Views views_of(const Case& what) const {
        Views views{.first = draw(what, 0)};
        if (what.history) views.second = draw(what, 1);
        return views;
    }

    // One effect at a time, because the largest takes a gigabyte.
    [[nodiscard]] Timing time(const Case& what, const Views& views) {
        if (!effect_ || extent_ != what.extent) {
            effect_.reset();
            effect_.emplace(*device_, passes_, what.extent);
            extent_ = what.extent;
            (void)run(what, views);  // drivers compile at the first dispatch
        }
        return run(what, views);
    }

  private:
    [[nodiscard]] scene::GBuffer draw(const Case& what, int frame) const {
        return scene::rasterize(*device_, passes_, what.scene, what.extent,
                                {.frame = frame, .motion = what.history});
    }

    Timing run(const Case& what, const Views& views) {
        effect_->begin(views.first, what.settings);
        Frame frame = effect_->next();
        if (views.second) {
            effect_->advance(*views.second);
            frame = effect_->next();
        }
        return {total_ms(frame),
                static_cast<double>(frame.work.tiles_open) / static_cast<double>(frame.work.tiles)};
    }

    const gpu::Device* device_;
    scene::PassLibrary passes_;
    std::optional<AmbientOcclusion> effect_;
    gpu::Extent extent_;
};

ScalingRun run_of(Timer& timer, const Sweep& sweep, int repeat, const std::function<void()>& visited) {
    std::vector<Views> views;
    for (const Case& what : sweep.cases) views.push_back(timer.views_of(what));
    std::vector<std::vector<double>> times(sweep.cases.size());
    std::vector<double> open(sweep.cases.size());
    for (int round = 0; round <= repeat; ++round) {
        for (std::size_t i = 0; i < sweep.cases.size(); ++i) {
            const Timing timing = timer.time(sweep.cases[i], views[i]);
            open[i] = timing.open;                         // the same in every round
            if (round > 0) times[i].push_back(timing.ms);  // the first warms up
            visited();
        }
    }
    ScalingRun run{.of = sweep.of};
    for (std::size_t i = 0; i < times.size(); ++i)
        run.points.emplace_back(sweep.cases[i].value, median(times[i]));
    if (sweep.counts_open) run.open = std::move(open);
    return run;
}

}  // namespace

std::vector<ScalingRun> study_scaling(const gpu::Device& device, const scene::PassLibrary& passes,
                                      const ScalingOptions& options) {
    require_timestamps(device.info());
    if (options.sizes.empty()) throw std::invalid_argument("no size to measure scaling with: expected one");
    const std::vector<Sweep> sweeps = Sweeps(options).all();
    std::size_t all = 0;
    for (const Sweep& sweep : sweeps)
        all += sweep.cases.size() * (static_cast<std::size_t>(options.repeat) + 1);
    std::size_t done = 0;
    const auto visited = [&] {
        ++done;
        if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(all));
    };
    Timer timer(device, passes);
    std::vector<ScalingRun> runs;
    for (const Sweep& sweep : sweeps) runs.push_back(run_of(timer, sweep, options.repeat, visited));
    return runs;
}

}  // namespace gloam::effect
