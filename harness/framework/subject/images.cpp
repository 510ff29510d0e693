// SPDX-License-Identifier: MIT
#include "subject/images.hpp"

#include <algorithm>
#include <cmath>

namespace gloam::check {
namespace {

using numeric::Random;

constexpr std::size_t unit_vector_words = 3;

void set_zero(std::span<Word> pixel) {
    std::ranges::fill(pixel, to_word(0.0F));
}

void set_one(std::span<Word> pixel, std::size_t axis) {
    std::ranges::fill(pixel, to_word(pixel.size() == unit_vector_words ? 0.0F : 1.0F));
    pixel[axis] = to_word(1.0F);
}

bool has_infinite(const Image& image) {
    return std::ranges::any_of(image.words, [](Word word) { return std::isinf(from_word<float>(word)); });
}

void set_mixed(std::span<Word> pixel, Random& random, bool infinite) {
    switch (random.below(infinite ? 5 : 4)) {
        case 0:
            return set_zero(pixel);
        case 1:
            return set_one(pixel, random.below(pixel.size()));
        case 2:
            if (pixel.size() == unit_vector_words) return set_one(pixel, random.below(pixel.size()));
            for (Word& word : pixel) word = to_word(random.below(2) == 0 ? 0.0F : 1.0F);
            return;
        case 3:
            return;
        default:
            std::ranges::fill(pixel, to_word(std::numeric_limits<float>::infinity()));
    }
}

// A copy of the scenario, with every pixel of its float images changed.
template <class Change>
ImageScenario changed(const ImageScenario& scenario, const std::string& name, Change change) {
    const auto make = [made = scenario.make, change](glm::ivec2 size, Random& random) {
        ImageSet images = made(size, random);
        for (auto& [prototype, image] : images) {
            if (image.element.scalar != shader::Scalar::float_) continue;
            const bool infinite = has_infinite(image);
            const std::size_t words = scalars_of(image.element).size();
            for (std::size_t i = 0; i < image.words.size(); i += words) {
                change(std::span(image.words).subspan(i, words), random, infinite);
            }
        }
        return images;
    };
    return {.name = name, .size = scenario.size, .make = make};
}

}  // namespace

std::vector<ImageScenario> with_exact_ends(std::vector<ImageScenario> scenarios) {
    const auto pixels = [](const ImageScenario& scenario) { return scenario.size.x * scenario.size.y; };
    const auto largest = std::ranges::max_element(scenarios, {}, pixels);
    if (largest == scenarios.end() || !largest->make) return scenarios;
    const ImageScenario base = *largest;
    scenarios.push_back(changed(base, "all 0", [](auto pixel, Random&, bool) { set_zero(pixel); }));
    scenarios.push_back(
        changed(base, "all 1", [](auto pixel, Random&, bool) { set_one(pixel, pixel.size() - 1); }));
    scenarios.push_back(changed(base, "0 and 1", set_mixed));
    return scenarios;
}

}  // namespace gloam::check
