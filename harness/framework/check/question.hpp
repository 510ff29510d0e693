// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "backend/sampled.hpp"
#include "check/answer.hpp"
#include "check/domain.hpp"
#include "check/signature.hpp"
#include "numeric/random.hpp"

namespace gloam::check {

// The effect of an access outside the image: a fault of the shader, reported with its pixel; or a fetch reads
// the nearest pixel inside and a store is dropped.
enum class Border { fault, clamp };

// A small image behind a prototype such as `float gloam_fetch_depth(ivec2 pixel);`, or, for stores, `void
// gloam_store_depth(ivec2 pixel, float depth);`. Row 0 is the top row. At least 1 x 1.
struct Image {
    shader::Type element;
    glm::ivec2 size{0};
    Border border = Border::fault;
    std::vector<Word> words;  // row by row, each pixel's scalars in order
    // Of a sampler's image, whose element is vec4, ivec4 or uvec4. The words are those of all layers and
    // levels, as in backend/sampled.hpp. Floats must be representable in 16 bits. Of a sampler that compares,
    // the first component is the depth, in [0, 1].
    struct Sampling {
        bool linear = false;
        backend::Wrap wrap = backend::Wrap::repeat;
        unsigned levels = 1;
        unsigned depth = 1;  // or layers; six for each cube
        backend::Compare compare = backend::Compare::less_equal;
    };
    std::optional<Sampling> sampling = {};

    // The pixel at (x, y), clamped to the image. T must be the element's type.
    template <class T>
    [[nodiscard]] T at(glm::ivec2 pixel) const {
        if (!(type_of<T>() == element)) {
            throw std::invalid_argument("image pixels are " + shader::to_glsl(element) + ", asked for " +
                                        shader::to_glsl(type_of<T>()));
        }
        pixel = glm::clamp(pixel, glm::ivec2(0), size - 1);
        const std::size_t scalars = word_count<T>();
        const std::size_t index = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
                                  static_cast<std::size_t>(pixel.x);
        std::span<const Word> rest = std::span(words).subspan(index * scalars, scalars);
        return take_words<T>(rest);
    }
};

// Images by the name of their prototype.
using ImageSet = std::map<std::string, Image>;

// An image whose pixel (x, y) is pixel(glm::ivec2(x, y)), of type T. Throws std::invalid_argument if a side
// is below 1.
template <class T, std::invocable<glm::ivec2> Pixel>
[[nodiscard]] Image make_image(glm::ivec2 size, Pixel&& pixel, Border border = Border::fault) {
    if (size.x < 1 || size.y < 1) throw std::invalid_argument("an image has at least 1 x 1 pixels");
    Image image{.element = type_of<T>(), .size = size, .border = border, .words = {}};
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) append_words(static_cast<T>(pixel(glm::ivec2(x, y))), image.words);
    }
    return image;
}

// Images for one run of a function that reads images; a check runs every scenario with its share of the
// inputs.
struct ImageScenario {
    std::string name;  // "3 x 3", "all background"
    glm::ivec2 size{1};
    std::function<ImageSet(glm::ivec2 size, numeric::Random& random)> make;
};

// A reference without its C++ types: input words in, one double for each output word out, as number_at()
// reads it. If a question has none, the module interpreted in double replaces it.
using Reference =
    std::function<void(const ImageSet& images, std::span<const Word> inputs, std::vector<double>& outputs)>;

// The range in which every output except a bool must be, for every input. NaN is never inside.
struct Codomain {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

// The check of a function: the source of its inputs, its expected results and their accuracy.
struct Question {
    std::string name;  // for reports: an ID of the catalogue; empty: the function's name
    std::string file;
    std::string function;
    Signature signature;
    Domain domain;
    Reference reference;  // empty: the rules judge, and the module in double is the reference
                          // in double
    Budget budget;
    Codomain codomain;
    // Inputs for which the budget is promised; empty: all. For other inputs, for example after overflow, only
    // the codomain and the documented results for zero, infinity and NaN are judged.
    std::function<bool(std::span<const Word>)> promised;
    // Whether every input of the domain has a defined result. If not, an input for which the function reads
    // outside an array, for example, is not judged; otherwise it is a failure.
    bool defined = true;
    // Whether every bool of the result has to be true: a false one that the rules permit is a failure of the
    // function itself.
    bool must_hold = false;
    std::vector<ImageScenario> scenarios;  // empty: the function reads no image
    bool only_rules = false;               // it documents no accuracy: judged by the rules in every variant
};

namespace detail {

// Calls a reference, with the images as first argument if it takes them.
template <class Callable, class... Values>
decltype(auto) call(const Callable& callable, const ImageSet& images, Values&... values) {
    if constexpr (std::is_invocable_v<const Callable&, const ImageSet&, Values&...>) {
        return callable(images, values...);
    } else {
        return callable(values...);
    }
}

template <class Function>
struct ReferenceOf;

template <class R, class... P>
struct ReferenceOf<R(P...)> {
    // Appends the result, then every out and inout parameter.
    template <class Callable>
    static void run(const Callable& callable, const ImageSet& images, std::span<const Word> words,
                    std::vector<double>& outputs) {
        std::tuple<InDouble<typename ParameterOf<P>::value>...> arguments{};
        const auto with = [&](auto&... values) {
            ((is_input<P> ? void(values = take_words<std::remove_cvref_t<decltype(values)>>(words)) : void()),
             ...);
            if constexpr (std::is_void_v<R>) {
                call(callable, images, values...);
            } else {
                append_numbers(static_cast<InDouble<R>>(call(callable, images, values...)), outputs);
            }
            ((is_output<P> ? append_numbers(values, outputs) : void()), ...);
        };
        std::apply(with, arguments);
    }
};

}  // namespace detail

// Makes a reference from a callable with the types of the signature, with double in place of float: (double,
// glm::dvec3) for float(float, glm::vec3). Out and inout parameters are references. The images (const
// ImageSet&) can be the first argument.
template <class Function, class Callable>
[[nodiscard]] Reference make_reference(Callable callable) {
    return [callable](const ImageSet& images, std::span<const Word> words, std::vector<double>& outputs) {
        outputs.clear();
        detail::ReferenceOf<Function>::run(callable, images, words, outputs);
    };
}

// Makes a `promised` test from a predicate on typed inputs. It is called with the exact values of in and
// inout parameters.
template <class Function, class Predicate>
[[nodiscard]] std::function<bool(std::span<const Word>)> make_predicate(Predicate predicate) {
    return [predicate](std::span<const Word> words) {
        return std::apply(predicate, take_words<typename SignatureOf<Function>::Inputs>(words));
    };
}

// The given scenarios and three more of the largest scenario's size: all pixels 0; all pixels 1; and a
// mixture of pixels that are 0, 1, zeros and ones by component, or unchanged. A pixel of three numbers 1
// becomes a unit vector along an axis. If an image has infinite pixels, the mixture has more of them.
[[nodiscard]] std::vector<ImageScenario> with_exact_ends(std::vector<ImageScenario> scenarios);

}  // namespace gloam::check
