// SPDX-License-Identifier: MIT
#include "report/mutation_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/text.hpp"
#include "base/version.hpp"
#include "report/page.hpp"

namespace gloam::report {
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

// "'a < b' -> 'a <= b'"
std::string change_text(const shader::Mutation& mutation) {
    return fmt::format("'{}' -> '{}'", in_a_line(mutation.before), in_a_line(mutation.after));
}

std::string place_text(const MutationReport& report, const MutantRow& row) {
    return fmt::format("{}:{}", report.files.at(row.file).name, row.mutation.line);
}

// "x = 1: 0.5 becomes 1"; empty where no input shows a difference.
std::string shown_by(const check::MutantComparison& comparison) {
    if (comparison.words.empty()) return {};
    return fmt::format("{}({}): {} becomes {}", comparison.function, comparison.values, comparison.before,
                       comparison.after);
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

std::string verdict_of(const MutantRow& row) {
    return row.fate == Fate::known ? "known: " + row.reason : name_of(row.comparison.difference);
}

}  // namespace

std::string name_of(Fate fate) {
    return fate_names.at(static_cast<std::size_t>(fate));
}

std::optional<Fate> fate_from(const std::string& name) {
    const auto found = std::ranges::find(fate_names, name);
    if (found == fate_names.end()) return std::nullopt;
    return static_cast<Fate>(found - fate_names.begin());
}

std::size_t MutationReport::missed() const {
    return static_cast<std::size_t>(std::ranges::count_if(mutants, [](const MutantRow& row) {
        return row.fate == Fate::survived && row.comparison.difference >= check::Difference::real;
    }));
}

std::string to_text(const MutationReport& report) {
    std::vector<Tally> tallies(report.files.size() + 1);
    std::size_t widest = 4;
    for (const MutantRow& row : report.mutants)
        for (const std::size_t i : {row.file, report.files.size()}) tallies[i].add(row.fate);
    for (const MutationReport::File& file : report.files) widest = std::max(widest, file.name.size());
    std::string text = fmt::format("{:<{}}", "file", widest);
    for (const char* name : fate_names) text += fmt::format("  {:>8}", name);
    text += "     share\n";
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        const bool some = std::ranges::any_of(tallies[i].counts, [](std::size_t count) { return count > 0; });
        if (!some || (tallies.size() == 2 && i == 1)) continue;  // the only file is all
        text += fmt::format("{:<{}}", i < report.files.size() ? report.files[i].name : "all", widest);
        for (const std::size_t count : tallies[i].counts) text += fmt::format("  {:>8}", count);
        text += fmt::format("  {:>8}\n", tallies[i].share());
    }
    for (const MutantRow* row : survivors(report)) {
        text += fmt::format("{}: {} in {}: {}\n", place_text(report, *row), change_text(row->mutation),
                            row->mutation.function.empty() ? "no function" : row->mutation.function,
                            verdict_of(*row));
        if (row->fate == Fate::survived && !row->comparison.words.empty())
            text += "  " + shown_by(row->comparison) + "\n";
    }
    return base::for_terminal(text);
}

std::string to_mutation_json(const MutationReport& report) {
    using nlohmann::ordered_json;
    ordered_json json{
        {"gloam", base::version()}, {"command", report.command}, {"mutants", ordered_json::array()}};
    for (const MutantRow& row : report.mutants) {
        ordered_json one{{"file", report.files.at(row.file).name},
                         {"line", row.mutation.line},
                         {"kind", row.mutation.kind},
                         {"function", row.mutation.function},
                         {"before", row.mutation.before},
                         {"after", row.mutation.after},
                         {"fate", name_of(row.fate)},
                         {"seconds", row.seconds}};
        if (row.fate == Fate::known) one["reason"] = row.reason;
        if (row.fate == Fate::survived) {
            const check::MutantComparison& found = row.comparison;
            one["difference"] = name_of(found.difference);
            one["inputs"] = found.inputs;
            if (!found.words.empty()) {
                one["input"] = found.values;
                one["words"] = found.words;
                one["result"] = found.before;
                one["result_with_fault"] = found.after;
            }
        }
        json["mutants"].push_back(std::move(one));
    }
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

namespace {

constexpr std::size_t most_notes = 3;  // behind a line; the table below has all

// The lines of a file. The more of a line's faults survived, the warmer it is.
std::vector<PageLine> coloured_lines(const MutationReport& report, std::size_t file) {
    std::vector<PageLine> lines;
    std::istringstream text(report.files[file].source);
    for (std::string row; std::getline(text, row);) {
        const auto number = static_cast<unsigned>(lines.size() + 1);
        Tally tally;
        std::vector<std::string> notes;
        for (const MutantRow& one : report.mutants) {
            if (one.file != file || static_cast<unsigned>(one.mutation.line) != number) continue;
            tally.add(one.fate);
            if (one.fate != Fate::survived) continue;
            if (notes.size() < most_notes)
                notes.push_back(fmt::format("{} {}", change_text(one.mutation), verdict_of(one)));
        }
        const double missed = tally.judged() == 0 ? 0.0
                                                  : static_cast<double>(tally.of(Fate::survived)) /
                                                        static_cast<double>(tally.judged());
        if (tally.of(Fate::survived) > notes.size())
            notes.push_back(fmt::format("and {} more", tally.of(Fate::survived) - notes.size()));
        if (tally.judged() > 0)
            notes.insert(notes.begin(), fmt::format("{} of {} noticed", tally.noticed(), tally.judged()));
        const auto heat = static_cast<unsigned>(3.0 * missed) + (missed > 0.0 ? 1U : 0U);
        lines.push_back({number, row, heat, fmt::format("{}", fmt::join(notes, "; "))});
    }
    return lines;
}

PageTable survivor_table(const MutationReport& report) {
    PageTable table{.columns = {{.title = "place"},
                                {.title = "kind", .filter = true},
                                {.title = "fault"},
                                {.title = "by the interpreter", .filter = true},
                                {.title = "simplest input that shows it"}},
                    .rows = {}};
    for (const MutantRow* row : survivors(report)) {
        const bool missed =
            row->fate == Fate::survived && row->comparison.difference >= check::Difference::real;
        table.rows.push_back({{.text = place_text(report, *row)},
                              {.text = row->mutation.kind},
                              {.text = change_text(row->mutation)},
                              {.text = verdict_of(*row), .tone = missed ? Tone::bad : Tone::plain},
                              {.text = shown_by(row->comparison)}});
    }
    return table;
}

// Lines for a C++ test of the framework, and for the command line: each input once.
std::string ready_to_paste(const MutationReport& report) {
    std::map<std::string, std::string> noticed;  // faults by the input that shows them
    for (const MutantRow* row : survivors(report)) {
        const check::MutantComparison& found = row->comparison;
        if (row->fate != Fate::survived || found.difference != check::Difference::real) continue;
        std::vector<std::string> words;
        for (const check::Word word : found.words) words.push_back(fmt::format("0x{:08x}", word));
        const std::string file = std::filesystem::path(report.files.at(row->file).name).filename().string();
        noticed[fmt::format("domain = domain.and_words({{{}}});\n// gloam explain {} '{}' {}\n",
                            fmt::join(words, ", "), file, found.function, fmt::join(words, " "))] +=
            fmt::format("// {}: {}; {}\n", place_text(report, *row), change_text(row->mutation),
                        shown_by(found));
    }
    std::string text;
    for (const auto& [lines, faults] : noticed) text += faults + lines;
    return text;
}

}  // namespace

std::string to_mutation_page(const MutationReport& report) {
    Tally all;
    for (const MutantRow& row : report.mutants) all.add(row.fate);
    Page page("Faults that a test notices");
    page.paragraph(fmt::format(
        "Each fault was planted alone, and this command was run: {}. It noticed {} of {} faults ({}); {} did "
        "not compile, {} did not change the optimised module, {} are known, and {} were not tried. The more "
        "of a line's faults survived, the warmer it is.",
        report.command, all.noticed(), all.judged(), all.share(), all.of(Fate::invalid), all.of(Fate::same),
        all.of(Fate::known), all.of(Fate::untried)));
    for (std::size_t i = 0; i < report.files.size(); ++i) {
        if (std::ranges::find(report.mutants, i, &MutantRow::file) == report.mutants.end()) continue;
        page.heading(report.files[i].name);
        page.source(coloured_lines(report, i));
    }
    if (!survivors(report).empty()) {
        page.heading("Survivors");
        page.table(survivor_table(report));
    }
    if (const std::string tests = ready_to_paste(report); !tests.empty()) {
        page.heading("Inputs for a test that notices them");
        page.preformatted(tests);
    }
    return page.html();
}

}  // namespace gloam::report
