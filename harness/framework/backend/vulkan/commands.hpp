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

namespace gloam::gpu {

// sampled_image: a SampledImage with its own sampler, or an Image for texelFetch, which uses no sampler.
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

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    base::Hidden<Impl> impl_;
};

// The resource of a binding: a whole storage buffer, or an image. Shaders may write to buffers and storage
// images.
using Resource =
    std::variant<std::reference_wrapper<const Buffer>, std::reference_wrapper<const Image>,
                 std::reference_wrapper<const SampledImage>, std::reference_wrapper<const LayeredImage>>;

// Work that is recorded in order and run once. Each command sees the writes of all commands before it.
// Resources and pipelines passed to it must live until submit() returns. After submit() only times_ms() may
// be called; recording or submitting again throws std::runtime_error.
class Commands {
  public:
    explicit Commands(const Device& device);

    // Runs `groups` work groups with resources[i] at binding i; 0 groups do nothing. Push constants are
    // copied here. Throws std::invalid_argument when a group count exceeds the device's limit. Resources and
    // push constants must match the pipeline; only the validation layer checks this, here and below.
    void dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                  std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {});

    // The same with the numbers of groups in x, y and z from a buffer, read when the dispatch runs, after the
    // writes of the commands before it. They are three uint at `offset` bytes.
    void dispatch_indirect(const ComputePipeline& pipeline, std::span<const Resource> resources,
                           const Buffer& groups, std::size_t offset,
                           std::span<const std::byte> push_constants = {});

    // Records the device's clock after all work so far. Returns the index of the reading in times_ms().
    std::size_t timestamp();

    // Submits the work and waits. Throws backend::DeviceLost; backend::Hang after the device's timeout, and
    // while an earlier submission that timed out still runs (see Device).
    void submit();

    // The readings in milliseconds since the first one, after submit(). Empty without calls of timestamp();
    // NaN where DeviceInfo::timestamp_period_ns is 0. Throws std::runtime_error unless submit() succeeded.
    [[nodiscard]] std::vector<double> times_ms() const;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    base::Hidden<Impl> impl_;
};

// The parts of a pipeline that renders triangle lists to colour images and one depth image. Entry points are
// "main"; fragment output i goes to colour image i. The nearest fragment wins: the depth test is LESS with
// standard z and GREATER with reversed_z. No culling, no blending. A vertex is a sequence of float32 values,
// read as consecutive attributes: location i has attribute_sizes[i] floats. Clip space is Vulkan's: y down
// (NDC -1 is the top row), z from 0 to 1.
struct RasterProgram {
    std::span<const std::uint32_t> vertex_spirv;
    std::span<const std::uint32_t> fragment_spirv;
    std::vector<int> attribute_sizes;  // 1 to 4 floats each
    std::vector<Format> color_formats;
    std::uint32_t push_constant_bytes = 0;  // visible to both stages
    bool reversed_z = false;
    std::vector<BindingKind> bindings = {};              // of descriptor set 0, visible to both stages
    std::vector<SpecializationConstant> constants = {};  // of both stages
};

// A compiled graphics pipeline. Throws std::runtime_error when the driver rejects it; std::invalid_argument
// when the words are not a SPIR-V module.
class RasterPipeline {
  public:
    RasterPipeline(const Device& device, const RasterProgram& program);

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    base::Hidden<Impl> impl_;
};

struct Draw {
    std::reference_wrapper<const Buffer> vertices;
    std::reference_wrapper<const Buffer> indices;  // uint32
    std::uint32_t index_count = 0;  // three for each triangle; the first is at the start of `indices`
    std::span<const std::byte> push_constants;  // copied when render() is called
    std::vector<Resource> resources{};          // at the pipeline's bindings; none is rendered to
};

// Renders all draws in one pass, in order. The attachments are first cleared to clear_color (each channel)
// and the far depth; later commands can read them. All images have the same extent. Indices must be valid
// vertices.
void render(Commands& commands, const RasterPipeline& pipeline,
            std::span<const std::reference_wrapper<const Image>> colors, const Image& depth,
            float clear_color, std::span<const Draw> draws);

// The parts of a pipeline, for running it elsewhere.
struct PipelineProgram {
    std::vector<std::uint32_t> spirv;
    std::vector<SpecializationConstant> constants;
    std::vector<BindingKind> bindings;
};
[[nodiscard]] const PipelineProgram& program_of(const ComputePipeline& pipeline);

}  // namespace gloam::gpu
