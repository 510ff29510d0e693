// SPDX-License-Identifier: MIT
#include "effect/internal/surface_inputs.hpp"

namespace gloam::effect {

void SurfaceInputs::take(const scene::GBuffer& gbuffer, const View& view) {
    converts_ = gbuffer.stored.has_value();
    reconstructs_ = gbuffer.normal.empty();
    program_ = {.encoding = converts_ ? gbuffer.stored->encoding : scene::Encoding{},
                .orthographic = view.camera.orthographic(),
                .has_normals = !reconstructs_};
    input_constants_ = input_parameters(view);
    normal_constants_ = normal_parameters(view);
}

void SurfaceInputs::append_steps(Pipelines& pipelines, const ViewImages& images, const gpu::Image& nothing,
                                 std::vector<Step>& steps) const {
    const auto groups = groups_for(images.depth.extent());
    if (converts_) {
        const gpu::Image& normals = images.stored_normal ? *images.stored_normal : nothing;
        steps.push_back({"take_inputs",
                         &pipelines.inputs(program_),
                         {*images.stored_depth, normals, images.depth, images.normal},
                         bytes_of(input_constants_),
                         groups});
    }
    if (reconstructs_) {
        steps.push_back({"normals_from_depth",
                         &pipelines.normals(),
                         {images.depth, images.normal},
                         bytes_of(normal_constants_),
                         groups});
    }
}

}  // namespace gloam::effect
