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

// The inputs of a check: one Values for each in and inout parameter, in order, and the relations between
// them.
class Domain {
  public:
    Domain() = default;
    Domain(std::initializer_list<Values> parameters) : parameters_(parameters) {}
    explicit Domain(std::vector<Values> parameters) : parameters_(std::move(parameters)) {}

    // Adds a relation for branch points that depend on another parameter. In one of sixteen inputs, float
    // parameter `target` becomes float parameter `source` times `factor`, or one of the floats one ULP beside
    // it. Positions count in and inout parameters from 0. Throws std::invalid_argument for a position out of
    // range.
    [[nodiscard]] Domain tied(std::size_t target, std::size_t source, double factor = 1.0) const;

    // Adds a function that may change the words of every input after it was drawn, for example to keep min <=
    // max.
    [[nodiscard]] Domain adjusted(std::function<void(std::span<Word>)> adjust) const;

    // Adds an input that every run includes, for example the worst one that a search found. It is passed to
    // the function without adjustment.
    template <class... T>
    [[nodiscard]] Domain and_input(const T&... values) const {
        std::vector<Word> words;
        (append_words(values, words), ...);
        return and_words(words);
    }
    [[nodiscard]] Domain and_words(const std::vector<Word>& words) const;

    // Adds degenerate inputs (check/degenerate.hpp) of a function with this signature.
    [[nodiscard]] Domain and_degenerate(const Signature& signature) const;

    struct Inputs {
        std::vector<Word> words;   // one input after another
        std::vector<bool> branch;  // input was placed at a branch point
        std::size_t width = 0;     // words of one input

        [[nodiscard]] std::size_t count() const { return branch.size(); }
        [[nodiscard]] std::span<const Word> row(std::size_t i) const {
            return std::span(words).subspan(i * width, width);
        }
    };

    // Draws `count` inputs; the same seed gives the same inputs on every machine. They begin with the given
    // inputs. Then every fixed value and every degenerate change occurs at least once; if there are too many,
    // a part of them takes half of the inputs. The rest is a mixture of random inputs, inputs with one fixed
    // value, inputs with fixed values only, and degenerate inputs.
    [[nodiscard]] Inputs draw(std::size_t count, std::uint64_t seed,
                              glm::ivec2 image_size = glm::ivec2(1)) const;

    // For a search: inputs as drawn, before adjustment; and the adjustment of such an input.
    [[nodiscard]] Inputs draw_unadjusted(std::size_t count, std::uint64_t seed,
                                         glm::ivec2 image_size = glm::ivec2(1)) const;
    void adjust(std::span<Word> row) const;

    // Whether an input certainly belongs to this domain: each parameter has a value that its Values admit, or
    // its value in `known`, an input that was drawn; and no adjustment would change it.
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
