// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "base/files.hpp"
#include "base/image_files.hpp"
#include "check/image_comparison.hpp"

namespace gloam::check {
namespace {

namespace fs = std::filesystem;

bool updates() {
    const char* const value = std::getenv("GLOAM_UPDATE_GOLDEN");
    return value != nullptr && std::string_view(value) == "1";
}

std::size_t components_of(const Image& image) {
    return scalars_of(image.element).size();
}

// The components are grey images, one below the other. The floats have their bits, whatever these are.
base::FloatImage as_file(const Image& image) {
    const std::size_t components = components_of(image);
    base::FloatImage file{
        .width = static_cast<std::uint32_t>(image.size.x),
        .height = static_cast<std::uint32_t>(image.size.y) * static_cast<std::uint32_t>(components),
        .channels = 1,
        .texels = {}};
    for (std::size_t plane = 0; plane < components; ++plane)
        for (std::size_t i = plane; i < image.words.size(); i += components)
            file.texels.push_back(std::bit_cast<float>(image.words[i]));
    return file;
}

// The image of a file that as_file() made for an image of this kind.
Image from_file(const base::FloatImage& file, const Image& like) {
    Image image = like;
    const std::size_t components = components_of(like);
    const std::size_t pixels = like.words.size() / components;
    for (std::size_t i = 0; i < image.words.size(); ++i)
        image.words[i] = std::bit_cast<Word>(file.texels[i % components * pixels + i / components]);
    return image;
}

// One component as grey, two as red and green, the first three as sRGB.
std::string picture_of(const Image& image) {
    const std::size_t components = components_of(image);
    const bool is_float = image.element.scalar == shader::Scalar::float_;
    std::vector<float> linear;
    for (std::size_t first = 0; first < image.words.size(); first += components)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t from = components == 1 ? 0 : c;
            const Word word = from < components ? image.words[first + from] : 0U;
            linear.push_back(is_float ? std::bit_cast<float>(word) : static_cast<float>(word) / 255.0F);
        }
    return base::to_rgb_png(base::srgb_of(linear), static_cast<std::uint32_t>(image.size.x),
                            static_cast<std::uint32_t>(image.size.y));
}

std::string pfm_of(const Image& image) {
    const base::FloatImage file = as_file(image);
    return base::to_pfm(file.texels, file.width, file.height, file.channels);
}

// Compares with the file. Throws std::runtime_error where it cannot be read.
ImageComparison compared(const PassImage& image, const fs::path& golden, const ImageBudget& budget) {
    const base::FloatImage file = base::read_pfm(golden);
    const base::FloatImage expected = as_file(image);
    if (file.width != expected.width || file.height != expected.height ||
        file.channels != expected.channels) {
        ImageComparison other{.pixels = image.words.size() / components_of(image)};
        other.story =
            fmt::format("{}: the golden image {} is {} x {} with {} channels, expected {} x {} with {}\n",
                        image.name, golden.string(), file.width, file.height, file.channels, expected.width,
                        expected.height, expected.channels);
        return other;
    }
    ImageComparison comparison = image.compare(from_file(file, image), budget);
    if (!comparison) comparison.story = "golden image " + golden.string() + "\n" + comparison.story;
    return comparison;
}

// What a person looks at.
void write_pictures(const PassImage& image, const ImageComparison& comparison, const fs::path& stem) {
    base::write_file(stem.string() + ".actual.pfm", pfm_of(image));
    base::write_file(stem.string() + ".actual.png", picture_of(image));
    if (comparison.errors.empty()) return;
    float largest = 0.0F;
    for (const float error : comparison.errors)
        if (std::isfinite(error)) largest = std::max(largest, error);
    base::write_file(
        stem.string() + ".difference.png",
        base::to_heat_png(comparison.errors, static_cast<std::uint32_t>(image.size.x),
                          static_cast<std::uint32_t>(image.size.y), largest > 0.0F ? double{largest} : 1.0));
}

}  // namespace

ImageComparison is_golden(const PassImage& image, const fs::path& golden, const ImageBudget& budget,
                          const fs::path& folder) {
    ImageComparison comparison{.pixels = image.words.size() / components_of(image)};
    try {
        comparison = compared(image, golden, budget);
    } catch (const std::runtime_error& error) {
        comparison.story = image.name + ": the golden image cannot be compared: " + error.what() + "\n";
    }
    if (comparison) return comparison;
    if (updates() && image.unwritten.empty()) {
        base::write_file(golden, pfm_of(image));
        return {.pixels = comparison.pixels};
    }
    const fs::path stem = folder / golden.stem();
    write_pictures(image, comparison, stem);
    comparison.story += fmt::format(
        "  see {0}.actual.png{1}; GLOAM_UPDATE_GOLDEN=1 replaces the golden image\n", stem.string(),
        comparison.errors.empty() ? "" : " and " + stem.string() + ".difference.png");
    return comparison;
}

}  // namespace gloam::check
