// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "audit/worst.hpp"
#include "catalogue/catalogue.hpp"
#include "stress/run.hpp"

namespace gloam::stress {
namespace {

// The input in a few words: those of a matrix would hide the rest of the line.
std::string input_text(const judge::Answer& answer) {
    if (!answer.worst) return "every input: exact";
    std::string text = answer.worst->values;
    constexpr std::size_t longest = 120;
    if (text.size() > longest) text.replace(longest, std::string::npos, "...");
    return "at " + text;
}

}  // namespace

void worst_inputs(const Context& context, const catalogue::Entry& entry) {
    const std::string& equation = entry.description.id;
    context.progress(equation);
    const audit::SearchResult found =
        audit::search(context.lab, entry.question,
                      {.inputs = context.scope.brief ? 2'048U : 262'144U, .seed = context.scope.seed});
    const judge::Answer& answer = found.answer;
    const char* limit = answer.rules_alone() ? "permitted" : "documented";
    const bool judged = answer.outcome() != judge::Outcome::not_judged;
    context.add(fmt::format("{} {}", equation, input_text(answer)),
                fmt::format("worst error found, of what is {}", limit),
                answer.fault.empty() ? answer.fraction : std::numeric_limits<double>::infinity(),
                judged ? std::optional(1.0) : std::nullopt);
    context.add(equation, "worst error of the random inputs alone", found.drawn_fraction, std::nullopt);
}

void worst_inputs(const Context& context) {
    const catalogue::Entries all = catalogue::all_entries(context.lab.options().include_roots.front());
    for (const catalogue::Entry& entry : catalogue::select(all, context.scope.equations))
        worst_inputs(context, entry);
}

}  // namespace gloam::stress
