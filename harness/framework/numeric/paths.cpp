// SPDX-License-Identifier: MIT
#include "numeric/paths.hpp"

#include <stdexcept>
#include <utility>

namespace gloam::numeric {

thread_local Paths* Paths::current_ = nullptr;

namespace {

// A run with more choices is an endless loop on its intervals.
constexpr std::size_t most_choices = 4096;

// Sets a pointer during its lifetime.
template <class T>
class Guard {
  public:
    Guard(T*& pointer, T* value) : pointer_(pointer), before_(std::exchange(pointer, value)) {}
    ~Guard() { pointer_ = before_; }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

  private:
    T*& pointer_;
    T* before_;
};

}  // namespace

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
    const Guard guard(current_, &paths);
    for (std::size_t runs = 0; runs < most; ++runs) {
        paths.position_ = 0;
        try {
            run();
        } catch (const Undetermined&) {
            return Outcome::undetermined;
        } catch (const Enough&) {
            return Outcome::enough;
        }
        if (!paths.advance()) return Outcome::complete;
    }
    return Outcome::too_many;
}

std::size_t Paths::choose(std::size_t count) {
    if (current_ == nullptr) {
        throw std::logic_error("an interval leaves a comparison open: expected to run inside Paths::explore");
    }
    if (count < 2) return 0;
    auto& choices = current_->choices_;
    if (current_->position_ == most_choices) throw Undetermined{};
    if (current_->position_ == choices.size()) choices.push_back({.taken = 0, .count = count});
    return choices[current_->position_++].taken;
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
