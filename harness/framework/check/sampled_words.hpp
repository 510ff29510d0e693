// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <string_view>
#include <vector>

#include "backend/sampled.hpp"
#include "check/question.hpp"

namespace gloam::check {

// An image for a sampler of this type ("usampler3D"), as backend/sampled.hpp has it. The image's pixels have
// four components, of which depths use the first. Throws std::invalid_argument where its size and its words
// disagree, for a cube without six square faces, and for depths outside [0, 1].
[[nodiscard]] inline std::vector<Word> sampled_words(const Image& image, std::string_view sampler) {
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

}  // namespace gloam::check
