// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <fmt/format.h>
#include <cmath>
#include <stdexcept>

#include "audit/worst.hpp"
#include "base/version.hpp"
#include "catalogue/catalogue.hpp"
#include "record/members.hpp"

namespace gloam::stress {

std::vector<Run> select_runs(const std::string& name) {
    if (name.empty()) return all_runs;
    std::string names;
    for (const Run& run : all_runs) {
        if (run.name == name) return {run};
        names += (names.empty() ? "" : ", ") + run.name;
    }
    throw std::invalid_argument("unknown stress run \"" + name + "\": expected " + names);
}

static constexpr const char* layout = "{:9} {:58} {:50} {:>11} {:>11} {}";

std::string table_header() {
    return fmt::format(layout, "run", "varied", "measured", "value", "bound", "verdict");
}

std::string table_line(const Row& row) {
    const std::string bound = row.bound ? fmt::format("{:.4g}", *row.bound) : "-";
    const char* verdict = !row.bound ? "measured" : row.passed() ? "ok" : "BROKEN";
    return fmt::format(layout, row.run, row.varied, row.quantity, fmt::format("{:.4g}", row.measured), bound,
                       verdict);
}

template <class Io>
void members(Io& io, Row& row) {
    record::each(io, "run", row.run, "varied", row.varied, "quantity", row.quantity, "measured", row.measured,
                 "bound", row.bound, "passed", row.passed());
}

std::string to_json(const gpu::DeviceInfo& device, const Rows& rows, const std::string& versions) {
    return record::to_text({{"gloam", base::version()},
                            {"device", {{"name", device.name}, {"driver", device.driver}}},
                            {"versions", versions},
                            {"rows", record::json_of(rows)}});
}

namespace {

constexpr const char* worst_inputs_name = "worst-inputs";

// The input in a few words: those of a matrix would hide the rest of the line.
std::string input_text(const check::Answer& answer) {
    if (!answer.worst) return "every input: exact";
    std::string text = answer.worst->values;
    constexpr std::size_t longest = 120;
    if (text.size() > longest) text.replace(longest, std::string::npos, "...");
    return "at " + text;
}

}  // namespace

Rows worst_inputs(const Context& context, const catalogue::Entry& entry) {
    const std::size_t inputs = context.brief ? 2'048 : 262'144;
    const std::string& equation = entry.description.id;
    context.progress(fmt::format("{}: {}", worst_inputs_name, equation));
    const check::SearchResult found =
        check::search(context.lab, entry.question, {.inputs = inputs, .seed = context.seed});
    const check::Answer& answer = found.answer;
    const std::string limit = answer.rules_alone() ? "permitted" : "documented";
    return {{worst_inputs_name, fmt::format("{} {}", equation, input_text(answer)),
             fmt::format("worst error found, of what is {}", limit), answer.fraction, 1.0},
            {worst_inputs_name, equation, "worst error of the random inputs alone", found.drawn_fraction}};
}

Rows worst_inputs(const Context& context) {
    Rows rows;
    const catalogue::Entries all = catalogue::all_entries(context.lab.options().include_roots.front());
    for (const catalogue::Entry& entry : catalogue::select(all, context.equations))
        for (Row& row : worst_inputs(context, entry)) {
            context.found(row);
            rows.push_back(std::move(row));
        }
    return rows;
}

}  // namespace gloam::stress
