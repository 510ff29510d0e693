// SPDX-License-Identifier: MIT
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/pack/effect.hpp"
#include "cli/settings.hpp"

namespace gloam::cli {
namespace {

using Json = nlohmann::ordered_json;

Json member_json(const shader::LaidOut& member) {
    Json json{{"name", member.name},       {"type", member.type},     {"rows", member.rows},
              {"columns", member.columns}, {"offset", member.offset}, {"bytes", member.size}};
    if (!member.sizes.empty()) {
        json["array"] = member.sizes;
        json["stride"] = member.stride;
    }
    for (const shader::LaidOut& inner : member.members) json["members"].push_back(member_json(inner));
    return json;
}

Json words_json(std::span<const std::byte> bytes) {
    Json words = Json::array();
    for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
        std::uint32_t word = 0;
        std::memcpy(&word, &bytes[i], sizeof word);
        words.push_back(word);
    }
    return words;
}

Json image_json(const PackedEffect& effect, const effect::PlannedImage& image) {
    return {{"name", image.name},
            {"meaning", image.meaning},
            {"format", vulkan_format(image.format)},
            {"usage", vulkan_usage(effect, image)},
            {"origin", to_string(image.origin)},
            {"divisor", image.divisor},
            {"width", image.extent.width},
            {"height", image.extent.height}};
}

Json buffer_json(const effect::PlannedBuffer& buffer) {
    return {{"name", buffer.name},         {"meaning", buffer.meaning},
            {"bytes", buffer.bytes},       {"bytes_a_tile", buffer.bytes_a_tile},
            {"refilled", buffer.refilled}, {"contents", words_json(buffer.contents)}};
}

Json bindings_json(const PackedPass& pass) {
    Json all = Json::array();
    for (const shader::Binding& binding : pass.interface.bindings) {
        Json json{{"set", binding.set},
                  {"binding", binding.number},
                  {"name", binding.name},
                  {"type", vulkan_descriptor(binding.type)},
                  {"resource", resource_at(pass, binding)},
                  {"reads", binding.reads},
                  {"writes", binding.writes}};
        if (!binding.format.empty()) json["format"] = binding.format;
        if (binding.block)
            for (const shader::LaidOut& member : binding.block->members)
                json["members"].push_back(member_json(member));
        all.push_back(std::move(json));
    }
    return all;
}

Json push_constants_json(const PackedPass& pass) {
    Json json{{"bytes", pass.plan.parameters.size()}, {"preset", words_json(pass.plan.parameters)}};
    if (pass.plan.odd_parameters != pass.plan.parameters)
        json["odd_preset"] = words_json(pass.plan.odd_parameters);
    for (const shader::LaidOut& member : pass.interface.push_constants->members) {
        Json entry = member_json(member);
        entry["of_view"] = is_of_view(pass, member);
        json["members"].push_back(std::move(entry));
    }
    return json;
}

const char* name_of(effect::Turn turn) {
    if (turn == effect::Turn::once) return "once";
    return turn == effect::Turn::moved ? "moved" : "always";
}

Json pass_json(const PackedEffect& effect, std::size_t index) {
    const PackedPass& pass = effect.passes[index];
    const effect::PlannedPass& plan = pass.plan;
    Json json{{"name", plan.name},
              {"file", pass.file},
              {"divisor", plan.divisor},
              {"turn", name_of(plan.turn)},
              {"local_size", pass.interface.local_size}};
    if (plan.list) {
        json["indirect"] = {{"buffer", "tile_lists"}, {"offset", *plan.list}};
    } else if (plan.pixels[0] == 0) {
        json["groups"] = plan.groups;
    } else {
        json["pixels_of_a_group"] = plan.pixels;
    }
    json["bindings"] = bindings_json(pass);
    if (pass.interface.push_constants) json["push_constants"] = push_constants_json(pass);
    json["specialization_constants"] = Json::array();
    for (const shader::SpecializationConstant& constant : pass.interface.constants) {
        json["specialization_constants"].push_back(
            {{"id", constant.id}, {"name", constant.name}, {"type", constant.type}, {"bits", constant.bits}});
    }
    json["barriers"] = Json::array();
    for (const Hazard& hazard : hazards_before(effect, index)) {
        json["barriers"].push_back(
            {{"resource", hazard.resource}, {"after", hazard.after}, {"written", hazard.written}});
    }
    return json;
}

}  // namespace

std::string effect_json(const PackedEffect& effect) {
    Json json{{"gloam", effect.version},
              {"preset", effect.preset},
              {"settings", json_of(effect.settings)},
              {"view", {{"width", effect.options.view.width}, {"height", effect.options.view.height}}},
              {"tile", effect.plan.tile},
              {"result", {{"image", effect.plan.result}, {"unit", effect.plan.result_unit}}},
              {"exchanged", effect.plan.exchanged}};
    for (const effect::PlannedImage& image : effect.plan.images)
        json["images"].push_back(image_json(effect, image));
    json["buffers"] = Json::array();
    for (const effect::PlannedBuffer& buffer : effect.plan.buffers)
        json["buffers"].push_back(buffer_json(buffer));
    for (std::size_t i = 0; i < effect.passes.size(); ++i) json["passes"].push_back(pass_json(effect, i));
    return json.dump(2) + "\n";
}

}  // namespace gloam::cli
