// SPDX-License-Identifier: MIT
#include "check/explain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "check/interpreted_kernel.hpp"
#include "check/kernel_code.hpp"
#include "numeric/paths.hpp"
#include "numeric/ulp.hpp"
#include "shader/cache.hpp"

namespace gloam::check {
namespace {

using interpreter::Explained;

constexpr const char* kernel_name = "kernel";

shader::Function function_of(const shader::CompileOptions& options, const std::string& file,
                             const std::string& name) {
    const shader::Source probe{.name = "signature of " + file,
                               .text = fmt::format("#version 450\n#include \"{}\"\n", file)};
    for (const shader::Function& function : shader::SpirvCache().functions(probe, options))
        if (function.name == name && function.defined) return function;
    throw std::invalid_argument(fmt::format("{}: no function {}", file, name));
}

std::size_t words_of(const shader::Function& function, bool outputs) {
    const Signature signature{.result = function.result, .parameters = function.parameters};
    return outputs ? signature.output_words() : signature.input_words();
}

KernelModule module_of(const shader::CompileOptions& options, const std::string& file,
                       const shader::Function& function) {
    shader::CompileOptions with_lines = options;
    with_lines.lines = true;
    const KernelSource source{.file = file, .function = function, .images = {}};
    return {
        .spirv = shader::SpirvCache().compile({.name = kernel_name, .text = kernel_code(source)}, with_lines),
        .input_words = words_of(function, false),
        .output_words = words_of(function, true)};
}

void append(const interpreter::Step<Explained>& step, std::vector<ExplainedStep>& steps) {
    if (step.place.file.empty() || step.place.file == kernel_name) return;
    for (std::size_t k = 0; k < step.results.size(); ++k) {
        if (!step.results[k].is_number()) continue;
        const Explained x = step.results[k].number();
        ExplainedStep one{.file = step.place.file,
                          .line = step.place.line,
                          .function = step.place.function,
                          .operation = step.operation(),
                          .component = k,
                          .value = x.value,
                          .exact = x.exact,
                          .permitted = x.permitted.bounds(),
                          .error = static_cast<double>(x.value) - x.exact,
                          .local = x.local,
                          .ulps = numeric::ulp_error(x.value, x.exact)};
        if (std::isnan(one.error)) one.error = 0.0;  // one infinity is the other
        steps.push_back(std::move(one));
    }
}

// The error may come down again; what counts is by how much it rises above all before.
std::size_t worst_of(const std::vector<ExplainedStep>& steps) {
    std::size_t worst = steps.size();
    double highest = 0.0;
    double rise = 0.0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].ulps - highest > rise) {
            rise = steps[i].ulps - highest;
            worst = i;
        }
        highest = std::max(highest, steps[i].ulps);
    }
    return worst;
}

}  // namespace

std::vector<shader::Scalar> inputs_of(const shader::CompileOptions& options, const std::string& file,
                                      const std::string& function) {
    const shader::Function found = function_of(options, file, function);
    return Signature{.result = found.result, .parameters = found.parameters}.input_scalars();
}

Explanation explain(const shader::CompileOptions& options, const std::string& file,
                    const std::string& function, std::span<const Word> input) {
    const shader::Function found = function_of(options, file, function);
    const KernelModule module = module_of(options, file, found);
    if (input.size() != module.input_words)
        throw std::invalid_argument(fmt::format("{} takes {} values, got {}", shader::to_glsl(found),
                                                module.input_words, input.size()));
    const interpreter::Program program(module.spirv);
    InterpretedKernel<Explained> kernel(program, module, {});
    Explanation all;
    // The path is that of float32; what intervals alone leave open is taken as it comes first.
    (void)numeric::Paths::explore(numeric::float32, 1, [&] {
        kernel.run(input, [&](const interpreter::Step<Explained>& step) { append(step, all.steps); });
        throw numeric::Paths::Enough{};
    });
    all.worst = worst_of(all.steps);
    return all;
}

}  // namespace gloam::check
