// SPDX-License-Identifier: MIT
#include "numeric/paths.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gloam::numeric {

thread_local Paths* Paths::current_ = nullptr;

namespace {

// A run with more choices is an endless loop on its intervals.
constexpr std::size_t most_choices = 4096;

constexpr std::size_t most_split_ways = 16;
constexpr double most_wholes = 4.0;  // of one operation

}  // namespace

Paths::Paths(const FloatFormat& format, Gaps gaps, Rounding rounding, Specials specials)
    : before_(std::exchange(current_, this)),
      format_(format),
      gaps_(gaps),
      rounding_(rounding),
      specials_(specials) {}

Paths::~Paths() {
    current_ = before_;
}

// The next path in depth-first order: the last choice with an untried possibility takes it.
bool Paths::advance() {
    while (!choices_.empty() && choices_.back().taken + 1 == choices_.back().count) choices_.pop_back();
    if (choices_.empty()) return false;
    ++choices_.back().taken;
    return true;
}

Paths::Outcome Paths::explore(const FloatFormat& format, std::size_t most, const std::function<void()>& run,
                              Gaps gaps, Rounding rounding, Specials specials) {
    Paths paths(format, gaps, rounding, specials);
    paths.most_ways_ = static_cast<double>(std::min(most, most_split_ways));
    const Outcome outcome = paths.run_all(most, run);
    if (outcome == Outcome::complete || outcome == Outcome::enough || !paths.has_split_) return outcome;
    paths.choices_.clear();
    paths.most_ways_ = 0.0;
    return paths.run_all(most, run);
}

Paths::Outcome Paths::run_all(std::size_t most, const std::function<void()>& run) {
    // What ends without the ways of whole numbers shall not take much longer with them.
    const std::size_t most_split = std::max(std::min(most, most_split_ways), most / 4);
    for (std::size_t runs = 0; runs < (has_split_ && most_ways_ > 0.0 ? most_split : most); ++runs) {
        position_ = 0;
        ways_ = 1.0;
        lots_ = nullptr;
        only_wholes_ = false;
        try {
            run();
        } catch (const Undetermined&) {
            return Outcome::undetermined;
        } catch (const Enough&) {
            return Outcome::enough;
        }
        if (!advance()) return Outcome::complete;
    }
    return Outcome::too_many;
}

std::size_t Paths::choose(std::size_t count) {
    if (current_ == nullptr) {
        throw std::logic_error("an interval leaves a comparison open: expected to run inside Paths::explore");
    }
    return current_->only_wholes_ ? 0 : current_->take(count);
}

std::size_t Paths::take(std::size_t count) {
    if (count < 2) return 0;
    if (lots_ != nullptr) return lots_->below(count);
    if (position_ == most_choices) throw Undetermined{};
    if (position_ == choices_.size()) choices_.push_back({.taken = 0, .count = count});
    ways_ *= static_cast<double>(count);
    return choices_[position_++].taken;
}

std::optional<std::size_t> Paths::choose_whole(double count) {
    if (current_ == nullptr || !(count <= most_wholes)) return std::nullopt;
    const bool is_drawn = current_->lots_ != nullptr;
    if (!is_drawn && current_->ways_ * count > current_->most_ways_) return std::nullopt;
    current_->has_split_ = current_->has_split_ || (count > 1.0 && !is_drawn);
    return current_->take(static_cast<std::size_t>(count));
}

void Paths::choose_only_wholes() {
    if (current_ != nullptr) current_->only_wholes_ = true;
}

void Paths::draw_wholes(Random& lots) {
    choose_only_wholes();
    if (current_ != nullptr) current_->lots_ = &lots;
}

const FloatFormat& Paths::format() {
    return current_ == nullptr ? float32 : current_->format_;
}

bool Paths::closes_gaps() {
    return current_ != nullptr && current_->gaps_ == Gaps::closed;
}

Paths::Rounding Paths::rounding() {
    return current_ == nullptr ? Rounding::either : current_->rounding_;
}

Paths::Specials Paths::specials() {
    return current_ == nullptr ? Specials::kept : current_->specials_;
}

Paths::EitherWay::EitherWay() : before_(rounding()) {
    if (current_ != nullptr) current_->rounding_ = Rounding::either;
}

Paths::EitherWay::~EitherWay() {
    if (current_ != nullptr) current_->rounding_ = before_;
}

void Paths::set_format(const FloatFormat& format) {
    if (current_ != nullptr) current_->format_ = format;
}

}  // namespace gloam::numeric
