// SPDX-License-Identifier: MIT
#include "scene/read_gbuffer.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <stdexcept>

namespace gloam::scene {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_with_frame(const fs::path& file, const std::string& what) {
    throw std::runtime_error(file.string() + ": " + what);
}

std::string size_text(backend::Extent extent, int channels) {
    return fmt::format("{}x{} with {} channel{}", extent.width, extent.height, channels,
                       channels == 1 ? "" : "s");
}

// Reads the viewport of the image with this stem, PFM or EXR; no texels if neither exists.
std::vector<float> read_image(const fs::path& stem, const FrameDescription& frame, int channels) {
    const fs::path pfm = stem.string() + ".pfm";
    const fs::path exr = stem.string() + ".exr";
    std::error_code none;
    const bool has_pfm = fs::exists(pfm, none);
    const bool has_exr = fs::exists(exr, none);
    if (has_pfm && has_exr)
        fail_with_frame(pfm, "there is " + exr.filename().string() + " as well, expected one of them");
    if (!has_pfm && !has_exr) return {};
    const fs::path& file = has_pfm ? pfm : exr;
    base::FloatImage image = has_pfm ? base::read_pfm(pfm) : read_exr(exr, channels);
    const backend::Extent found{image.width, image.height};
    const backend::Extent extent = with_border(frame.view.extent, frame.around);
    if (found != extent || image.channels != channels) {
        fail_with_frame(
            file, "is " + size_text(found, image.channels) + ", expected " + size_text(extent, channels));
    }
    const Border& around = frame.around;
    const auto n = static_cast<std::uint32_t>(channels);
    return cropped({.extent = {n * extent.width, extent.height},
                    .border = {n * around.left, around.top, n * around.right, around.bottom}},
                   image.texels);
}

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Unit normals; 0 for invalid ones and at the background. Normals of 16-bit files have lengths slightly
// different from 1.
void make_unit(std::vector<glm::vec3>& normals, const std::vector<float>& depth) {
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::dvec3 n = normals[i];
        const double square = is_finite(normals[i]) && std::isfinite(depth[i]) ? glm::dot(n, n) : 0.0;
        if (!(square > 1e-6)) {
            normals[i] = glm::vec3(0);
        } else if (std::abs(square - 1.0) > 1e-6) {  // else as exact as floats are: not to be touched
            normals[i] = glm::vec3(n / std::sqrt(square));
        }
    }
}

// The images as GBuffer has them. Motion that is not finite becomes 0, no history; albedo that is not, 0.
void convert(GBuffer& gbuffer, const Encoding& encoding) {
    for (float& depth : gbuffer.depth) depth = linear_depth(depth, encoding, gbuffer.camera);
    if (encoding != Encoding{})
        for (glm::vec3& normal : gbuffer.normal) normal = view_normal(normal, encoding, gbuffer.camera);
    make_unit(gbuffer.normal, gbuffer.depth);
    for (glm::vec3& m : gbuffer.motion) m = is_finite(m) ? m : glm::vec3(0);
    for (glm::vec3& color : gbuffer.color)
        color = is_finite(color) ? glm::clamp(color, 0.0F, 1.0F) : glm::vec3(0);
}

// Reads PREFIX_layer1 and so on, up to the first missing one.
std::vector<std::vector<float>> read_layers(const fs::path& stem, const FrameDescription& frame) {
    std::vector<std::vector<float>> layers;
    for (int i = 1; i <= most_further_layers; ++i) {
        const std::string name = stem.string() + "_layer" + std::to_string(i);
        std::vector<float> layer = read_image(name, frame, 1);
        if (layer.empty()) continue;
        if (layers.size() + 1 != static_cast<std::size_t>(i))
            fail_with_frame(name + ".pfm", "the layer before it is missing");
        for (float& depth : layer) {
            if (depth == 0.0F || !std::isfinite(depth)) depth = std::numeric_limits<float>::infinity();
        }
        layers.push_back(std::move(layer));
    }
    return layers;
}

// An orthographic projection shows what lies behind the eye's plane as well, where its near plane has a
// negative distance. The eye may stand anywhere along the view direction: it is moved back, so that every
// depth is positive.
void move_in_front_of_the_eye(GBuffer& gbuffer, const Encoding& encoding) {
    CameraFrame& camera = gbuffer.camera;
    const Planes planes = planes_of(camera.proj_vk);
    if (!camera.orthographic() || planes.near > 0.0) return;
    constexpr double margin = 0.01;  // of the depth range, in front of the near plane
    const double distance = -planes.near + margin * (planes.far - planes.near);
    const auto moved = [&](double by) { return glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, by)); };
    camera.proj_vk = glm::mat4(glm::dmat4(camera.proj_vk) * moved(distance));
    camera.view = glm::mat4(moved(-distance) * glm::dmat4(camera.view));
    if (camera.previous_view)
        camera.previous_view = glm::mat4(moved(-distance) * glm::dmat4(*camera.previous_view));
    if (camera.previous_from_current) {
        camera.previous_from_current =
            glm::mat4(moved(-distance) * glm::dmat4(*camera.previous_from_current) * moved(distance));
    }
    const auto push_back = [&](std::vector<float>& depths) {
        for (float& depth : depths) {
            if (depth != 0.0F) depth = static_cast<float>(double{depth} + distance);  // 0 is background
        }
    };
    if (!encoding.depth_buffer) push_back(gbuffer.depth);
    push_back(gbuffer.previous_depth);
}

// The whole pixels of GBuffer::off_centre: that of the frame before, or none, where a jitter leads from one
// to the other.
int whole_off_centre(double pixels, int before) {
    constexpr double jitter = 3.0;  // twice the way of the axis: half a pixel to each side, and rounding
    for (const int known : {before, 0}) {
        if (std::abs(pixels - known) <= jitter) return known;
    }
    return static_cast<int>(std::lround(pixels));
}

}  // namespace

std::string frame_prefix(int frame) {
    if (frame < 0 || frame > 9999)
        throw std::invalid_argument(fmt::format("frame {}: expected 0 to 9999", frame));
    return fmt::format("f{:04}", frame);
}

std::vector<int> frames_of(const fs::path& directory) {
    std::error_code error;
    std::vector<int> frames;
    for (fs::directory_iterator i(directory, error), end; !error && i != end; i.increment(error)) {
        const std::string name = i->path().filename().string();
        const int frame = name.starts_with('f') ? std::atoi(name.c_str() + 1) : -1;
        if (frame >= 0 && frame <= 9999 && name == frame_prefix(frame) + ".json") frames.push_back(frame);
    }
    if (error) fail_with_frame(directory, "cannot be read: " + error.message());
    if (frames.empty()) fail_with_frame(directory, "no frames in it, expected f0000.json and so on");
    std::ranges::sort(frames);
    return frames;
}

GBuffer read_gbuffer(const fs::path& directory, int frame, const Encoding& encoding,
                     const glm::ivec2& off_centre) {
    const fs::path stem = directory / frame_prefix(frame);
    const FrameDescription description = read_frame_json(stem.string() + ".json");
    const auto numbers = [&](const char* name, int channels = 1) {
        return read_image(stem.string() + name, description, channels);
    };
    const auto vectors = [&](const char* name) { return vectors_of(numbers(name, 3), 3); };
    GBuffer gbuffer = description.view;
    gbuffer.depth = numbers("_depth");
    gbuffer.normal = vectors("_normal");
    if (description.left_handed && !encoding.world)
        for (glm::vec3& normal : gbuffer.normal) normal = other_handed(normal, encoding);
    gbuffer.motion = vectors("_motion");
    gbuffer.previous_depth = numbers("_previous_depth");
    gbuffer.color = vectors("_color");
    for (const int axis : {0, 1})
        gbuffer.off_centre[axis] = whole_off_centre(description.off_centre[axis], off_centre[axis]);
    gbuffer.layers = read_layers(stem, description);
    if (!gbuffer.previous_depth.empty() && gbuffer.motion.empty())
        fail_with_frame(stem.string() + "_previous_depth.pfm",
                        "there are no motion vectors, which it belongs to");
    if (gbuffer.depth.empty()) fail_with_frame(stem.string() + "_depth.pfm", "is missing (and so is .exr)");
    move_in_front_of_the_eye(gbuffer, encoding);
    StoredInputs as_stored{.encoding = encoding, .depth = gbuffer.depth, .normal = gbuffer.normal};
    convert(gbuffer, encoding);
    const std::string contradiction = contradiction_of(gbuffer, as_stored);
    if (!contradiction.empty()) fail_with_frame(stem, contradiction);
    if (encoding != Encoding{}) gbuffer.stored = std::move(as_stored);
    return gbuffer;
}

}  // namespace gloam::scene
