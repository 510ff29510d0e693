// SPDX-License-Identifier: MIT
#include "record/mutation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "base/text.hpp"
#include "base/version.hpp"
#include "record/members.hpp"
#include "record/table.hpp"

namespace gloam::record {
namespace {

constexpr std::array fate_names{"untried", "invalid", "same", "known", "killed", "too long", "survived"};

// How many of some mutants had each fate.
struct Tally {
    std::array<std::size_t, fate_names.size()> counts{};

    void add(Fate fate) { ++counts[static_cast<std::size_t>(fate)]; }
    [[nodiscard]] std::size_t of(Fate fate) const { return counts[static_cast<std::size_t>(fate)]; }
    [[nodiscard]] std::size_t noticed() const { return of(Fate::killed) + of(Fate::too_long); }
    [[nodiscard]] std::size_t judged() const { return noticed() + of(Fate::survived); }
    [[nodiscard]] std::string share() const {
        if (judged() == 0) return "-";
        return fmt::format("{:.1f} %",
                           100.0 * static_cast<double>(noticed()) / static_cast<double>(judged()));
    }
};

std::string in_a_line(const std::string& text) {
    constexpr std::size_t longest = 80;
    std::istringstream words(text);
    std::string all;
    for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
    return base::shortened(base::one_line(all), longest);
}

// The gravest first.
std::vector<const MutantRow*> survivors(const MutationReport& report) {
    std::vector<const MutantRow*> rows;
    for (const MutantRow& row : report.mutants)
        if (row.fate == Fate::survived || row.fate == Fate::known) rows.push_back(&row);
    std::ranges::stable_sort(rows, [](const MutantRow* a, const MutantRow* b) {
        return std::pair(a->fate, a->comparison.difference) > std::pair(b->fate, b->comparison.difference);
    });
    return rows;
}

}  // namespace

std::string name_of(Fate fate) {
    return fate_names.at(static_cast<std::size_t>(fate));
}

bool MutationReport::is_begun() const {
    const auto any = [this](auto of) { return std::ranges::any_of(mutants, of, &MutantRow::fate); };
    return any([](Fate fate) { return fate >= Fate::killed; }) ||
           !any([](Fate fate) { return fate == Fate::untried; });
}

std::size_t MutationReport::missed() const {
    return static_cast<std::size_t>(std::ranges::count_if(mutants, [](const MutantRow& row) {
        return row.fate == Fate::survived && row.comparison.difference >= audit::Difference::real;
    }));
}

std::string to_text(const MutationReport& report) {
    std::vector<Tally> tallies(report.files.size() + 1);
    for (const MutantRow& row : report.mutants)
        for (const std::size_t i : {row.file, report.files.size()}) tallies[i].add(row.fate);
    Table table{{{"file"}}};
    for (const char* name : fate_names) table.columns.push_back({name});
    table.columns.push_back({"share"});
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        const bool some = std::ranges::any_of(tallies[i].counts, [](std::size_t count) { return count > 0; });
        if (!some || (tallies.size() == 2 && i == 1)) continue;  // the only file is all
        std::vector<Cell>& row =
            table.rows.emplace_back(1, i < report.files.size() ? report.files[i] : "all");
        row.insert(row.end(), tallies[i].counts.begin(), tallies[i].counts.end());
        row.emplace_back(tallies[i].share());
    }
    std::string text = aligned(table);
    if (tallies.back().judged() > 0 && tallies.back().noticed() == 0)
        text +=
            "no fault was noticed: expected a command that reads the shaders in the folder GLOAM_SHADERS\n";
    for (const MutantRow* row : survivors(report)) {
        const source::Mutation& mutation = row->mutation;
        const audit::MutantComparison& shown = row->comparison;
        text += fmt::format("{}:{}: '{}' -> '{}' in {}: {}\n", report.files.at(row->file), mutation.line,
                            in_a_line(mutation.before), in_a_line(mutation.after),
                            mutation.function.empty() ? "no function" : mutation.function,
                            row->fate == Fate::known ? "known: " + row->reason : name_of(shown.difference));
        if (row->fate == Fate::survived && !shown.words.empty())
            text += fmt::format("  {}({}): {} becomes {}\n", shown.function, shown.values, shown.before,
                                shown.after);
    }
    return base::for_terminal(text);
}

std::string to_mutation_json(const MutationReport& report) {
    using nlohmann::ordered_json;
    ordered_json mutants = ordered_json::array();
    for (const MutantRow& row : report.mutants) {
        const source::Mutation& mutation = row.mutation;
        const audit::MutantComparison& found = row.comparison;
        MemberWriter<Form::whole> one;
        each(one, "file", report.files.at(row.file), "line", mutation.line, "kind", mutation.kind, "function",
             mutation.function, "before", mutation.before, "after", mutation.after, "fate", row.fate,
             "seconds", row.seconds);
        if (row.fate == Fate::known) each(one, "reason", row.reason);
        if (row.fate == Fate::survived) each(one, "difference", found.difference, "inputs", found.inputs);
        if (row.fate == Fate::survived && !found.words.empty())
            each(one, "input", found.values, "words", found.words, "result", found.before,
                 "result_with_fault", found.after);
        mutants.push_back(std::move(one.json));
    }
    return to_text(
        {{"gloam", base::version()}, {"command", report.command}, {"mutants", std::move(mutants)}});
}

}  // namespace gloam::record
