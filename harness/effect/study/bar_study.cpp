// SPDX-License-Identifier: MIT
#include "effect/study/bar_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "effect/internal/work.hpp"

namespace gloam::effect {
namespace {

// The run and the two kinds of single frames.
class Bars {
  public:
    Bars(const gpu::Device& device, const scene::PassLibrary& passes, BenchmarkViews& views,
         const BarSettings& settings)
        : views_(&views),
          settings_(settings),
          run_(device, passes, views.view(0, settings.temporal).extent),
          exact_(device, passes, views.frames().extent, settings.exact),
          fast_(device, passes, views.frames().extent, settings.fast) {
        start();
        for (int i = 1; i < std::min(3, views.frames().frames); ++i) (void)advanced(i);
        (void)single(exact_, 0);
        (void)single(fast_, 0);
    }

    // Runs through all frames once.
    void go_through(bool judged) {
        start();
        for (int i = 1; i < views_->first_scored(); ++i) (void)advanced(i);
        for (int i = std::max(1, views_->first_scored()); i < views_->frames().frames; ++i) scored(i, judged);
    }

    [[nodiscard]] Bar found() const {
        const double frames = counted_;
        Bar mean = sum_;
        for (BarError* error : {&mean.temporal, &mean.exact, &mean.fast}) {
            error->raw /= frames;
            error->shown /= frames;
        }
        if (mean.flicker) *mean.flicker /= frames;
        return mean;
    }

  private:
    void start() {
        run_.begin(views_->view(0, settings_.temporal), settings_.temporal);
        before_ = run_.next().filtered;
    }

    [[nodiscard]] Frame advanced(int number) {
        run_.advance(views_->view(number, settings_.temporal));
        Frame frame = run_.next();
        before_ = frame.filtered;
        return frame;
    }

    [[nodiscard]] PlainFrame single(PlainSlices& slices, int number) {
        slices.take(views_->view(number, {}), settings_.temporal.radius);
        return slices.next();
    }

    void scored(int number, bool judged) {
        const std::vector<float> before = before_;
        Frame frame;
        const bool run_first = ++turn_ % 2 == 0;
        if (run_first) frame = advanced(number);
        const PlainFrame fast = single(fast_, number);
        if (!run_first) frame = advanced(number);
        sum_.readings.push_back(
            {total_ms(frame), sampling_ms(frame), fast.slices_ms + fast.blur_ms, fast.slices_ms});
        if (!judged) return;
        const PlainFrame exact = single(exact_, number);
        sum_.exact_ms.push_back(exact.slices_ms + exact.blur_ms);
        const ScoredFrame& truth = views_->scored(number);
        add(sum_.temporal, frame.occlusion, frame.filtered, truth.geometry);
        add(sum_.exact, exact.occlusion, exact.blurred, truth.geometry);
        add(sum_.fast, fast.occlusion, fast.blurred, truth.geometry);
        if (truth.history)
            sum_.flicker = sum_.flicker.value_or(0.0) + mean_change(*truth.history, frame.filtered, before);
        counted_ += 1.0;
    }

    static void add(BarError& error, const std::vector<float>& raw, const std::vector<float>& shown,
                    const Truth& truth) {
        error.raw += errors_of(raw, truth).rmse;
        error.shown += errors_of(shown, truth).rmse;
    }

    BenchmarkViews* views_;
    BarSettings settings_;
    AmbientOcclusion run_;
    PlainSlices exact_;
    PlainSlices fast_;
    std::vector<float> before_;  // the displayed image of the run's previous frame
    Bar sum_;
    int turn_ = 0;
    double counted_ = 0.0;
};

}  // namespace

Bar study_bar(const gpu::Device& device, const scene::PassLibrary& passes, BenchmarkViews& views,
              const BarSettings& settings, int rounds, const std::function<void(double)>& progress) {
    if (rounds < 1) throw std::invalid_argument(fmt::format("{} rounds: expected 1 or more", rounds));
    if (views.frames().frames < 2) throw std::invalid_argument("1 frame: expected 2 or more for a history");
    Bars bars(device, passes, views, settings);
    for (int round = 0; round < rounds; ++round) {
        bars.go_through(round == 0);
        if (progress) progress(static_cast<double>(round + 1) / rounds);
    }
    return bars.found();
}

}  // namespace gloam::effect
