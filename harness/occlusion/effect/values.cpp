// SPDX-License-Identifier: MIT
#include "effect/internal/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// A number in the type that a shader declares.
std::uint32_t bits_of(double number, const std::string& type) {
    if (type == "float") return std::bit_cast<std::uint32_t>(static_cast<float>(number));
    return type == "int" ? static_cast<std::uint32_t>(static_cast<std::int32_t>(number))
                         : static_cast<std::uint32_t>(number);
}

// A switch is 0 or 1, a name its place among the choices.
double number_of(const Setting& setting, const Settings& settings) {
    const SettingValue value = setting.get(settings);
    if (const auto* on = std::get_if<bool>(&value)) return *on ? 1.0 : 0.0;
    if (const auto* number = std::get_if<double>(&value)) return *number;
    const auto choice = std::ranges::find(setting.choices, std::get<std::string>(value));
    return static_cast<double>(choice - setting.choices.begin());
}

void add_settings(const Settings& s, Values& all) {
    for (const Setting& setting : setting_table()) all.set(setting.name, number_of(setting, s));
    const MethodInfo& method = method_named(s.method);
    all.set("caps_radius", s.radius_cap < no_radius_cap);
    all.set("fewer_samples", s.samples_distance > 0.0F || s.samples_radius > 0.0F);
    all.set("keeps_history", s.history);
    all.set("method_steps", s.own.steps);
    all.set("on_lattice", s.rotation == Rotation::lattice);
    all.set("rounds_up", method.unit == SampleUnit::pair);
    all.set("samples_asked", s.samples);
    all.set("samples_unit", unit_of(method, s.own.steps));
    all.set("shade_border", s.guard_history);
    all.set("shows_alone", shows_alone(s));
    const float width = static_cast<float>(2 * s.filter_half_width + 1);
    all.set("sigma_pixels", double{s.filter_sigma * width});
    all.set("smooths", s.smoothing > 0.0F);
}

void add_view(const Moment& m, Values& all) {
    const scene::CameraFrame& camera = m.view.camera;
    const scene::Encoding encoding = m.converted.value_or(scene::Encoding{});
    all.set("border", vector_of_size(m.view.border.each_side()));
    all.set("depth_buffer", encoding.depth_buffer);
    all.set("has_normals", m.has_normals);
    all.set("moving_objects", m.has_positions);
    all.set("octahedral_normals", encoding.octahedral);
    all.set("orthographic", camera.orthographic());
    all.set("p00_p11", camera.p00_p11());
    all.set("p22_p32", glm::vec2(camera.proj_vk[2][2], camera.proj_vk[3][2]));
    all.set("previous_from_current", camera.previous_from_current.value_or(glm::mat4(1.0F)));
    all.set("previous_orthographic", m.before.camera.orthographic());
    all.set("previous_p00_p11", m.before.camera.p00_p11());
    all.set("size", vector_of_size(m.view.extent));
    all.set("unorm_normals", encoding.unorm);
    all.set("view_from_world", glm::mat3x4(glm::mat3(camera.view)));
    all.set("watches_objects",
            m.moves_history() && m.has_positions && m.settings.invalidation != Invalidation::none);
    all.set("world_from_view", glm::mat3x4(glm::transpose(glm::mat3(camera.view))));
    all.set("world_normals", encoding.world);
}

}  // namespace

void Values::set(const std::string& name, std::vector<double> numbers) {
    values_.insert_or_assign(name, std::move(numbers));
}

const std::vector<double>& Values::at(const std::string& name, std::size_t count,
                                      const std::string& file) const {
    const auto found = values_.find(name);
    if (found == values_.end()) throw std::logic_error(fmt::format("{}: no value of {}", file, name));
    if (found->second.size() != count)
        throw std::logic_error(
            fmt::format("{}: {} has {} elements, its value {}", file, name, count, found->second.size()));
    return found->second;
}

std::vector<std::byte> Values::push_constants(const module::ModuleInterface& interface,
                                              const std::string& file) const {
    std::vector<std::byte> bytes;
    if (!interface.push_constants) return bytes;
    bytes.resize(interface.push_constants->size);
    for (const module::LaidOut& member : interface.push_constants->members) {
        const std::vector<double>& numbers = at(member.name, std::size_t{member.rows} * member.columns, file);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::size_t column = i / member.rows * (member.size / member.columns);
            const std::uint32_t bits = bits_of(numbers[i], member.type);
            std::memcpy(&bytes[member.offset + column + sizeof bits * (i % member.rows)], &bits, sizeof bits);
        }
    }
    return bytes;
}

std::vector<backend::vulkan::SpecializationConstant> Values::constants(
    const module::ModuleInterface& interface, const std::string& file) const {
    std::vector<backend::vulkan::SpecializationConstant> all;
    for (const module::SpecializationConstant& constant : interface.constants)
        all.push_back({.id = constant.id, .bits = bits_of(at(constant.name, 1, file)[0], constant.type)});
    return all;
}

Values values_of(const Moment& moment) {
    Values all;
    add_settings(moment.settings, all);
    add_view(moment, all);
    return all;
}

Values values_of(const View& view, const Settings& settings) {
    Moment moment{.settings = settings};
    moment.look(view, view);
    return values_of(moment);
}

}  // namespace gloam::effect
