// SPDX-License-Identifier: MIT
#include "subject/images.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <ranges>

#include "subject/kernel_code.hpp"

namespace gloam::subject {
namespace {

using backend::SampledShape;
using backend::SampledTexel;
using module::Scalar;
using numeric::Random;

constexpr std::size_t unit_vector_words = 3;

void set_one(std::span<Word> pixel, std::size_t axis) {
    std::ranges::fill(pixel, to_word(pixel.size() == unit_vector_words ? 0.0F : 1.0F));
    pixel[axis] = to_word(1.0F);
}

void set_mixed(std::span<Word> pixel, Random& random, bool infinite) {
    const std::uint64_t lot = random.below(infinite ? 5 : 4);
    if (lot == 1 || (lot == 2 && pixel.size() == unit_vector_words))
        return set_one(pixel, random.below(pixel.size()));
    for (Word& word : pixel) {
        if (lot == 0) word = to_word(0.0F);
        if (lot == 2) word = to_word(random.below(2) == 0 ? 0.0F : 1.0F);
        if (lot == 4) word = to_word(std::numeric_limits<float>::infinity());
    }
}

// A copy of the scenario, with every pixel of its float images changed.
template <class Change>
ImageScenario changed(const ImageScenario& scenario, const std::string& name, Change change) {
    const auto make = [made = scenario.make, change](glm::ivec2 size, Random& random) {
        ImageSet images = made(size, random);
        for (auto& [prototype, image] : images) {
            if (image.element.scalar != Scalar::float_) continue;
            const bool infinite = std::ranges::any_of(
                image.words, [](Word word) { return std::isinf(from_word<float>(word)); });
            const std::size_t words = scalars_of(image.element).size();
            for (std::size_t i = 0; i < image.words.size(); i += words)
                change(std::span(image.words).subspan(i, words), random, infinite);
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
    scenarios.push_back(
        changed(base, "all 0", [](auto pixel, Random&, bool) { std::ranges::fill(pixel, to_word(0.0F)); }));
    scenarios.push_back(
        changed(base, "all 1", [](auto pixel, Random&, bool) { set_one(pixel, pixel.size() - 1); }));
    scenarios.push_back(changed(base, "0 and 1", set_mixed));
    return scenarios;
}

namespace {

// Pixels of a prototype: positive numbers of usual size. Accesses outside read the border.
Image random_image(const ImagePrototype& prototype, glm::ivec2 size, Random& random) {
    Image image{.element = prototype.element, .size = size, .border = Border::clamp, .words = {}};
    for (int pixel = 0; pixel < size.x * size.y; ++pixel) {
        for (const Scalar scalar : scalars_of(prototype.element)) {
            const double value = random.uniform(0.1, 10.0);
            image.words.push_back(module::is_float(scalar) ? float_word(scalar, value)
                                                           : static_cast<Word>(random.below(2)));
        }
    }
    return image;
}

backend::SampledHeader header_of(const Image& image, std::string_view sampler) {
    const Image::Sampling sampling = image.sampling.value_or(Image::Sampling{});
    return {.width = static_cast<Word>(image.size.x),
            .height = static_cast<Word>(image.size.y),
            .depth = sampling.depth,
            .levels = sampling.levels,
            .shape = backend::shape_of_sampler(sampler),
            .texel = backend::texel_of_sampler(sampler),
            .linear = sampling.linear ? 1U : 0U,
            .wrap = sampling.wrap,
            .compare = sampling.compare};
}

// Texels of a sampler. Floats are multiples of 1/64, which 16 bits represent.
Image random_texels(const ImagePrototype& prototype, glm::ivec2 size, Image::Sampling sampling,
                    Random& random) {
    constexpr unsigned layers = 3;
    const SampledShape shape = backend::shape_of_sampler(prototype.sampler);
    if (shape == SampledShape::three || shape == SampledShape::layers) sampling.depth = layers;
    if (backend::is_cube(shape)) {
        sampling.depth = backend::cube_faces * (shape == SampledShape::cube ? 1 : layers);
        size.y = size.x;
    }
    const bool floats = prototype.element.scalar == Scalar::float_;
    sampling.linear = sampling.linear && floats;
    Image image{.element = prototype.element, .size = size, .words = {}, .sampling = sampling};
    const backend::SampledHeader header = header_of(image, prototype.sampler);
    const bool is_depth = header.texel == SampledTexel::depth;
    const std::uint64_t values = is_depth ? 9 : 640;  // depths are eighths, 0 and 1 among them
    const float unit = is_depth ? 8.0F : 64.0F;
    for (std::size_t i = 0; i < backend::texels_before(header, header.levels) * backend::texel_words; ++i) {
        const auto value = static_cast<Word>(random.below(values));
        image.words.push_back(floats ? to_word(static_cast<float>(value) / unit) : value);
    }
    return image;
}

ImageScenario random_scenario(const std::vector<ImagePrototype>& images, const std::string& name,
                              glm::ivec2 size, const Image::Sampling& sampling) {
    const auto make = [images, sampling](glm::ivec2 pixels, Random& random) {
        ImageSet set;
        for (const ImagePrototype& image : images)
            set.emplace(image.name, image.sampled ? random_texels(image, pixels, sampling, random)
                                                  : random_image(image, pixels, random));
        return set;
    };
    return {.name = name, .size = size, .make = make};
}

}  // namespace

std::vector<ImageScenario> random_scenarios(const std::vector<ImagePrototype>& all) {
    std::vector<ImagePrototype> images;  // that have a content
    std::ranges::copy_if(all, std::back_inserter(images),
                         [](const auto& image) { return image.layered.empty(); });
    using backend::Compare;
    using backend::Wrap;
    if (images.empty()) return {};
    if (std::ranges::none_of(images, &ImagePrototype::sampled))
        return {random_scenario(images, "5 x 4, random", {5, 4}, {})};
    return {random_scenario(images, "5 x 4, random, linear, repeat", {5, 4}, {.linear = true}),
            random_scenario(images, "4 x 4, random, linear, edge, 3 levels", {4, 4},
                            {.linear = true, .wrap = Wrap::edge, .levels = 3, .compare = Compare::greater}),
            random_scenario(images, "5 x 4, random, nearest, mirrored, 2 levels", {5, 4},
                            {.wrap = Wrap::mirrored, .levels = 2, .compare = Compare::less})};
}

namespace {

const Image& find_image(const ImageSet& images, const ImagePrototype& prototype, const std::string& kernel) {
    const auto found = images.find(prototype.name);
    if (found == images.end()) {
        throw std::invalid_argument(fmt::format(
            "{}: no image serves the prototype {}; given: {}", kernel, prototype.name,
            images.empty() ? "none" : fmt::format("{}", fmt::join(std::views::keys(images), ", "))));
    }
    const Image& image = found->second;
    if (!(image.element == prototype.element)) {
        throw std::invalid_argument(fmt::format("{}: the image of {} has {} pixels, the prototype {}", kernel,
                                                prototype.name, module::to_glsl(image.element),
                                                module::to_glsl(prototype.element)));
    }
    if (image.sampling.has_value() != prototype.sampled)
        throw std::invalid_argument(fmt::format("{}: the image of {} is {}for a sampler", kernel,
                                                prototype.name, image.sampling ? "" : "not "));
    const std::size_t words = static_cast<std::size_t>(image.size.x) *
                              static_cast<std::size_t>(image.size.y) * scalars_of(image.element).size();
    // Those of a sampler's image sampled_header() counts.
    if (image.size.x < 1 || image.size.y < 1 || (!image.sampling && image.words.size() != words)) {
        throw std::invalid_argument(
            fmt::format("{}: the image of {} is {} x {} with {} words, which disagree", kernel,
                        prototype.name, image.size.x, image.size.y, image.words.size()));
    }
    return image;
}

}  // namespace

std::vector<Word> sampled_words(const Image& image, std::string_view sampler) {
    const backend::SampledHeader header = header_of(image, sampler);
    const auto first = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
    std::vector<Word> words(first.begin(), first.end());
    words.insert(words.end(), image.words.begin(), image.words.end());
    (void)backend::sampled_header(words);
    for (std::size_t i = 0; header.texel == SampledTexel::depth && i < image.words.size(); i += 4)
        if (const auto depth = std::bit_cast<float>(image.words[i]); !(depth >= 0.0F && depth <= 1.0F))
            throw std::invalid_argument("an image of depths that are not all in [0, 1]");
    return words;
}

std::vector<std::vector<Word>> image_words(const KernelModule& kernel, const ImageSet& images) {
    std::vector<std::vector<Word>> all;
    for (const ImagePrototype& prototype : kernel.source->images) {
        std::vector<Word>& words = all.emplace_back();
        if (!prototype.layered.empty()) continue;
        const Image& image = find_image(images, prototype, kernel.name);
        words = prototype.sampled
                    ? sampled_words(image, prototype.sampler)
                    : std::vector{static_cast<Word>(image.size.x), static_cast<Word>(image.size.y),
                                  image.border == Border::clamp ? 1U : 0U};
        if (!prototype.sampled) words.insert(words.end(), image.words.begin(), image.words.end());
    }
    return all;
}

}  // namespace gloam::subject
