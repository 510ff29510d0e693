// SPDX-License-Identifier: MIT
#include "gpu/internal/timestamps.hpp"

#include <algorithm>
#include <limits>

namespace gloam::gpu {
namespace {

constexpr std::uint32_t pool_size = 64;

}  // namespace

std::size_t Timestamps::record(const Context& context, const vk::raii::CommandBuffer& commands) {
    if (context.physical.timestamp_mask == 0) return count_++;
    const auto query = static_cast<std::uint32_t>(count_ % pool_size);
    if (query == 0) {
        pools_.emplace_back(context.device, vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eTimestamp,
                                                                    .queryCount = pool_size});
        commands.resetQueryPool(*pools_.back(), 0, pool_size);
    }
    commands.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *pools_.back(), query);
    return count_++;
}

std::vector<double> Timestamps::read_ms(const Context& context) const {
    std::vector<double> times(count_, std::numeric_limits<double>::quiet_NaN());
    const auto mask = context.physical.timestamp_mask;
    std::uint64_t start = 0;
    for (std::size_t first = 0; mask != 0 && first < count_; first += pool_size) {
        const auto readings = static_cast<std::uint32_t>(std::min<std::size_t>(pool_size, count_ - first));
        const auto ticks = pools_[first / pool_size]
                               .getResults<std::uint64_t>(0, readings, readings * sizeof(std::uint64_t),
                                                          sizeof(std::uint64_t), vk::QueryResultFlagBits::e64)
                               .second;
        if (first == 0) start = ticks[0];
        for (std::size_t i = 0; i < readings; ++i) {
            const auto elapsed = static_cast<double>((ticks[i] - start) & mask);  // the clock may wrap around
            times[first + i] = elapsed * context.physical.info.timestamp_period_ns * 1e-6;
        }
    }
    return times;
}

}  // namespace gloam::gpu
