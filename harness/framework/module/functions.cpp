// SPDX-License-Identifier: MIT
#include "source/declarations.hpp"

#include <spirv.h>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "module/internal/front_end.hpp"
#include "module/module.hpp"
#include "module/spirv.hpp"
#include "module/texts.hpp"
#include "source/lines.hpp"

namespace gloam::module {
namespace {

using source::FunctionHead;
using spirv::Id;

// A function as SPIR-V describes it: without the directions of its parameters and the names of opaque types.
struct Compiled : Function {
    std::vector<std::size_t> calls;  // indices of the called functions, in the order of the module
};

// The types of a module, described by their id.
class TypeReader {
  public:
    explicit TypeReader(const std::vector<Instruction>& code) {
        for (const Instruction& instruction : code) {
            declared_.read(instruction);
            if (instruction.opcode == SpvOpConstant || instruction.opcode == SpvOpSpecConstant)
                constants_[instruction.word(2)] = instruction.word(3);
        }
    }

    [[nodiscard]] std::string name_of(Id id) const { return declared_.name_of(id); }

    // The type of a value, or of what a pointer points to. Its description is small, however large a value
    // is.
    [[nodiscard]] const Type& type_of(Id id) const {
        const auto known = known_.find(id);  // a structure may have many members of one type, level by level
        if (known != known_.end()) return known->second;
        Type type = whole_type_of(id);
        if (scalar_count(type) > most_scalars)
            type = {.scalar = Scalar::oversized, .members = {}, .name = module::name_of(type)};
        return known_.emplace(id, std::move(type)).first->second;
    }

  private:
    [[nodiscard]] Type whole_type_of(Id id) const {
        using Kind = spirv::Type::Kind;
        const spirv::Type& type = declared_.types.at(id);
        switch (type.kind) {
            case Kind::pointer:  // to a buffer whose structure may hold it again
                if (type.storage == SpvStorageClassPhysicalStorageBuffer)
                    return {.scalar = Scalar::unsupported, .members = {}, .name = name_of(type.element)};
                return type_of(type.element);
            case Kind::vector:
            case Kind::matrix:
                return composed(type);
            case Kind::array:
            case Kind::runtime_array: {
                Type array = type_of(type.element);
                const auto size =
                    constants_.find(type.length);  // or an operation on specialization constants
                array.sizes.insert(array.sizes.begin(), size == constants_.end() ? 0 : size->second);
                return array;
            }
            case Kind::structure:
                return structure(id, type);
            default: {
                std::string other = spirv::other_number(type);
                return {.scalar = other.empty() ? scalar_of(type) : Scalar::unsupported,
                        .members = {},
                        .name = std::move(other)};
            }
        }
    }

    static Scalar scalar_of(const spirv::Type& type) {
        switch (type.kind) {
            case spirv::Type::Kind::void_:
                return Scalar::void_;
            case spirv::Type::Kind::boolean:
                return Scalar::bool_;
            case spirv::Type::Kind::integer:
                return type.is_signed ? Scalar::int_ : Scalar::uint_;
            case spirv::Type::Kind::real:
                return type.width == 16 ? Scalar::float16_ : Scalar::float_;
            default:
                return Scalar::unsupported;
        }
    }

    [[nodiscard]] Type composed(const spirv::Type& type) const {
        Type result = type_of(type.element);
        if (result.scalar == Scalar::unsupported) return result;  // named by its scalar
        const int count = static_cast<int>(type.count);
        (type.kind == spirv::Type::Kind::matrix ? result.columns : result.rows) = count;
        return result;
    }

    [[nodiscard]] Type structure(Id id, const spirv::Type& type) const {
        Type result{.scalar = Scalar::structure, .members = {}, .name = name_of(id)};
        for (const spirv::Member& member : type.members)
            result.members.push_back({member.name, type_of(member.type)});
        return result;
    }

    spirv::Declarations declared_;
    std::map<Id, Id> constants_;
    mutable std::map<Id, Type> known_;
};

void merge(std::vector<Parameter>& used, const Parameter& variable, source::Direction direction) {
    auto found = std::ranges::find(used, variable.name, &Parameter::name);
    if (found == used.end()) found = used.insert(used.end(), variable);
    if (direction == source::Direction::inout) found->direction = direction;
}

// Private variables, samplers and images at file scope, and what a function does with them.
class Globals {
  public:
    Globals(const std::vector<Instruction>& code, const TypeReader& types) {
        for (const Instruction& instruction : code)
            if (instruction.opcode == SpvOpVariable &&
                (instruction.word(3) == SpvStorageClassPrivate ||
                 instruction.word(3) == SpvStorageClassUniformConstant))
                variables_[instruction.word(2)] = {types.name_of(instruction.word(2)),
                                                   types.type_of(instruction.word(1)), source::Direction::in,
                                                   true};
    }

    void read(const Instruction& instruction, std::vector<Parameter>& used) {
        switch (instruction.opcode) {
            case SpvOpFunction:
                bases_.clear();
                for (const auto& [id, variable] : variables_) bases_[id] = id;
                break;
            case SpvOpAccessChain:
            case SpvOpInBoundsAccessChain:
                if (const auto base = bases_.find(instruction.word(3)); base != bases_.end())
                    bases_[instruction.word(2)] = Id{base->second};
                break;
            case SpvOpLoad:
                return use(instruction.word(3), false, used);
            case SpvOpStore:
                return use(instruction.word(1), true, used);
            case SpvOpCopyMemory:
                use(instruction.word(1), true, used);
                return use(instruction.word(2), false, used);
            case SpvOpFunctionCall:
            case SpvOpExtInst:  // modf, frexp
                for (const Id pointer : instruction.from(instruction.opcode == SpvOpExtInst ? 5 : 4))
                    use(pointer, true, used);
                break;
            default:
                break;
        }
    }

  private:
    void use(Id pointer, bool writes, std::vector<Parameter>& used) const {
        const auto base = bases_.find(pointer);
        if (base == bases_.end()) return;
        merge(used, variables_.at(base->second), writes ? source::Direction::inout : source::Direction::in);
    }

    std::map<Id, Parameter> variables_;
    std::map<Id, Id> bases_;  // of pointers in the current function
};

// The first number of a type that is not judged.
std::string other_number_of(const Type& type) {
    if (type.scalar == Scalar::unsupported) return type.name;
    for (const Member& member : type.members)
        if (std::string other = other_number_of(member.type); !other.empty()) return other;
    return {};
}

// Adds what a function uses by what it calls. There is no recursion.
void add_globals_of_called(std::vector<Compiled>& functions, std::size_t caller, std::vector<bool>& done) {
    if (done[caller]) return;
    done[caller] = true;
    for (const std::size_t called : functions[caller].calls) {
        add_globals_of_called(functions, called, done);
        for (const Parameter& variable : functions[called].globals)
            merge(functions[caller].globals, variable, variable.direction);
        if (functions[caller].other_number.empty())
            functions[caller].other_number = functions[called].other_number;
    }
}

// Every function of an unoptimised module, in the order of the module. Throws std::runtime_error for words
// that are not a SPIR-V module.
std::vector<Compiled> compiled(const Spirv& module) {
    const std::vector<Instruction> code = instructions(module);
    const TypeReader types(code);
    Globals globals(code, types);
    std::map<Id, std::size_t> indices;  // of the functions
    for (const Instruction& instruction : code)
        if (instruction.opcode == SpvOpFunction) indices.emplace(instruction.word(2), indices.size());
    std::vector<Compiled> found;
    for (const Instruction& instruction : code) {
        const Id type = instruction.word(1);
        const Id id = instruction.word(2);
        if (instruction.opcode == SpvOpFunction)
            found.push_back({{types.name_of(id), types.type_of(type), {}}, {}});
        if (instruction.opcode == SpvOpFunctionParameter)
            found.back().parameters.push_back(
                {types.name_of(id), types.type_of(type), source::Direction::in});
        if (instruction.opcode == SpvOpFunctionCall)
            found.back().calls.push_back(indices.at(instruction.word(3)));
        if (found.empty()) continue;
        globals.read(instruction, found.back().globals);
        if (const auto [result, typed] = spirv::result_shape(instruction.opcode);
            result && typed && found.back().other_number.empty())
            found.back().other_number = other_number_of(types.type_of(type));
    }
    std::vector<bool> done(found.size(), false);
    for (std::size_t i = 0; i < found.size(); ++i) add_globals_of_called(found, i, done);
    return found;
}

// Combines a function of the module with what only the text contains: directions, and the names of opaque
// types.
Function function_of(Function function, const source::FunctionHead& declaration) {
    if (function.name.starts_with(source::own_prefix)) function.name.erase(0, source::own_prefix.size());
    function.defined = declaration.defined;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        Parameter& parameter = function.parameters[i];
        const source::DeclaredParameter& declared = declaration.parameters.at(i);
        parameter.direction = declared.direction;
        if (parameter.type.scalar == Scalar::unsupported && parameter.type.name.empty())
            parameter.type.name = declared.type.substr(0, declared.type.find('['));  // the sizes are known
        const bool sampler = parameter.type.scalar == Scalar::unsupported && parameter.type.sizes.empty() &&
                             source::is_sampler_type(parameter.type.name);
        if (sampler) parameter.type.scalar = Scalar::sampler;
        if (!declaration.defined) parameter.name.clear();
    }
    return function;
}

// The declaration of each function of the module; null for an added main. Functions of one name are in the
// same order on both sides.
std::vector<const source::FunctionHead*> paired(const std::vector<Compiled>& compiled,
                                                const std::vector<source::FunctionHead>& declared) {
    std::vector<const source::FunctionHead*> pairs(compiled.size(), nullptr);
    for (const source::FunctionHead& declaration : declared) {
        std::size_t i = 0;
        while (i < pairs.size() && (pairs[i] || compiled[i].name != declaration.name)) ++i;
        if (i == pairs.size())
            throw std::logic_error("function '" + declaration.name + "' is not in its own module");
        pairs[i] = &declaration;
    }
    return pairs;
}

// In order of definition; a function that is only declared is listed at its first call.
std::vector<Function> listed(const std::vector<Compiled>& compiled,
                             const std::vector<source::FunctionHead>& declared) {
    const std::vector<const source::FunctionHead*> pairs = paired(compiled, declared);
    std::vector<Function> functions;
    std::vector<bool> taken(pairs.size(), false);
    const auto take = [&](std::size_t i) {
        if (!taken[i]) functions.push_back(function_of(compiled[i], *pairs[i]));
        taken[i] = true;
    };
    for (const source::FunctionHead& declaration : declared) {
        if (!declaration.defined) break;  // those that are only declared come last
        const auto found = static_cast<std::size_t>(std::ranges::find(pairs, &declaration) - pairs.begin());
        take(found);
        for (const std::size_t called : compiled[found].calls)
            if (pairs[called] && !pairs[called]->defined) take(called);
    }
    return functions;
}

// The front end takes a bias in every stage, and its module is not valid in most.
void require_no_bias(const Spirv& module, const std::string& name) {
    for (const Instruction& instruction : instructions(module)) {
        const bool samples = instruction.opcode >= SpvOpImageSampleImplicitLod &&
                             instruction.opcode <= SpvOpImageSampleProjDrefExplicitLod;
        if (!samples) continue;
        const bool compares = (instruction.opcode - SpvOpImageSampleImplicitLod) % 4 >= 2;
        if ((instruction.word(compares ? 6 : 5) & SpvImageOperandsBiasMask) != 0)
            throw source::CompileError(name +
                                       ": 'texture' : a bias of the level is not supported in this stage");
    }
}

}  // namespace

std::vector<Function> functions(const source::Source& source, const CompileOptions& options) {
    source::require_vulkan_version(source);
    // The unchanged text is parsed first, so that messages have its line numbers.
    internal::check(options.stage, internal::Client::vulkan, source.name, {source}, options.include_roots);
    const std::string text =
        internal::preprocessed({source}, options.stage, internal::Client::vulkan,
                               internal::include_folders(options.include_roots, {source}));
    const std::vector<source::FunctionHead> declared = source::each_once(source::function_heads(text));
    const source::Source whole{source.name, source::completed(text, declared)};
    const Spirv module = internal::to_spirv(whole, options.stage, {}, internal::Unreached::kept);
    try {
        if (options.stage != source::Stage::fragment) require_no_bias(module, source.name);
        return listed(compiled(module), declared);
    } catch (const source::CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {  // the front end does not bound the words of an instruction
        throw source::CompileError(source.name + ": " + error.what());
    }
}

}  // namespace gloam::module
