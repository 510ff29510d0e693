// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "module/internal/cross.hpp"
#include "module/internal/front_end.hpp"
#include "module/texts.hpp"
#include "source/declarations.hpp"
#include "source/plain_global.hpp"

namespace gloam::module {
namespace {

using source::internal::DeclaredParameter;
using source::internal::FunctionHead;

void require_values(const std::string& name, const source::internal::FunctionHead& function) {
    for (const source::internal::DeclaredParameter& parameter : function.parameters)
        if (source::internal::is_opaque(parameter.type))
            throw std::invalid_argument(name + ": " + function.name + " has a parameter of type " +
                                        parameter.type +
                                        ": functions with images as parameters are not translated");
}

// A main() that calls every function once: SPIRV-Cross writes what main() reaches.
std::string caller_of(const std::vector<source::internal::FunctionHead>& functions) {
    std::string variables;
    std::string calls;
    std::size_t count = 0;
    for (const source::internal::FunctionHead& function : functions) {
        std::string arguments;
        for (const source::internal::DeclaredParameter& parameter : function.parameters) {
            const std::string name = "argument" + std::to_string(count++);
            variables += parameter.type + " " + name + ";\n";
            arguments += (arguments.empty() ? "" : ", ") + name;
        }
        calls += function.name + "(" + arguments + ");\n";
    }
    return "\nvoid main() {\n" + variables + calls + "}\n";
}

// The text with a main(), and with bodies of the functions that its user defines.
std::string whole(const source::Source& packed, source::Stage stage) {
    std::vector<source::internal::FunctionHead> functions =
        source::internal::function_heads(internal::preprocessed(packed, stage, {}));
    if (std::ranges::find(functions, "main", &source::internal::FunctionHead::name) != functions.end())
        return packed.text;
    for (const source::internal::FunctionHead& function : functions) require_values(packed.name, function);
    const std::string text = packed.text + caller_of(functions);
    functions.push_back({.name = "main", .result = "void", .text = "", .parameters = {}, .defined = true});
    return source::internal::completed(text, functions);
}

std::string licences_of(const std::string& text) {
    std::istringstream lines(text);
    std::string licences;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("//") && line.find("SPDX-License-Identifier") != std::string::npos)
            licences += line + "\n";
    return licences;
}

}  // namespace

std::optional<Target> target_from(std::string_view name) {
    if (name == "hlsl") return Target::hlsl;
    if (name == "msl") return Target::msl;
    return std::nullopt;
}

std::string suffix(Target target) {
    return target == Target::hlsl ? ".hlsl" : ".metal";
}

std::string translated(const source::Source& packed, Target target, source::Stage stage) {
    const bool hlsl = target == Target::hlsl;
    const char* head =
        hlsl ? "// HLSL of shader model 6.0 by SPIRV-Cross. Compile it by IEEE's rules (dxc -Gis).\n"
             : "// Metal Shading Language 2.1 by SPIRV-Cross. Compile it without fast math.\n";
    try {
        const Spirv module = internal::to_spirv({packed.name, whole(packed, stage)}, stage, {});
        return licences_of(packed.text) + head +
               (hlsl ? internal::to_direct3d_hlsl(module) : internal::to_msl(module));
    } catch (const source::CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(packed.name + ": " + error.what());
    }
}

}  // namespace gloam::module
