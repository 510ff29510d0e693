// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "interpreter/internal/code.hpp"

// Finds two accesses of a group's invocations to one word of memory, one of them a write, that no barrier
// puts into an order.
namespace gloam::interpreter::internal {

// What a barrier orders: the bits of SpvMemorySemantics for each kind of memory.
inline constexpr std::uint32_t orders_shared = 0x100;
inline constexpr std::uint32_t orders_buffers = 0x40;
inline constexpr std::uint32_t orders_images = 0x800;
[[nodiscard]] std::uint32_t semantics_of(const Resource& resource);

class Races {
  public:
    enum class Use { read, write, atomic };

    struct Access {
        std::uint32_t lane = 0;
        std::uint32_t instruction = 0;
        Use use = Use::read;
        std::uint32_t round = 0;  // of its subgroup
    };
    struct Where {
        std::uint32_t resource = 0;
        std::uint32_t word = 0;
    };

    Races(const Code& code, std::uint32_t lanes, std::uint32_t subgroup_size)
        : code_(code), subgroup_size_(subgroup_size), rounds_(lanes / subgroup_size + 1) {}

    // Forgets all: a new run begins.
    void begin() { known_.clear(); }

    // Records the access. Returns an earlier one with which it races.
    std::optional<Access> add(const Where& where, Access access);

    // Whether another invocation has used the word since the last barrier.
    [[nodiscard]] bool is_contended(const Where& where, std::uint32_t lane) const;

    // A barrier of the whole group, with the memory semantics of it and of the fences before it.
    void group_barrier(std::uint32_t semantics);
    void subgroup_barrier(std::uint32_t subgroup) { ++rounds_.at(subgroup); }

  private:
    // The last write, and the last read of two different invocations.
    struct Word {
        std::optional<Access> write;
        std::array<std::optional<Access>, 2> reads;
        std::uint32_t first_lane = 0;
        bool several = false;  // other invocations have used it, too
    };
    [[nodiscard]] bool races(const std::optional<Access>& before, const Access& now) const;

    const Code& code_;
    std::uint32_t subgroup_size_;
    std::vector<std::uint32_t> rounds_;  // barriers of each subgroup
    std::unordered_map<std::uint64_t, Word> known_;
};

}  // namespace gloam::interpreter::internal
