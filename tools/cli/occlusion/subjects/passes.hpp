// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/question.hpp"
#include "subject/images.hpp"

namespace gloam::cli {

// Judges an image that a pass wrote, pixel by pixel: the question's inputs are pixels. wanted: appends what
// one shall hold. promised: whether it is judged by the budget; none: each is.
[[nodiscard]] check::Answer judged(const check::Lab& lab, check::Question question, const check::Image& image,
                                   const std::string& scenario,
                                   const std::function<void(glm::ivec2, std::vector<double>&)>& wanted,
                                   const std::function<bool(glm::ivec2)>& promised = {});

// The study's passes ("PASS-reproject"), each run as it is on two frames of a moving camera, with several
// settings. Every pixel is judged by what the paper's equations give in double for the same images; where a
// decision of theirs lies within rounding, nothing is promised.
[[nodiscard]] std::vector<check::Question> study_passes();

}  // namespace gloam::cli
