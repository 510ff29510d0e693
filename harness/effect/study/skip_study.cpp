// SPDX-License-Identifier: MIT
#include "effect/study/skip_study.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "effect/internal/work.hpp"
#include "effect/study/copy_clock.hpp"

namespace gloam::effect {
namespace {

// One way to run a case, and the times of its frames.
struct Contestant {
    Settings settings;
    std::vector<double> times;
    std::vector<double> first_times;
    Work work;
    std::vector<PassTime> passes;  // of the last frame
};

// Runs the frames of a round: those of the views, or successive frames of a view that stands still.
void run_round(AmbientOcclusion& effect, const SkipCase& skip_case, Contestant& contestant) {
    const auto show = [&](bool timed) {
        const Frame frame = effect.next();
        if (timed) contestant.times.push_back(total_ms(frame));
        contestant.work = frame.work;
        contestant.passes = frame.times;
    };
    effect.begin(skip_case.views.front(), contestant.settings);
    contestant.first_times.push_back(total_ms(effect.next()));
    for (int i = 0; i < skip_case.warm; ++i) (void)effect.next();
    const bool still = skip_case.views.size() == 1 || skip_case.after > 0;
    for (std::size_t i = 1; i < skip_case.views.size(); ++i) {
        effect.advance(skip_case.views[i]);
        // After a few frames it is known which images hold background.
        show(!still && 2 * i >= skip_case.views.size());
    }
    for (int i = 1; i < skip_case.after; ++i) (void)effect.next();
    if (still) show(true);
}

Settings only(const Settings& settings, bool Settings::* skip) {
    Settings one = without_skips(settings);
    one.*skip = true;
    return one;
}

}  // namespace

Settings without_skips(Settings settings) {
    settings.skip_background = false;
    settings.skip_open = false;
    settings.skip_closed = false;
    settings.skip_settled = false;
    settings.skip_filtered = false;
    return settings;
}

namespace {

Contestant fresh(const Settings& settings) {
    return {settings, {}, {}, {}, {}};
}

// Runs the ways in turns, so that the machine's drift affects all alike. Returns the time of a copy.
double compete(AmbientOcclusion& effect, CopyClock& clock, const SkipCase& skip_case,
               std::vector<Contestant>& contestants, int rounds) {
    if (skip_case.views.empty()) throw std::invalid_argument("a case of skips without a view");
    if (rounds < 1) throw std::invalid_argument(fmt::format("rounds {}: expected 1 or more", rounds));
    double copy = 0.0;
    for (int round = 0; round <= rounds; ++round) {
        for (Contestant& contestant : contestants) {
            run_round(effect, skip_case, contestant);
            if (round == 0) contestant = fresh(contestant.settings);  // drivers compile
        }
        copy = clock.measure();
    }
    return copy;
}

}  // namespace

SkipStudy::SkipStudy(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent)
    : device_(&device), passes_(passes), extent_(extent), effect_(device, passes, extent) {
    require_timestamps(device.info());
}

SkipTimes SkipStudy::times(const SkipCase& skip_case, int rounds) {
    const Settings& all = skip_case.settings;
    std::vector<Contestant> contestants{fresh(without_skips(all)),
                                        fresh(all),
                                        fresh(only(all, &Settings::skip_background)),
                                        fresh(only(all, &Settings::skip_open)),
                                        fresh(only(all, &Settings::skip_settled)),
                                        fresh(only(all, &Settings::skip_closed))};
    CopyClock clock(*device_, passes_, extent_);
    const double copy = compete(effect_, clock, skip_case, contestants, rounds);
    const auto of = [&](std::size_t i) { return median(contestants.at(i).times); };
    return {.without = of(0),
            .with = of(1),
            .background = of(2),
            .open = of(3),
            .closed = of(5),
            .settled = of(4),
            .fresh = median(contestants[1].first_times),
            .copy = copy,
            .work = contestants[1].work,
            .passes = contestants[1].passes};
}

SkipPair SkipStudy::pair(const SkipCase& skip_case, int rounds) {
    const Settings& all = skip_case.settings;
    std::vector<Contestant> contestants{fresh(without_skips(all)), fresh(all)};
    CopyClock clock(*device_, passes_, extent_);
    const double copy = compete(effect_, clock, skip_case, contestants, rounds);
    return {.without = median(contestants[0].times),
            .with = median(contestants[1].times),
            .copy = copy,
            .work = contestants[1].work};
}

}  // namespace gloam::effect
