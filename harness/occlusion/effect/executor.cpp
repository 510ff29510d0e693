// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "module/reflection.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

namespace {

std::size_t pixels_of(backend::Extent extent) {
    return std::size_t{extent.width} * extent.height;
}

// The resource with this name.
template <class Map>
auto& named(Map& all, const std::string& name, const char* what) {
    const auto found = all.find(name);
    if (found == all.end()) throw std::logic_error(fmt::format("passes without the {} {}", what, name));
    return found->second;
}

void fill(backend::vulkan::Buffer& buffer, const std::vector<std::byte>& contents) {
    std::ranges::copy(contents, buffer.bytes().begin());
}

// All that a source says, as one text.
std::string key_of(const PassSource& source) {
    std::string key = source.unrolls ? source.file + ", unrolled" : source.file;
    for (const std::string& define : source.defines) key += "\n" + define;
    for (const scene::PassLibrary::Replacement& replacement : source.replaced)
        key += "\n" + replacement.include + "\n" + replacement.instead;
    for (const backend::vulkan::SpecializationConstant& constant : source.constants)
        key += fmt::format("\n{}={}", constant.id, constant.bits);
    return key;
}

bool reads_storage_images(const backend::vulkan::Device& device, scene::Inputs inputs) {
    return inputs == scene::Inputs::storage ||
           (inputs == scene::Inputs::by_device && device.info().type == "cpu");
}

backend::vulkan::BindingKind kind_of(module::BindingType type) {
    if (type == module::BindingType::storage_buffer) return backend::vulkan::BindingKind::storage_buffer;
    return type == module::BindingType::sampled_image ? backend::vulkan::BindingKind::sampled_image
                                                      : backend::vulkan::BindingKind::storage_image;
}

module::Spirv module_of(const backend::vulkan::Device& device, const scene::PassLibrary& library,
                        const PassSource& source) {
    return module_of(source, library, reads_storage_images(device, library.inputs));
}

// kinds: of the bindings that the module lacks.
backend::vulkan::ComputePipeline pipeline_of(const backend::vulkan::Device& device, const PassSource& source,
                                             const module::Spirv& spirv,
                                             const module::ModuleInterface& interface,
                                             std::vector<backend::vulkan::BindingKind> kinds) {
    for (const module::Binding& binding : interface.bindings) {
        if (kinds.size() <= binding.number)
            kinds.resize(binding.number + 1, backend::vulkan::BindingKind::storage_image);
        kinds[binding.number] = kind_of(binding.type);
    }
    const std::size_t bytes = interface.push_constants ? interface.push_constants->size : 0;
    return {device,
            {.spirv = spirv,
             .bindings = std::move(kinds),
             .push_constant_bytes = static_cast<std::uint32_t>(bytes),
             .constants = source.constants}};
}

// Texels of which each channel is a layer.
std::vector<float> texels_of(std::span<const std::vector<float>> layers) {
    std::vector<float> texels(4 * layers.front().size(), 0.0F);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        for (std::size_t i = 0; i < layers[l].size(); ++i) texels[4 * i + l] = layers[l][i];
    }
    return texels;
}

}  // namespace

module::Spirv module_of(const PassSource& source, const scene::PassLibrary& library, bool storage_inputs) {
    const scene::PassLibrary& optimized = source.unrolls ? library.unrolled() : library;
    std::vector<std::string> defines = source.defines;
    if (storage_inputs) defines.emplace_back("GLOAM_STORAGE_INPUTS");
    return optimized.compile(source.file, defines, source.replaced);
}

backend::vulkan::ComputePipeline pipeline_of(const backend::vulkan::Device& device,
                                             const scene::PassLibrary& library, const PassSource& source,
                                             std::vector<backend::vulkan::BindingKind> kinds) {
    const module::Spirv spirv = module_of(device, library, source);
    return pipeline_of(device, source, spirv, module::reflect(spirv), std::move(kinds));
}

Resources::Resources(const backend::vulkan::Device& device) : device_(&device) {
    using backend::vulkan::Format;
    for (const auto& [name, format] : {std::pair{"r32f", backend::vulkan::Format::r32f},
                                       {"rgba32f", backend::vulkan::Format::rgba32f},
                                       {"rgba16ui", backend::vulkan::Format::rgba16ui},
                                       {"r32ui", backend::vulkan::Format::r32ui},
                                       {"rgb10_a2", backend::vulkan::Format::rgb10_a2}})
        nothing_.try_emplace(name, device, backend::Extent{1, 1}, format);
}

backend::vulkan::Image& Resources::image(const std::string& name, backend::Extent extent,
                                         backend::vulkan::Format format, std::uint32_t levels) {
    const auto found = images_.find(name);
    if (found == images_.end())
        return images_.try_emplace(name, *device_, extent, format, levels).first->second;
    backend::vulkan::Image& image = found->second;
    if (image.extent() != extent || image.format() != format || image.levels() != levels)
        image = backend::vulkan::Image(*device_, extent, format, levels);
    return image;
}

backend::vulkan::Buffer& Resources::buffer(const std::string& name, std::size_t bytes) {
    const auto found = buffers_.find(name);
    if (found != buffers_.end() && found->second.size() == bytes) return found->second;
    backend::vulkan::Buffer made(*device_, bytes);
    std::ranges::fill(made.bytes(), std::byte{0});
    return buffers_.insert_or_assign(name, std::move(made)).first->second;
}

void Resources::provide(const Plan& plan) {
    for (const PlannedImage& planned : plan.images)
        image(planned.name, planned.extent, planned.format, planned.levels);
    for (const PlannedBuffer& planned : plan.buffers)
        fill(buffer(planned.name, planned.contents.size()), planned.contents);
}

void Resources::restart(const Plan& plan) {
    for (const PlannedImage& planned : plan.images)
        if (planned.origin == PlannedImage::Origin::history)
            image(planned.name)
                .upload(std::vector<float>(
                    backend::vulkan::channels(planned.format) * pixels_of(planned.extent), 0.0F));
    for (const PlannedBuffer& planned : plan.buffers) fill(buffer(planned.name), planned.contents);
}

void Resources::exchange(std::span<const std::array<std::string, 2>> pairs) {
    for (const auto& [first, second] : pairs) std::swap(image(first), image(second));
}

backend::vulkan::Image& Resources::image(const std::string& name) {
    return named(images_, name, "image");
}
const backend::vulkan::Image& Resources::image(const std::string& name) const {
    return named(images_, name, "image");
}
backend::vulkan::Buffer& Resources::buffer(const std::string& name) {
    return named(buffers_, name, "buffer");
}
const backend::vulkan::Buffer& Resources::buffer(const std::string& name) const {
    return named(buffers_, name, "buffer");
}

backend::vulkan::Resource Resources::at(const std::string& name, const std::string& format) const {
    if (name == nothing_image) {
        const auto found = nothing_.find(format);
        return found == nothing_.end() ? nothing_.at("rgba32f") : found->second;
    }
    if (has_buffer(name)) return buffer(name);
    const auto [bound, level, linear] = image_name_of(name);
    if (level) return backend::vulkan::ImageLevel{image(bound), *level};
    if (linear) return backend::vulkan::LinearImage{image(bound)};
    return image(bound);
}

Executor::Executor(const backend::vulkan::Device& device, scene::PassLibrary library)
    : device_(&device), library_(std::move(library)) {}

const Executor::Module& Executor::module(const PassSource& source) {
    PassSource without = source;
    without.constants.clear();
    const std::string key = key_of(without);
    const auto known = modules_.find(key);
    if (known != modules_.end()) return known->second;
    module::Spirv spirv = module_of(*device_, library_, without);
    module::ModuleInterface interface = module::reflect(spirv);
    return modules_.emplace(key, Module{std::move(spirv), std::move(interface)}).first->second;
}

const module::ModuleInterface& Executor::interface_of(const PassSource& source) {
    return module(source).interface;
}

PlannedPass planned_pass(std::string name, PassSource source, std::vector<std::string> resources,
                         const Values& values, const InterfaceOf& interface_of,
                         std::array<std::uint32_t, 3> groups) {
    const module::ModuleInterface interface = interface_of(source);
    source.constants = values.constants(interface, source.file);
    std::vector<std::byte> parameters = values.push_constants(interface, source.file);
    return {.name = std::move(name),
            .source = std::move(source),
            .resources = std::move(resources),
            .parameters = std::move(parameters),
            .groups = groups};
}

const Executor::Compiled& Executor::compiled(const PlannedPass& pass, const Resources& resources) {
    std::string key = key_of(pass.source);
    const auto known = compiled_.find(key);
    if (known != compiled_.end()) return known->second;
    std::vector<backend::vulkan::BindingKind> kinds;
    for (const std::string& name : pass.resources)
        kinds.push_back(resources.has_buffer(name) ? backend::vulkan::BindingKind::storage_buffer
                                                   : backend::vulkan::BindingKind::storage_image);
    const auto& [spirv, interface] = module(pass.source);
    std::vector<std::string> formats(pass.resources.size(), "rgba32f");
    for (const module::Binding& binding : interface.bindings) {
        if (binding.number >= formats.size()) continue;
        if (!binding.format.empty())
            formats[binding.number] = binding.format;
        else if (binding.texel == "uint")
            formats[binding.number] = "r32ui";
    }
    return compiled_
        .emplace(std::move(key),
                 Compiled{pipeline_of(*device_, pass.source, spirv, interface, std::move(kinds)),
                          std::move(formats)})
        .first->second;
}

std::vector<Step> Executor::steps(std::span<const PlannedPass> passes, const Resources& resources) {
    std::vector<Step> steps;
    for (const PlannedPass& pass : passes) {
        const Compiled& of_pass = compiled(pass, resources);
        Step step{.name = pass.name,
                  .pipeline = &of_pass.pipeline,
                  .resources = {},
                  .parameters = pass.parameters,
                  .groups = pass.groups,
                  .groups_from = pass.groups_from.empty() ? nullptr : &resources.buffer(pass.groups_from),
                  .groups_at = pass.groups_at};
        for (std::size_t i = 0; i < pass.resources.size(); ++i)
            step.resources.push_back(resources.at(pass.resources[i], of_pass.formats[i]));
        steps.push_back(std::move(step));
    }
    return steps;
}

void Executor::run(const PlannedPass& pass, const Resources& resources) {
    (void)effect::run(*device_, steps(std::span(&pass, 1), resources), 1);
}

void Executor::run(std::string name, PassSource source, std::vector<std::string> bound, const Values& values,
                   std::array<std::uint32_t, 3> groups, const Resources& resources) {
    run(planned_pass(
            std::move(name), std::move(source), std::move(bound), values,
            [this](const PassSource& one) { return interface_of(one); }, groups),
        resources);
}

void require_guard(const scene::GBuffer& view, const Settings& settings) {
    const backend::Extent none;
    const double guard = double{settings.guard};
    if (view.border.each_side() != none || scene::guard_border(view.extent, guard) == none) return;
    throw std::invalid_argument(fmt::format("guard {:g}: the view has no guard band", guard));
}

void require_layers(const scene::GBuffer& view, const Settings& settings) {
    if (view.layers.size() + 1 >= static_cast<std::size_t>(settings.own.layers)) return;
    throw std::invalid_argument(fmt::format("layers {}: the view has {}, the first among them",
                                            settings.own.layers, view.layers.size() + 1));
}

void require_centred(const scene::GBuffer& view) {
    if (view.off_centre != glm::ivec2(0))
        throw std::invalid_argument(
            "the camera's axis is not in the image's middle: expected a centred() view");
}

void upload(const scene::GBuffer& view, bool stores, Resources& resources) {
    using enum backend::vulkan::Format;
    const bool stored = stores && view.stored;
    const auto image = [&](const char* name, backend::vulkan::Format format) -> backend::vulkan::Image& {
        return resources.image(name, view.extent, format);
    };
    const std::vector<glm::vec3>& normals = stored ? view.stored->normal : view.normal;
    image("depth", r32f).upload(stored ? view.stored->depth : view.depth);
    if (!normals.empty()) image("normal", rgba32f).upload(texels_of(normals));
    if (!view.previous_position.empty())
        image("previous_position", rgba32f).upload(texels_of(view.previous_position));
    if (!view.layers.empty()) image("layers", rgba32f).upload(texels_of(view.layers));
}

void take_linear(const scene::GBuffer& view, Resources& resources, Executor& executor) {
    require_centred(view);
    upload(view, false, resources);
    if (!view.normal.empty()) return;
    (void)resources.image("normal", view.extent, backend::vulkan::Format::rgba32f);
    executor.run("normals_from_depth", {.file = "study/normals_from_depth.comp"}, {"depth", "normal"},
                 values_of({view.camera, view.extent, view.border}, {}), groups_for(view.extent), resources);
}

}  // namespace gloam::effect
