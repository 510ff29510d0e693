// SPDX-License-Identifier: MIT
#include "effect/study/bar_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "effect/internal/work.hpp"

namespace gloam::effect {
namespace {

double gather_of(const Frame& frame) {
    double sum = 0.0;
    for (const PassTime& time : frame.times)
        if (time.pass.starts_with("ambient_occlusion")) sum += time.ms;
    return sum;
}

// The three configurations, each with an effect of its own: the single frames must not reset the run's
// history.
class Bars {
  public:
    Bars(const gpu::Device& device, const scene::PassLibrary& passes, BenchmarkViews& views,
         const BarSettings& settings)
        : views_(&views),
          settings_(settings),
          run_(device, passes, views.view(0, settings.temporal).extent),
          exact_(device, passes, views.view(0, settings.exact).extent),
          fast_(device, passes, views.view(0, settings.fast).extent) {
        start();
        for (int i = 1; i < std::min(3, views.frames().frames); ++i) (void)advanced(i);
        (void)single(exact_, settings_.exact, 0);
        (void)single(fast_, settings_.fast, 0);
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

    [[nodiscard]] Frame single(AmbientOcclusion& effect, const Settings& settings, int number) {
        effect.begin(views_->view(number, settings), settings);
        return effect.next();
    }

    void scored(int number, bool judged) {
        const std::vector<float> before = before_;
        std::array<Frame, 3> frames;
        const bool run_first = ++turn_ % 2 == 0;
        if (run_first) frames[0] = advanced(number);
        frames[2] = single(fast_, settings_.fast, number);
        if (!run_first) frames[0] = advanced(number);
        sum_.readings.push_back(
            {total_ms(frames[0]), gather_of(frames[0]), total_ms(frames[2]), gather_of(frames[2])});
        if (!judged) return;
        frames[1] = single(exact_, settings_.exact, number);
        sum_.exact_ms.push_back(total_ms(frames[1]));
        judge(number, frames, before);
    }

    void judge(int number, const std::array<Frame, 3>& frames, const std::vector<float>& before) {
        const ScoredFrame& truth = views_->scored(number);
        const std::array<BarError*, 3> errors{&sum_.temporal, &sum_.exact, &sum_.fast};
        for (std::size_t i = 0; i < frames.size(); ++i) {
            errors[i]->raw += errors_of(frames[i].occlusion, truth.geometry).rmse;
            errors[i]->shown += errors_of(frames[i].filtered, truth.geometry).rmse;
        }
        if (truth.history)
            sum_.flicker =
                sum_.flicker.value_or(0.0) + mean_change(*truth.history, frames[0].filtered, before);
        counted_ += 1.0;
    }

    BenchmarkViews* views_;
    BarSettings settings_;
    AmbientOcclusion run_;
    AmbientOcclusion exact_;
    AmbientOcclusion fast_;
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
