// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <iosfwd>
#include <string>
#include <vector>

#include "check/question.hpp"

namespace gloam::check {

// The largest permitted difference of two images. A component passes if its error is at most `ulp` or at most
// `absolute`; integers must be equal. With `similarity` the structural similarity (numeric/similarity.hpp) of
// each component as a whole, in [0, 1], is judged instead: 1 is equal, 0.99 hardly visible.
struct ImageBudget {
    double ulp = 0.0;
    double absolute = 0.0;
    double similarity = 0.0;  // the least one; 0: not asked
};

struct ImageComparison {
    std::size_t pixels = 0;
    std::size_t outside = 0;    // pixels with an error outside the budget
    std::size_t unwritten = 0;  // of these, pixels that the pass did not write
    glm::ivec2 worst{-1};       // the pixel with the largest error outside; -1: none
    std::string story;          // why it fails, in lines for people, the worst pixel first; empty: it passes
    std::vector<float> errors;  // absolute, the largest of each pixel; infinite where one is NaN alone

    [[nodiscard]] explicit operator bool() const { return story.empty(); }
};
std::ostream& operator<<(std::ostream& stream, const ImageComparison& comparison);

// The values of a pixel that are expected, one for each component.
using PixelReference = std::function<void(glm::ivec2 pixel, std::vector<double>& values)>;

// An image that a pass wrote. `at<T>(pixel)` reads it.
struct PassImage : Image {
    std::string name;             // "blur.comp: result"
    std::vector<bool> unwritten;  // by pixel; empty: all are written

    // Compares it with another image: the output of another pass, or a reference. Throws
    // std::invalid_argument for another size or type.
    [[nodiscard]] ImageComparison compare(const Image& reference, const ImageBudget& budget = {}) const;

    // Compares it with a closed form: a callable that takes the pixel, glm::ivec2, and returns its value, in
    // double as far as the image has floats: double, glm::dvec4.
    template <std::invocable<glm::ivec2> Form>
    [[nodiscard]] ImageComparison compare(const Form& form, const ImageBudget& budget = {}) const {
        using Value = std::remove_cvref_t<std::invoke_result_t<Form, glm::ivec2>>;
        require_element(type_of<Value>());
        return compare_each(
            [&form](glm::ivec2 pixel, std::vector<double>& values) {
                const Value value = form(pixel);
                visit_scalars(value,
                              [&](const auto& scalar) { values.push_back(static_cast<double>(scalar)); });
            },
            budget);
    }

    // The same with the reference's values one after another.
    [[nodiscard]] ImageComparison compare_each(const PixelReference& reference,
                                               const ImageBudget& budget) const;

  private:
    void require_element(const shader::Type& type) const;
};

// Compares an image with the golden one in a file, a PFM that keeps every bit: its components are grey
// images, one below the other. A file that is missing or malformed fails. On failure the image, and both as
// pictures, are written into `folder`: NAME.actual.pfm, NAME.actual.png, NAME.difference.png. With
// GLOAM_UPDATE_GOLDEN=1 in the environment, and never otherwise, a failure replaces the golden file and
// passes, unless the pass left pixels unwritten.
[[nodiscard]] ImageComparison is_golden(const PassImage& image, const std::filesystem::path& golden,
                                        const ImageBudget& budget = {},
                                        const std::filesystem::path& folder = ".");

}  // namespace gloam::check
