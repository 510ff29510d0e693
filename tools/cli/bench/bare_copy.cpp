// SPDX-License-Identifier: MIT
#include "cli/bench/bare_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "gpu/commands.hpp"

namespace gloam::cli {
namespace {

constexpr std::uint32_t group = 64;

std::string text_of(std::size_t words_in, std::size_t words_out) {
    std::string loads;
    for (std::size_t i = 0; i < words_in; ++i)
        loads += fmt::format("uint word{} = i[at * {}u + {}u];\n", i, words_in, i);
    std::string stores;
    for (std::size_t i = 0; i < words_out; ++i)
        stores += fmt::format("o[at * {}u + {}u] = word{};\n", words_out, i, i % words_in);
    return fmt::format(
        "#version 450\nlayout(local_size_x = {}) in;\n"
        "layout(push_constant) uniform Run {{ uint count; }};\n"
        "layout(std430, binding = 0) readonly buffer In {{ uint i[]; }};\n"
        "layout(std430, binding = 1) writeonly buffer Out {{ uint o[]; }};\n"
        "void main() {{ uint at = gl_GlobalInvocationID.x; if (at >= count) return;\n{}{}}}\n",
        group, loads, stores);
}

gpu::ComputePipeline pipeline_of(const check::Lab& lab, std::size_t words_in, std::size_t words_out) {
    const shader::Spirv spirv = lab.compile({.name = "copy", .text = text_of(words_in, words_out)});
    return {lab.device(),
            {.spirv = spirv,
             .bindings = {gpu::BindingKind::storage_buffer, gpu::BindingKind::storage_buffer},
             .push_constant_bytes = sizeof(std::uint32_t)}};
}

}  // namespace

BareCopy::BareCopy(const check::Lab& lab, std::size_t count, std::size_t words_in, std::size_t words_out)
    : device_(&lab.device()),
      count_(count),
      pipeline_(pipeline_of(lab, words_in, words_out)),
      inputs_(lab.device(), count * words_in * sizeof(check::Word)),
      outputs_(lab.device(), count * words_out * sizeof(check::Word)),
      received_(count * words_out) {}

void BareCopy::run(std::span<const check::Word> inputs) {
    std::ranges::copy(inputs, inputs_.as<check::Word>().begin());
    gpu::Commands commands(*device_);
    const std::vector<gpu::Resource> resources{std::cref(inputs_), std::cref(outputs_)};
    const auto count = static_cast<std::uint32_t>(count_);
    commands.dispatch(pipeline_, resources, {(count + group - 1) / group, 1, 1},
                      std::as_bytes(std::span(&count, 1)));
    commands.submit();
    std::ranges::copy(outputs_.as<check::Word>(), received_.begin());
}

}  // namespace gloam::cli
