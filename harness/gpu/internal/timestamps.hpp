// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/internal/context.hpp"

namespace gloam::gpu {

// Readings of the device's clock in one recording.
class Timestamps {
  public:
    // Records a reading; only outside a render pass. Returns its index.
    std::size_t record(const Context& context, const vk::raii::CommandBuffer& commands);

    // After the recording has run: milliseconds since the first reading; NaN on a device without timestamps.
    [[nodiscard]] std::vector<double> read_ms(const Context& context) const;

  private:
    std::size_t count_ = 0;
    std::vector<vk::raii::QueryPool> pools_;
};

}  // namespace gloam::gpu
