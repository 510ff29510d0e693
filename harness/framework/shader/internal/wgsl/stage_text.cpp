// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/stage_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shader/internal/wgsl/function_writer.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

struct Builtin {
    std::string name;
    std::string type;  // where it is another one than in GLSL: the value is converted
};

const std::map<std::uint32_t, Builtin>& builtins_read() {
    static const std::map<std::uint32_t, Builtin> names{{SpvBuiltInVertexIndex, {"vertex_index", "u32"}},
                                                        {SpvBuiltInInstanceIndex, {"instance_index", "u32"}},
                                                        {SpvBuiltInFragCoord, {"position", ""}},
                                                        {SpvBuiltInFrontFacing, {"front_facing", ""}},
                                                        {SpvBuiltInSampleId, {"sample_index", "u32"}}};
    return names;
}

std::string listed(const std::vector<std::string>& parts) {
    std::string list;
    for (const std::string& part : parts) list += (list.empty() ? "" : ", ") + part;
    return list;
}

}  // namespace

StageText::StageText(ModuleText& text, const std::set<Id>& used)
    : text_(text), module_(text.module()), used_(used) {}

std::string StageText::global(const Variable& variable) const {
    return fmt::format("var<private> {}: {};\n", text_.name(variable.id), text_.type(variable.type));
}

// "@location(2) @interpolate(flat)"
std::string StageText::location(const Variable& variable) const {
    const Decorations decorations = module_.decorations_of(variable.id);
    const Type& type = module_.type(variable.type);
    const std::string name = module_.name_of(variable.id);
    const bool number =
        type.kind == TypeKind::vector || type.kind == TypeKind::real || type.kind == TypeKind::integer;
    if (!decorations.location || !number || module_.is_bool(variable.type))
        throw NotTranslated("an input or output of a stage that is no number or vector: " + name);
    if (decorations.special_location)
        throw NotTranslated("a part of a location, or an interpolation within the pixel: " + name);
    const char* how = decorations.flat             ? " @interpolate(flat)"
                      : decorations.no_perspective ? " @interpolate(linear)"
                                                   : "";
    return fmt::format("@location({}){}", *decorations.location, how);
}

std::vector<StageText::Port> StageText::inputs(std::uint32_t model) const {
    std::vector<Port> all;
    for (const Variable& variable : module_.variables) {
        if (variable.storage != SpvStorageClassInput || !used_.contains(variable.id)) continue;
        const std::string& name = text_.name(variable.id);
        Port port{.mark = {},
                  .name = text_.names.take(name + "_given"),
                  .type = text_.type(variable.type),
                  .value = {}};
        port.value = port.name;
        if (const auto number = module_.decorations_of(variable.id).built_in) {
            const auto builtin = builtins_read().find(*number);
            if (builtin == builtins_read().end())
                throw NotTranslated("the builtin value " + module_.name_of(variable.id));
            port.mark = fmt::format("@builtin({})", builtin->second.name);
            if (!builtin->second.type.empty()) {
                port.value = fmt::format("{}({})", port.type, port.name);
                port.type = builtin->second.type;
            }
        } else {
            port.mark = location(variable);
            // Vertices are not interpolated.
            if (model == SpvExecutionModelVertex) port.mark = port.mark.substr(0, port.mark.find(' '));
        }
        port.value = fmt::format("{} = {}", name, port.value);
        all.push_back(port);
    }
    return all;
}

std::vector<StageText::Port> StageText::outputs(std::uint32_t model) const {
    std::vector<Port> all;
    for (const Variable& variable : module_.variables) {
        if (variable.storage != SpvStorageClassOutput || !used_.contains(variable.id)) continue;
        const std::string& name = text_.name(variable.id);
        const Type& type = module_.type(variable.type);
        const Decorations decorations = module_.decorations_of(variable.id);
        if (type.kind == TypeKind::structure) {  // gl_PerVertex
            for (std::uint32_t m = 0; m < type.members.size(); ++m) {
                if (type.members[m].built_in != SpvBuiltInPosition) continue;
                const std::string value = name + "." + text_.member_name(variable.type, m);
                // Vulkan's y of the clip space goes down, WebGPU's goes up.
                all.push_back({"@builtin(position)", "position", text_.type(type.members[m].type),
                               fmt::format("{} * vec4f(1.0, -1.0, 1.0, 1.0)", value)});
            }
        } else if (decorations.built_in) {
            if (decorations.built_in != SpvBuiltInFragDepth)
                throw NotTranslated("the builtin value " + module_.name_of(variable.id));
            all.push_back({"@builtin(frag_depth)", "frag_depth", text_.type(variable.type), name});
        } else {
            std::string mark = location(variable);
            if (model == SpvExecutionModelFragment) mark = mark.substr(0, mark.find(' '));
            all.push_back({mark, name, text_.type(variable.type), name});
        }
    }
    return all;
}

std::string StageText::entry_point(std::uint32_t model, const std::string& body) const {
    const bool vertex = model == SpvExecutionModelVertex;
    std::vector<std::string> parameters;
    std::string statements;
    for (const Port& input : inputs(model)) {
        parameters.push_back(fmt::format("{} {}: {}", input.mark, input.name, input.type));
        statements += fmt::format("    {};\n", input.value);
    }
    std::string members;
    std::vector<std::string> results;
    const std::vector<Port> written = outputs(model);
    if (vertex && std::ranges::find(written, "@builtin(position)", &Port::mark) == written.end())
        throw NotTranslated("a vertex shader that sets no gl_Position");
    for (const Port& output : written) {
        members += fmt::format("    {} {}: {},\n", output.mark, output.name, output.type);
        results.push_back(output.value);
    }
    const std::string structure = text_.names.take("Outputs");
    const std::string head = written.empty()
                                 ? fmt::format("fn main({}) {{", listed(parameters))
                                 : fmt::format("fn main({}) -> {} {{", listed(parameters), structure);
    std::string text = written.empty() ? "" : fmt::format("struct {} {{\n{}}}\n\n", structure, members);
    text +=
        fmt::format("@{}\n{}\n{}    {}();\n", vertex ? "vertex" : "fragment", broken(head), statements, body);
    if (!written.empty())
        text += broken(fmt::format("    return {}({});", structure, listed(results))) + "\n";
    return text + "}\n";
}

}  // namespace gloam::shader::internal::wgsl
