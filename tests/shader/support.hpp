// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shader/compile.hpp"
#include "support/files.hpp"

namespace gloam::shader::test {

using gloam::test::TemporaryDirectory;

inline std::filesystem::path fixture(std::string_view name) {
    return std::filesystem::path(FIXTURES) / name;
}

inline CompileOptions with_fixtures(Optimization optimization = Optimization::none) {
    return {.include_roots = {FIXTURES}, .variant = {.optimization = optimization}};
}

// The message of the exception that `action` throws; "" when it throws none of that type.
template <class Error, class Action>
std::string message_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

// A compute shader that stores `expression`, behind `head`.
inline Source kernel(std::string_view head, std::string_view expression) {
    std::string text = "#version 450\n";
    text.append(head).append("\nlayout(local_size_x = 1) in;\n");
    text.append("layout(std430, binding = 0) buffer Out { float result[]; };\n");
    text.append("void main() { result[gl_GlobalInvocationID.x] = ").append(expression).append("; }\n");
    return {"kernel", text};
}

}  // namespace gloam::shader::test
