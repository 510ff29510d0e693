// SPDX-License-Identifier: MIT
#include "module/internal/compiler_process.hpp"

#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "base/compiler_limits.hpp"
#include "module/include.hpp"
#include "module/internal/include_folders.hpp"

namespace gloam::shader {

using Json = nlohmann::json;

// What crosses to the compiler's process, and back. A type has members that have types.
static void to_json(Json& json, const Member& member);
static void from_json(const Json& json, Member& member);
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Type, scalar, columns, rows, name, members, sizes)
static void to_json(Json& json, const Member& member) {
    json = Json::array({member.name, member.type});
}
static void from_json(const Json& json, Member& member) {
    json.at(0).get_to(member.name);
    json.at(1).get_to(member.type);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Parameter, name, type, direction, global)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Function, name, result, parameters, defined, globals, other_number)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Source, name, text)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Variant, optimization, strict, relaxed)  // what compile() reads
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CompileOptions, stage, include_roots, variant, lines)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PackRequest, language, functions, constants)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BoundVariable, name, type, format, written)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Excerpt, function, text, interface, bound, globals, definitions, comments,
                                   needs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Excerpts, version, functions, by_macro)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mutation, begin, end, line, before, after, kind, function)

namespace internal {
namespace {

// A value as bytes, which Json::from_cbor() reads.
std::string bytes_of(const Json& json) {
    std::string bytes;
    Json::to_cbor(json, bytes);
    return bytes;
}

}  // namespace

std::string encode(const std::vector<Function>& functions) {
    return bytes_of(functions);
}

std::optional<std::vector<Function>> decode(std::string_view bytes) {
    try {
        return Json::from_cbor(bytes).get<std::vector<Function>>();
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

namespace {

enum class Work { compile, functions, excerpts, mutations, pack, translate };

// The first byte of an answer: the result follows, or the message of what the work threw.
constexpr char result = 'r';
constexpr char compile_error = 'c';
constexpr char invalid_argument = 'i';

using Roots = std::vector<std::filesystem::path>;

// The work of a question: [work, dependency list, its arguments].
std::string done(const Json& question) {
    use_dependency_list(question.at(1).get<std::string>());  // of the test that asks
    const Json& arguments = question.at(2);
    switch (question.at(0).get<Work>()) {
        case Work::compile: {
            const Spirv module = compile_here(arguments.at(0), arguments.at(1));
            return {reinterpret_cast<const char*>(module.data()), module.size() * sizeof(Spirv::value_type)};
        }
        case Work::functions:
            return encode(functions_here(arguments.at(0), arguments.at(1)));
        case Work::excerpts:
            return bytes_of(excerpts_here(arguments.at(0), arguments.at(1).get<Roots>()));
        case Work::mutations:
            return bytes_of(mutations_here(arguments.at(0), arguments.at(1).get<Roots>()));
        case Work::pack:
            return pack_here(arguments.at(0).get<std::vector<Source>>(), arguments.at(1),
                             arguments.at(2).get<Roots>(), arguments.at(3).get<Stage>());
        default:
            return translated_here(arguments.at(0), arguments.at(1).get<Target>(),
                                   arguments.at(2).get<Stage>());
    }
}

std::string answer_to(std::string_view question) {
    try {
        return result + done(Json::from_cbor(question));
    } catch (const CompileError& error) {
        return compile_error + std::string(error.what());
    } catch (const std::invalid_argument& error) {
        return invalid_argument + std::string(error.what());
    }
}

// The result of the work. `name`: of the text, for the limits' messages.
std::string asked(Work work, const std::string& name, Json arguments) {
    thread_local base::Apart compiler(answer_to, base::compiler_limits);
    const std::string question = bytes_of(Json::array({work, dependency_list(), std::move(arguments)}));
    std::string answer;
    try {
        answer = compiler.ask(question);
    } catch (const base::LimitError& error) {
        throw CompileError(name + ": the compiler " + error.what());
    }
    const char kind = answer.at(0);
    answer.erase(0, 1);
    if (kind == compile_error) throw CompileError(answer);
    if (kind == invalid_argument) throw std::invalid_argument(answer);
    return answer;
}

}  // namespace

std::optional<Spirv> module_of(std::string_view bytes) {
    if (bytes.empty() || bytes.size() % sizeof(Spirv::value_type) != 0) return std::nullopt;
    Spirv module(bytes.size() / sizeof(Spirv::value_type));
    std::memcpy(module.data(), bytes.data(), bytes.size());
    return module;
}

std::string compiled_bytes(const Source& source, const CompileOptions& options) {
    return asked(Work::compile, source.name, Json::array({source, options}));
}

std::string functions_bytes(const Source& source, const CompileOptions& options) {
    return asked(Work::functions, source.name, Json::array({source, options}));
}

}  // namespace internal

using internal::asked;
using internal::Work;

Spirv compile(const Source& source, const CompileOptions& options) {
    return internal::module_of(internal::compiled_bytes(source, options)).value();
}

std::vector<Function> functions(const Source& source, const CompileOptions& options) {
    return internal::decode(internal::functions_bytes(source, options)).value();
}

Excerpts excerpts(const Source& source, const std::vector<std::filesystem::path>& roots) {
    return Json::from_cbor(asked(Work::excerpts, source.name, Json::array({source, roots})));
}

std::vector<Mutation> mutations(const Source& source, const std::vector<std::filesystem::path>& roots) {
    return Json::from_cbor(asked(Work::mutations, source.name, Json::array({source, roots})));
}

std::string pack(const std::vector<Source>& sources, const PackRequest& request,
                 const std::vector<std::filesystem::path>& roots) {
    return asked(
        Work::pack, sources.empty() ? "nothing" : sources.back().name,
        Json::array({sources, request, roots, request.stage.value_or(usual_stage(request.language))}));
}

std::string translated(const Source& packed, Target target, Stage stage) {
    return asked(Work::translate, packed.name, Json::array({packed, target, stage}));
}

}  // namespace gloam::shader
