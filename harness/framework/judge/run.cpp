// SPDX-License-Identifier: MIT
#include "judge/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "interpreter/program.hpp"
#include "judge/explain.hpp"
#include "judge/interpretation.hpp"
#include "judge/session.hpp"

namespace gloam::judge {
namespace {

using namespace subject;

// A few inputs of all kinds, the beginning of a larger draw. Each is compiled code, so the scenarios of a
// question share their number.
Domain::Inputs few_inputs(const Domain& domain, std::size_t scenarios, std::uint64_t seed,
                          glm::ivec2 image_size) {
    constexpr std::size_t spread = 16;
    constexpr std::size_t least = 8;
    const std::size_t count = std::max(least, most_constants / std::max<std::size_t>(scenarios, 1));
    return domain.draw(spread * count, seed, image_size).where([](std::size_t i) { return i % spread == 0; });
}

std::size_t distinct_of(const Domain::Inputs& inputs) {
    std::set<std::vector<Word>> rows;
    for (std::size_t i = 0; i < inputs.count(); ++i) rows.emplace(inputs.row(i).begin(), inputs.row(i).end());
    return rows.size();
}

// Inputs of many words are fewer: those of a run take 256 MiB at most.
std::size_t inputs_of_run(const Question& question, std::size_t wanted) {
    constexpr std::size_t most_words = std::size_t{1} << 26U;
    const std::size_t words = question.signature.input_words() + question.signature.output_words();
    return std::min(wanted, most_words / std::max<std::size_t>(words, 1));
}

// Throws the error that invocations disturb each other with the lines of the source, which the module of a
// kernel need not have.
void throw_with_lines(const Lab& lab, const Question& question, std::uint64_t seed) {
    constexpr std::size_t most_inputs = 4096;
    const KernelSource source = lab.source(question.file, question.function, question.signature);
    const ImageScenario scenario = question.first_scenario();
    const Decoded decoded =
        decode({std::make_shared<const KernelModule>(lined_module(lab, source))}, images_of(scenario, seed));
    Interpretation doubles(decoded, question.signature);
    std::vector<double> outputs;
    const Domain::Inputs inputs = question.domain.draw(most_inputs, seed, scenario.size);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        try {
            doubles.calculate({i, inputs.row(i)}, outputs);
        } catch (const interpreter::Error& error) {
            if (!error.is_of_group()) continue;
            throw interpreter::Error(
                error.kind(), fmt::format("{}: {}: {}", question.file, question.function, error.what()));
        }
    }
}

}  // namespace

Answer run(const Lab& lab, const Question& question, const RunOptions& options) {
    if (question.answers) return question.answers(lab);
    const module::Variant& variant = lab.options().variant;
    try {
        const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
        const Domain domain = domain_of(lab, question, *kernel.module().source);
        Answer answer = empty_answer(question, question.criterion_in(variant));
        for (const auto& [scenario, share] : question.shares(inputs_of_run(question, options.inputs))) {
            const Session session(lab, question, kernel, scenario, options.seed);
            const std::uint64_t seed = session.input_seed();
            const Domain::Inputs drawn =
                variant.constants == module::Variant::Constants::none
                    ? domain.draw(share, seed, scenario.size)
                    : few_inputs(domain, question.scenarios.size(), seed, scenario.size);
            if (question.must_hold) answer.distinct += distinct_of(drawn);
            Domain::Inputs inputs = session.without_long_runs(drawn, answer);
            if (inputs.count() > 0) session.judge(session.run(std::move(inputs), answer), answer);
        }
        complete(answer, lab, question, kernel.module(), options.seed);
        return answer;
    } catch (const interpreter::Error& error) {
        if (error.is_of_group() && !lab.compile_options().lines)
            throw_with_lines(lab, question, options.seed);
        throw;
    }
}

}  // namespace gloam::judge
