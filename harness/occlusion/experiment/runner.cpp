// SPDX-License-Identifier: MIT
#include "experiment/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <ranges>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <variant>

#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "effect/study/copy_clock.hpp"

namespace gloam::experiment {
namespace {

// All that the layers say of one candidate in one case.
struct Subject {
    Kind kind = Kind::effect;
    effect::Settings settings;  // for a radius of 1
    bool sequence = true;
    bool hoisted = true;
    double radius = 1.0;  // in units of the scene's
    bool enough_samples = false;
    PlainLoop plain;
    effect::HistoryPrecision copied = effect::HistoryPrecision::float32;
};

// The text of a value, where "x2" means twice the number that the setting has.
std::string value_text(const effect::Settings& settings, const std::string& name, const std::string& text) {
    if (!text.starts_with('x')) return text;
    const auto value = effect::setting_named(name).get(settings);
    double factor = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 1, end, factor);
    if (!std::holds_alternative<double>(value) || error != std::errc{} || stop != end) return text;
    return effect::text_of(factor * std::get<double>(value));
}

void apply(effect::Settings& settings, const Layer& layer) {
    for (const auto& [name, value] : layer.set) {
        if (name == "method" || name == "radius")
            throw std::invalid_argument(
                fmt::format("set {}: expected a setting other than method and radius", name));
        effect::set(settings, name, value_text(settings, name, value));
    }
}

Subject subject_of(const std::vector<const Layer*>& layers, const Place& place) {
    Subject subject;
    std::string preset;
    std::string method;
    for (const Layer* layer : layers) {
        if (!layer->preset.empty()) preset = layer->preset;
        if (!layer->method.empty()) method = layer->method;
        subject.sequence = layer->sequence.value_or(subject.sequence);
        subject.hoisted = layer->hoisted.value_or(subject.hoisted);
        subject.radius = layer->radius.value_or(subject.radius);
        subject.enough_samples |= layer->enough_samples;
        if (!layer->kind) continue;
        subject.kind = *layer->kind;
        subject.plain = layer->plain;
        subject.copied = layer->copied;
    }
    if (!preset.empty()) subject.settings = place.preset_of(preset);
    if (!method.empty() && method != subject.settings.method)
        subject.settings = with_method(subject.settings, method);
    for (const Layer* layer : layers) apply(subject.settings, *layer);
    validate(subject.settings);
    return subject;
}

bool takes_part(const Case& one, const Candidate& candidate) {
    return one.candidates.empty() || std::ranges::count(one.candidates, candidate.name) > 0;
}

Subject subject_of(const Experiment& experiment, const Case& one, const Candidate& candidate,
                   const Place& place) {
    try {
        return subject_of({&experiment.layer, &one.layer, &candidate.layer}, place);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{}, {}: {}", one.name, candidate.name, error.what()));
    }
}

void require_possible(const Experiment& experiment, const Case& one, const Candidate& candidate,
                      const Place& place) {
    const Subject subject = subject_of(experiment, one, candidate, place);
    const bool judged = frames_of(experiment, one, {}).rays > 0 && subject.kind == Kind::effect;
    if (subject.enough_samples && !judged)
        throw std::invalid_argument(
            fmt::format("{}, {}: enough_samples: expected rays and the effect", one.name, candidate.name));
}

// The error of (D) against (G).
ConfigurationVisit depth_truth_of(const BenchmarkViews& views, int round) {
    if (round > 0) return {};
    FrameQuality quality;
    for (int i = views.first_scored(); i < views.frames().frames; ++i) {
        const effect::Errors errors = effect::errors_of(views.scored(i).depth, views.scored(i).geometry);
        quality.geometry += errors.rmse / views.frames().scored;
        quality.bias += errors.bias / views.frames().scored;
    }
    quality.raw_geometry = quality.geometry;
    return {.quality = quality};
}

// A candidate in a case, and the views in which it is measured: with the truth for its radius, and for the
// scene's own.
struct Measured {
    std::size_t number;  // of the candidate
    Subject subject;
    std::shared_ptr<BenchmarkViews> views;
    std::shared_ptr<BenchmarkViews> own;
};

// One case, and what is measured in it.
struct Visited {
    const Case* shown;
    bool again = false;  // the first round has no complete record: it is visited as a whole
    std::vector<Measured> all;
};

// All cases at one size.
class SizeRun {
  public:
    SizeRun(const Experiment& experiment, gpu::Extent extent, const Place& place, Record& record)
        : experiment_(experiment),
          extent_(extent),
          place_(place),
          record_(record),
          cache_(place.truth_cache) {}

    void run() {
        if (experiment_.interleaved) {
            std::vector<Visited> all;
            for (const Case& one : experiment_.cases) all.push_back(visited(one));
            go_through(all, experiment_.name);
            return;
        }
        for (const Case& one : experiment_.cases) {
            std::vector<Visited> alone{visited(one)};
            go_through(alone, label_of(one));
            shared_.clear();
        }
    }

  private:
    [[nodiscard]] std::string label_of(const Case& one) const {
        const gpu::Extent extent = frames_of(experiment_, one, extent_).extent;
        return fmt::format("{}, {} x {}", one.name, extent.width, extent.height);
    }

    // What tables say of the case, and nothing measured yet.
    [[nodiscard]] Visit empty_visit(const Case& one, const Candidate& candidate, int round) const {
        return {.size = extent_,
                .shown = {.name = one.name,
                          .what = one.what,
                          .kind = one.kind,
                          .half = one.half,
                          .value = one.value,
                          .target = one.target},
                .candidate = candidate.name,
                .group = candidate.group,
                .round = round};
    }

    [[nodiscard]] bool is_due(const Case& one, const Measured& measured, int round) const {
        const BenchmarkFrames frames = frames_of(experiment_, one, extent_);
        return !experiment_.equal_readings || !measured.subject.sequence || round % frames.scored == 0;
    }

    [[nodiscard]] bool is_recorded(const Case& one, const Measured& measured, int round) const {
        return record_.find(empty_visit(one, experiment_.candidates[measured.number], round)) != nullptr;
    }

    // Nothing is measured in a case of which all is recorded.
    [[nodiscard]] Visited visited(const Case& one) {
        Visited made{.shown = &one};
        bool depth_truth = shows(experiment_, "rmse_depth") || shows(experiment_, "rmse_depth_raw");
        bool missing = false;
        for (std::size_t i = 0; i < experiment_.candidates.size(); ++i) {
            const Candidate& candidate = experiment_.candidates[i];
            if (!takes_part(one, candidate)) continue;
            made.all.push_back({.number = i, .subject = subject_of(experiment_, one, candidate, place_)});
            const Measured& measured = made.all.back();
            depth_truth |= measured.subject.kind == Kind::depth_truth;
            for (int round = 0; round <= experiment_.rounds; ++round)
                missing |= is_due(one, measured, round) && !is_recorded(one, measured, round);
            made.again |= shows(experiment_, "difference") && !is_recorded(one, measured, 0);
        }
        if (!missing) made.all.clear();
        for (Measured& measured : made.all) {
            measured.views = views_of(one, measured.subject.radius, depth_truth);
            measured.own = own_radius_ ? views_of(one, 1.0, depth_truth) : measured.views;
            Subject& subject = measured.subject;
            if (subject.enough_samples) subject.settings = enough_samples(subject, *measured.views);
        }
        return made;
    }

    // Cases that show the same share their views.
    [[nodiscard]] std::shared_ptr<BenchmarkViews> views_of(const Case& one, double radius, bool depth_truth) {
        BenchmarkFrames frames = frames_of(experiment_, one, extent_);
        frames.depth_truth = depth_truth;
        frames.remap = remap_;
        const std::string key =
            fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", one.scene, one.view, one.motion,
                        fmt::join(one.shown, "+"), frames.scored, one.still, one.rough_from.value_or(-1.0),
                        one.empty_until, one.filled_later, one.scale, one.objects, radius);
        std::shared_ptr<BenchmarkViews>& views = shared_[key];
        if (views) return views;
        scene::Scene scene = scene_of(one, place_.meshes);
        scene.ao_radius *= radius;
        views = std::make_shared<BenchmarkViews>(place_.device, place_.passes, std::move(scene), frames,
                                                 cache_, place_.progress(label_of(one) + ", truth"));
        return views;
    }

    // The settings with the fewest samples whose error more samples do not lower by a hundredth. The samples
    // are doubled from one unit of the method on.
    [[nodiscard]] effect::Settings enough_samples(const Subject& subject, BenchmarkViews& views) {
        constexpr double least_gain = 0.01;
        Subject tried = subject;
        effect::Settings& settings = tried.settings;
        std::vector<std::pair<std::uint32_t, double>> errors;
        for (std::uint32_t samples = unit_of(effect::method_named(settings.method), settings.own.steps);
             samples <= effect::most_samples; samples *= 2) {
            settings.samples = settings.samples_converged = samples;
            errors.emplace_back(samples, visit(tried, views, 0).quality.value().raw_geometry);
        }
        double best = errors.back().second;
        for (const auto& [samples, error] : errors | std::views::reverse) {
            best = std::min(best, error);
            if (error > best / (1.0 - least_gain)) break;
            settings.samples = settings.samples_converged = samples;
        }
        return settings;
    }

    void go_through(std::vector<Visited>& all, const std::string& what) {
        const auto progress = place_.progress(what);
        for (int round = 0; round <= experiment_.rounds; ++round) {
            for (Visited& one : all) {
                if (round > 0) std::ranges::reverse(one.all);
                std::optional<effect::Truth> first;
                for (const Measured& measured : one.all) {
                    if (!is_due(*one.shown, measured, round)) continue;
                    if (is_recorded(*one.shown, measured, round) && (round > 0 || !one.again)) continue;
                    Visit made = empty_visit(*one.shown, experiment_.candidates[measured.number], round);
                    measure(made, measured, first);
                    if (place_.keep) place_.keep(line_of(made));
                    record_.add(std::move(made));
                }
            }
            progress(static_cast<double>(round + 1) / (experiment_.rounds + 1));
        }
    }

    // first: the first candidate's image of the case, once it is known.
    void measure(Visit& made, const Measured& measured, std::optional<effect::Truth>& first) {
        ConfigurationVisit found = visit(measured.subject, *measured.views, made.round);
        made.quality = found.quality;
        if (made.round > 0 || experiment_.equal_readings) made.readings = std::move(found.readings);
        made.work = found.work;
        made.samples_asked = static_cast<int>(measured.subject.settings.samples);
        if (made.round > 0 || found.shown.empty()) return;
        if (made.quality) made.own_radius_error = error_at_own_radius(*made.quality, measured);
        const scene::GBuffer& view = measured.views->view(measured.views->frames().frames - 1, {});
        if (!first) first = effect::truth_from(view, found.shown);
        made.difference = effect::errors_of(found.shown, *first).rmse;
    }

    // The radius in the world stays that of the candidate; only the truth is another.
    [[nodiscard]] double error_at_own_radius(const FrameQuality& quality, const Measured& measured) {
        if (measured.own == measured.views || measured.subject.kind != Kind::effect) return quality.geometry;
        const auto radius = static_cast<float>(measured.views->scene().ao_radius);
        return visit(measured.subject, *measured.own, 0, radius).quality.value().geometry;
    }

    [[nodiscard]] ConfigurationVisit visit(const Subject& subject, BenchmarkViews& views, int round) {
        return visit(subject, views, round, static_cast<float>(views.scene().ao_radius));
    }

    [[nodiscard]] ConfigurationVisit visit(const Subject& subject, BenchmarkViews& views, int round,
                                           float radius) {
        const gpu::Extent extent = views.frames().extent;
        switch (subject.kind) {
            case Kind::plain:
                return loop_of(extent, subject.plain).visit(views, clock(extent, gpu::Format::r32f), round);
            case Kind::copy: {
                if (round == 0) return {};
                const double copy_ms = clock(extent, gpu::Format::r32f).measure();
                const double ms = clock(extent, effect::format_of(subject.copied)).measure_now();
                return {.readings = {{{{"copy", ms}}, copy_ms}}};
            }
            case Kind::depth_truth:
                return depth_truth_of(views, round);
            default:
                return study_of(extent, subject.hoisted)
                    .visit(views, with_radius(subject.settings, radius), subject.sequence, round);
        }
    }

    ConfigurationStudy& study_of(gpu::Extent extent, bool hoisted) {
        std::unique_ptr<ConfigurationStudy>& study = studies_[{extent.width, extent.height, hoisted}];
        if (!study)
            study = std::make_unique<ConfigurationStudy>(
                place_.device,
                hoisted ? place_.passes : place_.passes.with(shader::Optimization::performance), extent);
        return *study;
    }

    PlainRun& loop_of(gpu::Extent extent, const PlainLoop& loop) {
        std::unique_ptr<PlainRun>& made =
            loops_[{extent.width, extent.height, loop.taps.slices, loop.taps.steps, loop.blurs}];
        if (!made)
            made = std::make_unique<PlainRun>(place_.device, place_.passes, extent, loop.taps, loop.blurs);
        return *made;
    }

    effect::CopyClock& clock(gpu::Extent extent, gpu::Format format) {
        std::unique_ptr<effect::CopyClock>& made = clocks_[{extent.width, extent.height, format}];
        if (!made) made = std::make_unique<effect::CopyClock>(place_.device, place_.passes, extent, format);
        return *made;
    }

    const Experiment& experiment_;
    gpu::Extent extent_;
    const Place& place_;
    Record& record_;
    scene::TruthCache cache_;
    std::map<std::string, std::shared_ptr<BenchmarkViews>> shared_;
    bool remap_ = shows(experiment_, "rmse_remapped");
    bool own_radius_ = shows(experiment_, "rmse_own_radius");
    // By width and height of the images, and by what they are made for.
    using Side = std::uint32_t;
    std::map<std::tuple<Side, Side, bool>, std::unique_ptr<ConfigurationStudy>> studies_;
    std::map<std::tuple<Side, Side, std::uint32_t, std::uint32_t, int>, std::unique_ptr<PlainRun>> loops_;
    std::map<std::tuple<Side, Side, gpu::Format>, std::unique_ptr<effect::CopyClock>> clocks_;
};

}  // namespace

bool shows(const Experiment& experiment, std::string_view quantity) {
    return std::ranges::any_of(experiment.tables, [&](const Table& table) {
        return std::ranges::count(table.columns, quantity, &Column::value) > 0;
    });
}

void require_possible(const Experiment& experiment, const Place& place) {
    if (experiment.candidates.empty()) throw std::invalid_argument("nothing to measure: no candidate");
    require_consistent(experiment);
    for (const Case& one : experiment.cases) {
        if (!one.view) (void)scene_of(one, place.meshes);  // a view's meshes are read when it is measured
        const BenchmarkFrames frames = frames_of(experiment, one, {});
        if (frames.scored > frames.frames)
            throw std::invalid_argument(fmt::format("{}: {} scored frames, expected at most {}, the frames",
                                                    one.name, frames.scored, frames.frames));
        for (const Candidate& candidate : experiment.candidates)
            if (takes_part(one, candidate)) require_possible(experiment, one, candidate, place);
    }
}

void run(const Experiment& experiment, const std::vector<gpu::Extent>& sizes, const Place& place,
         Record& record) {
    require_possible(experiment, place);
    if (experiment.rounds > 0) effect::require_timestamps(place.device.info());
    for (const gpu::Extent extent : sizes) SizeRun(experiment, extent, place, record).run();
}

}  // namespace gloam::experiment
