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

// What a draw may depend on.
struct DrawContext {
    numeric::Random& random;
    glm::ivec2 image_size{1};  // of the images of the run, for pixel coordinates
};

// How the values of one parameter are chosen: drawn at random, or one of a few fixed ones that every run
// includes.
struct Values {
    struct Fixed {
        std::vector<Word> words;
        bool branch = false;  // at or beside a branch point
    };

    std::function<void(DrawContext&, std::vector<Word>&)> draw;  // appends one value
    std::vector<Fixed> fixed;
    // Whether a value is one that may be drawn; empty: not known. A search for worse inputs moves
    // inside.
    std::function<bool(std::span<const Word>)> contains;
    // The words at which sizes of the run's images stand, two each.
    std::vector<std::size_t> image_sizes;
    bool only_drawn = false;  // see only_as_drawn

    // Whether a value may be an input: it is fixed, or it may be drawn.
    [[nodiscard]] bool admits(std::span<const Word> words) const;

    // Each returns the same values with more fixed ones.
    // Every special float (numeric::special_floats) as a scalar, in each component of a vector, and in all at
    // once.
    [[nodiscard]] Values and_special() const;
    // Branch points of a float parameter: each point and the floats one ULP either side of it.
    [[nodiscard]] Values and_near(std::initializer_list<double> points) const;
    // Branch points of an integer parameter: each point and its two neighbours (as int; unsigned wraps).
    [[nodiscard]] Values and_near_integers(std::initializer_list<long> points) const;

    // The same values and nothing degenerate (check/degenerate.hpp): for a parameter of which nothing else is
    // documented, such as what another function gave, or the size of the image that a pixel is inside.
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

// float, uniform in [low, high]. Fixed values: the ends, and where 0 lies between them both zeros, the
// smallest normal and subnormal numbers of each side.
[[nodiscard]] Values uniform(double low, double high);
// float, its logarithm uniform between those of 0 < low < high.
[[nodiscard]] Values log_uniform(double low, double high);
// The same with either sign.
[[nodiscard]] Values signed_log_uniform(double low, double high);
// Any float32 bit pattern at all.
[[nodiscard]] Values any_float();
// int or uint in [low, high] (ends included as fixed values).
[[nodiscard]] Values integers(long low, long high);
// int or uint whose logarithm is uniform in [1, high], and 0.
[[nodiscard]] Values log_integers(long high);
[[nodiscard]] Values booleans();
// vecN or ivecN whose components are drawn independently; fixed values of the component go into each
// component alone and into all together.
[[nodiscard]] Values vector(int components, const Values& component);
// Different values for each component.
[[nodiscard]] Values vector(const std::vector<Values>& components);
// Directions, uniform on the unit circle (2) or sphere (3); the axes as fixed values.
[[nodiscard]] Values unit_vector(int components);
// A unit vector times a length.
[[nodiscard]] Values vector_of_length(int components, const Values& length);
// ivec2 pixel of the run's image, corners included; and ivec2 size of the image.
[[nodiscard]] Values image_pixel();
[[nodiscard]] Values image_size();
// One of two kinds of values, each as often as the other; the fixed values of both.
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
