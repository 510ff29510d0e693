// SPDX-License-Identifier: MIT
#include "cli/mutate/overlay.hpp"

#include <fmt/format.h>
#include <cstdint>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = std::uintmax_t{256} << 20;
constexpr std::size_t most_files = 20'000;

void require_small(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    std::size_t files = 0;
    for (const fs::directory_entry& one : fs::recursive_directory_iterator(folder)) {
        ++files;
        if (one.is_regular_file() && !one.is_symlink()) bytes += one.file_size();
        if (bytes > most_bytes || files > most_files)
            throw std::runtime_error(fmt::format(
                "{}: expected a folder of shaders to copy, found more than {} MiB or {} files; --include "
                "names another",
                folder.string(), most_bytes >> 20, most_files));
    }
}

}  // namespace

Overlay::Overlay(fs::path original) : original_(std::move(original)), folder_("mutate") {
    require_small(original_);
    std::error_code error;
    fs::copy(original_, folder_.path(), fs::copy_options::recursive | fs::copy_options::copy_symlinks, error);
    if (error)
        throw std::runtime_error(fmt::format("cannot copy {}: {}", original_.string(), error.message()));
}

void Overlay::change(const fs::path& file, std::string_view text) const {
    base::write_file(folder_.path() / file, text);
}

void Overlay::restore(const fs::path& file) const {
    fs::copy_file(original_ / file, folder_.path() / file, fs::copy_options::overwrite_existing);
}

std::vector<std::string> Overlay::environment(const fs::path& file) const {
    return {"GLOAM_SHADERS=" + folder_.path().string(), "GLOAM_SHADERS_OF=" + original_.string(),
            "GLOAM_SHADERS_CHANGED=" + file.generic_string()};
}

Overlays::Overlays(const fs::path& original, unsigned jobs) {
    for (unsigned i = 0; i < jobs; ++i) all_.push_back(std::make_unique<Overlay>(original));
    for (const auto& overlay : all_) free_.push_back(overlay.get());
}

const Overlay& Overlays::take() {
    const std::lock_guard lock(mutex_);
    const Overlay* const overlay = free_.back();  // there are as many as threads
    free_.pop_back();
    return *overlay;
}

void Overlays::give_back(const Overlay& overlay) {
    const std::lock_guard lock(mutex_);
    free_.push_back(&overlay);
}

}  // namespace gloam::cli
