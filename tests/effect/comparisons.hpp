// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"

// Images and frames beside others.
namespace gloam::effect {

// For comparisons in which NaN is itself and -0 is not 0.
inline std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
}

// Whether two images have the same bits; otherwise the first pixel that differs, of rows of that many.
inline testing::AssertionResult same_bits(const std::vector<float>& left, const std::vector<float>& right,
                                          std::size_t width) {
    if (left.size() != right.size())
        return testing::AssertionFailure() << left.size() << " and " << right.size() << " pixels";
    for (std::size_t i = 0; i < left.size(); ++i)
        if (std::bit_cast<std::uint32_t>(left[i]) != std::bit_cast<std::uint32_t>(right[i]))
            return testing::AssertionFailure()
                   << "pixel " << i % width << ", " << i / width << ": " << left[i] << " and " << right[i];
    return testing::AssertionSuccess();
}

using FrameImage = std::vector<float> Frame::*;

inline const std::vector<std::pair<FrameImage, std::string>> images_of_frame{
    {&Frame::occlusion, "occlusion"},
    {&Frame::filtered, "filtered"},
    {&Frame::convergence, "convergence"},
    {&Frame::kept, "kept"}};

// Fails unless images of two frames have the same bits: all of them, or those that are named.
inline void expect_same_images(const Frame& left, const Frame& right,
                               std::initializer_list<FrameImage> images = {}, const std::string& what = "") {
    for (const auto& [image, name] : images_of_frame) {
        if (images.size() > 0 && std::ranges::find(images, image) == images.end()) continue;
        EXPECT_TRUE(same_bits(left.*image, right.*image, left.extent.width)) << name << ' ' << what;
    }
}

// Fails unless the images of each frame of two sequences have the same bits.
inline void expect_same_images(const std::vector<Frame>& left, const std::vector<Frame>& right,
                               std::initializer_list<FrameImage> images = {}) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        expect_same_images(left[i], right[i], images, "of frame " + std::to_string(i));
}

inline double mean_of(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

inline double largest_difference(const std::vector<float>& left, const std::vector<float>& right) {
    double largest = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i)
        largest = std::max(largest, std::abs(double{left[i]} - double{right[i]}));
    return largest;
}

}  // namespace gloam::effect
