// SPDX-License-Identifier: MIT
#include "shader/wgsl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/internal/wgsl/stage_text.hpp"

namespace gloam::shader {
namespace {

namespace wgsl = internal::wgsl;
using wgsl::Id;
using wgsl::Passing;

// The builtin values of compute shaders, by SPIR-V's number: name and type in WGSL.
const std::map<std::uint32_t, std::string>& builtin_values() {
    static const std::map<std::uint32_t, std::string> names{
        {SpvBuiltInGlobalInvocationId, "global_invocation_id"},
        {SpvBuiltInLocalInvocationId, "local_invocation_id"},
        {SpvBuiltInLocalInvocationIndex, "local_invocation_index"},
        {SpvBuiltInWorkgroupId, "workgroup_id"},
        {SpvBuiltInNumWorkgroups, "num_workgroups"},
        {SpvBuiltInSubgroupSize, "subgroup_size"},
        {SpvBuiltInSubgroupLocalInvocationId, "subgroup_invocation_id"}};
    return names;
}

// The name of a parameter in the head of a function that changes its copy.
Id head_of(Id parameter) {
    return 0x20000000U + parameter;
}

class Writer {
  public:
    Writer(const Spirv& words, const WgslOptions& options)
        : module_(words),
          facts_(module_, options.functions),
          text_(module_, facts_, options.comment_of),
          stage_(text_, used_),
          options_(options) {
        if (module_.entry_points.size() == 1) std::tie(model_, main_) = *module_.entry_points.begin();
        if (options.entry_point && main_ == 0) throw NotTranslated("several entry points, or none");
        if (is_stage()) text_.rename(main_, "main_body");
    }

    std::string run() {
        const std::vector<const wgsl::Function*> functions = functions_to_write();
        std::string bodies;
        for (const wgsl::Function* function : functions) bodies += "\n" + function_text(*function);
        if (is_stage()) bodies += "\n" + stage_.entry_point(model_, text_.name(main_));
        std::string globals;
        for (const wgsl::Variable& variable : globals_in_order())
            if (used_.contains(variable.id)) globals += comment_of(variable.id) + global_text(variable);
        const std::string supplied = prototypes();  // before the structures that they need are written
        std::string result = options_.head + text_.enabled();
        result += text_.structures() + text_.overrides(text_.overrides_used()) + globals;
        result += supplied + text_.helpers() + bodies;
        for (std::size_t at = result.find("\n\n\n"); at != std::string::npos; at = result.find("\n\n\n", at))
            result.erase(at, 1);
        return result.substr(std::min(result.find_first_not_of('\n'), result.size()));
    }

  private:
    // Whether the whole of a vertex or fragment shader is written.
    [[nodiscard]] bool is_stage() const {
        return options_.entry_point && model_ != SpvExecutionModelGLCompute;
    }

    [[nodiscard]] const shader::Function* declared(const wgsl::Function& function) const {
        return wgsl::declaration_of(module_, function, options_.functions);
    }

    // Those that main uses, or all but main; main is the last one.
    std::vector<const wgsl::Function*> functions_to_write() {
        std::set<Id> reached;
        if (options_.entry_point) reach(main_, reached);
        std::vector<const wgsl::Function*> list;
        for (const wgsl::Function& function : module_.functions) {
            const shader::Function* known = declared(function);
            if (known != nullptr && !known->defined) {
                prototypes_.push_back(&function);
            } else if (function.id != main_ && (!options_.entry_point || reached.contains(function.id))) {
                list.push_back(&function);
            }
        }
        const auto main = std::ranges::find(module_.functions, main_, &wgsl::Function::id);
        if (options_.entry_point) list.push_back(&*main);
        for (const wgsl::Function* function : list) {
            const std::set<Id>& globals = facts_.globals_of(function->id);
            used_.insert(globals.begin(), globals.end());
            if (function->id != main_) used_elsewhere_.insert(globals.begin(), globals.end());
        }
        // Those that main() leaves as they are, the next stage may still read.
        if (is_stage())
            for (const wgsl::Variable& variable : module_.variables)
                if (variable.storage == SpvStorageClassOutput) used_.insert(variable.id);
        return list;
    }

    void reach(Id function, std::set<Id>& reached) const {
        if (!reached.insert(function).second) return;
        for (const Id callee : facts_.calls_of(function)) reach(callee, reached);
    }

    [[nodiscard]] std::string comment_above(const wgsl::Function& function) const {
        const shader::Function* known = declared(function);
        return known != nullptr && options_.comment_above ? options_.comment_above(*known) : "";
    }

    [[nodiscard]] std::string comment_of(Id id) const {
        return options_.comment_of ? options_.comment_of("", module_.name_of(id)) : "";
    }

    // An image or a sampler; of a combined one both.
    std::string opaque_parameter(Id id, Id type, const std::map<Id, std::string>& names) {
        if (module_.type(type).kind != wgsl::TypeKind::sampler && module_.image_type(type).stored)
            throw NotTranslated("a storage image as a parameter");
        const auto name = [&names](Id named) -> const std::string& {
            return wgsl::entry_of(names, named, "a parameter without a name");
        };
        const std::string text = fmt::format("{}: {}", name(id), text_.opaque_type(id, type));
        const bool both = module_.type(type).kind == wgsl::TypeKind::sampled_image && facts_.is_sampled(id);
        return both ? fmt::format("{}, {}: sampler", text, name(wgsl::sampler_parameter(id))) : text;
    }

    // "fn name(a: f32) -> f32".
    std::string head(const wgsl::Function& function, const std::map<Id, std::string>& names) {
        const std::vector<Passing>& passing = facts_.of(function.id).passing;
        std::string parameters;
        for (std::size_t p = 0; p < function.parameters.size(); ++p) {
            const Id id = function.parameters[p];
            const Id type = module_.type_of(id);
            const bool pointer = module_.type(type).kind == wgsl::Type::Kind::pointer;
            if (pointer && module_.is_opaque(module_.type(type).element)) {
                parameters += (p == 0 ? "" : ", ") + opaque_parameter(id, module_.type(type).element, names);
                continue;
            }
            const Id named = passing[p] == Passing::copied ? head_of(id) : id;
            parameters += fmt::format(
                "{}{}: {}", p == 0 ? "" : ", ", wgsl::entry_of(names, named, "a parameter without a name"),
                text_.type(pointer && passing[p] != Passing::pointer ? module_.type(type).element : type));
        }
        const bool nothing = module_.type(function.result).kind == wgsl::Type::Kind::void_;
        return fmt::format("fn {}({}){}", text_.name(function.id), parameters,
                           nothing ? "" : " -> " + text_.type(function.result));
    }

    std::string function_text(const wgsl::Function& function) {
        if (function.id == main_ && !is_stage()) return main_text(function);
        wgsl::FunctionBody body = wgsl::body_of(text_, function);
        const std::map<Id, std::string> names = named(function, body);
        return comment_above(function) + wgsl::broken(head(function, names) + " {") + "\n" +
               print(body, names) + "}\n";
    }

    // Declares the variables and gives them names.
    std::map<Id, std::string> named(const wgsl::Function& function, wgsl::FunctionBody& body) {
        const std::vector<Passing>& passing = facts_.of(function.id).passing;
        std::vector<Id> heads;
        for (std::size_t p = 0; p < function.parameters.size(); ++p) {
            const Id id = function.parameters[p];
            const std::string given = module_.name_of(id);
            const std::string name = wgsl::identifier(given.empty() ? "parameter" : given);
            body.wanted_names[id] = name;
            heads.push_back(id);
            if (facts_.is_sampled(id)) {
                body.wanted_names[wgsl::sampler_parameter(id)] = name + "_sampler";
                heads.push_back(wgsl::sampler_parameter(id));
            }
            if (passing[p] != Passing::copied) continue;
            heads.back() = head_of(id);
            body.wanted_names[head_of(id)] = name + "_given";
            body.statements.insert(
                body.statements.begin(),
                {.kind = wgsl::StatementKind::assign, .target = id, .value = wgsl::mark(head_of(id))});
        }
        wgsl::declare_variables(body, {heads.begin(), heads.end()});
        std::set<std::string> taken = wgsl::identifiers_in(body.statements);
        return wgsl::choose_names(body, heads, taken);
    }

    // The entry point; its builtin values are its parameters.
    std::string main_text(const wgsl::Function& function) {
        wgsl::FunctionBody body = wgsl::body_of(text_, function);
        const std::map<Id, std::string> names = named(function, body);
        std::string parameters;
        std::string copies;
        for (const wgsl::Variable& variable : module_.variables) {
            if (!is_builtin(variable) || !used_.contains(variable.id)) continue;
            const auto builtin = builtin_values().find(*module_.decorations_of(variable.id).built_in);
            if (builtin == builtin_values().end())
                throw NotTranslated("the builtin value " + module_.name_of(variable.id));
            const bool elsewhere = used_elsewhere_.contains(variable.id);
            const std::string name = elsewhere ? builtin->second : text_.name(variable.id);
            parameters += fmt::format("{}@builtin({}) {}: {}", parameters.empty() ? "" : ", ",
                                      builtin->second, name, text_.type(variable.type));
            if (elsewhere) copies += fmt::format("    {} = {};\n", text_.name(variable.id), name);
        }
        return comment_above(function) +
               fmt::format("@compute @workgroup_size({})\n{}\n{}{}}}\n", group_size(),
                           wgsl::broken(fmt::format("fn {}({}) {{", text_.name(function.id), parameters)),
                           copies, print(body, names));
    }

    [[nodiscard]] bool is_builtin(const wgsl::Variable& variable) const {
        return variable.storage == SpvStorageClassInput && module_.decorations_of(variable.id).built_in;
    }

    std::string group_size() {
        std::vector<std::string> sizes;
        for (const std::uint32_t size : module_.local_size) sizes.push_back(std::to_string(size));
        for (const Id id : module_.constant_order) {
            if (module_.decorations_of(id).built_in != SpvBuiltInWorkgroupSize) continue;
            for (std::size_t k = 0; k < 3; ++k)
                sizes[k] = text_.constant(module_.constant(id)->word(3 + k)).text;
        }
        while (sizes.size() > 1 && (sizes.back() == "1" || sizes.back() == "1u")) sizes.pop_back();
        std::string list;
        for (const std::string& size : sizes) {
            const bool number = size.back() == 'u';
            list += (list.empty() ? "" : ", ") + (number ? size.substr(0, size.size() - 1) : size);
        }
        return list;
    }

    std::string global_text(const wgsl::Variable& variable) {
        const wgsl::Decorations decorations = module_.decorations_of(variable.id);
        const std::string name = text_.name(variable.id);
        const std::string place =
            fmt::format("@group({}) @binding({}) ", decorations.set, decorations.binding);
        switch (variable.storage) {
            case SpvStorageClassStorageBuffer:
                return fmt::format("{}var<storage, {}> {}: {};\n", place,
                                   facts_.is_written(variable.id) ? "read_write" : "read", name,
                                   text_.variable_type(variable));
            case SpvStorageClassUniform:
                return fmt::format("{}var<uniform> {}: {};\n", place, name, text_.variable_type(variable));
            case SpvStorageClassPushConstant:
                return fmt::format("@group({}) @binding(0) var<uniform> {}: {};\n", free_group(), name,
                                   text_.variable_type(variable));
            case SpvStorageClassUniformConstant:
                return fmt::format("{}var {}: {};\n", place, name, text_.variable_type(variable)) +
                       sampler_text(variable);
            case SpvStorageClassWorkgroup:
                return fmt::format("var<workgroup> {}: {};\n", name, text_.variable_type(variable));
            case SpvStorageClassPrivate:
                return fmt::format(
                    "var<private> {}: {}{};\n", name, text_.variable_type(variable),
                    variable.initial == 0 ? "" : " = " + text_.constant(variable.initial).text);
            default:
                if (is_stage()) return stage_.global(variable);
                if (!used_elsewhere_.contains(variable.id)) return "";
                return fmt::format("var<private> {}: {};\n", name, text_.type(variable.type));
        }
    }

    // The sampler of a combined one, at the next binding of its group that nothing has.
    std::string sampler_text(const wgsl::Variable& variable) {
        if (!text_.has_sampler(variable.id)) return "";
        const std::uint32_t group = module_.decorations_of(variable.id).set;
        std::uint32_t& binding = next_binding_[group];
        for (const wgsl::Variable& other : module_.variables) {
            const wgsl::Decorations taken = module_.decorations_of(other.id);
            if (has_binding(other) && taken.set == group) binding = std::max(binding, taken.binding + 1);
        }
        return fmt::format("@group({}) @binding({}) var {}: sampler;\n", group, binding++,
                           text_.sampler_of(variable.id));
    }

    // Resources by their bindings, then the rest.
    [[nodiscard]] std::vector<wgsl::Variable> globals_in_order() const {
        std::vector<wgsl::Variable> all = module_.variables;
        const auto place = [this](const wgsl::Variable& variable) {
            const wgsl::Decorations decorations = module_.decorations_of(variable.id);
            return std::tuple(!has_binding(variable), decorations.set, decorations.binding);
        };
        std::ranges::stable_sort(all, {}, place);
        return all;
    }

    static bool has_binding(const wgsl::Variable& variable) {
        return variable.storage == SpvStorageClassStorageBuffer ||
               variable.storage == SpvStorageClassUniform ||
               variable.storage == SpvStorageClassUniformConstant;
    }

    // The first group without resources: that of the push constants.
    [[nodiscard]] std::uint32_t free_group() const {
        std::set<std::uint32_t> taken;
        for (const wgsl::Variable& variable : module_.variables) {
            if (has_binding(variable)) taken.insert(module_.decorations_of(variable.id).set);
        }
        std::uint32_t group = 0;
        while (taken.contains(group)) ++group;
        return group;
    }

    // The functions that the user defines, as comments: WGSL has no declarations without a body.
    std::string prototypes() {
        std::string result;
        for (const wgsl::Function* function : prototypes_) {
            wgsl::FunctionBody body;
            const std::map<Id, std::string> names = named(*function, body);
            const std::string comment = comment_above(*function);
            result += "\n" + (comment.empty() ? "// Defined by the user.\n" : comment) +
                      fmt::format("// {}\n", head(*function, names));
        }
        return result;
    }

    wgsl::Module module_;
    wgsl::Facts facts_;
    wgsl::ModuleText text_;
    std::set<Id> used_;
    wgsl::StageText stage_;
    const WgslOptions& options_;
    std::uint32_t model_ = 0;  // of the entry point
    Id main_ = 0;
    std::set<Id> used_elsewhere_;  // by other functions than main
    std::vector<const wgsl::Function*> prototypes_;
    std::map<std::uint32_t, std::uint32_t> next_binding_;  // of a group, for samplers
};

}  // namespace

std::string to_wgsl(const Spirv& module, const WgslOptions& options) {
    return Writer(module, options).run();
}

}  // namespace gloam::shader
