// SPDX-License-Identifier: MIT
#include "audit/mutant.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "audit/internal/runs.hpp"
#include "audit/internal/search.hpp"
#include "base/pattern.hpp"
#include "module/spirv.hpp"
#include "numeric/numbers.hpp"
#include "subject/kernel_code.hpp"

namespace gloam::audit {

using namespace subject;

std::string name_of(Difference difference) {
    static constexpr std::array names{"same on every input tried", "differs only where nothing is promised",
                                      "differs within the budget", "differs", "not compared"};
    return names.at(static_cast<std::size_t>(difference));
}

namespace {

constexpr double small_error = 4.0;  // ULP

// Whether a text has conditions besides the guard of an include.
bool has_conditions(const std::string& text) {
    static const base::Pattern condition(R"((?:^|\n)[ \t]*#[ \t]*if\w*)");
    const std::vector<std::string> all = condition.all(text);
    return !all.empty() && (all.size() > 1 || !all.front().ends_with("ifndef"));
}

bool is_same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

std::string numbers_text(const std::vector<double>& numbers) {
    constexpr double exact = 0x1p53;
    std::vector<std::string> texts;
    for (const double x : numbers)
        texts.push_back(std::isnan(x)                               ? "NaN"
                        : std::abs(x) < exact && x == std::floor(x) ? fmt::format("{:.0f}", x)
                                                                    : fmt::format("{:.9g}", x));
    return numbers.empty() ? "no result" : fmt::format("{}", fmt::join(texts, ", "));
}

// The ordinary domain of a function, but a parameter of which nothing is known has all values of its type.
Domain wide_domain(const OwnFunction& own, const Domain& any) {
    std::vector<OrdinaryValues> ordinary = ordinary_values(own, {});
    std::size_t k = 0;
    for (const module::Parameter& parameter : own.function.parameters) {
        if (parameter.direction == source::Direction::out) continue;
        const Values& all = any.parameters().at(k++);
        const auto known = std::ranges::find(ordinary, parameter.name, &OrdinaryValues::parameter);
        if (known != ordinary.end() && known->reason == "type") known->values = all;
    }
    return ordinary_domain(own.function, ordinary);
}

// Vulkan promises no NaN: a driver may give any number in its place.
Difference difference_of(module::Scalar scalar, double before, double after,
                         const numeric::Bounds& permitted) {
    if (is_same(before, after)) return Difference::none;
    if (std::isnan(before) || permitted.is_anything()) return Difference::unpromised;
    if (std::isnan(after)) return permitted.nan ? Difference::budget : Difference::real;
    const bool finite = module::is_float(scalar) && std::isfinite(before);
    const bool near = finite && std::abs(before - after) <= small_error * format_of(scalar).ulp(before);
    return near || permitted.contains(after) ? Difference::budget : Difference::real;
}

// Of an input.
Difference difference_at(internal::AuditRuns& original, internal::AuditRuns& changed,
                         const std::vector<Word>& words) {
    using Gaps = internal::AuditRuns::Gaps;
    const std::vector<double> before = original.in_float(words);
    const std::vector<double> after = changed.in_float(words);
    if (std::ranges::equal(before, after, is_same)) return Difference::none;
    if (before.empty() || original.is_undefined(words, Gaps::closed) ||
        original.is_undefined(words, Gaps::open))
        return Difference::unpromised;
    if (after.empty()) return Difference::real;
    const std::vector<module::Scalar> scalars = original.question().signature.output_scalars();
    const std::vector<numeric::Bounds> permitted = original.permitted(words);
    Difference worst = Difference::none;
    for (std::size_t w = 0; w < before.size(); ++w)
        worst = std::max(worst, difference_of(scalars[w], before[w], after[w], permitted[w]));
    return worst;
}

}  // namespace

MutantFile::MutantFile(std::filesystem::path path, std::string text, std::vector<std::filesystem::path> roots)
    : path_(std::move(path)),
      text_(std::move(text)),
      roots_(std::move(roots)),
      mutations_(module::mutations({path_.string(), text_}, roots_)),
      conditional_(has_conditions(text_)),
      whole_(whole(text_)) {
    try {
        module::require_valid({path_.string(), text_}, roots_);
    } catch (const source::CompileError& error) {
        trouble_ = error.what();
    }
    const LabOptions options{.device = std::string(interpreter_name),
                             .file = std::make_shared<const OwnFile>(path_, text_, roots_)};
    lab_.emplace(options);
    for (OwnFunction& function : own_functions(options).found) {
        try {
            module::Spirv module = module::without_names(module_of(function, function.text));
            own_.push_back({std::move(function), std::move(module)});
        } catch (const source::CompileError&) {
            continue;  // a kernel of it is no valid module: what a fault does to it is not known
        }
    }
}

module::Spirv MutantFile::module_of(const OwnFunction& own, const std::string& text) const {
    KernelSource source = lab_->source(path_.filename().string(), own.function.name, own.signature());
    source.text = text;
    source.preserve_nan = false;  // under that mode SPIRV-Tools folds nothing
    const module::CompileOptions options{.stage = stage_of(source.team),
                                         .include_roots = roots_,
                                         .variant = {.optimization = module::Optimization::performance}};
    return module::compile({.name = "mutant", .text = kernel_code(source)}, options);
}

std::optional<module::Spirv> MutantFile::whole(const std::string& text) const {
    const auto stage = source::stage_of_file(path_);
    if (!stage) return std::nullopt;
    try {
        return module::without_names(module::compile(
            {path_.string(), text}, {.stage = *stage,
                                     .include_roots = roots_,
                                     .variant = {.optimization = module::Optimization::performance}}));
    } catch (const source::CompileError&) {
        return std::nullopt;  // of another version, for example
    }
}

std::vector<std::pair<const MutantFile::Own*, std::string>> MutantFile::changed_in(
    const std::string& text) const {
    std::vector<std::pair<const Own*, std::string>> changed;
    const OwnFile file(path_, text, roots_);
    for (const Own& own : own_) {
        const source::Excerpt* found = file.find(own.function.function.name);
        if (found != nullptr && found->text != own.function.text) changed.emplace_back(&own, found->text);
    }
    return changed;
}

Change MutantFile::change_of(const source::Mutation& mutation) const {
    const std::string text = source::mutated(text_, mutation);
    try {
        if (trouble_.empty()) module::require_valid({path_.string(), text}, roots_);  // what no kernel holds
        bool all_same = !conditional_ && !mutation.function.empty();
        bool known = false;
        for (const auto& [own, changed] : changed_in(text)) {
            known = true;
            all_same = module::without_names(module_of(own->function, changed)) == own->module && all_same;
        }
        if (whole_) {
            const auto module = whole(text);
            if (!module) return Change::invalid;
            all_same = *module == *whole_ && all_same;
            known = known || mutation.function == "main";
        }
        return known && all_same ? Change::same : Change::other;
    } catch (const source::CompileError&) {
        return Change::invalid;
    }
}

MutantComparison MutantFile::compare(const source::Mutation& mutation, std::size_t inputs,
                                     std::uint64_t seed) const {
    const auto changed = changed_in(source::mutated(text_, mutation));
    MutantComparison worst{.function = mutation.function};
    for (const bool own_only : {true, false}) {
        for (const auto& [own, text] : changed) {
            if ((own->function.function.name == mutation.function) != own_only) continue;
            MutantComparison one = compare(*own, text, inputs, seed);
            if (one.difference != Difference::unknown &&
                (worst.difference == Difference::unknown || one.difference > worst.difference))
                worst = std::move(one);
        }
        if (worst.difference != Difference::unknown) break;  // what calls it can show no more
    }
    return worst;
}

MutantComparison MutantFile::compare(const Own& own, const std::string& changed, std::size_t inputs,
                                     std::uint64_t seed) const {
    const std::string file = path_.filename().string();
    MutantComparison result{.function = own.function.name};
    try {
        judge::Question question = judge::question_of(*lab_, own.function, {});
        question.domain = wide_domain(own.function, question.domain);
        for (const std::string& text : {own.function.text, changed})
            question.domain = question.domain.and_numbers(
                question.signature, module::float_constants(module_of(own.function, text)));
        KernelSource source = lab_->source(file, question.function, question.signature);
        internal::AuditRuns original(*lab_, question, source, seed);
        source.text = changed;
        internal::AuditRuns mutant(*lab_, question, source, original);
        const Domain::Inputs drawn = question.domain.draw(inputs, seed, original.image_size());
        result.difference = Difference::none;
        for (std::size_t i = 0; i < drawn.count() && result.difference != Difference::real; ++i) {
            const std::vector<Word> words(drawn.row(i).begin(), drawn.row(i).end());
            const Difference found = difference_at(original, mutant, words);
            ++result.inputs;
            if (found <= result.difference) continue;
            result.difference = found;
            result.words = words;
        }
        if (result.difference == Difference::none) return result;
        result.words = internal::simplified(original, result.words, [&](const std::vector<Word>& tried) {
            return difference_at(original, mutant, tried) == result.difference;
        });
        result.values = original.named(result.words);
        result.before = numbers_text(original.in_float(result.words));
        result.after = numbers_text(mutant.in_float(result.words));
    } catch (const interpreter::Error&) {
        result.difference = Difference::unknown;
    } catch (const source::CompileError&) {
        result.difference = Difference::unknown;
    }
    return result;
}

}  // namespace gloam::audit
