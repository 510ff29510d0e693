// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "shader/compile.hpp"
#include "shader/internal/compiler_process.hpp"
#include "shader/internal/declarations.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/signature.hpp"
#include "shader/internal/version_line.hpp"

namespace gloam::shader {
namespace {

using internal::Declaration;
using internal::Signature;

bool defines(const std::vector<Declaration>& declared, const Declaration& wanted) {
    return std::ranges::any_of(declared, [&wanted](const Declaration& other) {
        return other.defined && internal::declare_the_same(other, wanted);
    });
}

// One declaration for each function, in the order of definition in the completed text: defined functions
// first, then those that are only declared.
std::vector<Declaration> in_order_of_definition(const std::vector<Declaration>& declared) {
    std::vector<Declaration> ordered;
    std::ranges::copy_if(declared, std::back_inserter(ordered), &Declaration::defined);
    for (const Declaration& declaration : declared)
        if (!defines(declared, declaration) && std::ranges::none_of(ordered, [&](const Declaration& other) {
                return declare_the_same(other, declaration);
            }))
            ordered.push_back(declaration);
    return ordered;
}

// Combines a function of the module with what only the text contains: directions, and the names of opaque
// types.
Function function_of(const Signature& signature, const Declaration& declaration) {
    Function function{signature.name, signature.result, signature.parameters, declaration.defined};
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        Parameter& parameter = function.parameters[i];
        const internal::DeclaredParameter& declared = declaration.parameters.at(i);
        parameter.direction = declared.direction;
        if (parameter.type.scalar == Scalar::unsupported && parameter.type.name.empty())
            parameter.type.name = declared.type;
        if (!declaration.defined) parameter.name.clear();
    }
    return function;
}

// The declaration of each function of the module; null for an added main. Functions of one name are in the
// same order on both sides.
std::vector<const Declaration*> paired(const std::vector<Signature>& signatures,
                                       const std::vector<Declaration>& declared) {
    std::vector<const Declaration*> pairs(signatures.size(), nullptr);
    for (const Declaration& declaration : declared) {
        std::size_t i = 0;
        while (i < pairs.size() && (pairs[i] || signatures[i].name != declaration.name)) ++i;
        if (i == pairs.size())
            throw std::logic_error("function '" + declaration.name + "' is not in its own module");
        pairs[i] = &declaration;
    }
    return pairs;
}

// In order of definition; a function that is only declared is listed at its first call.
std::vector<Function> listed(const std::vector<Signature>& signatures,
                             const std::vector<Declaration>& declared) {
    const std::vector<const Declaration*> pairs = paired(signatures, declared);
    std::vector<Function> functions;
    std::vector<bool> taken(pairs.size(), false);
    const auto take = [&](std::size_t i) {
        if (!taken[i]) functions.push_back(function_of(signatures[i], *pairs[i]));
        taken[i] = true;
    };
    for (const Declaration& declaration : declared) {
        if (!declaration.defined) break;  // those that are only declared come last
        const auto found = static_cast<std::size_t>(std::ranges::find(pairs, &declaration) - pairs.begin());
        take(found);
        for (const std::size_t called : signatures[found].calls)
            if (pairs[called] && !pairs[called]->defined) take(called);
    }
    return functions;
}

}  // namespace

std::vector<Function> internal::functions_here(const Source& source, const CompileOptions& options) {
    internal::require_vulkan_version(source);
    // The unchanged text is parsed first, so that messages have its line numbers.
    const internal::Parse parse(options.stage, internal::Client::vulkan, source.name, {source},
                                options.include_roots);
    const std::string text = internal::preprocessed(source, options.stage, options.include_roots);
    const std::vector<Declaration> declared = in_order_of_definition(internal::declarations(text));
    const Source whole{source.name, internal::completed(text, declared)};
    const Spirv module =
        internal::to_spirv(whole, options.stage, {}, {.unreached = internal::Unreached::kept});
    return listed(internal::signatures(module), declared);
}

}  // namespace gloam::shader
