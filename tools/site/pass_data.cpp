// SPDX-License-Identifier: MIT
#include "site/page_data.hpp"

#include <regex>
#include <sstream>

#include "shader/pack.hpp"
#include "shader/reflection.hpp"

namespace gloam::site {
namespace {

using nlohmann::ordered_json;
using shader::Stage;

// A declaration of a line of its own. The comment behind it stays there.
const std::regex& declaration() {
    static const std::regex line(R"(^(uniform|in|out) (\w+) (\w+);(.*)$)");
    return line;
}

bool is_image(const std::string& type) {
    return type.find("sampler") != std::string::npos;
}

std::string packed(const PassText& pass, const std::string& text, shader::Language language,
                   const ShaderFolders& folders) {
    return shader::pack({shader::Source{.name = pass.name, .text = text}},
                        {.language = language, .stage = pass.stage}, {folders.library});
}

std::string type_of(const shader::LaidOut& member) {
    const std::string sign = member.type == "float" ? "" : member.type.substr(0, 1);
    if (member.columns > 1) return "mat" + std::to_string(member.columns);
    return member.rows > 1 ? sign + "vec" + std::to_string(member.rows) : member.type;
}

void add_values(const std::vector<shader::LaidOut>& members, std::size_t start, ordered_json& values) {
    for (const shader::LaidOut& member : members) {
        if (member.members.empty())
            values.push_back({member.name, type_of(member), start + member.offset});
        else
            add_values(member.members, start + member.offset, values);
    }
}

ordered_json webgpu_pass(const PassText& pass, const ShaderFolders& folders) {
    const std::string text = packed(pass, for_vulkan(pass), shader::Language::vulkan450, folders);
    const shader::ModuleInterface interface =
        shader::reflect(shader::compile({pass.name, text}, {.stage = pass.stage}));
    ordered_json json{
        {"text", condensed(shader::translated({pass.name, text}, shader::Target::wgsl, pass.stage))},
        {"bytes", 0},
        {"values", ordered_json::array()},
        {"images", ordered_json::array()},
        {"constants", ordered_json::object()}};
    for (const shader::Binding& binding : interface.bindings) {
        if (!binding.block) {
            json["images"].push_back({binding.name, binding.number});
            continue;
        }
        json["bytes"] = (binding.block->size + 15) / 16 * 16;
        add_values(binding.block->members, 0, json["values"]);
    }
    // Another constant of the same value may have given its name to the one of the module.
    static const std::regex constant(R"(constant_id = (\d+)\) const \w+ (\w+))");
    for (std::sregex_iterator i(text.begin(), text.end(), constant), end; i != end; ++i)
        json["constants"][(*i)[2]] = std::stoi((*i)[1]);
    return json;
}

}  // namespace

std::string for_vulkan(const PassText& pass) {
    const std::string set = "set = " + std::to_string(pass.stage == Stage::vertex ? 1 : 0);
    std::istringstream lines(
        std::regex_replace(pass.text, std::regex(R"(\bgl_VertexID\b)"), "gl_VertexIndex"));
    std::vector<std::string> written;
    std::string members;
    std::size_t end = 0;  // of the uniforms
    int images = 0;
    std::map<std::string, int> ports;
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, declaration())) {
            written.push_back(line);
        } else if (found[1] != "uniform") {
            written.push_back("layout(location = " + std::to_string(ports[found[1]]++) + ") " + line);
        } else if (is_image(found[2])) {
            written.push_back("layout(" + set + ", binding = " + std::to_string(++images) + ") " + line);
        } else {
            members += "    " + found[2].str() + " " + found[3].str() + ";" + found[4].str() + "\n";
            end = written.size();
        }
    }
    const std::string block = "layout(" + set + ", binding = 0, std140) uniform Values {\n" + members + "};";
    if (!members.empty()) written.insert(written.begin() + static_cast<std::ptrdiff_t>(end), block);
    std::string text;
    for (const std::string& line : written) text += line + "\n";
    return text;
}

ordered_json pass_json(const PassText& pass, Api api, const ShaderFolders& folders) {
    if (api == Api::webgpu) return webgpu_pass(pass, folders);
    return condensed(packed(pass, pass.text, shader::Language::es300, folders));
}

}  // namespace gloam::site
