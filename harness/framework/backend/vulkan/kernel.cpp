// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <variant>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/internal/context.hpp"

namespace gloam::backend::vulkan {
namespace {

using backend::Word;

std::vector<BindingKind> bindings_of(const backend::KernelProgram& program) {
    std::vector<BindingKind> bindings(backend::KernelBinding::first_image, BindingKind::storage_buffer);
    for (const backend::KernelImage& image : program.images)
        bindings.push_back(image.sampled            ? BindingKind::sampled_image
                           : !image.layered.empty() ? BindingKind::storage_image
                                                    : BindingKind::storage_buffer);
    return bindings;
}

// Of a quad a fragment shader that draws nothing, otherwise a compute shader.
using Pipeline = std::variant<ComputePipeline, RasterPipeline>;

Pipeline pipeline_of(const Device& device, const backend::KernelProgram& program) {
    const auto& limits = device.impl().physical.properties.limits;
    if (program.team.count() > limits.maxComputeWorkGroupInvocations)
        throw backend::Unsupported(fmt::format("{}: a work group of {} invocations, device \"{}\" allows {}",
                                               program.name, program.team.count(), device.info().name,
                                               limits.maxComputeWorkGroupInvocations));
    if (lacks_float16(device.impl(), program.spirv))
        throw backend::Unsupported(fmt::format("{}: needs shaderFloat16, which device \"{}\" lacks",
                                               program.name, device.info().name));
    const std::vector<SpecializationConstant> constants(program.constants.begin(), program.constants.end());
    if (program.team.kind == backend::Team::Kind::quad)
        return RasterPipeline(device, {.vertex_spirv = program.vertex_spirv,
                                       .fragment_spirv = program.spirv,
                                       .push_constant_bytes = sizeof(backend::KernelRun),
                                       .bindings = bindings_of(program),
                                       .constants = constants});
    return ComputePipeline(device, {.spirv = program.spirv,
                                    .bindings = bindings_of(program),
                                    .push_constant_bytes = sizeof(backend::KernelRun),
                                    .constants = constants});
}

Buffer uploaded(const Device& device, std::span<const Word> words) {
    Buffer buffer(device, std::max<std::size_t>(words.size(), 1) * sizeof(Word));
    std::ranges::copy(words, buffer.as<Word>().begin());
    return buffer;
}

void download(const Buffer& buffer, std::span<Word> words) {
    std::ranges::copy(buffer.as<Word>().first(words.size()), words.begin());
}

class VulkanKernel : public backend::Kernel {
  public:
    VulkanKernel(const Device& device, const backend::KernelProgram& program)
        : device_(device),
          pipeline_(pipeline_of(device, program)),
          images_(program.images),
          layer_size_(program.layer_size),
          widest_(program.widest()),
          team_(program.team) {}

    [[nodiscard]] std::size_t most_inputs() const override {
        const std::size_t by_memory =
            device_.info().max_buffer_bytes / sizeof(Word) / widest_ - backend::guard_words;
        const bool layered =
            std::ranges::any_of(images_, [](const auto& image) { return !image.layered.empty(); });
        if (layered)
            return std::min<std::size_t>(by_memory,
                                         device_.impl().physical.properties.limits.maxImageArrayLayers);
        return is_quad() ? std::min(by_memory, quad_columns * most_quad_rows) : by_memory;
    }

    void run(std::size_t count, Word canary, backend::KernelMemory& memory) const override {
        with_typed_errors([&] { submit(count, canary, memory); });
    }

  private:
    void submit(std::size_t count, Word canary, backend::KernelMemory& memory) const {
        auto faults = std::bit_cast<std::array<Word, sizeof memory.faults / sizeof(Word)>>(memory.faults);
        std::deque<std::variant<Buffer, SampledImage, Image>> made;
        std::vector<Resource> resources;
        const auto add = [&](auto resource) {
            using Type = decltype(resource);
            resources.push_back(std::cref(std::get<Type>(made.emplace_back(std::move(resource)))));
        };
        for (const std::span<const Word> words :
             {memory.inputs, std::span<const Word>(memory.outputs), std::span<const Word>(faults)})
            add(uploaded(device_, words));
        for (std::size_t i = 0; i < images_.size(); ++i) {
            const auto& [sampled, layered] = images_[i];
            if (sampled)
                add(SampledImage(device_, memory.images[i]));
            else if (layered.empty())
                add(uploaded(device_, memory.images[i]));
            else
                add(Image(device_, {layer_size_[0], layer_size_[1]}, format_from(layered).value(), 1,
                          static_cast<std::uint32_t>(count)));
        }
        const std::size_t inputs = team_.kind == backend::Team::Kind::alone ? backend::kernel_group_size : 1;
        const std::size_t groups = (count + inputs - 1) / inputs;
        const std::size_t most = is_quad() ? quad_columns : device_.info().max_group_count[0];
        const auto columns = static_cast<Word>(std::min(groups, most));
        const auto rows = static_cast<Word>((groups + columns - 1) / columns);
        const backend::KernelRun run{.count = static_cast<Word>(count),
                                     .row_length = static_cast<Word>(columns * inputs),
                                     .canary = canary};
        const auto parameters = std::as_bytes(std::span(&run, 1));
        Commands commands(device_);
        // Of quads a triangle that is half of the image, and so large that no edge of it divides one: where
        // an edge does, the invocations outside read 0 from buffers on llvmpipe. A side has 2 * 2 pixels a
        // quad.
        if (const auto* compute = std::get_if<ComputePipeline>(&pipeline_))
            commands.dispatch(*compute, resources, {columns, rows, 1}, parameters);
        else
            render(commands, std::get<RasterPipeline>(pipeline_), {4 * columns, 4 * rows}, resources,
                   parameters);
        commands.submit();
        download(std::get<Buffer>(made[backend::KernelBinding::outputs]), memory.outputs);
        download(std::get<Buffer>(made[backend::KernelBinding::faults]), faults);
        memory.faults = std::bit_cast<backend::KernelFaults>(faults);
    }

    [[nodiscard]] bool is_quad() const { return team_.kind == backend::Team::Kind::quad; }

    // Every device has images of 4096 pixels a side.
    static constexpr std::size_t quad_columns = 256;
    static constexpr std::size_t most_quad_rows = 1024;

    const Device& device_;
    Pipeline pipeline_;
    std::vector<backend::KernelImage> images_;
    std::array<std::uint32_t, 2> layer_size_;
    std::size_t widest_;
    backend::Team team_;
};

}  // namespace

std::unique_ptr<backend::Kernel> Device::make_kernel(const backend::KernelProgram& program) const {
    return with_typed_errors([&] { return std::make_unique<VulkanKernel>(*this, program); });
}

}  // namespace gloam::backend::vulkan
