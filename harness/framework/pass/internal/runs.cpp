// SPDX-License-Identifier: MIT
// A pass on a device, and on the interpreter.
#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <glm/gtc/packing.hpp>

#include "backend/vulkan/commands.hpp"
#include "interpreter/machine.hpp"
#include "pass/internal/work.hpp"

namespace gloam::check::internal {
namespace {

using At = Bound::Kind;

bool has_short_integers(gpu::Format format) {
    return format == gpu::Format::r16ui || format == gpu::Format::rg16ui || format == gpu::Format::rgba16ui;
}

// The memory of a run on the device. Uploads and downloads of images take floats: integers of 16 bits by
// value, those of 32 by their bits.
class DeviceMemory {
  public:
    DeviceMemory(const gpu::Device& device, const PassWork& work) : device_(device) {
        for (const Bound& bound : work.bindings) add(bound);
    }

    void read_back(PassWork& work) const {
        for (std::size_t i = 0; i < work.bindings.size(); ++i) {
            Bound& bound = work.bindings[i];
            if (bound.kind == At::image && bound.written)
                read(std::get<std::reference_wrapper<const gpu::Image>>(resources[i]), bound);
            if (const auto* buffer = std::get_if<std::reference_wrapper<const gpu::Buffer>>(&resources[i]);
                buffer != nullptr && bound.kind != At::nothing)
                std::ranges::copy(buffer->get().as<Word>(), bound.words.begin());
        }
    }

    std::vector<gpu::Resource> resources;
    std::vector<gpu::BindingKind> kinds;

  private:
    void add(const Bound& bound) {
        using enum gpu::BindingKind;
        if (bound.kind == At::image) return add(storage_image, make_image(bound));
        if (bound.kind == At::sampler && bound.stateless) return add(sampled_image, make_image(bound));
        if (bound.kind == At::sampler)
            return add(sampled_image, samplers_.emplace_back(device_, bound.words));
        const std::vector<Word> contents = bound.kind == At::nothing ? std::vector<Word>{0} : bound.words;
        gpu::Buffer& buffer = buffers_.emplace_back(device_, contents.size() * sizeof(Word));
        std::ranges::copy(contents, buffer.as<Word>().begin());
        add(bound.kind == At::uniform ? uniform_buffer : storage_buffer, buffer);
    }
    template <class Made>
    void add(gpu::BindingKind kind, const Made& made) {
        kinds.push_back(kind);
        resources.emplace_back(std::cref(made));
    }

    gpu::Image& make_image(const Bound& bound) {
        const std::size_t first = bound.kind == At::sampler ? backend::sampled_header_words : 0;
        std::vector<float> texels;
        for (std::size_t w = first; w < bound.words.size(); ++w)
            if ((w - first) % texel_words < bound.channels())
                texels.push_back(has_short_integers(bound.format) ? static_cast<float>(bound.words[w])
                                                                  : std::bit_cast<float>(bound.words[w]));
        const gpu::Extent extent{static_cast<std::uint32_t>(bound.size.x),
                                 static_cast<std::uint32_t>(bound.size.y)};
        gpu::Image& made = images_.emplace_back(device_, extent, bound.format);
        made.upload(texels);
        return made;
    }

    static void read(const gpu::Image& from, Bound& bound) {
        const std::vector<float> texels = from.download();
        for (std::size_t i = 0; i < texels.size(); ++i)
            bound.words[i / bound.channels() * texel_words + i % bound.channels()] =
                has_short_integers(bound.format) ? static_cast<Word>(texels[i])
                                                 : std::bit_cast<Word>(texels[i]);
    }

    const gpu::Device& device_;
    std::deque<gpu::Image> images_;
    std::deque<gpu::Buffer> buffers_;
    std::deque<gpu::SampledImage> samplers_;
};

}  // namespace

void run_on_device(const gpu::Device& device, const PassInterface& pass, PassWork& work) {
    DeviceMemory memory(device, work);
    const gpu::ComputePipeline pipeline(
        device, {.spirv = pass.module,
                 .bindings = memory.kinds,
                 .push_constant_bytes = static_cast<std::uint32_t>(work.push_constants.size()),
                 .constants = work.constants});
    gpu::Commands commands(device);
    commands.dispatch(pipeline, memory.resources, work.groups, work.push_constants);
    commands.submit();
    memory.read_back(work);
}

namespace {

// What an image of this format keeps of a word that a shader writes.
Word stored(gpu::Format format, Word word) {
    const auto value = std::bit_cast<float>(word);
    switch (format) {
        case gpu::Format::r16f:
        case gpu::Format::rg16f:
        case gpu::Format::rgba16f:
            return std::bit_cast<Word>(glm::unpackHalf1x16(glm::packHalf1x16(value)));
        case gpu::Format::r8:
        case gpu::Format::rgba8:
            return std::bit_cast<Word>(value > 0.0F ? std::round(std::min(value, 1.0F) * 255.0F) / 255.0F
                                                    : 0.0F);
        default:
            return has_short_integers(format) ? std::min(word, 0xFFFFU) : word;
    }
}

void interpret(const shader::Spirv& module, PassWork& work) {
    interpreter::Machine<float> machine(interpreter::Program(module, work.constants));
    std::vector<Word> parameters(work.push_constants.size() / sizeof(Word));
    std::ranges::copy(work.push_constants, std::as_writable_bytes(std::span(parameters)).begin());
    machine.bind_push_constants(parameters);
    const auto count = static_cast<std::uint32_t>(work.bindings.size());
    for (std::uint32_t b = 0; b < count; ++b) {
        const Bound& bound = work.bindings[b];
        const glm::uvec2 size(bound.size);
        if (bound.kind == At::image)
            machine.bind(0, b, interpreter::ImageView{.size = {size.x, size.y, 1}, .texels = bound.words});
        else if (bound.kind == At::sampler)
            machine.bind(0, b, interpreter::sampled_view_of(bound.words, {}));
        else
            machine.bind(0, b, bound.words);
    }
    interpreter::Invocation at{.group_size = work.group_size, .groups = work.groups};
    for (at.group[2] = 0; at.group[2] < work.groups[2]; ++at.group[2])
        for (at.group[1] = 0; at.group[1] < work.groups[1]; ++at.group[1])
            for (at.group[0] = 0; at.group[0] < work.groups[0]; ++at.group[0]) {
                machine.set_group(at);
                machine.run();
                for (std::uint32_t b = 0; b < count; ++b)
                    machine.keep_writes(0, b, [&bound = work.bindings[b]](std::size_t word, Word bits) {
                        return bound.words[word] =
                                   bound.kind == At::image ? stored(bound.format, bits) : bits;
                    });
            }
}

}  // namespace

void run_interpreted(const PassInterface& pass, PassWork& work) {
    try {
        interpret(pass.module, work);
    } catch (const interpreter::Error& error) {
        const std::string message = pass.name + ": " + error.what();
        if (error.kind() == interpreter::Error::Kind::unknown_instruction)
            throw backend::Unsupported(message);
        throw backend::Fault(message);
    }
}

}  // namespace gloam::check::internal
