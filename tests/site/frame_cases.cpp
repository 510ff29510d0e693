// SPDX-License-Identifier: MIT
// frame_cases FILE: views as engines store them, and the occlusion that the passes of the frame give for them
// on Vulkan, as a script for the page.
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "backend/vulkan/device.hpp"
#include "base/text.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "scene/draw.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"
#include "support/poison.hpp"

namespace {

using namespace gloam;
using nlohmann::ordered_json;
using namespace std::string_literals;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Row {
    const char* name;
    const char* preset;
    gpu::Extent extent{96, 54};
    const char* depth = "linear";
    const char* normals = "view";
    bool orthographic = false;
    double near = 0.1;
    double far = 100;
    bool reversed = false;
    bool poisoned = false;
    double aside = 0.0;  // of the camera's axis: half images
    int frames = 1;
    double speed = 0.0;  // of the camera, world units a frame
};

constexpr gpu::Extent odd{83, 45};
constexpr Row rows[] = {
    {"linear", "fast"},
    {"linear", "balanced"},
    {"linear", "quality"},
    {"linear", "reference"},
    {"odd", "fast", odd, "buffer", "world"},
    {"odd", "quality", odd, "buffer", "view-unorm", false, 0.1, 100, true},
    {"infinite", "fast", {96, 54}, "buffer", "world-octahedral-unorm", false, 0.1, infinite, true},
    {"infinite", "quality", {31, 57}, "buffer", "view-octahedral", false, 0.1, infinite},
    {"orthographic", "fast", odd, "buffer", "view", true, 0.1, 60},
    {"orthographic", "quality", {96, 54}, "buffer", "world-unorm", true, 0.1, 60, true},
    {"no normals", "balanced", odd, "buffer", "none", false, 0.1, infinite, true},
    {"behind the eye", "fast", odd, "buffer", "view", true, -9, 50},
    {.name = "poisoned", .preset = "balanced", .extent = odd, .poisoned = true},
    {.name = "poisoned", .preset = "quality", .extent = odd, .poisoned = true},
    {.name = "moving", .preset = "fast", .extent = odd, .depth = "buffer", .frames = 5, .speed = 0.05},
    {.name = "moving",
     .preset = "balanced",
     .depth = "buffer",
     .reversed = true,
     .frames = 5,
     .speed = -0.05},
    {.name = "moving", .preset = "quality", .extent = odd, .poisoned = true, .frames = 5, .speed = 0.05},
    {.name = "moving", .preset = "reference", .frames = 5, .speed = 0.05},
    {.name = "off its centre", .preset = "quality", .aside = 0.2, .frames = 4, .speed = 0.05},
    {"orthographic, moving", "balanced", odd, "buffer", "view", true, -9, 50, false, false, -0.2, 4, 0.05},
    {.name = "camera that stands", .preset = "balanced", .frames = 9},
    {.name = "camera that stands", .preset = "quality", .frames = 9}};

template <class Texel>
std::string bytes_of(const std::vector<Texel>& texels) {
    return base::base64(
        {reinterpret_cast<const unsigned char*>(texels.data()), texels.size() * sizeof(Texel)});
}

std::vector<float> numbers_of(const glm::mat4& matrix) {
    return {&matrix[0][0], &matrix[0][0] + 16};
}

scene::GBuffer view_of(const Row& row, scene::Scene& scene, int frame) {
    scene::Camera camera = scene.camera;
    if (row.orthographic) camera.projection = scene::Projection::orthographic;
    const double before = row.near > 0.0 ? 0.0 : 0.1 - row.near;
    camera.near = row.near + before;
    camera.far = row.far + before;
    camera.reversed_z = row.reversed;
    scene.camera_path = [camera, &row](int number) {
        scene::Camera moved = camera;
        moved.eye.x += row.speed * number;
        moved.target.x += row.speed * number;
        return moved;
    };
    scene::GBuffer view = scene::draw(scene, row.extent, {.frame = frame});
    if (row.poisoned) test::poison(view);
    if (row.normals == "none"s) view.normal.clear();
    view.stored = scene::stored_inputs(
        view, scene::encoding_named(row.depth, view.normal.empty() ? "view" : row.normals));
    view.camera.proj_vk[3][2] -= static_cast<float>(before) * view.camera.proj_vk[2][2];
    view.camera.proj_vk[row.orthographic ? 3 : 2][0] += static_cast<float>(row.aside);
    return view;
}

ordered_json frame_json(const scene::GBuffer& view, const std::vector<float>& shown) {
    std::vector<glm::vec4> normals;
    for (const glm::vec3& normal : view.stored->normal) normals.emplace_back(normal, 0.0F);
    return {{"projection", numbers_of(view.camera.proj_vk)},
            {"view", numbers_of(view.camera.view)},
            {"depth", bytes_of(view.stored->depth)},
            {"normal", bytes_of(normals)},
            {"want", bytes_of(shown)}};
}

ordered_json case_of(const Row& row, const gpu::Device& device, const scene::PassLibrary& passes) {
    scene::Scene scene = scene::make_scene(row.frames > 1 ? "moving" : "columns");
    effect::Settings settings = effect::preset_named(row.preset).settings;
    settings.radius = static_cast<float>(scene.ao_radius);
    settings.output = effect::OutputFormat::r32f;
    settings.history = row.frames > 1;
    effect::AmbientOcclusion effect(device, passes, row.extent);
    ordered_json frames = ordered_json::array();
    for (int i = 0; i < row.frames; ++i) {
        const scene::GBuffer view = view_of(row, scene, i);
        i == 0 ? effect.begin(view, settings) : effect.advance(view);
        frames.push_back(frame_json(view, effect.next().filtered));
    }
    return {{"name", std::string(row.name) + " " + row.preset},
            {"preset", row.preset},
            {"inputs", {{"depth", row.depth}, {"normals", row.normals}}},
            {"size", {row.extent.width, row.extent.height}},
            {"radius", scene.ao_radius},
            {"frames", frames}};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "frame_cases FILE\n";
        return 2;
    }
    const scene::PassLibrary passes(GLOAM_GLSL_DIR);
    const gpu::Device device({.validation = gpu::Validation::on});
    ordered_json cases = ordered_json::array();
    for (const Row& row : rows) cases.push_back(case_of(row, device, passes));
    std::ofstream(argv[1]) << "const cases = " << cases.dump() << ";\n";
    return 0;
}
