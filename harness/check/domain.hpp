// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <vector>

#include "check/degenerate.hpp"
#include "check/values.hpp"

namespace gloam::check {

// The inputs of a check: one Values for each in and inout parameter, in order, and what ties them together.
class Domain {
  public:
    Domain() = default;
    Domain(std::initializer_list<Values> parameters) : parameters_(parameters) {}
    explicit Domain(std::vector<Values> parameters) : parameters_(std::move(parameters)) {}

    // In one input of sixteen, float parameter `target` is set to float parameter `source` times `factor`, or
    // to one of the floats one ULP beside it: branch points that depend on another parameter. Positions count
    // parameters.
    [[nodiscard]] Domain tied(std::size_t target, std::size_t source, double factor = 1.0) const;

    // `adjust` may change the words of every input after it was drawn (to keep min <= max, for example).
    [[nodiscard]] Domain adjusted(std::function<void(std::span<Word>)> adjust) const;

    // The same with an input that every run includes, whatever else it draws: the worst that a search found,
    // say. As the function gets it: nothing is adjusted.
    template <class... T>
    [[nodiscard]] Domain and_input(const T&... values) const {
        std::vector<Word> words;
        (append_words(values, words), ...);
        return and_words(words);
    }
    [[nodiscard]] Domain and_words(const std::vector<Word>& words) const;

    // The same with degenerate inputs (check/degenerate.hpp) of a function with that signature.
    [[nodiscard]] Domain and_degenerate(const Signature& signature) const;

    struct Inputs {
        std::vector<Word> words;   // one input after the other
        std::vector<bool> branch;  // input was placed at a branch point
        std::size_t width = 0;     // words of one input

        [[nodiscard]] std::size_t count() const { return branch.size(); }
        [[nodiscard]] std::span<const Word> row(std::size_t i) const {
            return std::span(words).subspan(i * width, width);
        }
    };

    // `count` inputs from the seed, the same on every machine: the given inputs; every fixed value and every
    // degenerate change at least once, or some of them in half of the inputs; then a mixture of all-random
    // inputs, inputs with one fixed value, inputs of fixed values only, and degenerate ones.
    [[nodiscard]] Inputs draw(std::size_t count, std::uint64_t seed,
                              glm::ivec2 image_size = glm::ivec2(1)) const;

    // What a search works on: inputs as drawn, before anything is adjusted; and what is done to them then.
    [[nodiscard]] Inputs draw_unadjusted(std::size_t count, std::uint64_t seed,
                                         glm::ivec2 image_size = glm::ivec2(1)) const;
    void adjust(std::span<Word> row) const;

    // Whether an input is known to be one of this domain: each parameter has a value that it admits, or the
    // one that it has in `known`, an input that was drawn; and no adjustment would change it.
    [[nodiscard]] bool holds(std::span<const Word> input, std::span<const Word> known) const;

    [[nodiscard]] const std::vector<Values>& parameters() const { return parameters_; }

  private:
    struct Tie {
        std::size_t target;
        std::size_t source;
        double factor;
    };
    struct Forced;
    [[nodiscard]] std::vector<Forced> all_forced() const;
    void append_row(DrawContext& context, Inputs& inputs, const Forced& forced) const;
    bool make_degenerate(DrawContext& context, std::span<Word> row, const Forced& forced) const;
    void append_drawn(Inputs& inputs, std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const;
    bool apply_tie(DrawContext& context, std::span<Word> row, const std::vector<std::size_t>& offsets) const;

    std::vector<Values> parameters_;
    std::vector<Tie> ties_;
    std::vector<std::function<void(std::span<Word>)>> adjustments_;
    std::vector<std::vector<Word>> given_;
    Degenerate degenerate_;
};

}  // namespace gloam::check
