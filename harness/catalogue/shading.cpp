// SPDX-License-Identifier: MIT
#include "reference/shading.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

using namespace check;

void append_shading(Entries& entries) {
    const Values visibility = uniform(0, 1).and_near({0.0, 0.5, 1.0}).and_special();
    const Values offset = either(uniform(-0.5, 0.5), constant(0.0F)).and_near({0.5}).and_special();
    const Values brightness = uniform(0.5, 2).and_near({1.0}).and_special();
    const Values contrast = uniform(0.25, 8).and_near({0.0, 1.0, 2.0}).and_value(-1.0F).and_special();
    entries.push_back(equation<float(float, float, float, float)>(
        {.id = "CS-REMAP",
         .function = "gloam_remap",
         .file = "gloam/shading/remap.glsl",
         .title = "visibility remapped by offset, brightness and contrast",
         .formula = "clamp((b (v + a))^c, 0, 1)",
         .source = "Aalund and Baerentzen 2013"},
        &reference::gloam_remap,
        {.domain = {visibility, offset, brightness, contrast},
         .budget = {.absolute = 2e-6, .backward_ulp = 2},
         .codomain = {0, 1},
         .promised =
             make_predicate<float(float, float, float, float)>([](double ao, double a, double b, double c) {
                 return moderate(1e-18, 1e18, ao, a, b) && moderate(1e-3, 16, c);
             })}));
    append_shading_bent(entries);
    append_shading_directional(entries);
}

}  // namespace gloam::catalogue
