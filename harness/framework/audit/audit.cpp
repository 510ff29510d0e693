// SPDX-License-Identifier: MIT
#include "audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "audit/internal/search.hpp"
#include "judge/explain.hpp"
#include "judge/session.hpp"
#include "numeric/numbers.hpp"

namespace gloam::audit {

using namespace judge;
using namespace subject;

std::string name_of(Concern concern) {
    static constexpr std::array names{"fault",       "is false", "not finite",   "undefined",
                                      "unspecified", "two ways", "loses digits", "drivers differ"};
    return names.at(static_cast<std::size_t>(concern));
}

bool Audit::is_broken() const {
    return std::ranges::any_of(
        findings, [](const AuditFinding& finding) { return finding.concern < Concern::unspecified; });
}

namespace {

using internal::AuditRuns;
using internal::digits_of;
using internal::Reading;

constexpr double least_lost = 2.0;      // decimal digits that are worth a line
constexpr double same_share = 0.9;      // of a loss, that a simpler input must keep
constexpr std::size_t most_places = 4;  // findings of one concern

AuditLocation place_of(const ExplainedStep& step) {
    return {step.file, step.line, step.function, step.undefined.empty() ? step.operation : step.undefined};
}

// The operation at which the width of what is permitted, beside the exact value and that of one rounding,
// grows by the largest factor.
AuditLocation widest_place(const Explanation& all) {
    double widest = 0.0;
    double most = 0.0;
    AuditLocation place;
    for (const ExplainedStep& step : all.steps) {
        const double span = step.permitted.high - step.permitted.low;
        const double width = std::isfinite(span) && step.exact != 0.0 ? span / std::abs(step.exact) : 0.0;
        if (const double growth = (width - widest) / (widest + 0x1p-24); growth > most) {
            most = growth;
            place = place_of(step);
        }
        widest = std::max(widest, width);
    }
    return place;
}

AuditRuns::Gaps gaps_of(Concern concern) {
    return concern == Concern::unspecified ? AuditRuns::Gaps::open : AuditRuns::Gaps::closed;
}

// The output that shows a concern.
std::size_t output_of(Concern concern, const Reading& reading) {
    for (std::size_t w = 0; w < reading.outputs.size(); ++w)
        if (internal::shows(concern, reading.outputs[w])) return w;
    return 0;
}

// The findings of one function.
class Findings {
  public:
    Findings(AuditRuns& runs, internal::AuditSearch& search) : runs_(runs), search_(search) {}

    // The gravest first.
    [[nodiscard]] std::vector<AuditFinding> all() {
        for (const Concern concern : {Concern::fault, Concern::is_false}) {
            AuditFinding* const finding = add_first(concern, [&](const std::vector<Word>& words) {
                return internal::shows(concern, runs_.read(words));
            });
            if (finding != nullptr) finding->message = runs_.read(finding->words).fault;
        }
        for (const Concern concern : {Concern::not_finite, Concern::undefined, Concern::unspecified})
            add_places(concern);
        add_parting();
        add_loss();
        add_width();
        return std::move(all_);
    }

  private:
    using Still = std::function<bool(const std::vector<Word>&)>;

    // Of the first example; null: there is none.
    AuditFinding* add_first(Concern concern, const Still& still) {
        const internal::Examples& examples = search_.examples[concern];
        if (examples.random.empty() && examples.others.empty()) return nullptr;
        AuditFinding& finding =
            add(concern, (examples.random.empty() ? examples.others : examples.random).front(), still);
        finding.share = share_of(examples.shown);
        return &finding;
    }

    // The first operation with a result that is not finite, or of which every value is permitted.
    AuditLocation origin(Concern concern, const std::vector<Word>& words) {
        const Explanation steps = runs_.steps(words, gaps_of(concern));
        if (concern == Concern::undefined)
            for (const ExplainedStep& one : steps.result)
                if (!one.undefined.empty()) return place_of(one);
        const auto first = std::ranges::find_if(steps.steps, [concern](const ExplainedStep& step) {
            return concern == Concern::not_finite ? !std::isfinite(step.value)
                                                  : step.permitted.is_anything() || step.permitted.nan;
        });
        return first == steps.steps.end() ? AuditLocation{} : place_of(*first);
    }

    [[nodiscard]] bool is_so(Concern concern, const std::vector<Word>& words) {
        if (concern == Concern::not_finite) return internal::shows(concern, runs_.read(words));
        if (concern == Concern::unspecified && runs_.is_undefined(words, AuditRuns::Gaps::closed))
            return false;
        return runs_.is_undefined(words, gaps_of(concern));
    }

    // One finding for each operation at which the examples go wrong.
    void add_places(Concern concern) {
        const internal::Examples& examples = search_.examples[concern];
        std::map<AuditLocation, std::size_t> random;
        std::map<AuditLocation, std::vector<Word>> first;
        for (const std::vector<Word>& words : examples.random) {
            const AuditLocation from = origin(concern, words);
            ++random[from];
            first.try_emplace(from, words);
        }
        for (const std::vector<Word>& words : examples.others)
            first.try_emplace(origin(concern, words), words);
        std::size_t places = 0;
        for (const auto& [from, words] : first) {
            if (places++ == most_places) break;
            AuditFinding& finding = add(concern, words, [&, from = from](const std::vector<Word>& tried) {
                return is_so(concern, tried) && origin(concern, tried) == from;
            });
            finding.place = from;
            if (!examples.random.empty())
                finding.share = share_of(examples.shown) * static_cast<double>(random[from]) /
                                static_cast<double>(examples.random.size());
        }
    }

    void add_parting() {
        const auto parting_of = [this](const std::vector<Word>& words) {
            return runs_.parting_of(words, runs_.read(words));
        };
        AuditFinding* const finding = add_first(
            Concern::parting, [&](const std::vector<Word>& words) { return parting_of(words).has_value(); });
        const auto parting = finding == nullptr ? std::nullopt : parting_of(finding->words);
        if (!parting) return;
        finding->output = parting->output;
        finding->value = runs_.read(finding->words).outputs.at(parting->output).value;
        finding->exact = parting->other;
        finding->message = parting->driver == 0 ? "exactly" : "on another driver";
        finding->place = runs_.place_of(*parting, finding->words);
        finding->reservation = about_zero(runs_.steps(finding->words));
    }

    // A quotient that is exactly 0: no driver is known to be off there, but Vulkan's words permit it.
    static std::string about_zero(const Explanation& all) {
        const auto zero = std::ranges::find_if(all.steps, [](const ExplainedStep& step) {
            return step.operation == "OpFDiv" && step.exact == 0.0 && step.value == 0.0 &&
                   (step.permitted.low < 0.0 || step.permitted.high > 0.0);
        });
        if (zero == all.steps.end()) return {};
        return fmt::format("where a driver takes the 2.5 ULP of a quotient at an exact 0, {}",
                           to_text(place_of(*zero)));
    }

    // The worst input of a search, with simpler numbers that keep most of it; null: it is not worth a line.
    AuditFinding* add_worst(Concern concern) {
        const internal::Moves::Candidate& worst = search_.worst[concern];
        if (digits_of(worst.score) < least_lost) return nullptr;
        AuditFinding& finding = add(concern, worst.words, [&](const std::vector<Word>& words) {
            const Reading reading = runs_.read(words);
            return reading.fault.empty() &&
                   runs_.largest(concern, reading).relative >= same_share * worst.score;
        });
        finding.lost = digits_of(runs_.largest(concern, runs_.read(finding.words)).relative);
        return &finding;
    }

    void add_loss() {
        AuditFinding* const finding = add_worst(Concern::digits);
        if (finding == nullptr) return;
        const Explanation steps = runs_.steps(finding->words);
        if (steps.worst == steps.steps.size()) return;
        const ExplainedStep& step = steps.steps[steps.worst];
        finding->place = place_of(step);
        finding->cancels = std::abs(step.inherited()) > std::abs(step.local);
    }

    // All paths and all orders of sums; where these are too many to tell, those of one path.
    void add_width() {
        AuditFinding* const finding = add_worst(Concern::drivers);
        if (finding == nullptr) return;
        const Explanation steps = runs_.steps(finding->words);
        finding->place = widest_place(steps);
        finding->reservation = about_zero(steps);
        const numeric::Bounds bounds = runs_.permitted(finding->words).at(finding->output);
        if (!bounds.is_anything() && !bounds.nan) finding->permitted = bounds;
    }

    [[nodiscard]] double share_of(std::size_t shown) const {
        return search_.random == 0 ? 0.0 : static_cast<double>(shown) / static_cast<double>(search_.random);
    }

    AuditFinding& add(Concern concern, const std::vector<Word>& words, const Still& still) {
        AuditFinding& finding = all_.emplace_back(AuditFinding{.concern = concern});
        finding.words = simplified(runs_, words, still);
        finding.values = runs_.named(finding.words);
        const Reading reading = runs_.read(finding.words, gaps_of(concern));
        if (!reading.fault.empty()) return finding;
        finding.output =
            concern < Concern::digits ? output_of(concern, reading) : runs_.largest(concern, reading).output;
        const internal::OutputReading& output = reading.outputs.at(finding.output);
        finding.value = static_cast<double>(output.value);
        finding.exact = output.exact;
        finding.permitted = output.permitted;
        return finding;
    }

    AuditRuns& runs_;
    internal::AuditSearch& search_;
    std::vector<AuditFinding> all_;
};

// What each line of the source loses over some inputs, those included that nothing reached.
std::vector<AuditLine> lines_of(AuditRuns& runs, const std::vector<std::vector<Word>>& inputs,
                                const Coverage& coverage) {
    std::map<std::pair<std::string, unsigned>, double> losses;
    for (const Coverage::Point& point : coverage.points) losses[{point.file, point.line}] = 0.0;
    for (const std::vector<Word>& words : inputs) {
        double highest = 0.0;
        for (const ExplainedStep& step : runs.steps(words).steps) {
            double& lost = losses[{step.file, step.line}];
            if (!std::isfinite(step.ulps) || step.ulps <= highest) continue;
            lost = std::max(lost, std::min(digits_of(step.ulps, std::max(highest, 1.0)), float_digits));
            highest = step.ulps;
        }
    }
    std::vector<AuditLine> lines;
    for (const auto& [place, lost] : losses) lines.push_back({place.first, place.second, lost});
    return lines;
}

}  // namespace

Audit audit(const Lab& lab, const Question& asked, const std::vector<OrdinaryValues>& domain,
            const AuditOptions& options) {
    Question question = asked;
    const KernelSource source = lab.source(asked.file, asked.function, asked.signature);
    question.domain = domain_of(lab, asked, source);
    AuditRuns runs(lab, question, source, options.seed);
    internal::AuditSearch search = internal::search(runs, options);
    Audit all{.function = question.name.empty() ? question.function : question.name,
              .declaration = module::to_glsl({.name = question.function,
                                              .result = question.signature.result,
                                              .parameters = question.signature.parameters,
                                              .defined = true}),
              .file = question.file,
              .domain = domain,
              .random = search.random,
              .inputs = search.inputs,
              .too_long = search.too_long};
    if (!all.was_run()) return all;
    all.findings = Findings(runs, search).all();
    // Each run of an endless loop takes long.
    if (2 * search.examples[Concern::fault].shown > search.random) return all;
    all.coverage = measure_coverage(lab, question, {.inputs = options.inputs, .seed = options.seed});
    for (const AuditFinding& finding : all.findings) search.traced.push_back(finding.words);
    if (!all.findings.empty()) all.rewrites = internal::rewrites(lab, runs, search);
    all.lines = lines_of(runs, search.traced, all.coverage);
    return all;
}

Audit audit(const Lab& lab, const OwnFunction& own, const Ranges& ranges, const AuditOptions& options) {
    Question question = question_of(lab, own, ranges);
    const std::vector<OrdinaryValues> domain = ordinary_values(own, ranges);
    question.domain = ordinary_domain(own.function, domain);
    return audit(lab, question, domain, options);
}

void add_witness(Audit& audit, const Lab& lab, const Question& question, const AuditOptions& options) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    const std::vector<module::Scalar> scalars = question.signature.output_scalars();
    const ImageSet images = images_of(question.first_scenario(), options.seed);
    for (AuditFinding& finding : audit.findings) {
        const bool may_fault = finding.concern == Concern::parting && std::isnan(finding.exact);
        if (finding.concern == Concern::fault || may_fault) continue;
        const KernelCore::Result result = kernel.run(finding.words, 1, images);
        const double seen = number_at(scalars[finding.output], result.outputs[finding.output]);
        finding.witnesses.push_back({lab.info().name, seen});
    }
}

}  // namespace gloam::audit
