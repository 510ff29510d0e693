// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "judge/answer.hpp"
#include "numeric/paths.hpp"
#include "subject/interpreted_kernel.hpp"

namespace gloam::judge {

// All outputs that Vulkan's precision rules permit for one input: those of each path through the function.
// Never empty: where anything is permitted, also if there were too many paths, one outcome holds everything.
using Permitted = std::vector<Sample::Outcome>;

// Paths beyond which anything counts as permitted.
inline constexpr std::size_t most_paths = 256;

// The smallest bounds that contain every outcome, one for each output word.
[[nodiscard]] Sample::Outcome hull_of(const Permitted& permitted);

// The distance of an output from `want`, as a fraction of the distance from `want` to the end of its bounds
// on that side: 0 at `want`, 1 at the end, more outside. Infinity outside if the second distance is 0.
[[nodiscard]] double fraction_of_width(double got, double want, const numeric::Bounds& bounds);

// A module of a run.
struct DecodedModule {
    std::shared_ptr<const subject::KernelModule> module;
    interpreter::Program program;
    std::vector<std::vector<Word>> images;
    numeric::Paths::Specials specials;  // that a driver must keep
};

// The modules of a run, decoded once for all threads. Throws interpreter::Error.
using Decoded = std::vector<DecodedModule>;
[[nodiscard]] Decoded decode(const subject::KernelModules& modules, const subject::ImageSet& images);

// An input of a run: its position and its words.
struct InputRow {
    std::size_t index = 0;
    std::span<const Word> words;
};

// Interprets the modules of a run for one input at a time, on each number type. For one thread.
class Interpretation {
  public:
    // `of_driver`: what is permitted includes what a driver makes of NaN and infinity that it need not keep,
    // and the function may leave an out parameter as it is. `decoded` must outlive this object.
    Interpretation(const Decoded& decoded, const subject::Signature& signature, bool of_driver = true)
        : decoded_(decoded),
          outputs_(signature.output_scalars()),
          results_(of_driver ? module::scalar_count(signature.result) : outputs_.size()),
          of_driver_(of_driver),
          parts_(decoded.size()) {}

    // Whether the outputs equal, in every bit, those of correctly rounded arithmetic; all NaNs are equal.
    // Vulkan permits these results for every module.
    [[nodiscard]] bool is_exact(const InputRow& input, std::span<const Word> got);

    // Limit of instructions of one input in double.
    static constexpr std::uint64_t most_instructions = 4'000'000;

    // The outputs in double. Returns how many instructions they took. Throws interpreter::Error as well for
    // an output that is undefined, but for an out parameter that the function leaves as it is.
    std::uint64_t calculate(const InputRow& input, std::vector<double>& outputs);

    // Whether some legal evaluation yields these outputs. It is faster than all_permitted(): it stops at the
    // first path that does, and tries rearranged sums only if the order of the module does not yield them.
    [[nodiscard]] bool is_permitted(const InputRow& input, std::span<const Word> got);

    // Whether an outcome contains these outputs.
    [[nodiscard]] bool holds(const Sample::Outcome& outcome, std::span<const Word> got) const;

    // Everything that Vulkan permits.
    [[nodiscard]] Permitted all_permitted(const InputRow& input);

    // Number of instructions interpreted on intervals so far.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    template <class N>
    using Made = std::unique_ptr<subject::InterpretedKernel<N>>;  // when it is needed
    using Part = std::tuple<Made<float>, Made<double>, Made<numeric::Interval>, Made<numeric::Rearranged>>;
    struct Location {
        std::size_t part;
        std::size_t index;
    };

    [[nodiscard]] Location place_of(std::size_t index) const;
    template <class N>
    [[nodiscard]] subject::InterpretedKernel<N>& kernel(std::size_t part);
    template <class N>
    [[nodiscard]] Permitted explore(const InputRow& input, std::span<const Word> until = {});

    const Decoded& decoded_;
    std::vector<module::Scalar> outputs_;
    std::size_t results_;  // those that the function must give
    bool of_driver_;
    std::vector<Part> parts_;
    std::vector<Word> exact_;
    std::uint64_t steps_ = 0;
};

}  // namespace gloam::judge
