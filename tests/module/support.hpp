// SPDX-License-Identifier: MIT
#pragma once

#include "module/compile.hpp"
#include "module/spirv.hpp"
#include "support/files.hpp"

namespace gloam::shader::test {

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

// What a test asks of a module, as its disassembly has it.
class Disassembly {
  public:
    explicit Disassembly(const Spirv& module) : text_(disassemble(module)) {
        std::istringstream lines(text_);
        for (std::string line; std::getline(lines, line);) read(line);
    }

    [[nodiscard]] const std::string& text() const { return text_; }

    // The result IDs of every instruction of that kind: "OpFAdd".
    [[nodiscard]] std::set<std::string> results(const std::string& opcode) const {
        const auto found = results_.find(opcode);
        return found == results_.end() ? std::set<std::string>{} : found->second;
    }

    // Every ID that carries the decoration, how often.
    [[nodiscard]] std::multiset<std::string> decorated(const std::string& decoration) const {
        const auto found = decorated_.find(decoration);
        return found == decorated_.end() ? std::multiset<std::string>{} : found->second;
    }

    // The result IDs with a type of that name: "%float", "%v3float".
    [[nodiscard]] std::set<std::string> of_type(const std::string& type) const {
        const auto found = typed_.find(type);
        return found == typed_.end() ? std::set<std::string>{} : found->second;
    }

  private:
    void read(const std::string& line) {
        std::istringstream words(line);
        std::string first;
        std::string second;
        std::string third;
        std::string fourth;
        words >> first >> second >> third >> fourth;
        if (first == "OpDecorate") decorated_[third].insert(second);
        if (second != "=") return;
        results_[third].insert(first);
        if (!third.starts_with("OpType")) typed_[fourth].insert(first);
    }

    std::string text_;
    std::map<std::string, std::set<std::string>> results_;
    std::map<std::string, std::set<std::string>> typed_;
    std::map<std::string, std::multiset<std::string>> decorated_;
};

}  // namespace gloam::shader::test

namespace gloam::shader {

using namespace test;

}  // namespace gloam::shader
