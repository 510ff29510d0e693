// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <fmt/format.h>

#include "catalogue/catalogue.hpp"
#include "check/run.hpp"

namespace gloam::stress {
namespace {

constexpr const char* worst_inputs_name = "worst-inputs";
constexpr std::size_t full_inputs = 262'144;
constexpr std::size_t brief_inputs = 4'096;

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
        append(rows, worst_inputs(context, entry));
    return rows;
}

}  // namespace gloam::stress
