// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/temporal_parts.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using History = reference::GloamHistory;

constexpr Origin origin{"gloam/temporal/history.glsl",
                        "TSSAO (Mattausch et al.), layout of the ambient-occlusion buffer"};

Values occlusions() {
    return uniform(0, 1).and_near({0.0, 1.0}).and_special();
}
Values weights() {
    return either(uniform(0, 1500), log_uniform(1e-30, 1e30)).and_special();
}
Values depths() {
    return log_uniform(1e-3, 1e6).and_near({0x1p-126, 0x1.fffffep127}).and_special();
}

// Histories and texels, their members drawn independently; each special member beside ordinary ones.
Values histories() {
    return vector(
        {occlusions(), weights(), log_integers(4294967295).and_near_integers({16777216}), depths()});
}
Values texels() {
    const Values index =
        either(made_by<float>([](numeric::Random& random) { return static_cast<float>(random.below(2048)); }),
               uniform(0, 16777216))
            .and_near({1.0, 16777216.0})
            .and_special();
    return vector({occlusions(), weights(), index, depths()}).and_special();
}

void append_buffer(Entries& entries) {
    append_exact<History(float)>(entries, origin,
                                 {.id = "TSSAO-BUF-empty",
                                  .function = "gloam_history_empty",
                                  .title = "history of a pixel that has none",
                                  .formula = "(0, 0, 0, d), d = infinity for background"},
                                 &reference::gloam_history_empty, {depths()});
    entries.push_back(equation<bool(float, float)>({.id = "TSSAO-BUF-usable",
                                                    .function = "gloam_history_usable",
                                                    .file = origin.file,
                                                    .title = "whether a history holds a mean",
                                                    .formula = "0 <= AO <= 1 and 0 < w < infinity",
                                                    .source = origin.source},
                                                   &reference::gloam_history_usable,
                                                   {.domain = {occlusions(), weights()}}));
    append_exact<History(History)>(
        entries, origin,
        {.id = "TSSAO-BUF-sanitize",
         .function = "gloam_history_sanitize",
         .title = "history made safe to use",
         .formula = "h if 0 <= AO <= 1, 0 < w < infinity and d is geometry, else empty"},
        &reference::gloam_history_sanitize, {histories()});
    append_exact<glm::vec4(History)>(entries, origin,
                                     {.id = "TSSAO-BUF-pack",
                                      .function = "gloam_history_pack",
                                      .title = "texel of the history buffer",
                                      .formula = "(AO, w, j, d)"},
                                     &reference::gloam_history_pack, {histories()});
    append_exact<History(glm::vec4)>(entries, origin,
                                     {.id = "TSSAO-BUF-unpack",
                                      .function = "gloam_history_unpack",
                                      .title = "history from a texel",
                                      .formula = "(AO, w, j, d)"},
                                     &reference::gloam_history_unpack, {texels()});
    const Values integer = log_integers(4294967295).and_near_integers({16777216, 4294967295});
    append_exact<unsigned(unsigned, unsigned, unsigned)>(
        entries, origin,
        {.id = "TSSAO-BUF-index",
         .function = "gloam_next_index",
         .title = "start index of the next frame",
         .formula = "(j + k) mod N"},
        [](unsigned index, unsigned k, unsigned size) { return reference::gloam_next_index(index, k, size); },
        {integer, integer, integer});
}

}  // namespace

void append_history(Entries& entries) {
    append_buffer(entries);
    constexpr const char* bilinear = "gloam/temporal/validated_bilinear.glsl";
    const Values part = uniform(0, 1).and_near({0.0, 1.0});
    entries.push_back(equation<glm::vec4(glm::vec2)>(
        {.id = "BILINEAR",
         .function = "gloam_bilinear_weights",
         .file = bilinear,
         .title = "weights of bilinear interpolation",
         .formula = "((1 - x)(1 - y), x (1 - y), (1 - x) y, x y)",
         .source = "definition"},
        &reference::gloam_bilinear_weights,
        {.domain = {vector(2, either(part, log_uniform(1e-30, 1))).and_special()},
         .budget = {.ulp = 2.5},
         .codomain = {0, 1}}));
    entries.push_back(equation<glm::vec4(glm::vec4, glm::bvec4)>(
        {.id = "BILINEAR-valid",
         .function = "gloam_validated_weights",
         .file = bilinear,
         .title = "bilinear weights of the valid texels only",
         .formula = "w_i / (sum of valid w)",
         .source = "TSSAO (Mattausch et al.), interpolation across depth edges"},
        &reference::gloam_validated_weights,
        {.domain = {vector(4, either(part, log_uniform(1e-37, 1))).and_special(), vector(4, booleans())},
         .budget = {.ulp = 3},
         .codomain = {0, 1}}));
}

}  // namespace gloam::catalogue
