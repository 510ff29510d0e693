// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <ranges>
#include <sstream>
#include <tuple>

#include "audit/internal/search.hpp"
#include "module/compile.hpp"
#include "numeric/numbers.hpp"

namespace gloam::audit::internal {
namespace {

constexpr std::size_t most_tried = 24;
constexpr double no_worse = 1.5;                 // of a loss, that it may reach
constexpr double little_loss = 100.0 * 0x1p-24;  // less than two digits, which an audit does not report
constexpr double same_meaning = 1e-5;            // of a result

// How a text does on some inputs, measured against the exact results of the original.
struct Score {
    std::size_t broken = 0;       // NaN, infinite or undefined
    std::size_t unspecified = 0;  // without a stated precision
    double loss = 0.0;
    double width = 0.0;
    double change = 0.0;  // of the results in double
};

// An input with the original's results.
struct Case {
    std::vector<subject::Word> words;
    Reading original;
    bool sound = false;  // they are proper ones
};

bool is_broken(AuditRuns& runs, const std::vector<subject::Word>& words, const Reading& reading) {
    return shows(Concern::fault, reading) || shows(Concern::not_finite, reading) ||
           runs.is_undefined(words, reading);
}

// A sound result must neither be lost nor mean anything else. One that is finite is compared with the
// original's exact one; one that is not has no truth to compare with.
Score score_on(AuditRuns& runs, const std::vector<Case>& cases) {
    Score score;
    for (const Case& one : cases) {
        Reading reading = runs.read(one.words);
        if (is_broken(runs, one.words, reading)) {
            ++score.broken;
            if (one.sound) score.loss = numeric::infinity;
        } else if (runs.is_undefined(one.words, AuditRuns::Gaps::open)) {
            ++score.unspecified;
        }
        if (!reading.fault.empty() || shows(Concern::fault, one.original) ||
            shows(Concern::not_finite, one.original))
            continue;
        Reading meaning = reading;
        for (std::size_t w = 0; w < reading.outputs.size(); ++w) {
            meaning.outputs[w].value = static_cast<float>(reading.outputs[w].exact);
            meaning.outputs[w].exact = reading.outputs[w].exact = one.original.outputs[w].exact;
        }
        score.loss = std::max(score.loss, runs.largest(Concern::digits, reading).relative);
        if (!one.sound) continue;
        score.width = std::max(score.width, runs.largest(Concern::drivers, reading).relative);
        score.change = std::max(score.change, runs.largest(Concern::digits, meaning).relative);
    }
    return score;
}

double digits(double relative) {
    return std::min(digits_of(relative), float_digits);
}

bool harms(const Score& before, const Score& after) {
    return after.change > same_meaning || after.broken > before.broken ||
           after.loss > std::max(no_worse * before.loss, little_loss) ||
           after.width > std::max(no_worse * before.width, little_loss);
}

// What is better; empty: nothing is.
std::string gain_text(const Score& before, const Score& after, std::size_t inputs) {
    constexpr double least = 0.6;     // digits: a quarter of the error
    constexpr std::size_t part = 10;  // one of this many inputs at least
    std::vector<std::string> gains;
    for (const auto& [what, a, b] : {std::tuple{"proper result", before.broken, after.broken},
                                     {"stated precision", before.unspecified, after.unspecified}})
        if (b < a && (a - b) * part >= a)
            gains.push_back(fmt::format("no {} for {} -> {} of {} inputs", what, a, b, inputs));
    for (const auto& [what, a, b] :
         {std::tuple{"loses", before.loss, after.loss}, {"drivers differ by", before.width, after.width}})
        if (digits(a) - digits(b) >= least)
            gains.push_back(fmt::format("{} {:.1f} -> {:.1f} digits", what, digits(a), digits(b)));
    return fmt::format("{}", fmt::join(gains, ", "));
}

// The file and line of a position: those of the last #line directive, counted on.
std::pair<std::string, unsigned> place_at(std::string_view text, std::size_t at, const std::string& file) {
    unsigned line = 1;
    std::string name = file;
    std::istringstream rows{std::string(text.substr(0, at))};
    for (std::string row; std::getline(rows, row) && !rows.eof();) {
        ++line;
        if (!row.starts_with("#line ")) continue;
        std::from_chars(&row[6], row.data() + row.size(), line);
        const std::size_t quote = row.find('"');
        if (quote != std::string::npos) name = row.substr(quote + 1, row.rfind('"') - quote - 1);
    }
    return {name, line};
}

std::vector<Case> cases_of(AuditRuns& runs, const AuditSearch& search) {
    constexpr std::size_t most_examples = 32;  // of a kind
    std::vector<std::vector<subject::Word>> all = search.traced;
    for (const auto& [concern, examples] : search.examples)
        if (concern != Concern::fault && concern != Concern::parting)
            for (const auto* some : {&examples.random, &examples.others})
                std::ranges::copy(*some | std::views::take(most_examples), std::back_inserter(all));
    std::vector<Case> cases;
    for (const std::vector<subject::Word>& words : all) {
        Reading reading = runs.read(words);
        const bool sound = !is_broken(runs, words, reading);
        cases.push_back({words, std::move(reading), sound});
    }
    return cases;
}

}  // namespace

std::vector<AuditRewrite> rewrites(const subject::Lab& lab, AuditRuns& runs, const AuditSearch& search) {
    std::vector<AuditRewrite> all;
    const judge::Question& question = runs.question();
    const subject::KernelSource& source = runs.source();
    if (source.text.empty()) return all;
    const std::vector<Case> cases = cases_of(runs, search);
    const Score before = score_on(runs, cases);
    std::size_t tried = 0;
    for (auto& [begin, change] : candidates_of(source.text)) {
        if (tried++ == most_tried) break;
        subject::KernelSource changed = source;
        changed.text.replace(begin, change.before.size(), change.after);
        changed.text.insert(0, change.helper);
        try {
            AuditRuns rewritten(lab, question, changed, runs);
            const Score after = score_on(rewritten, cases);
            change.gain = gain_text(before, after, cases.size());
            if (change.gain.empty() || harms(before, after)) continue;
            std::tie(change.file, change.line) = place_at(source.text, begin, question.file);
            all.push_back(std::move(change));
        } catch (const source::CompileError&) {
            continue;  // a type for which the change is not meant
        }
    }
    return all;
}

}  // namespace gloam::audit::internal
