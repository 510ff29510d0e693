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

// Work that is recorded in order and run once. Each command sees the writes of all commands before it.
// Resources and pipelines passed to it must live until submit() returns. After submit() only times_ms() may
// be called; recording or submitting again throws std::runtime_error.
class Commands {
  public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(Commands&&) noexcept;
    Commands& operator=(Commands&&) noexcept;

    // Runs `groups` work groups with resources[i] at binding i; 0 groups do nothing. Throws
    // std::invalid_argument when the resources do not match the pipeline's bindings, the push constants
    // (copied here) do not match its size, or a group count exceeds the device's limit.
    void dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                  std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {});

    // The same with the numbers of groups in x, y and z from a buffer, read when the dispatch runs, after the
    // writes of the commands before it. They are three uint at `offset` bytes. Throws like dispatch(), and
    // std::invalid_argument for an offset that is not a multiple of 4 or leaves less than 12 bytes. Numbers
    // beyond the device's limit are an error of the shader that wrote them; only the validation layer reports
    // them.
    void dispatch_indirect(const ComputePipeline& pipeline, std::span<const Resource> resources,
                           const Buffer& groups, std::size_t offset,
                           std::span<const std::byte> push_constants = {});

    // Records the device's clock after all work so far. Returns the index of the reading in times_ms().
    std::size_t timestamp();

    // Submits the work and waits. Throws std::runtime_error on a lost device, after the device's timeout, and
    // while an earlier submission that timed out still runs (see Device).
    void submit();

    // The readings in milliseconds since the first one, after submit(). Empty without calls of timestamp();
    // NaN where DeviceInfo::timestamp_period_ns is 0. Throws std::runtime_error unless submit() succeeded.
    [[nodiscard]] std::vector<double> times_ms() const;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::gpu
