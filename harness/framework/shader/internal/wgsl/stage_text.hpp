// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include "shader/internal/wgsl/module_text.hpp"

namespace gloam::shader::internal::wgsl {

// What main() of a vertex or fragment shader reads and writes. WGSL has parameters and a result of the entry
// point in its place: they are private variables here, which the entry point sets before it calls GLSL's
// main(), and returns.
class StageText {
  public:
    // used: the variables of the module that main() uses.
    StageText(ModuleText& text, const std::set<Id>& used);

    // The declaration of one of these variables.
    [[nodiscard]] std::string global(const Variable& variable) const;

    // The entry point `main`, and the structure of its result. body: the name of GLSL's main().
    [[nodiscard]] std::string entry_point(std::uint32_t model, const std::string& body) const;

  private:
    // A parameter or a part of the result: what marks it, its name and type, and the variable's value as GLSL
    // has it.
    struct Port {
        std::string mark;
        std::string name;
        std::string type;
        std::string value;
    };

    [[nodiscard]] std::vector<Port> inputs(std::uint32_t model) const;
    [[nodiscard]] std::vector<Port> outputs(std::uint32_t model) const;
    [[nodiscard]] std::string location(const Variable& variable) const;

    ModuleText& text_;
    const Module& module_;
    const std::set<Id>& used_;
};

}  // namespace gloam::shader::internal::wgsl
