// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"

namespace gloam::cli {
namespace {

using Texts = std::vector<std::string>;

// File, documented error and instructions of a function, or "method NAME", as equations may be called alike.
using Facts = std::map<std::string, std::array<std::string, 3>>;

Facts facts_of(const catalogue::Entries& entries) {
    Facts facts;
    const subject::Lab lab({.device = std::string(subject::interpreter_name),
                            .include_roots = {glsl_directory()},
                            .cache_directory = cache_directory()});
    Texts things;
    std::vector<module::Spirv> kernels;
    for (const auto& [d, question, known] : entries) {
        const bool is_method = d.file.starts_with("gloam/methods/");
        const std::string thing = is_method ? "method " + d.function.substr(6) : d.function;
        if (!d.file.starts_with("gloam/") || facts.contains(thing)) continue;
        std::string error = base::replaced(to_text(question.budget), "at inputs within ", "~");
        for (const char* word : {" of the largest component", " absolute"})
            error = base::replaced(error, word, "");
        facts[thing] = {d.file.substr(6), error, ""};
        things.push_back(thing);
        kernels.push_back(cost_kernel(lab, d.file, d.function, question.signature));
    }
    for (std::size_t i = 0; const cost::Cost& cost : cost::costs_of(kernels))
        facts[things[i++]][2] = fmt::to_string(cost.instructions);
    return facts;
}

// "method `hbao`", "`steps=6`", "(a remark)"
std::string quoted(const std::string& thing) {
    if (thing.starts_with("(") || thing.starts_with("none")) return thing;
    const std::size_t kind = thing.starts_with("gloam ") ? 0 : thing.find(' ') + 1;
    return fmt::format("{}`{}`", thing.substr(0, kind), thing.substr(kind));
}

// A row of the table. A file stands once, and an error or a number that all its functions have.
std::string row_of(const catalogue::PrintedRow& row, const Facts& facts) {
    std::array<Texts, 5> cells;  // functions, three facts, other things
    for (const std::string& thing : row.has) {
        auto found = facts.find(thing);
        if (found == facts.end() && thing.starts_with("gloam_"))
            found = facts.find("method " + thing.substr(6));
        cells[found == facts.end() ? 4 : 0].push_back(quoted(thing));
        for (std::size_t i = 0; i < 3 && found != facts.end(); ++i)
            if (i > 0 || std::ranges::count(cells[1], found->second[0]) == 0)
                cells[i + 1].push_back(found->second[i]);
    }
    std::string text = fmt::format("| {}{}{} | {} |", fmt::join(row.places, ", "),
                                   row.phrases.empty() ? "" : ": ", fmt::join(row.phrases, "; "), row.says);
    for (Texts& cell : cells) {
        if (!cell.empty() && std::ranges::count(cell, cell.front()) == std::ssize(cell)) cell.resize(1);
        text += fmt::format(" {} |", fmt::join(cell, ", "));
    }
    return text + "\n";
}

}  // namespace

std::string numbers_page() {
    const Facts facts = facts_of(catalogue::all_entries(glsl_directory()));
    std::string page =
        "# What the papers print, and where it is\n\n"
        "`gloam list numbers --markdown` prints this page. `list`, `check`, `explain`, `cost`, `audit` and "
        "`pack` take\n"
        "what stands in the first column: `gloam check 'Mattausch 6'`, `gloam list 'guard band'`. Functions "
        "and methods\n"
        "are in files of `glsl/gloam`, `passes` in `glsl`. The error is the documented one, absolute or in "
        "ulp, and\n"
        "`~4 ulp` at inputs within 4 ulp. Instructions are those of `gloam cost` with Mesa 22.3.6.\n";
    std::string paper;
    for (const catalogue::PrintedRow& row : catalogue::printed_rows()) {
        if (row.paper != paper)
            page += fmt::format(
                "\n## {}\n\n| asked for as | what it says | functions | file | error | instructions | "
                "also |\n|{}\n",
                paper = row.paper, base::replaced("-------", "-", " --- |"));
        page += row_of(row, facts);
    }
    page += "\n## Errors in print\n\n| where | in print | here |\n| --- | --- | --- |\n";
    for (const auto& [place, printed, here] : catalogue::errata())
        page += fmt::format("| {} | {} | {} |\n", place, printed, here);
    return page;
}

std::vector<Named> names_of(const std::vector<catalogue::PrintedRow>& rows) {
    std::vector<Named> names;
    for (const catalogue::PrintedRow& row : rows) {
        std::string more =
            row.places.size() > 1
                ? fmt::format("{}: ", fmt::join(row.places.begin() + 1, row.places.end(), "; "))
                : "";
        names.push_back(
            {row.places.front(), fmt::format("{}{}: {}", more, row.says, fmt::join(row.has, ", "))});
    }
    return names;
}

catalogue::Found found_named(const std::vector<std::string>& names) {
    catalogue::Found found = catalogue::find(catalogue::all_entries(glsl_directory()), names);
    if (found.several.empty()) return found;
    for (const auto& [name, says] : names_of(found.rows)) fmt::print(stderr, "{}: {}\n", name, says);
    throw std::invalid_argument(
        fmt::format("\"{}\" fits several rows: expected the name of one", found.several));
}

std::vector<judge::Question> equations_named(const std::vector<std::string>& names) {
    catalogue::Found found = found_named(names);
    const std::vector<Named> rows = names_of(found.rows);
    if (!found.lacking.empty())
        throw std::invalid_argument(fmt::format("\"{}\" has no function: {}: {}", found.lacking,
                                                rows.back().name, rows.back().description));
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (found.rows[i].has.back().starts_with('('))
            fmt::print(stderr, "{}: {}\n", rows[i].name, rows[i].description);
    std::vector<judge::Question> questions;
    for (catalogue::Entry& entry : found.entries) questions.push_back(std::move(entry.question));
    return questions;
}

}  // namespace gloam::cli
