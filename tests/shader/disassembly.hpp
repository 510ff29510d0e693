// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <sstream>
#include <string>

#include "shader/spirv.hpp"

namespace gloam::shader::test {

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
