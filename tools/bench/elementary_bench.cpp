// SPDX-License-Identifier: MIT
// The elementary functions of glsl/gloam/numeric beside those that GLSL has itself, on the default device (or
// $GLOAM_BENCH_DEVICE): each dispatch evaluates one of them 2^24 times. Timed in turn; the counter
// `of_builtin` is the time as a fraction of the built-in's, the median over the run.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/device.hpp"
#include "backend/vulkan/resources.hpp"
#include "shader/compile.hpp"

namespace gloam {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t invocations = 1U << 18U;
constexpr std::uint32_t repeats = 64;

// What is compared: two expressions of a float x in [0, 1) that give a float.
struct Pair {
    const char* name;
    const char* own;
    const char* builtin;
};

gpu::DeviceOptions device_options() {
    const char* device = std::getenv("GLOAM_BENCH_DEVICE");
    return {.device = device == nullptr ? "" : device};
}

// Evaluates the expression `repeats` times in every invocation, each at another x.
class Evaluation {
  public:
    Evaluation(const gpu::Device& device, const std::string& expression)
        : device_(device), pipeline_(make_pipeline(device, expression)), outputs_(device, invocations * 4U) {}

    double seconds() {
        gpu::Commands commands(device_);
        const std::vector<gpu::Resource> resources{std::cref(outputs_)};
        commands.dispatch(pipeline_, resources, {invocations / 64, 1, 1});
        const auto begin = Clock::now();
        commands.submit();
        return std::chrono::duration<double>(Clock::now() - begin).count();
    }

  private:
    static gpu::ComputePipeline make_pipeline(const gpu::Device& device, const std::string& expression) {
        const std::string text = fmt::format(
            "#version 450\n"
            "#include \"gloam/numeric/inverse_trigonometry.glsl\"\n#include \"gloam/numeric/sincos.glsl\"\n"
            "layout(local_size_x = 64) in;\n"
            "layout(std430, binding = 0) writeonly buffer Out {{ float o[]; }};\n"
            "float f(float x) {{ return {}; }}\n"
            "void main() {{\n"
            "    uint at = gl_GlobalInvocationID.x;\n    float x = float(at) / {}.0;\n    float sum = 0.0;\n"
            "    for (uint i = 0u; i < {}u; ++i) {{ sum += f(x); x = fract(x + 0.618034); }}\n"
            "    o[at] = sum;\n}}\n",
            expression, invocations, repeats);
        const shader::Spirv spirv =
            shader::compile({.name = "elementary", .text = text}, {.include_roots = {GLOAM_GLSL_DIR}});
        return {device,
                {.spirv = spirv,
                 .bindings = {gpu::BindingKind::storage_buffer},
                 .push_constant_bytes = 0,
                 .constants = {}}};
    }

    const gpu::Device& device_;
    gpu::ComputePipeline pipeline_;
    gpu::Buffer outputs_;
};

void compare(benchmark::State& state, const Pair& pair) {
    const gpu::Device device(device_options());
    Evaluation own(device, pair.own);
    Evaluation builtin(device, pair.builtin);
    own.seconds();  // the drivers compile at the first dispatch
    builtin.seconds();
    std::vector<double> ratios;
    for (auto _ : state) {
        const double seconds = own.seconds();
        state.SetIterationTime(seconds);
        ratios.push_back(seconds / builtin.seconds());
    }
    std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(invocations) * repeats);
    state.counters["of_builtin"] = ratios[ratios.size() / 2];
}

constexpr Pair pairs[] = {
    {"sincos_turns", "dot(gloam_sincos_turns(x), vec2(1.0))", "cos(6.283185307 * x) + sin(6.283185307 * x)"},
    {"sincos", "dot(gloam_sincos(6.0 * x), vec2(1.0))", "cos(6.0 * x) + sin(6.0 * x)"},
    {"sqrt", "gloam_sqrt(x)", "sqrt(x)"},
    {"acos", "gloam_acos(2.0 * x - 1.0)", "acos(2.0 * x - 1.0)"},
    {"atan2", "gloam_atan2(x - 0.5, 0.3 - x)", "atan(x - 0.5, 0.3 - x)"},
};

}  // namespace
}  // namespace gloam

int main(int argc, char** argv) {
    for (const gloam::Pair& pair : gloam::pairs) {
        benchmark::RegisterBenchmark(pair.name,
                                     [&pair](benchmark::State& state) { gloam::compare(state, pair); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::AddCustomContext("device", gloam::gpu::Device(gloam::device_options()).info().name);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
