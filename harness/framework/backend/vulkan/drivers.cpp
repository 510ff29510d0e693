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

// Whether a variable is set. If it is empty, the loader searches nowhere.
bool is_set(const char* variable) {
    return std::getenv(variable) != nullptr;
}

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
    if (!is_file(manifest)) refuse(manifest, "no such file");
    if (manifest.string().find(':') != std::string::npos)
        refuse(manifest, "the Vulkan loader takes no path with a colon");
    const fs::path library = library_of(manifest);
    if (!library.has_parent_path()) return;
    const fs::path file = manifest.parent_path() / library;
    if (!is_file(file)) refuse(manifest, fmt::format("its library {} is missing", file.string()));
}

void append(const char* variable, const std::string& files) {
    const char* old = std::getenv(variable);
    const std::string value = old == nullptr || *old == '\0' ? files : old + (":" + files);
    ::setenv(variable, value.c_str(), 1);
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

bool drivers_are_chosen() {
    return is_set(instead[0]) || is_set(instead[1]) || is_set(besides);
}

void add_drivers(std::span<const fs::path> manifests) {
    std::string files;
    for (const fs::path& manifest : manifests) {
        const fs::path file = fs::absolute(manifest);
        require_driver(file);
        files += (files.empty() ? "" : ":") + file.string();
    }
    if (files.empty()) return;
    bool told = false;
    for (const char* variable : instead) {
        if (!is_set(variable)) continue;
        append(variable, files);
        told = true;
    }
    if (!told) append(besides, files);
}

}  // namespace gloam::backend::vulkan
