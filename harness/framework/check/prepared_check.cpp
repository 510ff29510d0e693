// SPDX-License-Identifier: MIT
#include "check/prepared_check.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "backend/gl/kernel.hpp"
#include "check/internal/budget_judge.hpp"
#include "check/internal/kernel_text.hpp"
#include "check/session.hpp"
#include "numeric/numbers.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

double least_float_from(double x) {
    const auto nearest = static_cast<float>(x);
    return static_cast<double>(nearest) < x ? numeric::step(nearest, 1) : nearest;
}

// Beside these values other floats are allowed, too: numeric::ulp_error().
bool is_plain(double want) {
    return std::abs(want) >= 0x1p-126 && std::abs(want) <= 0x1.fffffep127;
}

// Whether the outputs that the budget allows around `want` are among those around `other`.
bool allows_no_more(const Question& question, const std::vector<double>& want,
                    const std::vector<double>& other) {
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    const std::vector<numeric::Bounds> a = internal::allowed_around(question, want);
    const std::vector<numeric::Bounds> b = internal::allowed_around(question, other);
    for (std::size_t i = 0; i < want.size(); ++i) {
        if (want[i] == other[i] && a[i] == b[i]) continue;
        if (scalars[i] != Scalar::float_ || !is_plain(want[i]) || !is_plain(other[i]) ||
            least_float_from(a[i].low) < least_float_from(b[i].low) ||
            least_float_from(-a[i].high) < least_float_from(-b[i].high))
            return false;
    }
    return true;
}

Expectation expectation_of(const Question& question, const ImageSet& images, const internal::Scalars& scalars,
                           std::span<const Word> inputs, bool branch) {
    Sample sample{.inputs = {inputs.begin(), inputs.end()}};
    sample.input_class = internal::class_of(sample.inputs, scalars.inputs, branch);
    question.reference(images, sample.inputs, sample.want);
    Expectation all{.input_class = sample.input_class, .wants = {sample.want}};
    if (internal::holds_special(sample, scalars.inputs)) return all;
    const bool promised = !question.promised || question.promised(sample.inputs);
    const bool edge = !promised && internal::is_edge(sample, scalars);
    all.criterion = promised ? Criterion::budget : edge ? Criterion::edge : Criterion::codomain;
    const auto add = [&](const std::vector<Word>& moved) {
        std::vector<double> want;
        question.reference(images, moved, want);
        const auto is_covered = [&](const std::vector<double>& other) {
            return edge ? want == other : allows_no_more(question, want, other);
        };
        if (std::ranges::none_of(all.wants, is_covered)) all.wants.push_back(std::move(want));
        return false;
    };
    if (promised) internal::visit_covered_inputs(question.budget, scalars.inputs, sample.inputs, add);
    if (edge) internal::visit_edge_inputs(scalars, sample.inputs, add);
    return all;
}

PreparedScenario prepare_scenario(const Question& question, const Domain& domain, const KernelSource& source,
                                  const ImageScenario& scenario, std::size_t count, std::uint64_t seed) {
    const ImageSet images = images_of(scenario, seed);
    const internal::Scalars scalars(question.signature);
    PreparedScenario prepared{
        .name = scenario.name,
        .images = images,
        .image_words = image_words(source.images, images, question.function),
        .inputs = domain.draw(count, input_seed_of(question, scenario, seed), scenario.size),
        .expectations = {}};
    internal::set_positive_zeros(prepared.inputs.words, question.signature.input_scalars());
    for (std::size_t i = 0; i < prepared.inputs.count(); ++i)
        prepared.expectations.push_back(
            expectation_of(question, images, scalars, prepared.inputs.row(i), prepared.inputs.branch[i]));
    return prepared;
}

}  // namespace

PreparedCheck prepare(const Lab& lab, const Question& question, const RunOptions& options) {
    if (!question.reference || question.only_rules)
        throw std::invalid_argument(question.function + ": has no reference to judge by");
    const KernelSource source = lab.source(question.file, question.function, question.signature);
    internal::require_alone(source, "a browser");
    PreparedCheck prepared;
    try {
        prepared.kernel =
            internal::gl_kernel_code(shader::Language::es300, source, lab.options().include_roots);
    } catch (const backend::Unsupported& reason) {
        prepared.unsupported = reason.what();
        return prepared;
    }
    prepared.row_words = gl::kernel_row(question.signature.output_words(), source.images.size());
    prepared.targets = gl::kernel_targets(prepared.row_words);
    const Domain domain = domain_of(lab, question);
    for_each_scenario(question, options.inputs, [&](const ImageScenario& scenario, std::size_t share) {
        prepared.scenarios.push_back(
            prepare_scenario(question, domain, source, scenario, share, options.seed));
    });
    return prepared;
}

}  // namespace gloam::check
