// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "effect/internal/passes.hpp"

namespace gloam::effect {
namespace {

bool reads_storage_images(const gpu::Device& device, scene::Inputs inputs) {
    return inputs == scene::Inputs::storage || (inputs == scene::Inputs::by_device && runs_on_cpu(device));
}

}  // namespace

bool runs_on_cpu(const gpu::Device& device) {
    return device.info().type == "cpu";
}

gpu::ComputePipeline pipeline_of(const gpu::Device& device, const scene::PassLibrary& library,
                                 const PassSource& source, std::vector<gpu::BindingKind> bindings,
                                 std::size_t push_constant_bytes) {
    const scene::PassLibrary& optimized = source.unrolls ? library.unrolled() : library;
    std::vector<std::string> defines = source.defines;
    if (reads_storage_images(device, library.inputs())) {
        defines.emplace_back("GLOAM_STORAGE_INPUTS");
        std::ranges::replace(bindings, gpu::BindingKind::sampled_image, gpu::BindingKind::storage_image);
    }
    const shader::Spirv spirv = optimized.compile(source.file, defines, source.replaced);
    return {device,
            {.spirv = spirv,
             .bindings = std::move(bindings),
             .push_constant_bytes = static_cast<std::uint32_t>(push_constant_bytes),
             .constants = source.constants}};
}

}  // namespace gloam::effect
