// SPDX-License-Identifier: MIT
#pragma once

#include "module/compile.hpp"
#include "module/fixtures.hpp"
#include "module/spirv.hpp"

namespace gloam::module {

inline std::filesystem::path fixture(std::string_view name) {
    return fixtures() / name;
}

inline CompileOptions with_fixtures(Optimization optimization = Optimization::none) {
    return {.include_roots = {fixtures()}, .variant = {.optimization = optimization}};
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
inline source::Source kernel(std::string_view head, std::string_view expression) {
    std::string text = "#version 450\n";
    text.append(head).append("\nlayout(local_size_x = 1) in;\n");
    text.append("layout(std430, binding = 0) buffer Out { float result[]; };\n");
    text.append("void main() { result[gl_GlobalInvocationID.x] = ").append(expression).append("; }\n");
    return {"kernel", text};
}

// Functions as GLSL has them; "? " stands before those without a body.
inline std::vector<std::string> prototypes(const std::vector<Function>& functions) {
    std::vector<std::string> texts;
    for (const Function& function : functions)
        texts.push_back((function.defined ? "" : "? ") + to_glsl(function));
    return texts;
}

// What a test asks of a module, as its disassembly has it.
class Disassembly {
  public:
    explicit Disassembly(const Spirv& module) {
        std::istringstream lines(disassemble(module));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            rows_.emplace_back(std::istream_iterator<std::string>(words),
                               std::istream_iterator<std::string>());
            rows_.back().resize(std::max<std::size_t>(rows_.back().size(), 4));
        }
    }

    // The result IDs of every instruction of that kind: "OpFAdd".
    [[nodiscard]] std::set<std::string> results(const std::string& opcode) const {
        return of<std::set<std::string>>(0,
                                         [&](const Row& row) { return row[1] == "=" && row[2] == opcode; });
    }
    // Every ID that carries the decoration, how often.
    [[nodiscard]] std::multiset<std::string> decorated(const std::string& decoration) const {
        return of<std::multiset<std::string>>(
            1, [&](const Row& row) { return row[0] == "OpDecorate" && row[2] == decoration; });
    }
    // The result IDs with a type of that name: "%float", "%v3float".
    [[nodiscard]] std::set<std::string> of_type(const std::string& type) const {
        return of<std::set<std::string>>(0, [&](const Row& row) {
            return row[1] == "=" && row[3] == type && !row[2].starts_with("OpType");
        });
    }

  private:
    using Row = std::vector<std::string>;
    template <class Ids, class Predicate>
    [[nodiscard]] Ids of(std::size_t column, Predicate predicate) const {
        Ids ids;
        for (const Row& row : rows_)
            if (predicate(row)) ids.insert(row[column]);
        return ids;
    }
    std::vector<Row> rows_;
};

}  // namespace gloam::module
