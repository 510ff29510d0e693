// SPDX-License-Identifier: MIT
#include <string>

#include "cli/pack/effect.hpp"

namespace gloam::cli {
namespace {

constexpr const char* beginning =
    R"(/* The passes run over images of half the view's size; see divisor below. */
#define GLOAM_HALF_RESOLUTION

/* Constants of a view, with the names that they have as push constants. */
typedef struct gloam_view_constants {
    int32_t size[2], border[2];
    float p00_p11[2], previous_p00_p11[2];
    float previous_from_current[16];
} gloam_view_constants;

/* The constants of the half-size view. Its pixel p is pixel 2 p of the view. Its camera is in the middle of it, half a
 * pixel of the view away from there where a side is even: its view space is sheared or shifted by that. band is halved
 * as border is. */
static inline gloam_view_constants gloam_half_view(const gloam_view_constants* view) {
    gloam_view_constants half = *view;
    double change[16], shift[2], previous_shift[2];
    for (int i = 0; i < 16; ++i) change[i] = (double)view->previous_from_current[i];
    for (int axis = 0; axis < 2; ++axis) {
        const double size = (double)view->size[axis];
        const double even = view->size[axis] % 2 == 0 ? 1.0 : 0.0;
        shift[axis] = even / (size * (double)view->p00_p11[axis]);
        previous_shift[axis] = even / (size * (double)view->previous_p00_p11[axis]);
        half.size[axis] = (view->size[axis] + 1) / 2;
        half.border[axis] = view->border[axis] < 2 ? 0 : view->border[axis] / 2 - 1;
        const float scale = (float)(size / (2.0 * (double)half.size[axis]));
        half.p00_p11[axis] *= scale;
        half.previous_p00_p11[axis] *= scale;
    }
)";

constexpr const char* perspective = R"(    for (int axis = 0; axis < 2; ++axis)
        for (int row = 0; row < 4; ++row) change[8 + row] += shift[axis] * change[4 * axis + row];
    for (int axis = 0; axis < 2; ++axis)
        for (int column = 0; column < 4; ++column)
            change[4 * column + axis] -= previous_shift[axis] * change[4 * column + 2];
)";

constexpr const char* orthographic = R"(    for (int axis = 0; axis < 2; ++axis)
        for (int row = 0; row < 4; ++row) change[12 + row] -= shift[axis] * change[4 * axis + row];
    for (int axis = 0; axis < 2; ++axis) change[12 + axis] += previous_shift[axis];
)";

constexpr const char* ending =
    R"(    for (int i = 0; i < 16; ++i) half.previous_from_current[i] = (float)change[i];
    return half;
}

)";

}  // namespace

std::string half_view_text(const PackedEffect& effect) {
    if (effect.settings.resolution == effect::Resolution::full) return "";
    return std::string(beginning) + (effect.options.orthographic ? orthographic : perspective) + ending;
}

}  // namespace gloam::cli
