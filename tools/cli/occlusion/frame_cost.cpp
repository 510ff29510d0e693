// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>

#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/settings.hpp"
#include "module/reflection.hpp"
#include "module/spirv.hpp"

namespace gloam::cli {

std::string text_of(const effect::PlannedPass& pass, const scene::PassLibrary& library,
                    source::Language language) {
    const effect::PassSource& source = pass.source;
    std::map<std::uint32_t, std::uint32_t> constants;
    for (const backend::vulkan::SpecializationConstant& one : source.constants) constants[one.id] = one.bits;
    return library.text(source.file, source.defines, source.replaced, constants, language);
}

namespace {

double bytes_of_level(const effect::PlannedImage& image, std::uint32_t level) {
    return std::ldexp(1.0 * image.extent.width * image.extent.height, -2 * static_cast<int>(level)) *
           static_cast<double>(backend::vulkan::texel_bytes(image.format));
}

// Bytes of what the pass reads and writes, each image and buffer once.
double bytes_of(const effect::Plan& plan, const effect::PlannedPass& pass,
                const scene::PassLibrary& library) {
    const module::Spirv used =
        module::with_passes(module::compile({pass.source.file, text_of(pass, library)}, {}),
                            {"--freeze-spec-const", "--fold-spec-const-op-composite", "--ccp",
                             "--eliminate-dead-branches", "-O"});
    double bytes = 0.0;
    for (const module::Binding& binding : module::reflect(used).bindings) {
        const std::string& name = pass.resources.at(binding.number);
        const effect::ImageName bound = effect::image_name_of(name);
        const double times = (binding.reads ? 1.0 : 0.0) + (binding.writes ? 1.0 : 0.0);
        for (const effect::PlannedImage& image : plan.images)
            if (bound.image == image.name) bytes += times * bytes_of_level(image, bound.level.value_or(0));
        for (const effect::PlannedBuffer& buffer : plan.buffers)
            if (buffer.name == name) bytes += times * static_cast<double>(buffer.contents.size());
    }
    return bytes;
}

double pixels_of_invocation(const effect::PlannedPass& pass, const module::Spirv& module, double view) {
    const auto [x, y, z] = module::reflect(module).local_size;
    const double invocations = 1.0 * x * y * z;
    return view / (invocations * pass.groups[0] * pass.groups[1] * pass.groups[2]);
}

// Bytes of the images and buffers that a frame needs beside those of the engine.
double memory_of(const effect::Plan& plan) {
    double bytes = 0.0;
    for (const effect::PlannedImage& image : plan.images)
        for (std::uint32_t level = 0; level < image.levels; ++level)
            if (image.origin != effect::PlannedImage::Origin::engine) bytes += bytes_of_level(image, level);
    for (const effect::PlannedBuffer& buffer : plan.buffers)
        bytes += static_cast<double>(buffer.contents.size());
    return bytes;
}

// full: of the tiles that are swept in full.
double share_of(const effect::PlannedPass& pass, const effect::Settings& settings, double full) {
    if (settings.resolution != effect::Resolution::tiles) return 1.0;
    if (pass.name == "join") return 1.0 - full;
    return pass.name == "refine" || pass.name == "filter" ? full : 1.0;
}

}  // namespace

PresetFrame frame_of(const std::string& preset, const std::vector<std::string>& set,
                     std::optional<double> tiles) {
    effect::Settings settings = preset_settings(preset);
    for (const std::string& assignment : set) apply(settings, assignment);
    effect::PlanOptions options{.first = true};
    if (settings.passes == effect::Passes::frame) options.encoding = {.depth_buffer = true, .unorm = true};
    const double view = 1.0 * options.view.width * options.view.height;
    const scene::PassLibrary library(glsl_directory(), cache_directory());
    const effect::Plan plan = effect::plan_of(settings, options, library);
    PresetFrame frame{.passes = {}, .memory = memory_of(plan)};
    const double full = tiles.value_or(preset.ends_with(".json") ? 1.0 : effect::preset_named(preset).tiles);
    for (const effect::PlannedPass& pass : plan.passes) {
        const module::Spirv module = effect::module_of(pass.source, library);
        frame.passes.push_back({.name = pass.name,
                                .module = module,
                                .constants = pass.source.constants,
                                .pixels = pixels_of_invocation(pass, module, view),
                                .share = share_of(pass, settings, full),
                                .groups = 1.0 * pass.groups[0] * pass.groups[1] * pass.groups[2],
                                .bytes = bytes_of(plan, pass, library) / view});
    }
    return frame;
}

}  // namespace gloam::cli
