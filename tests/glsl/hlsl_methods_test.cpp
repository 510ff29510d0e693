// SPDX-License-Identifier: MIT
// Every method as HLSL, as an engine gets it: compiled by glslang's HLSL front end, it gives the results of
// the GLSL.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gathers.hpp"
#include "gpu/commands.hpp"
#include "shader/translate.hpp"

namespace gloam {
namespace hlsl_methods_test {

using test::Camera;
using test::Gather;
using test::Method;
using test::Samples;

constexpr glm::ivec2 size{64, 48};

// Waves on a tilted plane, in front of a wall.
float depth(glm::ivec2 p) {
    const auto x = static_cast<float>(p.x);
    const auto y = static_cast<float>(p.y);
    return p.x > 40 ? 6.5F : 5.0F + 0.01F * x + 0.2F * std::sin(0.3F * x) * std::cos(0.23F * y);
}
glm::vec3 normal(glm::ivec2 p) {
    return glm::normalize(glm::vec3(0.2F * std::cos(0.3F * static_cast<float>(p.x)), 0.1F, 1.0F));
}
// Whatever a method makes of it.
glm::vec4 prepared(glm::ivec2 p) {
    return {depth(p), 0.1F * depth(p), -depth(p), 1.0F};
}

struct Point {
    glm::vec4 position;  // and the number of its first sample
    glm::vec4 normal;
};

std::vector<Point> points() {
    std::vector<Point> all;
    for (int y = 4; y < size.y; y += 6) {
        for (int x = 4; x < size.x; x += 6) {
            const glm::vec2 ndc = (2.0F * glm::vec2(x, y) + 1.0F - glm::vec2(size)) / glm::vec2(size);
            const float d = depth({x, y});
            all.push_back({{ndc / glm::vec2(1.8F, -2.0F) * d, -d, static_cast<float>(16 * (x + y))},
                           {normal({x, y}), 0.0F}});
        }
    }
    return all;
}

// What the engine adds to the file of functions.
constexpr const char* engine = R"(
StructuredBuffer<float4> points : register(t0);
StructuredBuffer<float4> pixels : register(t1);  // depth and normal, then what is prepared
RWStructuredBuffer<float2> results : register(u2);
int index_of(int2 p) { return clamp(p.y, 0, 47) * 64 + clamp(p.x, 0, 63); }
float gloam_fetch_depth(int2 p) { return pixels[2 * index_of(p)].x; }
float3 gloam_fetch_normal(int2 p) { return pixels[2 * index_of(p)].yzw; }
float4 gloam_fetch_prepared(int2 p) { return pixels[2 * index_of(p) + 1]; }
[numthreads(1, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    GloamCamera camera = { float2(1.8f, -2.0f), int2(64, 48), false };
    GatherKernel kernel = { 0.6f, 1e-3f, 0.7f, uint(points[2 * id.x].w), 16u };
    MethodValues values = { 2.0f, 0.05f, 0.2f, 1e3f, 0.0f, 0.0f, 4u, 0.05f, 1e18f };
    results[id.x] = method_gather(points[2 * id.x].xyz, points[2 * id.x + 1].xyz, camera, kernel, values);
}
)";

std::vector<glm::vec2> by_hlsl(const gpu::Device& device, const std::string& hlsl,
                               const std::vector<Point>& given) {
    const shader::Spirv module =
        shader::compile_hlsl({.name = "method.hlsl", .text = hlsl + engine}, shader::Stage::compute);
    gpu::Buffer points(device, given.size() * sizeof(Point));
    std::ranges::copy(given, points.as<Point>().begin());
    gpu::Buffer pixels(device, sizeof(glm::vec4) * 2 * static_cast<std::size_t>(size.x * size.y));
    for (int i = 0; i < size.x * size.y; ++i) {
        const glm::ivec2 p(i % size.x, i / size.x);
        const auto at = 2 * static_cast<std::size_t>(i);
        pixels.as<glm::vec4>()[at] = glm::vec4(depth(p), normal(p));
        pixels.as<glm::vec4>()[at + 1] = prepared(p);
    }
    gpu::Buffer results(device, given.size() * sizeof(glm::vec2));
    const gpu::ComputePipeline pipeline(
        device, {.spirv = module, .bindings = std::vector(3, gpu::BindingKind::storage_buffer)});
    gpu::Commands commands(device);
    commands.dispatch(pipeline, std::vector<gpu::Resource>{points, pixels, results},
                      {static_cast<std::uint32_t>(given.size()), 1, 1});
    commands.submit();
    const auto values = results.as<glm::vec2>();
    return {values.begin(), values.end()};
}

// text: that declares the images which the method reads.
std::vector<glm::vec2> by_glsl(const check::Lab& lab, const std::string& file, const std::string& text,
                               const std::vector<Point>& given) {
    std::vector<check::Kernel<Gather>::Inputs> inputs;
    const Camera camera{glm::vec2(1.8F, -2.0F), size, false};
    for (const Point& point : given) {
        const Samples samples{.radius = 0.6F,
                              .bias = 1e-3F,
                              .angle = 0.7F,
                              .first = static_cast<unsigned>(point.position.w),
                              .count = 16};
        inputs.emplace_back(glm::vec3(point.position), glm::vec3(point.normal), camera, samples,
                            Method{.steps = 4});
    }
    const auto clamped = check::Border::clamp;
    const check::ImageSet images{
        {"gloam_fetch_depth", check::make_image<float>(size, depth, clamped)},
        {"gloam_fetch_normal", check::make_image<glm::vec3>(size, normal, clamped)},
        {"gloam_fetch_prepared", check::make_image<glm::vec4>(size, prepared, clamped)}};
    return check::Kernel<Gather>(lab, file, effect::method_function)(inputs, test::declared_in(text, images));
}

class HlslMethods : public testing::TestWithParam<std::string> {
  protected:
    test::MethodFunctions functions;
};

TEST_P(HlslMethods, GiveTheResultsOfGlsl) {
    const std::string file = test::MethodFunctions::file(GetParam());
    const std::string glsl = test::packed_method(functions, file);
    const std::string hlsl = shader::translated({.name = file, .text = glsl}, shader::Target::hlsl);
    const std::vector<Point> given = points();
    const std::vector<glm::vec2> got = by_hlsl(*test::SharedDevice::get(), hlsl, given);
    const std::vector<glm::vec2> want = by_glsl(functions.lab(), file, glsl, given);
    float largest = 0.0F;
    float spread = 0.0F;
    for (std::size_t i = 0; i < given.size(); ++i) {
        EXPECT_EQ(got[i].y, want[i].y) << "samples of point " << i;
        if (want[i].y == 0.0F) continue;
        largest = std::max(largest, std::abs(got[i].x / got[i].y - want[i].x / want[i].y));
        spread = std::max(spread, std::abs(want[i].x / want[i].y - want[0].x / want[0].y));
    }
    EXPECT_LT(largest, 1e-6F);
    EXPECT_GT(spread, 1e-3F);
    RecordProperty("largest", std::to_string(largest));
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const effect::MethodInfo& method : effect::methods()) names.push_back(method.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, HlslMethods, testing::ValuesIn(method_names()),
                         [](const auto& info) { return info.param; });

}  // namespace hlsl_methods_test
}  // namespace gloam
