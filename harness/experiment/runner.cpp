// SPDX-License-Identifier: MIT
#include "experiment/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/setting_table.hpp"
#include "effect/study/copy_clock.hpp"
#include "effect/study/plain_run.hpp"
#include "experiment/cases.hpp"

namespace gloam::experiment {
namespace {

using effect::BenchmarkViews;
using effect::ConfigurationVisit;

// All that the layers say of one candidate in one case.
struct Subject {
    Kind kind = Kind::effect;
    effect::Settings settings;  // for a radius of 1
    bool sequence = true;
    bool hoisted = true;
    PlainLoop plain;
    effect::HistoryPrecision copied = effect::HistoryPrecision::float32;
};

void apply(effect::Settings& settings, const Layer& layer) {
    for (const auto& [name, value] : layer.set) {
        if (name == "method" || name == "radius")
            throw std::invalid_argument(
                fmt::format("set {}: expected a setting other than method and radius", name));
        effect::set(settings, name, value);
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

// The error of (D) against (G).
ConfigurationVisit depth_truth_of(const BenchmarkViews& views, int round) {
    if (round > 0) return {};
    effect::FrameQuality quality;
    for (int i = views.first_scored(); i < views.frames().frames; ++i) {
        const effect::Errors errors = effect::errors_of(views.scored(i).depth, views.scored(i).geometry);
        quality.geometry += errors.rmse / views.frames().scored;
        quality.bias += errors.bias / views.frames().scored;
    }
    quality.raw_geometry = quality.geometry;
    return {.quality = quality};
}

// One case with its views, and what is measured in it.
struct Visited {
    CaseResult* result;
    std::shared_ptr<BenchmarkViews> views;
    std::vector<std::pair<std::size_t, Subject>> subjects;  // by number of the candidate
};

// All cases at one size.
class SizeRun {
  public:
    SizeRun(const Experiment& experiment, gpu::Extent extent, const Place& place)
        : experiment_(experiment), extent_(extent), place_(place), cache_(place.truth_cache) {}

    [[nodiscard]] SizeResult run() {
        SizeResult result{.extent = extent_};
        for (const Case& one : experiment_.cases)
            result.cases.push_back({one, std::vector<std::optional<Cell>>(experiment_.candidates.size())});
        if (experiment_.interleaved) {
            std::vector<Visited> all;
            for (CaseResult& one : result.cases) all.push_back(visited(one));
            go_through(all, experiment_.name);
        } else {
            for (CaseResult& one : result.cases) {
                std::vector<Visited> alone{visited(one)};
                go_through(alone, label_of(one.shown));
                shared_.clear();
            }
        }
        return result;
    }

  private:
    [[nodiscard]] std::string label_of(const Case& one) const {
        return fmt::format("{}, {} x {}", one.name, extent_.width, extent_.height);
    }

    [[nodiscard]] Visited visited(CaseResult& result) {
        const Case& one = result.shown;
        Visited made{.result = &result};
        bool depth_truth = false;
        for (std::size_t i = 0; i < experiment_.candidates.size(); ++i) {
            const Candidate& candidate = experiment_.candidates[i];
            if (!takes_part(one, candidate)) continue;
            made.subjects.emplace_back(i, subject_of(experiment_, one, candidate, place_));
            depth_truth |= made.subjects.back().second.kind == Kind::depth_truth;
            result.cells[i].emplace();
        }
        made.views = views_of(one, depth_truth);
        return made;
    }

    // Cases that show the same share their views.
    [[nodiscard]] std::shared_ptr<BenchmarkViews> views_of(const Case& one, bool depth_truth) {
        effect::BenchmarkFrames frames = frames_of(experiment_, one, extent_);
        frames.depth_truth = depth_truth;
        const std::string key = fmt::format("{} {} {} {} {} {} {} {} {}", one.scene, one.view, one.motion,
                                            fmt::join(one.shown, "+"), frames.scored, one.still,
                                            one.rough_from.value_or(-1.0), one.empty_until, one.filled_later);
        std::shared_ptr<BenchmarkViews>& views = shared_[key];
        if (!views)
            views =
                std::make_shared<BenchmarkViews>(place_.device, place_.passes, scene_of(one, place_.meshes),
                                                 frames, cache_, place_.progress(label_of(one) + ", truth"));
        return views;
    }

    void go_through(std::vector<Visited>& all, const std::string& what) {
        const auto progress = place_.progress(what);
        for (int round = 0; round <= experiment_.rounds; ++round) {
            for (Visited& one : all) {
                std::vector<std::pair<std::size_t, Subject>>& subjects = one.subjects;
                if (round > 0) std::ranges::reverse(subjects);
                std::optional<effect::Truth> first;
                for (const auto& [number, subject] : subjects) {
                    const ConfigurationVisit found = visit(subject, *one.views, round);
                    Cell& cell = *one.result->cells[number];
                    take(cell, found, round);
                    if (round > 0 || found.shown.empty()) continue;
                    const scene::GBuffer& view = one.views->view(one.views->frames().frames - 1, {});
                    if (!first) first = effect::truth_from(view, found.shown);
                    cell.difference = effect::errors_of(found.shown, *first).rmse;
                }
            }
            progress(static_cast<double>(round + 1) / (experiment_.rounds + 1));
        }
    }

    static void take(Cell& cell, const ConfigurationVisit& found, int round) {
        if (found.quality) cell.quality = found.quality;
        cell.work = found.work;
        if (round > 0) cell.rounds.push_back(found.readings);
    }

    [[nodiscard]] ConfigurationVisit visit(const Subject& subject, BenchmarkViews& views, int round) {
        const auto radius = static_cast<float>(views.scene().ao_radius);
        switch (subject.kind) {
            case Kind::plain:
                return loop_of(subject.plain).visit(views, clock(gpu::Format::r32f), round);
            case Kind::copy: {
                if (round == 0) return {};
                const double copy_ms = clock(gpu::Format::r32f).measure();
                const double ms = clock(effect::format_of(subject.copied)).measure_now();
                return {.readings = {{{{"copy", ms}}, copy_ms}}};
            }
            case Kind::depth_truth:
                return depth_truth_of(views, round);
            default:
                return study_of(subject.hoisted)
                    .visit(views, with_radius(subject.settings, radius), subject.sequence, round);
        }
    }

    effect::ConfigurationStudy& study_of(bool hoisted) {
        std::unique_ptr<effect::ConfigurationStudy>& study = studies_[hoisted];
        if (!study)
            study = std::make_unique<effect::ConfigurationStudy>(
                place_.device,
                hoisted ? place_.passes : place_.passes.with(shader::Optimization::performance), extent_);
        return *study;
    }

    effect::PlainRun& loop_of(const PlainLoop& loop) {
        std::unique_ptr<effect::PlainRun>& made = loops_[{loop.taps.slices, loop.taps.steps, loop.blurs}];
        if (!made)
            made = std::make_unique<effect::PlainRun>(place_.device, place_.passes, extent_, loop.taps,
                                                      loop.blurs);
        return *made;
    }

    effect::CopyClock& clock(gpu::Format format) {
        std::unique_ptr<effect::CopyClock>& made = clocks_[format];
        if (!made) made = std::make_unique<effect::CopyClock>(place_.device, place_.passes, extent_, format);
        return *made;
    }

    const Experiment& experiment_;
    gpu::Extent extent_;
    const Place& place_;
    scene::TruthCache cache_;
    std::map<std::string, std::shared_ptr<BenchmarkViews>> shared_;
    std::map<bool, std::unique_ptr<effect::ConfigurationStudy>> studies_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, int>, std::unique_ptr<effect::PlainRun>> loops_;
    std::map<gpu::Format, std::unique_ptr<effect::CopyClock>> clocks_;
};

}  // namespace

void require_possible(const Experiment& experiment, const Place& place) {
    if (experiment.candidates.empty()) throw std::invalid_argument("nothing to measure: no candidate");
    require_consistent(experiment);
    for (const Case& one : experiment.cases) {
        if (!one.view) (void)scene_of(one, place.meshes);  // a view's meshes are read when it is measured
        const effect::BenchmarkFrames frames = frames_of(experiment, one, {});
        if (frames.scored > frames.frames)
            throw std::invalid_argument(fmt::format("{}: {} scored frames, expected at most {}, the frames",
                                                    one.name, frames.scored, frames.frames));
        for (const Candidate& candidate : experiment.candidates)
            if (takes_part(one, candidate)) (void)subject_of(experiment, one, candidate, place);
    }
}

std::vector<SizeResult> run(const Experiment& experiment, const std::vector<gpu::Extent>& sizes,
                            const Place& place) {
    require_possible(experiment, place);
    if (experiment.rounds > 0) effect::require_timestamps(place.device.info());
    std::vector<SizeResult> results;
    for (const gpu::Extent extent : sizes) results.push_back(SizeRun(experiment, extent, place).run());
    return results;
}

}  // namespace gloam::experiment
