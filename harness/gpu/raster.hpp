// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/image.hpp"

namespace gloam::gpu {

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
    std::uint32_t image_count = 0;  // storage images that fragments may read: bindings 0, 1, ... of set 0
};

// A compiled graphics pipeline. Throws std::runtime_error when the driver rejects it; std::invalid_argument
// when the words are not a SPIR-V module, or a count, size or format is invalid.
class RasterPipeline {
  public:
    RasterPipeline(const Device& device, const RasterProgram& program);
    ~RasterPipeline();
    RasterPipeline(RasterPipeline&&) noexcept;
    RasterPipeline& operator=(RasterPipeline&&) noexcept;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

struct Draw {
    std::reference_wrapper<const Buffer> vertices;
    std::reference_wrapper<const Buffer> indices;  // uint32
    std::uint32_t index_count = 0;  // three for each triangle; the first is at the start of `indices`
    std::span<const std::byte> push_constants;                  // copied when render() is called
    std::vector<std::reference_wrapper<const Image>> images{};  // read by fragments, not rendered to
};

// Renders all draws in one pass, in order. The attachments are first cleared to clear_color (each channel)
// and the far depth; later commands can read them. All images have the same extent. Throws
// std::invalid_argument when images, push constants or index counts do not match the pipeline or each other.
// Indices must be valid vertices.
void render(Commands& commands, const RasterPipeline& pipeline,
            std::span<const std::reference_wrapper<const Image>> colors, const Image& depth,
            float clear_color, std::span<const Draw> draws);

}  // namespace gloam::gpu
