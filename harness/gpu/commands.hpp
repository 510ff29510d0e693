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
// Resources and pipelines named here must live until submit() returns. After submit(), only times_ms() is of
// use: recording or submitting again throws std::runtime_error.
class Commands {
  public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(Commands&&) noexcept;
    Commands& operator=(Commands&&) noexcept;

    // Runs `groups` work groups with resources[i] at binding i. Throws std::invalid_argument when the
    // resources do not match the pipeline's bindings, the push constants (copied here) its size, or a group
    // count exceeds the device's limit (0 groups do nothing).
    void dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                  std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {});

    // The same with the numbers of groups in x, y and z read from a buffer when the dispatch runs: what
    // commands before it have written there counts. They are three uint at `offset` bytes. Throws like
    // dispatch(), and std::invalid_argument for an offset that is no multiple of 4 or leaves less than 12
    // bytes. Numbers beyond the device's limit are the shader's fault that wrote them: only the validation
    // layer sees them.
    void dispatch_indirect(const ComputePipeline& pipeline, std::span<const Resource> resources,
                           const Buffer& groups, std::size_t offset,
                           std::span<const std::byte> push_constants = {});

    // Records the device's clock after all work so far; returns the position of the reading in times_ms().
    std::size_t timestamp();

    // Submits and waits. Throws std::runtime_error on a lost device, when the device's timeout passes, and
    // while an earlier submission that timed out still runs (see Device).
    void submit();

    // After submit(): the readings, in milliseconds since the first. Empty without calls of timestamp(); NaN
    // where DeviceInfo::timestamp_period_ns is 0. Throws std::runtime_error unless submit() succeeded.
    [[nodiscard]] std::vector<double> times_ms() const;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::gpu
