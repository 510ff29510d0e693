// SPDX-License-Identifier: MIT
#include "interpreter/internal/races.hpp"

namespace gloam::interpreter::internal {
namespace {

constexpr unsigned bits_of_word = 32;

std::uint64_t key_of(const Races::Where& where) {
    return std::uint64_t{where.resource} << bits_of_word | where.word;
}

}  // namespace

std::uint32_t semantics_of(const Resource& resource) {
    if (resource.shared_words > 0) return orders_shared;
    return resource.kind == Resource::Kind::image ? orders_images : orders_buffers;
}

bool Races::races(const std::optional<Access>& before, const Access& now) const {
    if (!before || before->lane == now.lane) return false;
    if (before->use == Use::read && now.use == Use::read) return false;
    if (before->use == Use::atomic && now.use == Use::atomic) return false;
    const bool same_subgroup = before->lane / subgroup_size_ == now.lane / subgroup_size_;
    return !same_subgroup || before->round == now.round;
}

std::optional<Races::Access> Races::add(const Where& where, Access access) {
    access.round = rounds_.at(access.lane / subgroup_size_);
    Word& word = known_.try_emplace(key_of(where), Word{.first_lane = access.lane}).first->second;
    word.several = word.several || word.first_lane != access.lane;
    if (races(word.write, access)) return word.write;
    for (const auto& read : word.reads)
        if (races(read, access)) return read;
    if (access.use == Use::read) {
        const bool first = !word.reads[0] || word.reads[0]->lane == access.lane;
        word.reads.at(first ? 0 : 1) = access;
    } else {
        word.write = access;
    }
    return std::nullopt;
}

bool Races::is_contended(const Where& where, std::uint32_t lane) const {
    const auto found = known_.find(key_of(where));
    return found != known_.end() && (found->second.several || found->second.first_lane != lane);
}

void Races::group_barrier(std::uint32_t semantics) {
    std::erase_if(known_, [&](const auto& one) {
        return (semantics & semantics_of(code_.resources.at(one.first >> bits_of_word))) != 0;
    });
}

}  // namespace gloam::interpreter::internal
