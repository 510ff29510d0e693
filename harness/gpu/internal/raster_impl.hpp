// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/internal/guarded.hpp"
#include "gpu/raster.hpp"

namespace gloam::gpu {

struct RasterHandles {
    vk::raii::RenderPass render_pass;
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

struct RasterPipeline::Impl {
    Impl(Context& owner, const RasterProgram& program);

    Context& context;
    std::vector<Format> color_formats;
    std::uint32_t push_constant_bytes;
    bool reversed_z;
    std::uint32_t image_count;
    Guarded<RasterHandles> handles;
};

inline constexpr auto raster_stages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

}  // namespace gloam::gpu
