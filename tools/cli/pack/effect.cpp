// SPDX-License-Identifier: MIT
#include "cli/pack/effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "shader/compile.hpp"

namespace gloam::cli {
namespace {

std::map<std::uint32_t, std::uint32_t> values_of(const std::vector<gpu::SpecializationConstant>& constants) {
    std::map<std::uint32_t, std::uint32_t> values;
    for (const gpu::SpecializationConstant& constant : constants) values[constant.id] = constant.bits;
    return values;
}

PackedPass packed_pass(const effect::PlannedPass& planned, const scene::PassLibrary& library,
                       shader::Language language) {
    const effect::PassSource& source = planned.source;
    PackedPass pass{.plan = planned, .file = planned.name + ".comp"};
    const auto text_in = [&](shader::Language version) {
        return library.text(source.file, source.defines, source.replaced, values_of(source.constants),
                            version);
    };
    pass.text = text_in(shader::Language::vulkan450);
    pass.interface = shader::reflect(
        shader::compile({.name = pass.file, .text = pass.text}, {.stage = shader::Stage::compute}));
    if (language != shader::Language::vulkan450) pass.text = text_in(language);
    return pass;
}

// Format of an image that is bound where nothing is read.
gpu::Format format_named(const std::string& name) {
    static const std::map<std::string, gpu::Format> formats{{"r32f", gpu::Format::r32f},
                                                            {"rgba16f", gpu::Format::rgba16f},
                                                            {"rgba16ui", gpu::Format::rgba16ui},
                                                            {"r32ui", gpu::Format::r32ui}};
    const auto found = formats.find(name);
    return found == formats.end() ? gpu::Format::rgba32f : found->second;
}

// Binds an image of one texel, in the declared format, where the settings need no image.
void bind_nothing(PackedPass& pass, std::vector<effect::PlannedImage>& images) {
    for (const shader::Binding& binding : pass.interface.bindings) {
        if (resource_at(pass, binding) != effect::nothing_image) continue;
        // A sampled image may have any format of such numbers.
        const std::string sampled = binding.texel == "uint" ? "r32ui" : "rgba32f";
        const std::string wanted = binding.format.empty() ? sampled : binding.format;
        const std::string name = std::string(effect::nothing_image) + "_" + wanted;
        pass.plan.resources[binding.number] = name;
        if (std::ranges::find(images, name, &effect::PlannedImage::name) == images.end())
            images.push_back({.name = name,
                              .meaning = "for bindings that these settings do not read",
                              .format = format_named(wanted),
                              .extent = {1, 1},
                              .divisor = 0});
    }
}

}  // namespace

PackedEffect packed_effect(const effect::Settings& settings, const effect::PlanOptions& options,
                           const scene::PassLibrary& library, shader::Language language) {
    PackedEffect effect{
        .language = language, .settings = settings, .options = options, .plan = plan_of(settings, options)};
    std::set<std::string> bound{effect.plan.result, effect.plan.later_result};
    for (const effect::PlannedPass& planned : effect.plan.passes) {
        effect.passes.push_back(packed_pass(planned, library, language));
        bind_nothing(effect.passes.back(), effect.plan.images);
        for (const shader::Binding& binding : effect.passes.back().interface.bindings)
            bound.insert(resource_at(effect.passes.back(), binding));
    }
    const auto unbound = [&bound](const auto& resource) { return !bound.contains(resource.name); };
    std::erase_if(effect.plan.images, unbound);
    std::erase_if(effect.plan.buffers, unbound);
    return effect;
}

const std::string& resource_at(const PackedPass& pass, const shader::Binding& binding) {
    if (binding.set == 0 && binding.number < pass.plan.resources.size())
        return pass.plan.resources[binding.number];
    throw std::logic_error(fmt::format("{}: nothing is planned for binding {} of set {}", pass.file,
                                       binding.number, binding.set));
}

bool is_nothing(const std::string& resource) {
    return resource.starts_with(effect::nothing_image) || resource == effect::nothing_buffer;
}

bool is_of_view(const PackedPass& pass, const shader::LaidOut& member) {
    const auto first = pass.plan.of_view.begin() + static_cast<std::ptrdiff_t>(member.offset);
    return std::find(first, first + static_cast<std::ptrdiff_t>(member.size), true) !=
           first + static_cast<std::ptrdiff_t>(member.size);
}

std::string comment_of(const std::string& text, const std::string& block, const std::string& member) {
    const std::size_t begin = text.find(" " + block + " {");
    if (begin == std::string::npos) return "";
    const std::size_t end = text.find('}', begin);
    const std::string inside = text.substr(begin, end - begin);
    const std::regex line("\\b" + member + R"((?:\[[^\]]*\])?;[ \t]*//[ \t]*([^\n]*))");
    std::smatch found;
    return std::regex_search(inside, found, line) ? found[1].str() : "";
}

std::vector<Hazard> hazards_before(const PackedEffect& effect, std::size_t pass) {
    std::map<std::string, std::string> written;  // resource, and the last pass that wrote it
    std::map<std::string, std::string> read;     // the same for reads since then
    std::vector<Hazard> hazards;
    for (std::size_t i = 0; i <= pass; ++i) {
        const PackedPass& each = effect.passes[i];
        if (each.plan.turn == effect::Turn::once && i != pass) continue;
        for (const shader::Binding& binding : each.interface.bindings) {
            const std::string& name = resource_at(each, binding);
            if (is_nothing(name)) continue;
            if (i == pass && written.contains(name)) {
                hazards.push_back({name, written.at(name), true});
            } else if (i == pass && binding.writes && read.contains(name)) {
                hazards.push_back({name, read.at(name), false});
            }
        }
        for (const shader::Binding& binding : each.interface.bindings) {
            const std::string& name = resource_at(each, binding);
            (binding.writes ? written : read)[name] = each.plan.name;
            if (binding.writes) read.erase(name);
        }
    }
    return hazards;
}

}  // namespace gloam::cli
