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
    gpu::Extent extent;
    const char* depth;
    const char* normals;
    bool orthographic;
    double near;
    double far;
    bool reversed;
    bool poisoned;
};

constexpr Row rows[] = {
    {"linear", "fast", {96, 54}, "linear", "view", false, 0.1, 100, false, false},
    {"linear", "balanced", {96, 54}, "linear", "view", false, 0.1, 100, false, false},
    {"linear", "quality", {96, 54}, "linear", "view", false, 0.1, 100, false, false},
    {"linear", "reference", {96, 54}, "linear", "view", false, 0.1, 100, false, false},
    {"odd", "fast", {83, 45}, "buffer", "world", false, 0.1, 100, false, false},
    {"odd", "quality", {83, 45}, "buffer", "view-unorm", false, 0.1, 100, true, false},
    {"infinite", "fast", {96, 54}, "buffer", "world-octahedral-unorm", false, 0.1, infinite, true, false},
    {"infinite", "quality", {31, 57}, "buffer", "view-octahedral", false, 0.1, infinite, false, false},
    {"orthographic", "fast", {83, 45}, "buffer", "view", true, 0.1, 60, false, false},
    {"orthographic", "quality", {96, 54}, "buffer", "world-unorm", true, 0.1, 60, true, false},
    {"no normals", "balanced", {83, 45}, "buffer", "none", false, 0.1, infinite, true, false},
    {"behind the eye", "fast", {83, 45}, "buffer", "view", true, -9, 50, false, false},
    {"poisoned", "balanced", {83, 45}, "linear", "view", false, 0.1, 100, false, true},
    {"poisoned", "quality", {83, 45}, "linear", "view", false, 0.1, 100, false, true}};

template <class Texel>
std::string bytes_of(const std::vector<Texel>& texels) {
    return base::base64(
        {reinterpret_cast<const unsigned char*>(texels.data()), texels.size() * sizeof(Texel)});
}

std::vector<float> numbers_of(const glm::mat4& matrix) {
    return {&matrix[0][0], &matrix[0][0] + 16};
}

scene::GBuffer view_of(const Row& row, scene::Scene& scene) {
    scene.camera_path = {};  // the camera below stands
    if (row.orthographic) scene.camera.projection = scene::Projection::orthographic;
    const double before = row.near > 0.0 ? 0.0 : 0.1 - row.near;
    scene.camera.near = row.near + before;
    scene.camera.far = row.far + before;
    scene.camera.reversed_z = row.reversed;
    scene::GBuffer view = scene::draw(scene, row.extent);
    if (row.poisoned) test::poison(view);
    if (row.normals == "none"s) view.normal.clear();
    view.stored = scene::stored_inputs(
        view, scene::encoding_named(row.depth, view.normal.empty() ? "view" : row.normals));
    view.camera.proj_vk[3][2] -= static_cast<float>(before) * view.camera.proj_vk[2][2];
    return view;
}

ordered_json case_of(const Row& row, const gpu::Device& device, const scene::PassLibrary& passes) {
    scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = view_of(row, scene);
    effect::Settings settings = effect::preset_named(row.preset).settings;
    settings.radius = static_cast<float>(scene.ao_radius);
    settings.output = effect::OutputFormat::r32f;
    settings.history = false;
    std::vector<glm::vec4> normals;
    for (const glm::vec3& normal : view.stored->normal) normals.emplace_back(normal, 0.0F);
    effect::AmbientOcclusion effect(device, passes, view.extent);
    effect.begin(view, settings);
    const std::vector<float> shown = effect.next().filtered;
    return {{"name", std::string(row.name) + " " + row.preset},
            {"preset",
             {{"slices", slices_of(settings)},
              {"steps", settings.own.steps},
              {"half", settings.resolution == effect::Resolution::half},
              {"half_width", settings.filter_half_width}}},
            {"inputs", {{"depth", row.depth}, {"range", "zero-to-one"}, {"normals", row.normals}}},
            {"size", {row.extent.width, row.extent.height}},
            {"radius", scene.ao_radius},
            {"projection", numbers_of(view.camera.proj_vk)},
            {"view", numbers_of(view.camera.view)},
            {"depth", bytes_of(view.stored->depth)},
            {"normal", bytes_of(normals)},
            {"want", bytes_of(shown)}};
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
