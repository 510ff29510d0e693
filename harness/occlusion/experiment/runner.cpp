// SPDX-License-Identifier: MIT
#include "experiment/runner.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <set>
#include <stdexcept>
#include <utility>

#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/study/closed_form.hpp"
#include "experiment/internal/subject.hpp"

namespace gloam::experiment {
namespace {

// A candidate in a case, and the views in which it is measured: with the truth for its radius, and for the
// scene's own.
struct Measured {
    const Candidate* candidate;
    Subject subject;
    std::shared_ptr<BenchmarkViews> views;
    std::shared_ptr<BenchmarkViews> own;
};

// One case, and what is measured in it.
struct Visited {
    const Case* shown;
    std::vector<Measured> all;
};

// All cases at one size.
class SizeRun {
  public:
    SizeRun(const Experiment& experiment, backend::Extent extent, const Place& place, Record& record)
        : experiment_(experiment), extent_(extent), place_(place), record_(record) {
        for (const Table& table : experiment.tables)
            measures_.insert(table.measures.begin(), table.measures.end());
    }

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
            views_.clear();
        }
    }

  private:
    [[nodiscard]] std::string label_of(const Case& one) const {
        return fmt::format("{}, {} x {}", one.name, extent_.width, extent_.height);
    }

    // With nothing measured yet.
    [[nodiscard]] Visit empty_visit(const Case& one, const Candidate& candidate, int round) const {
        return {.size = extent_,
                .shown = one,
                .candidate = candidate.name,
                .group = candidate.group,
                .round = round};
    }

    // Whether the record lacks the visit. Nothing is timed at a point in closed form.
    [[nodiscard]] bool is_due(const Case& one, const Candidate& candidate, int round) const {
        return (!one.closed_form || round == 0) &&
               record_.find(empty_visit(one, candidate, round)) == nullptr;
    }

    // Nothing is measured in a case of which all is recorded.
    [[nodiscard]] Visited visited(const Case& one) {
        Visited made{.shown = &one};
        bool depth_truth = measures_.contains(Quantity::depth);
        bool missing = false;
        for (const Candidate& candidate : experiment_.candidates) {
            if (!takes_part(one, candidate)) continue;
            made.all.push_back(
                {.candidate = &candidate, .subject = subject_of(experiment_, one, candidate, place_)});
            depth_truth |= made.all.back().subject.kind == Kind::depth_truth;
            for (int round = 0; round <= experiment_.rounds; ++round)
                missing |= is_due(one, candidate, round);
        }
        if (!missing) made.all.clear();
        for (Measured& measured : made.all) {
            if (one.closed_form) continue;
            measured.views = views_of(one, measured.subject.radius, depth_truth);
            measured.own =
                measures_.contains(Quantity::own_radius) ? views_of(one, 1.0, depth_truth) : measured.views;
            Subject& subject = measured.subject;
            if (subject.enough_samples) subject.settings = enough_samples(subject, *measured.views);
        }
        return made;
    }

    // Cases that show the same share their views.
    [[nodiscard]] std::shared_ptr<BenchmarkViews> views_of(const Case& one, double radius, bool depth_truth) {
        BenchmarkFrames frames = frames_of(experiment_, one, extent_);
        frames.truth_cache = place_.truth_cache;
        frames.depth_truth = depth_truth;
        frames.measures = measures_;
        const std::string key =
            fmt::format("{} {} {} {} {} {} {}", one.scene, one.motion ? static_cast<int>(*one.motion) : -1,
                        fmt::join(one.shown, "+"), frames.scored, frames.every, one.still, radius);
        std::shared_ptr<BenchmarkViews>& views = views_[key];
        if (views) return views;
        scene::Scene scene = scene::make_scene(one.scene, place_.meshes);
        scene.ao_radius *= radius;
        views = std::make_shared<BenchmarkViews>(std::move(scene), frames,
                                                 place_.progress(label_of(one) + ", truth"));
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
        double visits = 0.0;
        double done = 0.0;
        for (const Visited& one : all)
            visits += static_cast<double>(one.all.size()) * (experiment_.rounds + 1);
        for (int round = 0; round <= experiment_.rounds; ++round) {
            for (Visited& one : all) {
                if (round > 0) std::ranges::reverse(one.all);
                for (const Measured& measured : one.all) {
                    progress(done++ / visits);
                    if (!is_due(*one.shown, *measured.candidate, round)) continue;
                    Visit made = empty_visit(*one.shown, *measured.candidate, round);
                    measure(made, *one.shown, measured);
                    place_.keep(line_of(made));
                    record_.add(std::move(made));
                }
            }
        }
        progress(1.0);
    }

    void measure(Visit& made, const Case& one, const Measured& measured) {
        if (measured.subject.kind == Kind::effect)
            made.samples_asked = static_cast<int>(measured.subject.settings.samples);
        if (one.closed_form) {
            made.point = point_of(one, measured.subject);
            return;
        }
        ConfigurationVisit found = visit(measured.subject, *measured.views, made.round);
        made.quality = found.quality;
        if (made.round > 0) made.readings = std::move(found.readings);
        if (made.round > 0 || found.shown.filtered.empty()) return;
        show(made, found, measured);
        if (measured.subject.kind == Kind::depth_truth || measured.subject.kind == Kind::truth) return;
        if (made.quality) made.own_radius_error = error_at_own_radius(*made.quality, measured);
    }

    // The pictures that the candidate asks for, and of which there is something to see.
    void show(const Visit& made, const ConfigurationVisit& found, const Measured& measured) const {
        for (const std::string& kind : measured.subject.pictures) {
            Picture picture{.name = fmt::format("{}-{}-{}", made.shown.name, made.candidate, kind),
                            .kind = kind,
                            .extent = measured.views->frames().extent,
                            .values = pictured(kind, found, measured)};
            if (!picture.values.empty()) place_.show(picture);
        }
    }

    [[nodiscard]] static std::vector<float> pictured(const std::string& kind, const ConfigurationVisit& found,
                                                     const Measured& measured) {
        if (kind == "visibility") return found.shown.filtered;
        if (kind == "convergence") return found.shown.convergence;
        if (kind == "converged") return found.converged;
        if (kind == "samples") {
            std::vector<float> parts = found.shown.kept;
            for (float& part : parts) part /= measured.subject.settings.weight_max;
            return parts;
        }
        if (measured.views->frames().rays == 0) return {};
        std::vector<float> errors = measured.views->scored(measured.views->last_scored()).geometry;
        for (std::size_t i = 0; i < errors.size(); ++i)
            errors[i] = std::abs(found.shown.filtered[i] - errors[i]);
        return errors;
    }

    [[nodiscard]] std::optional<PointQuality> point_of(const Case& one, const Subject& subject) {
        const scene::ClosedFormView view = closed_form_of(one);
        if (subject.kind == Kind::truth)
            return PointQuality{.truth = view.occlusion, .occlusion = view.occlusion};
        if (subject.kind != Kind::effect) return std::nullopt;
        const effect::Settings& settings = subject.settings;
        constexpr std::uint32_t pixels = 257;  // of a side of its image
        if (!closed_form_) closed_form_.emplace(place_.device, place_.passes);
        const effect::Estimate measured =
            effect::measured(*closed_form_, scene::draw(view, pixels), settings, experiment_.frames);
        const effect::Remap remap = remap_of(settings);
        return PointQuality{.truth = view.occlusion,
                            .occlusion = measured.value,
                            .standard_error = measured.error,
                            .shown = 1.0 - remap(1.0 - measured.value)};
    }

    // The radius in the world stays that of the candidate; only the truth is another.
    [[nodiscard]] double error_at_own_radius(const FrameQuality& quality, const Measured& measured) {
        if (measured.own == measured.views || measured.subject.kind != Kind::effect) return quality.geometry;
        return visit(measured.subject, *measured.own, 0, measured.views->scene().ao_radius)
            .quality.value()
            .geometry;
    }

    // radius: in the world; that of the views where it is not given.
    [[nodiscard]] ConfigurationVisit visit(const Subject& subject, BenchmarkViews& views, int round,
                                           std::optional<double> radius = {}) {
        switch (subject.kind) {
            case Kind::plain: {
                const auto& [taps, blurs] = subject.plain;
                const auto [loop, is_new] =
                    loops_.try_emplace({taps.slices, taps.steps, static_cast<std::uint32_t>(blurs)},
                                       place_.device, place_.passes, extent_, taps, blurs);
                return plain_visit(loop->second, views, round);
            }
            case Kind::depth_truth:
                return depth_truth_of(views, round);
            case Kind::truth:
                return truth_of(views, round);
            default: {
                const scene::PassLibrary& passes = place_.passes;
                ConfigurationStudy& study =
                    studies_
                        .try_emplace(
                            subject.hoisted, place_.device,
                            subject.hoisted ? passes : passes.with(module::Optimization::performance))
                        .first->second;
                const auto world = static_cast<float>(radius.value_or(views.scene().ao_radius));
                return study.visit(views, with_radius(subject.settings, world), subject.sequence, round);
            }
        }
    }

    const Experiment& experiment_;
    backend::Extent extent_;
    const Place& place_;
    Record& record_;
    // What cases share, by what it is made for.
    std::map<std::string, std::shared_ptr<BenchmarkViews>> views_;
    std::optional<effect::AmbientOcclusion> closed_form_;  // of their images
    std::map<bool, ConfigurationStudy> studies_;           // by Subject::hoisted
    std::map<std::array<std::uint32_t, 3>, effect::PlainSlices> loops_;
    std::set<Quantity> measures_;  // of its tables
};

}  // namespace

void run(const Experiment& experiment, const std::vector<backend::Extent>& sizes, const Place& place,
         Record& record) {
    for (const backend::Extent extent : sizes) {
        if (experiment.rounds > 0) effect::require_timestamps(place.device.info());
        SizeRun(experiment, extent, place, record).run();
    }
}

}  // namespace gloam::experiment
