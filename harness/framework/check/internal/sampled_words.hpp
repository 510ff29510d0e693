// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <string_view>
#include <vector>

#include "backend/sampled.hpp"
#include "check/question.hpp"

namespace gloam::check::internal {

// An image for a sampler of this type ("usampler3D"), as backend/sampled.hpp has it. The image's pixels have
// four components. Throws std::invalid_argument where its size and its words disagree.
[[nodiscard]] inline std::vector<Word> sampled_words(const Image& image, std::string_view sampler) {
    using backend::SampledShape;
    using backend::SampledTexel;
    const Image::Sampling sampling = image.sampling.value_or(Image::Sampling{});
    const backend::SampledHeader header{.width = static_cast<Word>(image.size.x),
                                        .height = static_cast<Word>(image.size.y),
                                        .depth = sampling.depth,
                                        .levels = sampling.levels,
                                        .shape = sampler.ends_with("Array") ? SampledShape::layers
                                                 : sampler.ends_with("3D")  ? SampledShape::three
                                                                            : SampledShape::two,
                                        .texel = sampler.starts_with('i')   ? SampledTexel::integer
                                                 : sampler.starts_with('u') ? SampledTexel::natural
                                                                            : SampledTexel::real,
                                        .linear = sampling.linear ? 1U : 0U,
                                        .wrap = sampling.wrap};
    const auto first = std::bit_cast<std::array<Word, backend::sampled_header_words>>(header);
    std::vector<Word> words(first.begin(), first.end());
    words.insert(words.end(), image.words.begin(), image.words.end());
    (void)backend::sampled_header(words);
    return words;
}

}  // namespace gloam::check::internal
