// SPDX-License-Identifier: MIT
#include "backend/vulkan/device.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <system_error>

namespace gloam::backend::vulkan {
namespace {

namespace fs = std::filesystem;

constexpr const char* swiftshader_manifest = "vk_swiftshader_icd.json";
constexpr const char* swiftshader_library = "libvk_swiftshader.so";

// Variables that replace the loader's own search, in its order: the newer name, then the older one.
constexpr std::array instead{"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};
constexpr const char* besides = "VK_ADD_DRIVER_FILES";

bool is_file(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none);
}

[[noreturn]] void refuse(const fs::path& manifest, const std::string& reason) {
    throw std::runtime_error(fmt::format("Vulkan driver {}: {}", manifest.string(), reason));
}

// The library in a manifest: a path, or a name that the system searches for.
std::string library_of(const fs::path& manifest) {
    std::ifstream stream(manifest, std::ios::binary);
    if (!stream) refuse(manifest, "cannot be read");
    const auto json = nlohmann::json::parse(stream, nullptr, false);
    const nlohmann::json::json_pointer place("/ICD/library_path");
    if (!json.is_object() || !json.contains(place) || !json.at(place).is_string())
        refuse(manifest, R"(not a driver manifest: expected JSON with {"ICD": {"library_path": "..."}})");
    return json.at(place).get<std::string>();
}

void require_driver(const fs::path& manifest) {
    std::error_code none;
    if (fs::is_directory(manifest, none)) refuse(manifest, "a folder, expected a driver's manifest");
    if (!is_file(manifest)) refuse(manifest, "no such file");
    if (manifest.string().find(':') != std::string::npos)
        refuse(manifest, "the Vulkan loader takes no path with a colon");
    const fs::path library = library_of(manifest);
    if (!library.has_parent_path()) return;
    const fs::path file = manifest.parent_path() / library;
    if (!is_file(file)) refuse(manifest, fmt::format("its library {} is missing", file.string()));
}

}  // namespace

std::vector<fs::path> swiftshader_folders() {
    return {"/usr/lib/chromium",
            "/usr/lib/chromium-browser",
            "/usr/lib64/chromium",
            "/usr/lib64/chromium-browser",
            "/opt/google/chrome",
            "/opt/google/chrome-beta",
            "/opt/google/chrome-unstable",
            "/opt/chromium.org/chromium",
            "/snap/chromium/current/usr/lib/chromium-browser"};
}

std::optional<fs::path> find_swiftshader(const std::vector<fs::path>& folders) {
    for (const fs::path& folder : folders)
        if (is_file(folder / swiftshader_manifest) && is_file(folder / swiftshader_library))
            return folder / swiftshader_manifest;
    return std::nullopt;
}

void choose_drivers(std::span<const fs::path> manifests) {
    std::string files;
    for (const fs::path& manifest : manifests) {
        require_driver(manifest);
        files += (files.empty() ? "" : ":") + fs::absolute(manifest).string();
    }
    for (const char* variable : instead) ::setenv(variable, files.c_str(), 1);
}

void add_swiftshader() {
    const auto manifest = find_swiftshader();
    if (manifest && chosen_drivers().empty()) ::setenv(besides, manifest->c_str(), 1);
}

std::vector<std::pair<std::string, std::string>> chosen_drivers() {
    std::vector<std::pair<std::string, std::string>> all;
    const auto add = [&](const char* variable) {
        if (const char* value = std::getenv(variable)) all.emplace_back(variable, value);
    };
    add(instead[0]);
    if (all.empty()) add(instead[1]);
    add(besides);
    return all;
}

}  // namespace gloam::backend::vulkan
