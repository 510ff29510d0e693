// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>

#include "shader/compile.hpp"

namespace gloam::shader::test {

inline std::filesystem::path fixture(std::string_view name) {
    return std::filesystem::path(FIXTURES) / name;
}

inline CompileOptions with_fixtures(Optimization optimization = Optimization::none) {
    return {.include_roots = {FIXTURES}, .variant = {.optimization = optimization}};
}

// A folder of its own for the time of a test.
class TempDir {
  public:
    TempDir() {
        std::random_device random;
        path_ = std::filesystem::temp_directory_path() /
                ("gloam-shader-" + std::to_string(random()) + "-" + std::to_string(random()));
        std::filesystem::create_directories(path_);
    }
    ~TempDir() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;

    const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(std::string_view name, std::string_view text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

  private:
    std::filesystem::path path_;
};

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
