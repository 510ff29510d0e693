// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "base/hidden.hpp"

namespace gloam::backend::vulkan {

// sampled_image: a SampledImage with its own sampler, or an Image, of which the nearest texel is taken,
// inside of it.
enum class BindingKind { storage_buffer, storage_image, sampled_image, uniform_buffer };

using SpecializationConstant = backend::Constant;

// The parts of a compute pipeline. Entry point "main"; binding i of descriptor set 0 has kind bindings[i].
struct ComputeProgram {
    std::span<const std::uint32_t> spirv;
    std::vector<BindingKind> bindings;
    std::uint32_t push_constant_bytes = 0;
    std::vector<SpecializationConstant> constants;
};

// A compiled compute pipeline. Throws std::runtime_error when the driver rejects it; std::invalid_argument
// when the words are not a SPIR-V module, or when the bindings or push constants (a multiple of 4 bytes)
// exceed the device's limits. The module must match the bindings; only the validation layer checks this.
class ComputePipeline {
  public:
    ComputePipeline(const Device& device, const ComputeProgram& program);

    [[nodiscard]] const std::vector<BindingKind>& bindings() const;

    struct Handles;  // of Vulkan; defined inside this room only
    base::Hidden<Handles> handles;
};

// The resource of a binding: a whole storage buffer, or an image. Shaders may write to buffers and storage
// images.
using Resource = std::variant<std::reference_wrapper<const Buffer>, std::reference_wrapper<const Image>,
                              std::reference_wrapper<const SampledImage>, ImageLevel, LinearImage>;

// Work that is recorded in order and run once. Each command sees the writes of all commands before it.
// Resources and pipelines passed to it must live until submit() returns. After submit() only times_ms() may
// be called; only the validation layer checks this.
class Commands {
  public:
    explicit Commands(const Device& device);

    // Runs `groups` work groups with resources[i] at binding i; 0 groups do nothing. Push constants are
    // copied here. Throws std::invalid_argument when a group count exceeds the device's limit. Resources and
    // push constants must match the pipeline; only the validation layer checks this, here and below.
    void dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                  std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {});

    // The same with the numbers of work groups from three words of a buffer, from byte `at` on, as the
    // commands before it leave them. They are not checked.
    void dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources, const Buffer& groups,
                  std::uint32_t at, std::span<const std::byte> push_constants = {});

    // Records the device's clock after all work so far. Returns the index of the reading in times_ms().
    std::size_t timestamp();

    // Submits the work and waits. Throws backend::DeviceLost; backend::Hang after the device's timeout, and
    // while an earlier submission that timed out still runs (see Device).
    void submit();

    // The readings in milliseconds since the first one. Call it only after submit() has returned. Empty
    // without calls of timestamp(); NaN where DeviceInfo::timestamp_period_ns is 0.
    [[nodiscard]] std::vector<double> times_ms() const;

    struct Handles;  // of Vulkan; defined inside this room only
    base::Hidden<Handles> handles;
};

// The parts of a pipeline that runs a fragment shader for the pixels of one triangle. Its only outputs are
// its resources. Entry points are "main"; the vertex shader makes the corners of gl_VertexIndex, 0 to 2, in
// Vulkan's clip space.
struct RasterProgram {
    std::span<const std::uint32_t> vertex_spirv;
    std::span<const std::uint32_t> fragment_spirv;
    std::uint32_t push_constant_bytes = 0;               // visible to both stages
    std::vector<BindingKind> bindings = {};              // of descriptor set 0, visible to both stages
    std::vector<SpecializationConstant> constants = {};  // of both stages
};

// A compiled graphics pipeline. Throws std::runtime_error when the driver rejects it; std::invalid_argument
// when the words are not a SPIR-V module.
class RasterPipeline {
  public:
    RasterPipeline(const Device& device, const RasterProgram& program);

    struct Handles;  // of Vulkan; defined inside this room only
    base::Hidden<Handles> handles;
};

// Runs the pipeline in a viewport of this size, with the resources at its bindings; later commands can read
// them.
void render(Commands& commands, const RasterPipeline& pipeline, Extent extent,
            std::span<const Resource> resources, std::span<const std::byte> push_constants);

}  // namespace gloam::backend::vulkan
