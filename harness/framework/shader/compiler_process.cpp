// SPDX-License-Identifier: MIT
#include "shader/internal/compiler_process.hpp"

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "base/process.hpp"
#include "shader/include.hpp"
#include "shader/internal/include_folders.hpp"

// nlohmann::json finds these by the types' namespace.
namespace gloam::shader {

using Json = nlohmann::json;

static void to_json(Json& json, const Member& member);
static void from_json(const Json& json, Member& member);

static void to_json(Json& json, const Type& type) {
    json = Json::array(
        {static_cast<int>(type.scalar), type.columns, type.rows, type.name, type.members, type.sizes});
}

static void from_json(const Json& json, Type& type) {
    type.scalar = static_cast<Scalar>(json.at(0).get<int>());
    json.at(1).get_to(type.columns);
    json.at(2).get_to(type.rows);
    json.at(3).get_to(type.name);
    json.at(4).get_to(type.members);
    json.at(5).get_to(type.sizes);
}

static void to_json(Json& json, const Member& member) {
    json = Json::array({member.name, member.type});
}

static void from_json(const Json& json, Member& member) {
    json.at(0).get_to(member.name);
    json.at(1).get_to(member.type);
}

static void to_json(Json& json, const Parameter& parameter) {
    json = Json::array(
        {parameter.name, parameter.type, static_cast<int>(parameter.direction), parameter.global});
}

static void from_json(const Json& json, Parameter& parameter) {
    json.at(0).get_to(parameter.name);
    json.at(1).get_to(parameter.type);
    parameter.direction = static_cast<Direction>(json.at(2).get<int>());
    json.at(3).get_to(parameter.global);
}

static void to_json(Json& json, const Function& function) {
    json = Json::array(
        {function.name, function.result, function.parameters, function.defined, function.globals});
}

static void from_json(const Json& json, Function& function) {
    json.at(0).get_to(function.name);
    json.at(1).get_to(function.result);
    json.at(2).get_to(function.parameters);
    json.at(3).get_to(function.defined);
    json.at(4).get_to(function.globals);
}

namespace internal {

std::string encode(const std::vector<Function>& functions) {
    std::string bytes;
    Json::to_cbor(Json(functions), bytes);
    return bytes;
}

std::optional<std::vector<Function>> decode(std::string_view bytes) {
    try {
        return Json::from_cbor(bytes).get<std::vector<Function>>();
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

namespace {

using Json = nlohmann::json;

const base::ProcessLimits limits{.memory_bytes = std::uint64_t{3} << 30,
                                 .cpu = std::chrono::seconds(60),
                                 .patience = std::chrono::minutes(5)};

enum class Work { compile, functions, excerpts, mutations, pack, translate };

// The first byte of an answer: the result follows, or the message of what the work threw.
constexpr char result = 'r';
constexpr char compile_error = 'c';
constexpr char invalid_argument = 'i';

constexpr int no_stage = -1;

Json json_of(const Source& source) {
    return Json::array({source.name, source.text});
}

Source source_from(const Json& json) {
    return {.name = json.at(0).get<std::string>(), .text = json.at(1).get<std::string>()};
}

Json json_of(const std::vector<std::filesystem::path>& roots) {
    Json json = Json::array();
    for (const auto& root : roots) json.push_back(root.string());
    return json;
}

std::vector<std::filesystem::path> roots_from(const Json& json) {
    std::vector<std::filesystem::path> roots;
    for (const Json& root : json) roots.emplace_back(root.get<std::string>());
    return roots;
}

Json json_of(const CompileOptions& options) {
    const Variant& variant = options.variant;
    return Json::array({options.stage, json_of(options.include_roots), variant.optimization, variant.through,
                        variant.strict, variant.relaxed, options.lines});
}

CompileOptions options_from(const Json& json) {
    CompileOptions options{.stage = json.at(0), .include_roots = roots_from(json.at(1)), .variant = {}};
    json.at(2).get_to(options.variant.optimization);
    json.at(3).get_to(options.variant.through);
    json.at(4).get_to(options.variant.strict);
    json.at(5).get_to(options.variant.relaxed);
    json.at(6).get_to(options.lines);
    return options;
}

Json json_of(const PackRequest& request) {
    return Json::array({request.language, request.functions,
                        request.stage ? static_cast<int>(*request.stage) : no_stage, request.constants});
}

PackRequest request_from(const Json& json) {
    PackRequest request{
        .language = json.at(0), .functions = json.at(1), .stage = {}, .constants = json.at(3)};
    if (const int stage = json.at(2); stage != no_stage) request.stage = static_cast<Stage>(stage);
    return request;
}

Json json_of(const std::vector<BoundVariable>& bound) {
    Json json = Json::array();
    for (const BoundVariable& one : bound)
        json.push_back(Json::array({one.name, one.type, one.format, one.written}));
    return json;
}

std::vector<BoundVariable> bound_from(const Json& json) {
    std::vector<BoundVariable> bound;
    for (const Json& one : json) bound.push_back({one.at(0), one.at(1), one.at(2), one.at(3)});
    return bound;
}

Json json_of(const Excerpts& excerpts) {
    Json functions = Json::array();
    for (const Excerpt& one : excerpts.functions)
        functions.push_back(Json::array({one.function, one.text, one.interface, one.globals, one.definitions,
                                         json_of(one.bound), one.needs}));
    return Json::array({excerpts.version, functions});
}

Excerpts excerpts_from(const Json& json) {
    Excerpts excerpts{.version = json.at(0), .functions = {}};
    for (const Json& one : json.at(1))
        excerpts.functions.push_back({.function = one.at(0),
                                      .text = one.at(1),
                                      .interface = one.at(2),
                                      .bound = bound_from(one.at(5)),
                                      .globals = one.at(3).get<std::map<std::string, Access>>(),
                                      .definitions = one.at(4),
                                      .needs = one.at(6).get<Needs>()});
    return excerpts;
}

Json json_of(const std::vector<Mutation>& mutations) {
    Json json = Json::array();
    for (const Mutation& one : mutations)
        json.push_back(
            Json::array({one.begin, one.end, one.line, one.before, one.after, one.kind, one.function}));
    return json;
}

std::vector<Mutation> mutations_from(const Json& json) {
    std::vector<Mutation> mutations;
    for (const Json& one : json)
        mutations.push_back({.begin = one.at(0),
                             .end = one.at(1),
                             .line = one.at(2),
                             .before = one.at(3),
                             .after = one.at(4),
                             .kind = one.at(5),
                             .function = one.at(6)});
    return mutations;
}

// A value as bytes, which Json::from_cbor() reads.
std::string bytes_of(const Json& json) {
    std::string bytes;
    Json::to_cbor(json, bytes);
    return bytes;
}

// The work of a question: [work, dependency list, its arguments].
std::string done(const Json& question) {
    use_dependency_list(question.at(1).get<std::string>());  // of the test that asks
    const Json& arguments = question.at(2);
    switch (question.at(0).get<Work>()) {
        case Work::compile: {
            const Spirv module = compile_here(source_from(arguments.at(0)), options_from(arguments.at(1)));
            return {reinterpret_cast<const char*>(module.data()), module.size() * sizeof(Spirv::value_type)};
        }
        case Work::functions:
            return encode(functions_here(source_from(arguments.at(0)), options_from(arguments.at(1))));
        case Work::excerpts:
            return bytes_of(
                json_of(excerpts_here(source_from(arguments.at(0)), roots_from(arguments.at(1)))));
        case Work::mutations:
            return bytes_of(
                json_of(mutations_here(source_from(arguments.at(0)), roots_from(arguments.at(1)))));
        case Work::pack: {
            std::vector<Source> sources;
            for (const Json& source : arguments.at(0)) sources.push_back(source_from(source));
            return pack_here(sources, request_from(arguments.at(1)), roots_from(arguments.at(2)));
        }
        default:
            return translated_here(source_from(arguments.at(0)), arguments.at(1).get<Target>(),
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
    thread_local base::Apart compiler(answer_to, limits);
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
    return asked(Work::compile, source.name, Json::array({json_of(source), json_of(options)}));
}

std::string functions_bytes(const Source& source, const CompileOptions& options) {
    return asked(Work::functions, source.name, Json::array({json_of(source), json_of(options)}));
}

}  // namespace internal

Spirv compile(const Source& source, const CompileOptions& options) {
    return internal::module_of(internal::compiled_bytes(source, options)).value();
}

std::vector<Function> functions(const Source& source, const CompileOptions& options) {
    return internal::decode(internal::functions_bytes(source, options)).value();
}

Excerpts excerpts(const Source& source, const std::vector<std::filesystem::path>& roots) {
    using internal::Json;
    return internal::excerpts_from(
        Json::from_cbor(internal::asked(internal::Work::excerpts, source.name,
                                        Json::array({internal::json_of(source), internal::json_of(roots)}))));
}

std::vector<Mutation> mutations(const Source& source, const std::vector<std::filesystem::path>& roots) {
    using internal::Json;
    return internal::mutations_from(
        Json::from_cbor(internal::asked(internal::Work::mutations, source.name,
                                        Json::array({internal::json_of(source), internal::json_of(roots)}))));
}

std::string pack(const std::vector<Source>& sources, const PackRequest& request,
                 const std::vector<std::filesystem::path>& roots) {
    using internal::Json;
    Json texts = Json::array();
    for (const Source& source : sources) texts.push_back(internal::json_of(source));
    return internal::asked(internal::Work::pack, sources.empty() ? "nothing" : sources.back().name,
                           Json::array({texts, internal::json_of(request), internal::json_of(roots)}));
}

std::string translated(const Source& packed, Target target, Stage stage) {
    using internal::Json;
    return internal::asked(internal::Work::translate, packed.name,
                           Json::array({internal::json_of(packed), target, stage}));
}

}  // namespace gloam::shader
