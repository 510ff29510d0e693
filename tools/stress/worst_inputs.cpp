// SPDX-License-Identifier: MIT
#include "stress/worst_inputs.hpp"

#include <fmt/format.h>

#include "catalogue/catalogue.hpp"
#include "check/describe.hpp"
#include "check/search.hpp"

namespace gloam::stress {
namespace {

constexpr const char* worst_inputs_name = "worst-inputs";
constexpr std::size_t full_inputs = 262'144;
constexpr std::size_t brief_inputs = 4'096;

// The input in a few words: those of a matrix would hide the rest of the line.
std::string input_text(const check::Result& result) {
    if (!result.census.worst) return "every input: exact";
    constexpr std::size_t longest = 120;
    std::string text = check::describe_inputs(result.signature, result.census.worst->inputs);
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return "at " + text;
}

void append(Rows& rows, const std::string& equation, const check::SearchResult& found) {
    const check::Census& census = found.result.census;
    const std::string limit = found.result.verdict == check::Verdict::rules ? "permitted" : "documented";
    rows.push_back({worst_inputs_name, fmt::format("{} {}", equation, input_text(found.result)),
                    fmt::format("worst error found, of what is {}", limit), census.fraction, 1.0});
    rows.push_back(
        {worst_inputs_name, equation, "worst error of the random inputs alone", found.drawn_fraction});
}

}  // namespace

Rows worst_inputs(const Context& context) {
    const std::size_t inputs = context.extent == Extent::full ? full_inputs : brief_inputs;
    Rows rows;
    for (const catalogue::Entry& entry : catalogue::select(catalogue::all_entries(), context.equations)) {
        context.progress(fmt::format("{}: {}", worst_inputs_name, entry.description.id));
        append(rows, entry.description.id,
               check::search(context.lab, entry.check_case, {.inputs = inputs, .seed = context.seed}));
    }
    return rows;
}

}  // namespace gloam::stress
