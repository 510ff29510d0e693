// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <span>
#include <vector>

#include "check/scalars.hpp"
#include "numeric/random.hpp"

namespace gloam::check {

// The state on which a draw may depend.
struct DrawContext {
    numeric::Random& random;
    glm::ivec2 image_size{1};  // of the run's images, for pixel coordinates
};

// How the values of one parameter are chosen: at random, or from a few fixed values that every run includes.
struct Values {
    struct Fixed {
        std::vector<Word> words;
        bool branch = false;  // at or beside a branch point
    };

    std::function<void(DrawContext&, std::vector<Word>&)> draw;  // appends one value
    std::vector<Fixed> fixed;
    // Whether a value may be drawn; empty: unknown. A search for worse inputs stays inside.
    std::function<bool(std::span<const Word>)> contains;
    // Positions of the words that hold sizes of the run's images, two words each.
    std::vector<std::size_t> image_sizes;
    bool only_drawn = false;  // see only_as_drawn

    // Whether a value may be an input: it is a fixed value, or it may be drawn.
    [[nodiscard]] bool admits(std::span<const Word> words) const;

    // Each returns the same values with more fixed ones.
    // Adds every special float (numeric::special_floats): as a scalar, in each component of a vector, and in
    // all components.
    [[nodiscard]] Values and_special() const;
    // Adds branch points of a float parameter: each point and the floats one ULP on either side.
    [[nodiscard]] Values and_near(std::initializer_list<double> points) const;
    // Adds branch points of an integer parameter: each point and its two neighbours (as int; unsigned wraps).
    [[nodiscard]] Values and_near_integers(std::initializer_list<long> points) const;

    // The same values without degenerate inputs (check/degenerate.hpp). For a parameter whose documented
    // values are only the drawn ones, for example the result of another function, or the size of the image
    // that contains a pixel.
    [[nodiscard]] Values only_as_drawn() const;

    template <class T>
    [[nodiscard]] Values and_value(const T& value, bool branch = false) const {
        Values more = *this;
        Fixed fixed_value{.words = {}, .branch = branch};
        append_words(value, fixed_value.words);
        more.fixed.push_back(std::move(fixed_value));
        return more;
    }
};

// float, uniform in [low, high]. Fixed values: the ends; if 0 is between them, also both zeros and the
// smallest normal and subnormal numbers of each sign.
[[nodiscard]] Values uniform(double low, double high);
// float whose logarithm is uniform in [log low, log high], 0 < low < high.
[[nodiscard]] Values log_uniform(double low, double high);
// The same with either sign.
[[nodiscard]] Values signed_log_uniform(double low, double high);
// float with any bit pattern.
[[nodiscard]] Values any_float();
// int or uint in [low, high]; the ends are fixed values.
[[nodiscard]] Values integers(long low, long high);
// int or uint: 0, or a value in [1, high] whose logarithm is uniform.
[[nodiscard]] Values log_integers(long high);
[[nodiscard]] Values booleans();
// vecN or ivecN with independent components. A fixed value of the component is set in each component alone
// and in all.
[[nodiscard]] Values vector(int components, const Values& component);
// vecN or ivecN with separate values for each component.
[[nodiscard]] Values vector(const std::vector<Values>& components);
// Directions, uniform on the unit circle (2) or sphere (3); the axes as fixed values.
[[nodiscard]] Values unit_vector(int components);
// A unit vector times a length.
[[nodiscard]] Values vector_of_length(int components, const Values& length);
// ivec2: a pixel of the run's image, corners included; and the size of the image.
[[nodiscard]] Values image_pixel();
[[nodiscard]] Values image_size();
// One of two kinds of values with equal probability; the fixed values of both.
[[nodiscard]] Values either(const Values& a, const Values& b);
// Values of T made by any function.
template <class T, class Make>
[[nodiscard]] Values made_by(Make make) {
    Values values;
    values.draw = [make](DrawContext& context, std::vector<Word>& words) {
        append_words(static_cast<T>(make(context.random)), words);
    };
    return values;
}
// Always the same value.
template <class T>
[[nodiscard]] Values constant(const T& value) {
    return made_by<T>([value](numeric::Random&) { return value; });
}

}  // namespace gloam::check
