// SPDX-License-Identifier: MIT
// A pass on Vulkan, OpenGL and the interpreter.
#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <glm/gtc/packing.hpp>

#include "backend/gl/program.hpp"
#include "backend/vulkan/commands.hpp"
#include "interpreter/machine.hpp"
#include "module/spirv.hpp"
#include "pass/internal/work.hpp"

namespace gloam::pass::internal {
namespace {

using At = Bound::Kind;

std::vector<Word> push_words(const PassWork& work) {
    std::vector<Word> words(work.push_constants.size() / sizeof(Word));
    std::ranges::copy(work.push_constants, std::as_writable_bytes(std::span(words)).begin());
    return words;
}

// The memory of a run on the device.
class DeviceMemory {
  public:
    DeviceMemory(const backend::vulkan::Device& device, const PassWork& work) : device_(device) {
        for (const Bound& bound : work.bindings) add(bound);
    }

    void read_back(PassWork& work) const {
        for (std::size_t i = 0; i < work.bindings.size(); ++i) {
            Bound& bound = work.bindings[i];
            if (bound.kind == At::image && bound.written)
                read(std::get<std::reference_wrapper<const backend::vulkan::Image>>(resources[i]), bound);
            if (const auto* buffer =
                    std::get_if<std::reference_wrapper<const backend::vulkan::Buffer>>(&resources[i]);
                buffer != nullptr && bound.kind != At::nothing)
                std::ranges::copy(buffer->get().as<Word>(), bound.words.begin());
        }
    }

    std::vector<backend::vulkan::Resource> resources;
    std::vector<backend::vulkan::BindingKind> kinds;

  private:
    void add(const Bound& bound) {
        using enum backend::vulkan::BindingKind;
        if (bound.kind == At::image) return add(storage_image, make_image(bound));
        if (bound.kind == At::sampler && bound.stateless) return add(sampled_image, make_image(bound));
        if (bound.kind == At::sampler)
            return add(sampled_image, samplers_.emplace_back(device_, bound.words));
        const std::vector<Word> contents = bound.kind == At::nothing ? std::vector<Word>{0} : bound.words;
        backend::vulkan::Buffer& buffer = buffers_.emplace_back(device_, contents.size() * sizeof(Word));
        std::ranges::copy(contents, buffer.as<Word>().begin());
        add(bound.kind == At::uniform ? uniform_buffer : storage_buffer, buffer);
    }
    template <class Made>
    void add(backend::vulkan::BindingKind kind, const Made& made) {
        kinds.push_back(kind);
        resources.emplace_back(std::cref(made));
    }

    backend::vulkan::Image& make_image(const Bound& bound) {
        std::vector<float> texels;
        const std::span<const Word> words = bound.texels();
        for (std::size_t w = 0; w < words.size(); ++w)
            if (w % texel_words < bound.channels()) texels.push_back(std::bit_cast<float>(words[w]));
        const backend::Extent extent{static_cast<std::uint32_t>(bound.size.x),
                                     static_cast<std::uint32_t>(bound.size.y)};
        backend::vulkan::Image& made = images_.emplace_back(device_, extent, bound.format);
        made.upload(texels);
        return made;
    }

    static void read(const backend::vulkan::Image& from, Bound& bound) {
        const std::vector<float> texels = from.download();
        for (std::size_t i = 0; i < texels.size(); ++i)
            bound.words[i / bound.channels() * texel_words + i % bound.channels()] =
                std::bit_cast<Word>(texels[i]);
    }

    const backend::vulkan::Device& device_;
    std::deque<backend::vulkan::Image> images_;
    std::deque<backend::vulkan::Buffer> buffers_;
    std::deque<backend::vulkan::SampledImage> samplers_;
};

}  // namespace

void run_on_device(const backend::vulkan::Device& device, const PassInterface& pass,
                   std::span<PassWork> works) {
    std::optional<backend::vulkan::ComputePipeline> pipeline;
    for (PassWork& work : works) {
        DeviceMemory memory(device, work);
        if (!pipeline)
            pipeline.emplace(
                device, backend::vulkan::ComputeProgram{
                            .spirv = pass.module,
                            .bindings = memory.kinds,
                            .push_constant_bytes = static_cast<std::uint32_t>(work.push_constants.size()),
                            .constants = work.constants});
        backend::vulkan::Commands commands(device);
        commands.dispatch(*pipeline, memory.resources, work.groups, work.push_constants);
        commands.submit();
        memory.read_back(work);
    }
}

namespace {

// A number as GLSL has it.
std::string literal(const std::string& type, Word bits) {
    if (type == "bool") return bits == 0 ? "false" : "true";
    if (type == "uint") return fmt::format("{}u", bits);
    if (type == "int") return fmt::format("{}", std::bit_cast<std::int32_t>(bits));
    return fmt::format("uintBitsToFloat({}u)", bits);
}

// The first uniform block that the pass has not.
std::uint32_t free_block(const PassWork& work) {
    const auto taken = [](const Bound& bound) { return bound.kind == At::uniform; };
    return static_cast<std::uint32_t>(std::ranges::find_if_not(work.bindings, taken) - work.bindings.begin());
}

std::string translated(const backend::gl::Device& device, const PassInterface& pass, const PassWork& work) {
    std::string text;
    try {
        text = module::opengl_text(pass.module, *source::language_from(device.info().glsl), free_block(work));
    } catch (const std::runtime_error& error) {
        throw backend::Unsupported(pass.name + ": " + error.what());
    }
    for (const backend::Constant& constant : work.constants)
        text.insert(text.find('\n') + 1,
                    fmt::format("#define SPIRV_CROSS_CONSTANT_ID_{} {}\n", constant.id,
                                literal(std::ranges::find(pass.declared.constants, constant.id,
                                                          &module::SpecializationConstant::id)
                                            ->type,
                                        constant.bits)));
    return text;
}

void run_once(const backend::gl::Device& device, const backend::gl::Program& program,
              const PassInterface& pass, PassWork& work) {
    backend::gl::Dispatch dispatch{.program = program, .storage = {}, .uniforms = {}, .groups = work.groups};
    std::deque<backend::gl::Image> images;
    std::deque<backend::gl::Buffer> buffers;
    std::map<std::uint32_t, backend::gl::SampledTexture> textures;
    const auto buffer = [&](std::span<const Word> words, std::size_t size) {
        return std::cref(buffers.emplace_back(device, words, size));
    };
    const auto uniforms = [&](std::span<const Word> words) {
        return buffer(words, (words.size() + 3) / 4 * 4);  // a uniform block ends with a vec4
    };
    for (const module::Binding& binding : pass.declared.bindings) {
        const Bound& bound = work.bindings[binding.number];
        if (bound.kind == At::image || bound.stateless)
            dispatch.images.emplace(
                binding.number, images.emplace_back(device, bound.stateless ? "rgba32f" : binding.format,
                                                    static_cast<std::size_t>(bound.size.x),
                                                    static_cast<std::size_t>(bound.size.y), bound.texels()));
        else if (bound.kind == At::sampler)
            textures.try_emplace(binding.number, device, bound.words);
        else if (bound.kind == At::uniform)
            dispatch.uniforms.emplace(binding.number, uniforms(bound.words));
        else
            dispatch.storage.emplace(binding.number, buffer(bound.words, bound.words.size()));
    }
    const std::vector<Word> parameters = push_words(work);
    if (!parameters.empty()) dispatch.uniforms.emplace(free_block(work), uniforms(parameters));
    for (const auto& [unit, texture] : textures) texture.bind(unit);
    backend::gl::dispatch(device, dispatch);
    for (const auto& [number, image] : dispatch.images)
        if (work.bindings[number].written) work.bindings[number].words = image.get().read();
    for (const auto& [number, storage] : dispatch.storage) work.bindings[number].words = storage.get().read();
}

}  // namespace

void run_on_opengl(const backend::gl::Device& device, const PassInterface& pass, std::span<PassWork> works) {
    if (!backend::gl::has_compute(device.info().id.version))
        throw backend::Unsupported(to_string(device.info().id.version) + " has no compute shaders");
    const backend::gl::Program program(
        device, backend::gl::Program::Stage::compute,
        {.name = pass.name, .text = pass.text.empty() ? translated(device, pass, works.front()) : pass.text});
    for (PassWork& work : works) run_once(device, program, pass, work);
}

namespace {

// What an image of this format keeps of a word that a shader writes as that component.
Word stored(backend::vulkan::Format format, std::size_t component, Word word) {
    const auto value = std::bit_cast<float>(word);
    const auto rounded = [value](float most) {
        return std::bit_cast<Word>(value > 0.0F ? std::round(std::min(value, 1.0F) * most) / most : 0.0F);
    };
    switch (format) {
        case backend::vulkan::Format::r16f:
        case backend::vulkan::Format::rg16f:
        case backend::vulkan::Format::rgba16f:
            return std::bit_cast<Word>(glm::unpackHalf1x16(glm::packHalf1x16(value)));
        case backend::vulkan::Format::r8:
        case backend::vulkan::Format::rgba8:
            return rounded(255.0F);
        case backend::vulkan::Format::rgb10_a2:
            return rounded(component < 3 ? 1023.0F : 3.0F);
        case backend::vulkan::Format::r16ui:
        case backend::vulkan::Format::rg16ui:
        case backend::vulkan::Format::rgba16ui:
            return std::min(word, 0xFFFFU);
        default:
            return word;
    }
}

void interpret(const module::Spirv& module, PassWork& work) {
    interpreter::Machine<float> machine(interpreter::Program(module, work.constants));
    const std::vector<Word> parameters = push_words(work);
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
                        return bound.words[word] = bound.kind == At::image
                                                       ? stored(bound.format, word % texel_words, bits)
                                                       : bits;
                    });
            }
}

}  // namespace

void run_interpreted(const PassInterface& pass, std::span<PassWork> works) {
    try {
        for (PassWork& work : works) interpret(pass.module, work);
    } catch (const interpreter::Error& error) {
        const std::string message = pass.name + ": " + error.what();
        if (error.kind() == interpreter::Error::Kind::unknown_instruction)
            throw backend::Unsupported(message);
        throw backend::Fault(message);
    }
}

}  // namespace gloam::pass::internal
