// SPDX-License-Identifier: MIT
#include "report/laboratory/driver_group.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace gloam::report {
namespace {

// Part of a device's or driver's name, in lower case, and whose it is. The first that is found counts, so
// those that run on others' hardware come first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> marks{
    {{"llvmpipe", "Mesa"},  {"softpipe", "Mesa"},  {"swiftshader", "Google"},  {"nvidia", "NVIDIA"},
     {"geforce", "NVIDIA"}, {"quadro", "NVIDIA"},  {"radeon", "AMD"},          {"amd ", "AMD"},
     {"radv", "AMD"},       {"intel", "Intel"},    {"adreno", "Qualcomm"},     {"qualcomm", "Qualcomm"},
     {"mali", "Arm"},       {"immortalis", "Arm"}, {"powervr", "Imagination"}, {"xclipse", "Samsung"},
     {"apple", "Apple"},    {"v3d", "Broadcom"},   {"videocore", "Broadcom"},  {"interpreter", "gloam"}}};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Where the version begins: at the first word that starts with a digit, or with v and a digit.
std::size_t version_at(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
        const std::size_t digit = text[i] == 'v' || text[i] == 'V' ? i + 1 : i;
        if (starts && digit < text.size() && is_digit(text[digit])) return i;
    }
    return text.size();
}

std::string trimmed(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" (");
    return std::string(text.substr(0, last == std::string_view::npos ? 0 : last + 1));
}

}  // namespace

DriverGroup group_of(const DeviceSummary& device) {
    const std::string names = lower(device.name + " " + device.driver);
    const auto* mark = std::ranges::find_if(
        marks, [&](const auto& each) { return names.find(each.first) != std::string::npos; });
    const std::string& text = device.driver.empty() ? device.name : device.driver;
    const std::size_t at = version_at(text);
    return {.vendor = mark == marks.end() ? "other" : std::string(mark->second),
            .driver = trimmed(std::string_view(text).substr(0, at)),
            .version = text.substr(at),
            .api = api_of(device)};
}

std::string name_of(const DriverGroup& group) {
    const char* between = group.driver.empty() || group.version.empty() ? "" : " ";
    return group.driver + between + group.version + ", " + group.api;
}

}  // namespace gloam::report
