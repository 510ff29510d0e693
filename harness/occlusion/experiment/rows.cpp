// SPDX-License-Identifier: MIT
#include "experiment/internal/rows.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "experiment/table.hpp"

namespace gloam::experiment::internal {
namespace {

// A row for each kind of the cases.
void add_kinds(std::vector<Row>& rows, const std::vector<CaseResult>& cases,
               const std::vector<std::size_t>& all) {
    std::map<std::string, std::size_t> row_of;  // by kind
    for (const std::size_t i : all) {
        const auto [at, is_new] = row_of.try_emplace(cases[i].shown.kind, rows.size());
        if (is_new) rows.push_back({{}, 0, ""});
        rows[at->second].cases.push_back(i);
    }
}

}  // namespace

Row Rows::all_cases(std::size_t size) const {
    const std::vector<CaseResult>& cases = results_[size].cases;
    Row all;
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (table_.kind.empty() || cases[i].shown.kind == table_.kind) all.cases.push_back(i);
    return all;
}

std::vector<Row> Rows::of(std::size_t size) const {
    const std::vector<CaseResult>& cases = results_[size].cases;
    const std::vector<std::size_t> all = all_cases(size).cases;
    std::vector<Row> rows;
    if (table_.rows == "candidates") {
        for (const std::size_t c : kept(cases_of(all_cases(size), size, {}, "")))
            rows.push_back({all, c, ""});
    } else if (table_.rows == "kinds") {
        add_kinds(rows, cases, all);
    } else {
        for (const std::size_t i : all) add_rows(rows, cases[i], i);
    }
    return rows;
}

// The candidates of which a table over these cases has rows, in their order.
std::vector<std::size_t> Rows::kept(const std::vector<const CaseResult*>& cases) const {
    std::vector<std::size_t> numbers;
    if (table_.keep == "front") {
        for (const FrontPoint& point : front_of(front_points(cases))) numbers.push_back(point.candidate);
    } else {
        for (std::size_t c = 0; c < experiment_.candidates.size(); ++c) numbers.push_back(c);
        if (table_.keep == "best") numbers = best_of(cases, numbers);
    }
    std::erase_if(numbers, [&](std::size_t c) {
        return !table_.group.empty() && experiment_.candidates[c].group != table_.group;
    });
    return numbers;
}

// The one with the least error of each group.
std::vector<std::size_t> Rows::best_of(const std::vector<const CaseResult*>& cases,
                                       const std::vector<std::size_t>& numbers) const {
    std::map<std::string, std::pair<double, std::size_t>> best;  // by group
    for (const std::size_t c : numbers) {
        const auto error = mean_value(cases, c, "rmse", "median", {});
        if (!error) continue;
        const auto [at, is_new] = best.try_emplace(experiment_.candidates[c].group, *error, c);
        if (!is_new && *error < at->second.first) at->second = {*error, c};
    }
    std::vector<std::size_t> chosen;
    for (const auto& [group, found] : best) chosen.push_back(found.second);
    std::ranges::sort(chosen);
    return chosen;
}

// The rows of one case.
void Rows::add_rows(std::vector<Row>& rows, const CaseResult& result, std::size_t number) const {
    if (table_.rows == "cases") {
        rows.push_back({{number}, 0, ""});
        return;
    }
    if (table_.rows == "frames") {
        add_frames(rows, result, number);
        return;
    }
    for (const std::size_t c : kept({&result})) {
        if (!result.cells[c]) continue;
        if (table_.rows == "runs") rows.push_back({{number}, c, ""});
        if (table_.rows == "passes")
            for (const std::string& pass : passes_of(*result.cells[c])) rows.push_back({{number}, c, pass});
    }
}

// The frames of the first candidate whose frames were scored; columns may show others.
void Rows::add_frames(std::vector<Row>& rows, const CaseResult& result, std::size_t number) const {
    for (std::size_t c = 0; c < result.cells.size(); ++c) {
        const std::optional<Cell>& cell = result.cells[c];
        if (!cell || !cell->quality || !cell->quality->by_class) continue;
        for (const FrameScore& frame : cell->quality->by_class->frames)
            if (table_.keep != "doubling" || std::has_single_bit(static_cast<unsigned>(frame.frame)))
                rows.push_back({{number}, c, "", frame.frame});
        return;
    }
}

std::vector<const CaseResult*> Rows::cases_of(const Row& row, std::size_t size,
                                              const std::vector<std::string>& names,
                                              const std::string& half) const {
    std::vector<const CaseResult*> cases;
    for (const std::size_t i : row.cases) {
        const CaseResult& one = results_[size].cases[i];
        if (!names.empty() && std::ranges::count(names, one.shown.name) == 0) continue;
        if (half.empty() || one.shown.half == half) cases.push_back(&one);
    }
    return cases;
}

}  // namespace gloam::experiment::internal
