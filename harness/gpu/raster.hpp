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

// A triangle-list pipeline that renders to colour images and one depth image (cleared first, nearest wins: the depth test is
// LESS with standard z and GREATER when reversed_z). No culling. Vertices: `vertex_floats` float32 values
// each, read as consecutive attributes of the given sizes (location i has attribute_sizes[i] floats).
struct RasterProgram {
    std::span<const std::uint32_t> vertex_spirv;
    std::span<const std::uint32_t> fragment_spirv;
    std::vector<int> attribute_sizes;      // 1 to 4 floats each
    std::vector<Format> color_formats;
    std::uint32_t push_constant_bytes = 0;  // visible to both stages
    bool reversed_z = false;
};

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
    std::uint32_t index_count = 0;
    std::span<const std::byte> push_constants;
};

// Renders all draws in one pass: attachments cleared to clear_color (each channel) and the far depth, then drawn in
// order, then left readable by later commands. All images have the same extent.
void render(Commands& commands, const RasterPipeline& pipeline, std::span<const std::reference_wrapper<const Image>> colors,
            const Image& depth, float clear_color, std::span<const Draw> draws);

}  // namespace gloam::gpu
