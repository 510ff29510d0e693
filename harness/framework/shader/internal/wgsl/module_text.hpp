// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "shader/internal/wgsl/module.hpp"

namespace gloam::shader::internal::wgsl {

// Whether WGSL reserves the word: keywords and the names of predeclared types.
[[nodiscard]] bool is_reserved(const std::string& word);
// Whether it is the name of a predeclared function of WGSL.
[[nodiscard]] bool is_builtin(const std::string& word);

// An identifier of WGSL like this name; "unnamed" where nothing is left of it.
[[nodiscard]] std::string identifier(const std::string& name);

// Names that are used, each once.
class Names {
  public:
    // The name, or the name with a number where it is taken; it is taken then.
    std::string take(const std::string& wanted);
    void reserve(const std::string& name) { taken_.insert(name); }
    [[nodiscard]] bool has(const std::string& name) const { return taken_.contains(name); }

  private:
    std::set<std::string> taken_;
};

using CommentOf = std::function<std::string(const std::string& block, const std::string& name)>;

// How an image of the module is declared.
enum class ImageUse { texture, writes, reads_and_writes };

// What all functions of a module share: names at module scope, types, constants, helper functions.
class ModuleText {
  public:
    // See WgslOptions.
    ModuleText(const Module& module, const Facts& facts, const CommentOf& comment_of);

    [[nodiscard]] const Module& module() const { return module_; }
    [[nodiscard]] const Facts& facts() const { return facts_; }

    // "f32", "vec3f", "array<u32, 4>", a structure's name.
    [[nodiscard]] std::string type(Id type);
    // The type of a variable of the module.
    [[nodiscard]] std::string variable_type(const Variable& variable);
    // The type of an image or a sampler, of a variable of the module or a parameter.
    [[nodiscard]] std::string opaque_type(Id variable, Id type);
    [[nodiscard]] std::string member_name(Id structure, std::uint32_t member);
    [[nodiscard]] const std::string& name(Id id) const {
        return entry_of(names_, id, "a function or a variable without a name");
    }
    void rename(Id id, const std::string& wanted) { names_[id] = names.take(wanted); }
    [[nodiscard]] bool has_name(Id id) const { return names_.contains(id); }
    [[nodiscard]] ImageUse image_use(Id variable) const;
    // The sampler that is declared for a combined one.
    [[nodiscard]] std::string sampler_of(Id variable) const {
        return entry_of(sampler_names_, variable, "a sampler in an array");
    }
    [[nodiscard]] bool has_sampler(Id variable) const { return sampler_names_.contains(variable); }

    // The text needs `enable EXTENSION;`.
    void need_extension(const std::string& extension) { extensions_.insert(extension); }
    // The text has derivatives, which GLSL allows where only some invocations run.
    void need_derivatives() { derivatives_ = true; }
    // The lines that enable what is needed.
    [[nodiscard]] std::string enabled() const;

    // A constant, also one that is specialized.
    [[nodiscard]] Expression constant(Id id);

    // The name of a helper function, which is written once: "is_nan" for a shape of operands.
    [[nodiscard]] std::string helper(const std::string& kind, Id operand_type);

    // Declarations of the structures that were used, of the specialization constants, and of the helpers.
    [[nodiscard]] std::string structures() const { return structures_; }
    [[nodiscard]] std::string overrides(const std::set<Id>& used);
    [[nodiscard]] std::string helpers() const { return helpers_; }
    [[nodiscard]] const std::set<Id>& overrides_used() const { return overrides_used_; }

    Names names;

  private:
    void name_all();
    // The comment, indented; it may be empty.
    [[nodiscard]] std::string comment(const std::string& block, const std::string& name,
                                      const std::string& indent) const;
    [[nodiscard]] std::string structure(Id type);
    [[nodiscard]] std::string member_text(Id structure, std::uint32_t member, std::uint32_t at);
    [[nodiscard]] std::string atomic_type(Id type);
    [[nodiscard]] std::string array(const Type& array);
    [[nodiscard]] std::string array_length(const Type& array);
    // array_length(), which only shared variables may have from a specialization constant.
    [[nodiscard]] std::string fixed_length(const Type& array);
    [[nodiscard]] Expression number(const Instruction& constant);
    [[nodiscard]] Expression composite(const Instruction& constant);
    [[nodiscard]] Expression computed(const Instruction& constant);

    const Module& module_;
    const Facts& facts_;
    const CommentOf& comment_of_;
    std::map<Id, std::string> names_;
    std::map<Id, std::string> structure_names_;
    std::map<std::string, std::string> structure_by_body_;
    std::map<Id, std::vector<std::string>> member_names_;
    std::map<std::string, std::string> helper_names_;
    std::map<Id, std::string> sampler_names_;  // by the combined ones
    std::set<std::string> extensions_;
    bool derivatives_ = false;
    std::set<Id> overrides_used_;
    std::string structures_;
    std::string helpers_;
};

// Scalars of 32 bits as numbers of WGSL.
[[nodiscard]] Expression float_literal(std::uint32_t bits);

// The size in bytes that WGSL gives a type of a buffer, and its alignment.
struct Layout {
    std::uint32_t size = 0;
    std::uint32_t alignment = 1;
};
[[nodiscard]] Layout layout_of(const Module& module, Id type);

}  // namespace gloam::shader::internal::wgsl
