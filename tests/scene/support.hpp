// SPDX-License-Identifier: MIT
#pragma once

#include "scene/read_gbuffer.hpp"
#include "support/environment.hpp"
#include "support/files.hpp"

namespace gloam::scene::test {

inline std::vector<float> components(const std::vector<glm::vec3>& vectors) {
    std::vector<float> values;
    for (const glm::vec3& v : vectors) values.insert(values.end(), {v.x, v.y, v.z});
    return values;
}

// A portable float map of texels that come with their rows from the top.
inline std::string pfm_text(gpu::Extent extent, const std::vector<float>& texels) {
    const std::size_t row = texels.size() / extent.height;
    std::string text = (row == extent.width ? "Pf\n" : "PF\n") + std::to_string(extent.width) + " " +
                       std::to_string(extent.height) + "\n-1.0\n";
    for (std::size_t y = extent.height; y-- > 0;) {
        const auto begin = texels.begin() + static_cast<std::ptrdiff_t>(y * row);
        text += bytes({begin, begin + static_cast<std::ptrdiff_t>(row)}, true);
    }
    return text;
}

// Writes a frame as an engine would.
inline void write_frame(const TemporaryDirectory& folder, int frame, const GBuffer& gbuffer) {
    const std::string prefix = frame_prefix(frame);
    folder.write(prefix + ".json", frame_json(gbuffer, frame));
    folder.write(prefix + "_depth.pfm", pfm_text(gbuffer.extent, gbuffer.depth));
    if (!gbuffer.normal.empty())
        folder.write(prefix + "_normal.pfm", pfm_text(gbuffer.extent, components(gbuffer.normal)));
    if (!gbuffer.motion.empty())
        folder.write(prefix + "_motion.pfm", pfm_text(gbuffer.extent, components(gbuffer.motion)));
    if (!gbuffer.previous_depth.empty())
        folder.write(prefix + "_previous_depth.pfm", pfm_text(gbuffer.extent, gbuffer.previous_depth));
}

}  // namespace gloam::scene::test
