// SPDX-License-Identifier: MIT
#include "effect/planned_run.hpp"

#include <algorithm>

namespace gloam::effect {
namespace {

using subject::Image;
using subject::Word;

module::Type texel_of(backend::vulkan::Format format) {
    using enum backend::vulkan::Format;
    const bool whole = format == r32ui || format == rg32ui || format == rgba16ui;
    return {.scalar = whole ? module::Scalar::uint_ : module::Scalar::float_,
            .rows = backend::vulkan::channels(format)};
}

Image level_of(const PlannedImage& planned, std::uint32_t level) {
    const glm::ivec2 size(std::max(planned.extent.width >> level, 1U),
                          std::max(planned.extent.height >> level, 1U));
    Image image{.element = texel_of(planned.format), .size = size, .words = {}};
    image.words.resize(static_cast<std::size_t>(size.x * size.y * image.element.rows));
    return image;
}

// All levels as one image for a sampler, which takes the nearest texel.
Image sampled(const std::vector<Image>& levels) {
    Image all = levels.front();
    if (levels.size() == 1 && all.element.scalar == module::Scalar::float_) return all;
    for (std::size_t i = 1; i < levels.size(); ++i)
        all.words.insert(all.words.end(), levels[i].words.begin(), levels[i].words.end());
    all.sampling =
        Image::Sampling{.wrap = backend::Wrap::edge, .levels = static_cast<unsigned>(levels.size())};
    return all;
}

// The text of a pass that engines take.
std::string text_of(const PlannedPass& pass, const scene::PassLibrary& passes, bool es) {
    std::map<std::uint32_t, std::uint32_t> constants;
    for (const auto& constant : pass.source.constants) constants[constant.id] = constant.bits;
    std::vector<std::string> defines = pass.source.defines;
    defines.emplace_back("GLOAM_PARAMETER_BLOCK");
    try {
        return passes.text(pass.source.file, defines, pass.source.replaced, constants,
                           es ? source::Language::es310 : source::Language::gl430);
    } catch (const source::CompileError& error) {
        const std::string all = error.what();
        if (es) throw backend::Unsupported(pass.name + ": " + all.substr(0, all.find('\n')));
        throw;
    }
}

}  // namespace

PlanMemory::PlanMemory(const Plan& plan, const scene::GBuffer& view) {
    for (const PlannedImage& planned : plan.images) {
        std::vector<Image>& levels = images[planned.name];
        for (std::uint32_t level = 0; level < planned.levels; ++level)
            levels.push_back(level_of(planned, level));
    }
    std::vector<Word> depth;
    std::vector<Word> normal;
    for (const float one : view.depth) subject::append_words(one, depth);
    for (const glm::vec3& one : view.normal) subject::append_words(glm::vec4(one, 0.0F), normal);
    images.at("depth").front().words = std::move(depth);
    if (!normal.empty()) images.at("normal").front().words = std::move(normal);
    for (const PlannedBuffer& planned : plan.buffers) {
        std::vector<Word>& words = buffers[planned.name];
        words.resize((planned.contents.size() + sizeof(Word) - 1) / sizeof(Word));
        std::ranges::copy(planned.contents, std::as_writable_bytes(std::span(words)).begin());
    }
}

void run(const subject::Lab& lab, const Plan& plan, const scene::PassLibrary& passes, PlanMemory& memory) {
    for (const PlannedPass& pass : plan.passes) {
        pass::PassBindings bindings{
            .push_constants = pass.parameters, .constants = {}, .groups = pass.groups};
        for (const auto& constant : pass.source.constants)
            bindings.constants.push_back({constant.id, constant.bits});
        for (std::uint32_t binding = 0; binding < pass.resources.size(); ++binding) {
            const ImageName name = image_name_of(pass.resources[binding]);
            if (const auto image = memory.images.find(name.image); image != memory.images.end())
                bindings.images.emplace(binding,
                                        name.level ? image->second.at(*name.level) : sampled(image->second));
            if (const auto buffer = memory.buffers.find(name.image); buffer != memory.buffers.end())
                bindings.buffers.emplace(binding, buffer->second);
        }
        const auto before = bindings.images;
        const auto language = lab.language();
        const bool es = language == source::Language::es310 || language == source::Language::es320;
        pass::Pass(lab, pass.name, module_of(pass.source, passes), language ? text_of(pass, passes, es) : "")
            .run(bindings);
        for (auto& [binding, image] : bindings.images) {
            const ImageName name = image_name_of(pass.resources[binding]);
            if (image.words != before.at(binding).words)  // two bindings may have one image
                memory.images.at(name.image).at(name.level.value_or(0)).words = image.words;
        }
        for (auto& [binding, words] : bindings.buffers) memory.buffers.at(pass.resources[binding]) = words;
    }
}

}  // namespace gloam::effect
