// SPDX-License-Identifier: MIT
// What candidates reached in cases, from the visits of a record.
#include <algorithm>

#include "experiment/results.hpp"

namespace gloam::experiment {
namespace {

// A visit of a later round replaces or extends what those before it gave.
void add_to(std::optional<Cell>& cell, const Visit& visit) {
    if (!cell) cell.emplace();
    if (visit.quality) cell->quality = visit.quality;
    if (visit.point) cell->point = visit.point;
    if (visit.round == 0) cell->own_radius_error = visit.own_radius_error;
    cell->samples_asked = visit.samples_asked;
    cell->work = visit.work;
    if (visit.round > 0 || !visit.readings.empty()) cell->rounds.push_back(visit.readings);
}

// One remap of each candidate, fitted to the cases of the tuning half, is applied to all of its cases.
void fit_remaps(SizeResult& result) {
    if (result.cases.empty()) return;
    for (std::size_t i = 0; i < result.cases.front().cells.size(); ++i) {
        std::vector<effect::RemapBin> tuning;
        for (const CaseResult& one : result.cases) {
            const std::optional<Cell>& cell = one.cells[i];
            if (one.shown.half == "tuning" && cell && cell->quality && cell->quality->bins)
                tuning.insert(tuning.end(), cell->quality->bins->begin(), cell->quality->bins->end());
        }
        if (tuning.empty()) continue;
        const effect::Remap fit = effect::best_remap(tuning);
        for (CaseResult& one : result.cases)
            if (std::optional<Cell>& cell = one.cells[i]; cell && cell->quality && cell->quality->bins)
                cell->rmse_fit = effect::remapped_rmse(*cell->quality->bins, fit);
    }
}

}  // namespace

std::vector<gpu::Extent> choose_recorded(Experiment& experiment, const Record& record) {
    std::vector<gpu::Extent> sizes;
    experiment.query.reset();
    experiment.cases.clear();
    experiment.candidates.clear();
    for (const Visit& visit : record.visits()) {
        if (std::ranges::find(sizes, visit.size) == sizes.end()) sizes.push_back(visit.size);
        const auto same = [&](const Case& one) {
            return one.name == visit.shown.name && one.kind == visit.shown.kind &&
                   one.what == visit.shown.what;
        };
        if (std::ranges::none_of(experiment.cases, same)) experiment.cases.push_back(visit.shown);
        if (std::ranges::find(experiment.candidates, visit.candidate, &Candidate::name) ==
            experiment.candidates.end())
            experiment.candidates.push_back({.name = visit.candidate, .group = visit.group});
    }
    return sizes;
}

std::vector<SizeResult> results_of(const Experiment& experiment, const std::vector<gpu::Extent>& sizes,
                                   const Record& record) {
    int rounds = 0;
    for (const Visit& visit : record.visits()) rounds = std::max(rounds, visit.round);
    std::vector<SizeResult> results;
    for (const gpu::Extent size : sizes) {
        SizeResult& result = results.emplace_back(SizeResult{.extent = size});
        for (const Case& one : experiment.cases) {
            CaseResult& shown = result.cases.emplace_back(CaseResult{.shown = one});
            for (const Candidate& candidate : experiment.candidates) {
                std::optional<Cell>& cell = shown.cells.emplace_back();
                for (int round = 0; round <= rounds; ++round)
                    if (const Visit* visit = record.find(
                            {.size = size, .shown = one, .candidate = candidate.name, .round = round}))
                        add_to(cell, *visit);
            }
        }
        fit_remaps(result);
    }
    return results;
}

}  // namespace gloam::experiment
