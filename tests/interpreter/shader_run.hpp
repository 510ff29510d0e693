// SPDX-License-Identifier: MIT
#pragma once

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "interpreter/machine.hpp"
#include "module/compile.hpp"
#include "numeric/paths.hpp"
#include "support/test.hpp"

namespace gloam::test {

using interpreter::Word;

// Compute shaders of one shape: row by row `inputs` words at binding 0, `outputs` words at binding 1, the row
// being gl_GlobalInvocationID.x, work groups of one invocation.
struct Rows {
    std::vector<Word> inputs;
    std::size_t input_words = 0;
    std::size_t output_words = 0;

    [[nodiscard]] std::size_t count() const { return inputs.size() / input_words; }
};

// What comes before main() of such a shader: input(k) and output(k, word).
inline std::string row_shader(std::size_t input_words, std::size_t output_words, const std::string& body,
                              const std::string& functions = {}) {
    return "#version 450\n"
           "layout(local_size_x = 1) in;\n"
           "layout(std430, binding = 0) readonly buffer In { uint in_words[]; };\n"
           "layout(std430, binding = 1) buffer Out { uint out_words[]; };\n"
           "uint row() { return gl_GlobalInvocationID.x; }\n"
           "uint word(uint k) { return in_words[row() * " +
           std::to_string(input_words) +
           "u + k]; }\n"
           "float number(uint k) { return uintBitsToFloat(word(k)); }\n"
           "void put(uint k, uint w) { out_words[row() * " +
           std::to_string(output_words) +
           "u + k] = w; }\n"
           "void put(uint k, int w) { put(k, uint(w)); }\n"
           "void put(uint k, bool w) { put(k, w ? 1u : 0u); }\n"
           "void put(uint k, float w) { put(k, floatBitsToUint(w)); }\n" +
           functions + "\nvoid main() {\n" + body + "}\n";
}

// The error that an action throws.
template <class Action>
interpreter::Error error_of(const Action& action) {
    try {
        action();
    } catch (const interpreter::Error& error) {
        return error;
    }
    ADD_FAILURE() << "no error";
    return {interpreter::Error::Kind::missing, ""};
}

inline module::Spirv strictly_compiled(const std::string& text) {
    return module::compile({.name = "test", .text = text}, {.variant = module::variant("strict")});
}

inline std::vector<Word> on_device(const backend::vulkan::Device& device, const module::Spirv& module,
                                   const Rows& rows) {
    const backend::vulkan::ComputePipeline pipeline(
        device, {.spirv = module,
                 .bindings = {backend::vulkan::BindingKind::storage_buffer,
                              backend::vulkan::BindingKind::storage_buffer},
                 .push_constant_bytes = 0,
                 .constants = {}});
    backend::vulkan::Buffer inputs(device, rows.inputs.size() * sizeof(Word));
    backend::vulkan::Buffer outputs(device, rows.count() * rows.output_words * sizeof(Word));
    std::ranges::copy(rows.inputs, inputs.as<Word>().begin());
    std::ranges::fill(outputs.as<Word>(), 0U);
    backend::vulkan::Commands commands(device);
    const std::vector<backend::vulkan::Resource> buffers{std::cref(inputs), std::cref(outputs)};
    commands.dispatch(pipeline, buffers, {static_cast<Word>(rows.count()), 1, 1});
    commands.submit();
    const auto words = outputs.as<Word>();
    return {words.begin(), words.end()};
}

// The values that the interpreter writes for one row.
template <class N>
std::vector<interpreter::Value<N>> interpreted(interpreter::Machine<N>& machine, std::span<const Word> row,
                                               std::size_t output_words) {
    const std::vector<Word> none(output_words, 0U);
    machine.bind(0, 0, row);
    machine.bind(0, 1, none);
    machine.set_invocation({0, 0, 0});
    machine.run();
    std::vector<interpreter::Value<N>> values;
    for (std::size_t w = 0; w < output_words; ++w) values.push_back(machine.read(0, 1, w));
    return values;
}

inline std::vector<Word> rounded_correctly(const interpreter::Program& program, const Rows& rows) {
    interpreter::Machine<float> machine(program);
    std::vector<Word> all;
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const auto row = std::span(rows.inputs).subspan(r * rows.input_words, rows.input_words);
        for (const auto& value : interpreted(machine, row, rows.output_words)) all.push_back(value.bits());
    }
    return all;
}

}  // namespace gloam::test
