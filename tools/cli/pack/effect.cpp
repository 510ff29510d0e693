// SPDX-License-Identifier: MIT
#include "cli/pack/effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "base/version.hpp"
#include "cli/arguments.hpp"
#include "cli/environment.hpp"
#include "cli/render.hpp"
#include "cli/settings.hpp"
#include "report/output.hpp"
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
    static const std::map<std::string, gpu::Format> formats{
        {"r32f", gpu::Format::r32f}, {"rgba16ui", gpu::Format::rgba16ui}, {"r32ui", gpu::Format::r32ui}};
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
    PackedEffect effect{.language = language,
                        .settings = settings,
                        .options = options,
                        .plan = plan_of(settings, options, library)};
    std::set<std::string> bound{effect.plan.result};
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
    return resource.starts_with(effect::nothing_image);
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

void pack_effect(const EffectPackOptions& options) {
    if (options.out.empty()) throw std::invalid_argument("--effect: give --out, the folder to write");
    const RenderOptions as_rendered{
        .method = options.method, .preset = options.preset, .radius = options.radius, .set = options.set};
    const effect::Settings settings = settings_for(as_rendered, {});
    const effect::PlanOptions plan{.view = parse_size(options.size),
                                   .moving_objects = options.moving_objects,
                                   .motion_vectors = options.motion_vectors,
                                   .orthographic = options.orthographic,
                                   .normals = !options.reconstruct_normals,
                                   .bent_normals = options.bent_normals,
                                   .encoding = scene::encoding_named(options.depth, options.normals)};
    const auto language = shader::language_from(options.version);
    if (!language || shader::usual_stage(*language) != shader::Stage::compute)
        throw std::invalid_argument("--effect --version " + options.version +
                                    ": expected 450, 310es or 320es");
    report::OutputFolder folder(options.out);
    PackedEffect effect = packed_effect(settings, plan, scene::PassLibrary(glsl_directory()), *language);
    effect.preset = options.preset;
    effect.version = base::version();
    effect.target = options.target;
    for (const PackedPass& pass : effect.passes) {
        folder.write(pass.file, with_version(pass.text));
        if (options.target)
            folder.write(
                pass.plan.name + shader::suffix(*options.target),
                with_version(shader::translated({.name = pass.file, .text = pass.text}, *options.target)));
    }
    folder.write("gloam_effect.h", effect_header(effect));
    folder.write("effect.json", effect_json(effect));
    folder.write("README.md", effect_page(effect));
    folder.keep();
}

std::string with_version(std::string text) {
    const std::size_t place = text.starts_with("#version") ? text.find('\n') + 1 : 0;
    return text.insert(place, "// Packed by gloam " + base::version() + ".\n");
}

std::string vulkan_format(gpu::Format format) {
    static constexpr std::array names{"R32_SFLOAT",
                                      "R32G32B32A32_SFLOAT",
                                      "R16G16B16A16_SFLOAT",
                                      "R16G16B16A16_UINT",
                                      "R16_SFLOAT",
                                      "R8_UNORM",
                                      "R32_UINT",
                                      "R32G32_SFLOAT",
                                      "R16G16_SFLOAT",
                                      "R8G8B8A8_UNORM",
                                      "R16_UINT",
                                      "R16G16_UINT",
                                      "R32G32_UINT",
                                      "R32G32B32A32_UINT",
                                      "A2B10G10R10_UNORM_PACK32"};  // as gpu::Format
    return std::string("VK_FORMAT_") + names.at(static_cast<std::size_t>(format));
}

std::string vulkan_descriptor(shader::BindingType type) {
    using enum shader::BindingType;
    static const std::map<shader::BindingType, const char*> names{
        {storage_image, "STORAGE_IMAGE"},   {sampled_image, "COMBINED_IMAGE_SAMPLER"},
        {texture, "SAMPLED_IMAGE"},         {sampler, "SAMPLER"},
        {storage_buffer, "STORAGE_BUFFER"}, {uniform_buffer, "UNIFORM_BUFFER"}};
    return std::string("VK_DESCRIPTOR_TYPE_") + names.at(type);
}

std::string to_string(effect::PlannedImage::Origin origin) {
    using enum effect::PlannedImage::Origin;
    static const std::map<effect::PlannedImage::Origin, const char*> names{
        {engine, "engine"}, {history, "kept"}, {once, "once"}, {frame, "frame"}};
    return names.at(origin);
}

std::vector<std::string> vulkan_usage(const PackedEffect& effect, const effect::PlannedImage& image) {
    using Origin = effect::PlannedImage::Origin;
    std::set<std::string> names{image.name};  // with the one that it is exchanged with
    for (const auto& [a, b] : effect.plan.exchanged)
        if (a == image.name || b == image.name) names.insert({a, b});
    std::vector<std::string> usage;
    const auto add = [&usage](const char* bit) {
        const std::string name = std::string("VK_IMAGE_USAGE_") + bit + "_BIT";
        if (std::ranges::find(usage, name) == usage.end()) usage.push_back(name);
    };
    for (const PackedPass& pass : effect.passes) {
        for (const shader::Binding& binding : pass.interface.bindings)
            if (names.contains(resource_at(pass, binding)))
                add(binding.type == shader::BindingType::storage_image ? "STORAGE" : "SAMPLED");
    }
    for (const effect::PlannedImage& other : effect.plan.images)  // filled, or cleared
        if (names.contains(other.name) && (other.origin == Origin::engine || other.origin == Origin::history))
            add("TRANSFER_DST");
    if (names.contains(effect.plan.result)) add("TRANSFER_SRC");
    return usage;
}

}  // namespace gloam::cli
