// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "numeric/float_format.hpp"

namespace gloam::numeric {

// How code that branches is run on intervals without being changed: it is run once for every way its
// undecided comparisons may go. A comparison that an interval leaves open asks choose(); explore() repeats
// the run until every sequence of answers was given. So the results over all runs hold every result that any
// value inside the intervals can lead to. The format of the arithmetic travels with it.
//
// What is being explored is a property of the running thread (an operator has no other way to learn of it);
// explore() sets it and puts it back.
class Paths {
  public:
    // Thrown by run() to say that on this path anything at all is permitted.
    struct Undetermined {};
    // Thrown by run() to say that no other path is of interest.
    struct Enough {};

    enum class Outcome { complete, enough, undetermined, too_many };

    // Calls run() for every path, at most `most` times. `undetermined`: some path ended with Undetermined;
    // `too_many`: there are more paths than `most`. In both cases the runs do not cover what is permitted.
    static Outcome explore(const FloatFormat& format, std::size_t most, const std::function<void()>& run);

    // One of `count` >= 1 possibilities, as the current path has it. Throws std::logic_error outside
    // explore().
    static std::size_t choose(std::size_t count);

    // The format of the current exploration; float32 outside of one.
    static const FloatFormat& format();

    // The format from here on, until it is set again or the exploration ends: for code that mixes several.
    static void set_format(const FloatFormat& format);

  private:
    struct Choice {
        std::size_t taken;
        std::size_t count;
    };

    explicit Paths(const FloatFormat& format) : format_(format) {}
    bool advance();

    static thread_local Paths* current_;
    FloatFormat format_;
    std::vector<Choice> choices_;
    std::size_t position_ = 0;
};

}  // namespace gloam::numeric
