// SPDX-License-Identifier: MIT
#include "cli/render_files.hpp"

#include <fmt/format.h>

#include <string>

#include "report/image.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

// Of the surface points, in the camera of the frame before; 0 at the background.
std::vector<float> previous_depths(const scene::GBuffer& view) {
    if (view.previous_position.empty()) return view.previous_depth;
    std::vector<float> depths;
    for (const glm::vec3& position : view.previous_position) depths.push_back(0.0F - position.z);
    return depths;
}

}  // namespace

std::vector<float> components_of(const std::vector<glm::vec3>& vectors) {
    std::vector<float> texels;
    texels.reserve(3 * vectors.size());
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z});
    return texels;
}

void write_gbuffer(report::OutputFolder& folder, int number, const scene::GBuffer& view) {
    const std::string prefix = scene::frame_prefix(number);
    const auto write = [&](const char* name, const std::vector<float>& texels, int channels) {
        if (texels.empty()) return;
        folder.write(prefix + name, report::to_pfm(texels, view.extent.width, view.extent.height, channels));
    };
    write("_depth.pfm", view.stored ? view.stored->depth : view.depth, 1);
    write("_normal.pfm", components_of(view.stored ? view.stored->normal : view.normal), 3);
    write("_color.pfm", components_of(view.color), 3);
    write("_motion.pfm", components_of(view.motion), 3);
    if (!view.motion.empty()) write("_previous_depth.pfm", previous_depths(view), 1);
    for (std::size_t i = 0; i < view.layers.size(); ++i)
        write(fmt::format("_layer{}.pfm", i + 1).c_str(), view.layers[i], 1);
    folder.write(prefix + ".json", scene::frame_json(view, number));
}

void write_images(report::OutputFolder& folder, const std::string& stem, const effect::Frame& frame) {
    const auto [width, height] = frame.extent;
    folder.write(stem + "_ao.pfm", report::to_pfm(frame.filtered, width, height, 1));
    folder.write(stem + "_ao.png", report::to_visibility_png(frame.filtered, width, height));
}

}  // namespace gloam::cli
