// SPDX-License-Identifier: MIT
#include "shader/internal/function_codec.hpp"

#include <nlohmann/json.hpp>

// nlohmann::json finds these by the types' namespace.
namespace gloam::shader {

using Json = nlohmann::json;

static void to_json(Json& json, const Member& member);
static void from_json(const Json& json, Member& member);

static void to_json(Json& json, const Type& type) {
    json = Json::array({static_cast<int>(type.scalar), type.columns, type.rows, type.name, type.members});
}

static void from_json(const Json& json, Type& type) {
    type.scalar = static_cast<Scalar>(json.at(0).get<int>());
    json.at(1).get_to(type.columns);
    json.at(2).get_to(type.rows);
    json.at(3).get_to(type.name);
    json.at(4).get_to(type.members);
}

static void to_json(Json& json, const Member& member) {
    json = Json::array({member.name, member.type});
}

static void from_json(const Json& json, Member& member) {
    json.at(0).get_to(member.name);
    json.at(1).get_to(member.type);
}

static void to_json(Json& json, const Parameter& parameter) {
    json = Json::array({parameter.name, parameter.type, static_cast<int>(parameter.direction)});
}

static void from_json(const Json& json, Parameter& parameter) {
    json.at(0).get_to(parameter.name);
    json.at(1).get_to(parameter.type);
    parameter.direction = static_cast<Direction>(json.at(2).get<int>());
}

static void to_json(Json& json, const Function& function) {
    json = Json::array({function.name, function.result, function.parameters, function.defined});
}

static void from_json(const Json& json, Function& function) {
    json.at(0).get_to(function.name);
    json.at(1).get_to(function.result);
    json.at(2).get_to(function.parameters);
    json.at(3).get_to(function.defined);
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

}  // namespace internal
}  // namespace gloam::shader
