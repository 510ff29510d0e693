// SPDX-License-Identifier: MIT
#include "gpu/internal/select.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>

namespace gloam::gpu {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

// Real GPUs first, in any order; software last.
std::size_t default_device(std::span<const DeviceInfo> devices) {
    const auto rank = [](const DeviceInfo& device) {
        constexpr std::array<std::string_view, 4> order{"discrete", "integrated", "virtual", "cpu"};
        const auto found = std::ranges::find(order, device.type);
        return std::max<std::ptrdiff_t>(found - order.begin(), 1);  // discrete and integrated alike
    };
    return static_cast<std::size_t>(std::ranges::min_element(devices, {}, rank) - devices.begin());
}

std::optional<std::size_t> by_index(std::span<const DeviceInfo> devices, std::string_view digits) {
    std::size_t index = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (parsed.ec != std::errc{} || index >= devices.size()) return std::nullopt;
    return index;
}

std::optional<std::size_t> by_name(std::span<const DeviceInfo> devices, std::string_view part) {
    const auto found = std::ranges::find_if(devices, [wanted = lower(part)](const DeviceInfo& device) {
        return lower(device.name).find(wanted) != std::string::npos;
    });
    if (found == devices.end()) return std::nullopt;
    return static_cast<std::size_t>(found - devices.begin());
}

std::string listing(std::span<const DeviceInfo> devices) {
    std::string text;
    for (const auto& device : devices) {
        text +=
            fmt::format("{}{} \"{}\" ({})", text.empty() ? "" : ", ", device.index, device.name, device.type);
    }
    return text;
}

}  // namespace

std::size_t select_device(std::span<const DeviceInfo> devices, std::string_view selector) {
    if (devices.empty()) throw std::runtime_error(no_device_message);
    if (selector.empty()) return default_device(devices);
    const bool is_index = selector.find_first_not_of("0123456789") == std::string_view::npos;
    const auto found = is_index ? by_index(devices, selector) : by_name(devices, selector);
    if (!found) {
        throw std::runtime_error(
            fmt::format("no Vulkan device \"{}\"; there are: {}", selector, listing(devices)));
    }
    return *found;
}

}  // namespace gloam::gpu
