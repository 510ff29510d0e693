// SPDX-License-Identifier: MIT
// Evaluations per second through the framework, for a cheap and a costly equation, beside a bare dispatch
// that copies the same bytes: input words in, output words and canary out. Compare within one run; the
// counter `of_copy` is the rate as a fraction of the copy's.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "check/lab.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "shader/compile.hpp"

namespace gloam {
namespace {

using check::Word;
using Clock = std::chrono::steady_clock;

constexpr std::size_t evaluations = 1U << 20U;

check::Lab make_lab() {
    return check::Lab({.include_roots = {GLOAM_GLSL_DIR}});
}

// Copies `words_in` words of every input to `words_out` words of its output, over and over where there are
// fewer.
class Copy {
  public:
    Copy(const gpu::Device& device, std::size_t words_in, std::size_t words_out)
        : device_(device),
          pipeline_(make_pipeline(device, words_in, words_out)),
          inputs_(device, evaluations * words_in * sizeof(Word)),
          outputs_(device, evaluations * words_out * sizeof(Word)),
          received_(evaluations * words_out) {}

    void run(const std::vector<Word>& words) {
        std::ranges::copy(words, inputs_.as<Word>().begin());
        gpu::Commands commands(device_);
        const std::vector<gpu::Resource> resources{std::cref(inputs_), std::cref(outputs_)};
        const Word count = evaluations;
        commands.dispatch(pipeline_, resources, {evaluations / 64, 1, 1},
                          std::as_bytes(std::span(&count, 1)));
        commands.submit();
        std::ranges::copy(outputs_.as<Word>(), received_.begin());
        benchmark::DoNotOptimize(received_.data());
    }

  private:
    static gpu::ComputePipeline make_pipeline(const gpu::Device& device, std::size_t words_in,
                                              std::size_t words_out) {
        std::string body;
        for (std::size_t i = 0; i < words_out; ++i)
            body += fmt::format("o[at * {}u + {}u] = word{};\n", words_out, i, i % words_in);
        std::string loads;
        for (std::size_t i = 0; i < words_in; ++i)
            loads += fmt::format("uint word{} = i[at * {}u + {}u];\n", i, words_in, i);
        const std::string text = fmt::format(
            "#version 450\nlayout(local_size_x = 64) in;\nlayout(push_constant) uniform Run {{ uint count; "
            "}};\n"
            "layout(std430, binding = 0) readonly buffer In {{ uint i[]; }};\n"
            "layout(std430, binding = 1) writeonly buffer Out {{ uint o[]; }};\n"
            "void main() {{ uint at = gl_GlobalInvocationID.x; if (at >= count) return;\n{}{}}}\n",
            loads, body);
        const shader::Spirv spirv = shader::compile({.name = "copy", .text = text}, {});
        return {device,
                {.spirv = spirv,
                 .bindings = {gpu::BindingKind::storage_buffer, gpu::BindingKind::storage_buffer},
                 .push_constant_bytes = sizeof(Word),
                 .constants = {}}};
    }

    const gpu::Device& device_;
    gpu::ComputePipeline pipeline_;
    gpu::Buffer inputs_;
    gpu::Buffer outputs_;
    std::vector<Word> received_;
};

// Times the framework and the copy in turn, so that the machine's moods fall on both.
void evaluate(benchmark::State& state, const std::string& equation) {
    const check::Lab lab = make_lab();
    const check::Case check_case = catalogue::select(catalogue::all_entries(), {equation}).front().check_case;
    const check::KernelCore kernel = lab.kernel(check_case.file, check_case.function, check_case.signature);
    const check::Domain::Inputs inputs = check_case.domain.draw(evaluations, 1);
    Copy copy(lab.device(), kernel.input_words(), kernel.output_words() + 1);
    copy.run(inputs.words);  // the drivers compile at the first dispatch
    benchmark::DoNotOptimize(kernel.run(inputs.words, evaluations));
    std::vector<double> ratios;
    for (auto _ : state) {
        const auto begin = Clock::now();
        benchmark::DoNotOptimize(kernel.run(inputs.words, evaluations));
        const auto middle = Clock::now();
        copy.run(inputs.words);
        const auto end = Clock::now();
        const std::chrono::duration<double> own = middle - begin;
        state.SetIterationTime(own.count());
        ratios.push_back(std::chrono::duration<double>(end - middle) / own);
    }
    std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(evaluations));
    state.counters["of_copy"] = ratios[ratios.size() / 2];
}

BENCHMARK_CAPTURE(evaluate, cheap_falloff_linear, std::string("gloam_falloff_linear"))
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluate, costly_halton_3d, std::string("gloam_halton_3d"))
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Opening a device and making one kernel: with nothing kept, and from the caches.
void make_kernel(benchmark::State& state, bool warm) {
    const auto cache = std::filesystem::temp_directory_path() / "gloam-bench-cache";
    std::filesystem::remove_all(cache);
    for (auto _ : state) {
        const check::Lab lab(
            {.include_roots = {GLOAM_GLSL_DIR}, .cache_directory = warm ? cache : std::filesystem::path{}});
        const check::Case check_case =
            catalogue::select(catalogue::all_entries(), {"gloam_blend"}).front().check_case;
        benchmark::DoNotOptimize(lab.kernel(check_case.file, check_case.function, check_case.signature));
    }
    std::filesystem::remove_all(cache);
}

BENCHMARK_CAPTURE(make_kernel, cold, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_kernel, warm, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gloam

BENCHMARK_MAIN();
