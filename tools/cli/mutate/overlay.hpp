// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.hpp"

namespace gloam::cli {

// A copy of a folder in which one file at a time has another text.
class Overlay {
  public:
    // Throws std::runtime_error for a folder that is too large to be copied.
    explicit Overlay(std::filesystem::path original);

    // `file`: relative to the folder.
    void change(const std::filesystem::path& file, std::string_view text) const;
    void restore(const std::filesystem::path& file) const;

    // For a program that is to read this copy, see shader::overlaid(); and which file has changed.
    [[nodiscard]] std::vector<std::string> environment(const std::filesystem::path& file) const;

  private:
    std::filesystem::path original_;
    base::TemporaryFolder folder_;
};

// Overlays of one folder, one for each job.
class Overlays {
  public:
    Overlays(const std::filesystem::path& original, unsigned jobs);

    [[nodiscard]] const Overlay& take();
    void give_back(const Overlay& overlay);

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Overlay>> all_;
    std::vector<const Overlay*> free_;
};

}  // namespace gloam::cli
