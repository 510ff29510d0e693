// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "numeric/numbers.hpp"
#include "numeric/random.hpp"

namespace gloam::numeric {

// Runs branching code on intervals without changing it: once for every way that its undecided comparisons may
// go. A comparison that the intervals do not decide calls choose(); explore() repeats the run until every
// sequence of answers was used. The results of all runs then contain every result for any values inside the
// intervals. The exploration also sets the format of the arithmetic.
//
// The current exploration is a property of the running thread, because an operator cannot get it otherwise;
// explore() sets and restores it.
class Paths {
  public:
    // Thrown by run() if every result is permitted on this path.
    struct Undetermined {};
    // Thrown by run() if no other path matters.
    struct Enough {};

    // What holds where Vulkan states no precision for a defined result: sine and cosine beyond pi, the root
    // of zero, zero to a power. `open`: every result is permitted. `closed`: the precision beside the gap.
    enum class Gaps { open, closed };

    // Which neighbour a correctly rounded result is: Vulkan leaves that open, unless it is known what runs.
    enum class Rounding { either, to_even };

    // Which operations keep NaN and infinity: all; those that SignedZeroInfNanPreserve binds in each of its
    // wordings (Vulkan 1.1.95 to 1.4.360); none. The others may assume that there are none.
    enum class Specials { kept, listed, dropped };

    enum class Outcome { complete, enough, undetermined, too_many };

    // Calls run() for every path, at most `most` times. `undetermined`: some path ended with Undetermined;
    // `too_many`: there are more than `most` paths. In both cases the runs do not cover all permitted
    // results.
    static Outcome explore(const FloatFormat& format, std::size_t most, const std::function<void()>& run,
                           Gaps gaps = Gaps::open, Rounding rounding = Rounding::either,
                           Specials specials = Specials::kept);

    // One of `count` >= 1 possibilities, chosen by the current path. Throws std::logic_error outside
    // explore().
    static std::size_t choose(std::size_t count);

    // One of `count` whole numbers that an operation may give, each a way of its own. Empty where all are one
    // way: they are many, or the ways that lead here are. If explore() does not come to an end with such
    // ways, it begins again without them.
    static std::optional<std::size_t> choose_whole(double count);

    // Until the run ends takes the first of all choices but of whole numbers. The second draws also these, as
    // one driver may choose them.
    static void choose_only_wholes();
    static void draw_wholes(Random& lots);

    // The format of the current exploration; float32 outside an exploration.
    static const FloatFormat& format();

    // Whether gaps are closed in the current exploration.
    static bool closes_gaps();

    static Rounding rounding();

    static Specials specials();

    // While it exists, results are rounded either way: for functions of several operations that a device may
    // evaluate as one.
    class EitherWay {
      public:
        EitherWay();
        ~EitherWay();
        EitherWay(const EitherWay&) = delete;
        EitherWay& operator=(const EitherWay&) = delete;

      private:
        Rounding before_;
    };

    // Sets the format until it is set again or the exploration ends, for code that mixes several formats.
    static void set_format(const FloatFormat& format);

  private:
    struct Choice {
        std::size_t taken;
        std::size_t count;
    };

    Paths(const FloatFormat& format, Gaps gaps, Rounding rounding, Specials specials);
    ~Paths();
    Paths(const Paths&) = delete;
    Paths& operator=(const Paths&) = delete;
    Outcome run_all(std::size_t most, const std::function<void()>& run);
    std::size_t take(std::size_t count);
    bool advance();

    static thread_local Paths* current_;
    Paths* before_;  // the exploration around this one
    FloatFormat format_;
    Gaps gaps_;
    Rounding rounding_;
    Specials specials_;
    std::vector<Choice> choices_;
    std::size_t position_ = 0;
    double ways_ = 1.0;       // that the choices up to here leave
    double most_ways_ = 0.0;  // up to which whole numbers are ways of their own
    bool has_split_ = false;
    bool only_wholes_ = false;
    Random* lots_ = nullptr;
};

}  // namespace gloam::numeric
