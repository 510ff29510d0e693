// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gpu/compute.hpp"

namespace gloam::gpu {

// Work recorded in order and run once. Each command sees the writes of all commands before it.
// Resources and pipelines named here must live until submit() returns.
class Commands {
  public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(Commands&&) noexcept;
    Commands& operator=(Commands&&) noexcept;

    // Runs `groups` work groups with resources[i] at binding i. Throws std::invalid_argument when the
    // resources do not match the pipeline's bindings, the push constants its size, or a group count the limit.
    void dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                  std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {});

    // Records the device's clock after all work so far; returns the position of the reading in times_ms().
    std::size_t timestamp();

    // Submits and waits. Throws std::runtime_error on a lost device or when the device's timeout passes.
    void submit();

    // After submit(): the readings, in milliseconds since the first. Empty without timestamps.
    [[nodiscard]] std::vector<double> times_ms() const;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::gpu
