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

std::vector<effect::MethodInfo> methods_of(const Context& context) {
    if (context.methods.empty()) return effect::methods();
    std::vector<effect::MethodInfo> methods;
    for (const std::string& name : context.methods) methods.push_back(effect::method_named(name));
    return methods;
}

std::vector<Run> all_runs() {
    return {{"worst-inputs", "the input of each equation with the largest error, searched for", worst_inputs},
            {"long-run", "the history over very many frames", long_run},
            {"far", "far from the origin, and depth in halves", far_away},
            {"poison", "NaN, infinities and other bad values in every buffer", poison}};
}

std::vector<Run> select_runs(const std::string& name) {
    if (name.empty()) return all_runs();
    std::string names;
    for (const Run& run : all_runs()) {
        if (run.name == name) return {run};
        names += (names.empty() ? "" : ", ") + run.name;
    }
    throw std::invalid_argument("unknown stress run \"" + name + "\": expected " + names);
}

namespace {

constexpr const char* layout = "{:9} {:58} {:50} {:>11} {:>11} {}";

}  // namespace

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
    nlohmann::ordered_json document{{"gloam", base::version()},
                                    {"device", {{"name", device.name}, {"driver", device.driver}}}};
    if (!versions.empty()) document["versions"] = versions;
    document["rows"] = record::json_of(rows);
    return record::to_text(document);
}

namespace {

constexpr const char* worst_inputs_name = "worst-inputs";
constexpr std::size_t full_inputs = 262'144;
constexpr std::size_t brief_inputs = 2'048;

// The input in a few words: those of a matrix would hide the rest of the line.
std::string input_text(const check::Answer& answer) {
    if (!answer.worst) return "every input: exact";
    constexpr std::size_t longest = 120;
    std::string text = answer.worst->values;
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return "at " + text;
}

}  // namespace

Rows worst_inputs(const Context& context, const catalogue::Entry& entry) {
    const std::size_t inputs = context.extent == Extent::full ? full_inputs : brief_inputs;
    const std::string& equation = entry.description.id;
    context.progress(fmt::format("{}: {}", worst_inputs_name, equation));
    const check::SearchResult found =
        check::search(context.lab, entry.question, {.inputs = inputs, .seed = context.seed});
    const check::Answer& answer = found.answer;
    const std::string limit = answer.verdict == check::Verdict::rules ? "permitted" : "documented";
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
