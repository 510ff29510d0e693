// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "backend/backend.hpp"
#include "backend/sampled.hpp"
#include "numeric/random.hpp"
#include "subject/signature.hpp"

namespace gloam::subject {

// The effect of an access outside the image: a fault of the shader, reported with its pixel; or a fetch reads
// the nearest pixel inside and a store is dropped.
enum class Border { fault, clamp };

// A small image behind a prototype such as `float gloam_fetch_depth(ivec2 pixel);`, or, for stores, `void
// gloam_store_depth(ivec2 pixel, float depth);`. Row 0 is the top row. At least 1 x 1.
struct Image {
    module::Type element;
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
            throw std::invalid_argument("image pixels are " + module::to_glsl(element) + ", asked for " +
                                        module::to_glsl(type_of<T>()));
        }
        pixel = glm::clamp(pixel, glm::ivec2(0), size - 1);
        const std::size_t scalars = module::scalar_count(element);
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

// The given scenarios and three more of the largest scenario's size: all pixels 0; all pixels 1; and a
// mixture of pixels that are 0, 1, zeros and ones by component, or unchanged. A pixel of three numbers 1
// becomes a unit vector along an axis. If an image has infinite pixels, the mixture has more of them.
[[nodiscard]] std::vector<ImageScenario> with_exact_ends(std::vector<ImageScenario> scenarios);

// A prototype T name(ivec2 pixel) or a sampler with a synthetic image behind it, or an image of the function
// itself.
struct ImagePrototype : backend::KernelImage {
    std::string name;
    module::Type element;
    std::string sampler = {};  // source::is_sampler_type() of what is sampled, which stands for no prototype
    // The kernel's variable for a parameter of that type. Empty: the file has one, whose binding is `macro`,
    // as that of an image that the function loads or stores: scratch memory that the kernel fills.
    std::string variable = {};
    std::string macro = {};

    [[nodiscard]] bool is_prototype() const { return !sampled && layered.empty(); }
};

// Random content for prototypes and samplers. Where there are samplers, they have different filters, edges
// and levels.
[[nodiscard]] std::vector<ImageScenario> random_scenarios(const std::vector<ImagePrototype>& images);

// An image for a sampler of this type ("usampler3D"), as backend/sampled.hpp has it. The image's pixels have
// four components, of which depths use the first. Throws std::invalid_argument where its size and its words
// disagree, for a cube without six square faces, and for depths outside [0, 1].
[[nodiscard]] std::vector<Word> sampled_words(const Image& image, std::string_view sampler);

}  // namespace gloam::subject
