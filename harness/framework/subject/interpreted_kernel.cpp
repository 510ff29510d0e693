// SPDX-License-Identifier: MIT
#include "subject/interpreted_kernel.hpp"

#include <fmt/format.h>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gloam::check {

namespace {

// Of a sampler's image, sampled_header() counts them.
std::size_t words_in(const Image& image) {
    if (image.sampling) return image.words.size();
    return static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y) *
           scalars_of(image.element).size();
}

const Image& find_image(const ImageSet& images, const ImagePrototype& prototype, const std::string& kernel) {
    const auto found = images.find(prototype.name);
    if (found == images.end()) {
        throw std::invalid_argument(
            fmt::format("{}: no image serves the prototype {}", kernel, prototype.name));
    }
    const Image& image = found->second;
    if (!(image.element == prototype.element)) {
        throw std::invalid_argument(fmt::format("{}: the image of {} has {} pixels, the prototype {}", kernel,
                                                prototype.name, shader::to_glsl(image.element),
                                                shader::to_glsl(prototype.element)));
    }
    if (image.sampling.has_value() != prototype.sampled)
        throw std::invalid_argument(fmt::format("{}: the image of {} is {}for a sampler", kernel,
                                                prototype.name, image.sampling ? "" : "not "));
    if (image.size.x < 1 || image.size.y < 1 || image.words.size() != words_in(image)) {
        throw std::invalid_argument(
            fmt::format("{}: the image of {} is {} x {} with {} words, which disagree", kernel,
                        prototype.name, image.size.x, image.size.y, image.words.size()));
    }
    return image;
}

std::vector<Word> words_of(const Image& image, const ImagePrototype& prototype) {
    if (prototype.sampled) return sampled_words(image, prototype.sampler);
    std::vector<Word> words{static_cast<Word>(image.size.x), static_cast<Word>(image.size.y),
                            image.border == Border::clamp ? 1U : 0U};
    words.insert(words.end(), image.words.begin(), image.words.end());
    return words;
}

}  // namespace

std::vector<Word> sampled_words(const Image& image, std::string_view sampler) {
    const Image::Sampling sampling = image.sampling.value_or(Image::Sampling{});
    const backend::SampledHeader header{.width = static_cast<Word>(image.size.x),
                                        .height = static_cast<Word>(image.size.y),
                                        .depth = sampling.depth,
                                        .levels = sampling.levels,
                                        .shape = backend::shape_of_sampler(sampler),
                                        .texel = backend::texel_of_sampler(sampler),
                                        .linear = sampling.linear ? 1U : 0U,
                                        .wrap = sampling.wrap,
                                        .compare = sampling.compare};
    const auto first = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
    std::vector<Word> words(first.begin(), first.end());
    words.insert(words.end(), image.words.begin(), image.words.end());
    (void)backend::sampled_header(words);
    for (std::size_t i = 0; header.texel == backend::SampledTexel::depth && i < image.words.size(); i += 4)
        if (const auto depth = std::bit_cast<float>(image.words[i]); !(depth >= 0.0F && depth <= 1.0F))
            throw std::invalid_argument("an image of depths that are not all in [0, 1]");
    return words;
}

std::vector<std::vector<Word>> image_words(const KernelModule& kernel, const ImageSet& images) {
    std::vector<std::vector<Word>> all;
    for (const ImagePrototype& image : kernel.source->images)
        all.push_back(image.layered.empty() ? words_of(find_image(images, image, kernel.name), image)
                                            : std::vector<Word>{});
    return all;
}

}  // namespace gloam::check
