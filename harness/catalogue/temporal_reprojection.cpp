// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include "catalogue/inputs.hpp"
#include "catalogue/scenarios.hpp"
#include "catalogue/temporal_parts.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using History = reference::GloamHistory;

constexpr const char* file = "gloam/temporal/reprojected_history.glsl";
constexpr const char* history_name = "gloam_fetch_history";
constexpr double near_depth = 2.0;
constexpr double far_depth = 3.0;

// Two surfaces in stripes; each texel has a history of its own, a few have none. Weights have the magnitude
// of occlusions, so that one budget fits both.
ImageSet striped_history(glm::ivec2 size, numeric::Random& random) {
    const auto texel = [&](glm::ivec2 pixel) {
        const double depth = (pixel.x + 2 * pixel.y) % 5 < 3 ? near_depth : far_depth;
        const bool none = random.below(8) == 0;
        return glm::vec4(random.unit(), none ? 0.0 : random.uniform(0.01, 1), random.below(2048),
                         depth * random.uniform(0.995, 1.005));
    };
    return {{history_name, make_image<glm::vec4>(size, texel)}};
}

// Invalid histories: NaN, infinity and negative numbers in every channel.
ImageSet poisoned_history(glm::ivec2 size, numeric::Random& random) {
    ImageSet images = striped_history(size, random);
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const std::array poison{std::nanf(""), infinite, -infinite, -1.0F,
                            std::numeric_limits<float>::denorm_min()};
    for (Word& word : images[history_name].words) {
        if (random.below(3) == 0) word = to_word(poison[random.below(poison.size())]);
    }
    return images;
}

Values previous_coordinates() {
    const Values coordinate =
        either(uniform(0, 1), uniform(-0.1, 1.1)).and_near({0.0, 1.0, 0.5}).and_special();
    return vector(2, coordinate);
}

Values expected_depths() {
    const Values near_surface = uniform(near_depth * 0.95, near_depth * 1.05);
    const Values far_surface = uniform(far_depth * 0.95, far_depth * 1.05);
    return either(near_surface, far_surface).and_special();
}

// A fraction within 1/256, the documented error, of 0 or 1 may or may not be moved to the centre.
bool off_a_step(double u, int extent) {
    const double position = u * extent - 0.5;
    const double fraction = position - std::floor(position);
    return std::abs(fraction - 1.0 / 256.0) > 1.25e-4 && std::abs(fraction - 255.0 / 256.0) > 1.25e-4;
}

}  // namespace

void append_reprojection(Entries& entries) {
    entries.push_back(equation<glm::vec2(float, int)>(
        {.id = "TSSAO-RP-texel",
         .function = "gloam_texel_position",
         .file = "gloam/geometry/texel_position.glsl",
         .title = "texture coordinate among the texel centres of an axis",
         .formula = "i + f = u n - 1/2, f in [0, 1), 0 within 1/256 of a centre",
         .source = "definition of texture coordinates"},
        &reference::gloam_texel_position,
        {.domain = {uniform(0, 1).and_near({0.0, 1.0, 0.5}).and_special(),
                    log_integers(4096).and_near_integers({0})},
         .budget = {.absolute = 1.25e-4},
         .codomain = {-1, 4096},
         .promised = make_predicate<glm::vec2(float, int)>(off_a_step)}));
    auto scenarios = image_scenarios(striped_history);
    scenarios.push_back({.name = "poisoned", .size = {7, 5}, .make = poisoned_history});
    entries.push_back(equation<History(glm::vec2, glm::ivec2, float, float)>(
        {.id = "TSSAO-RP-history",
         .function = "gloam_reprojected_history",
         .file = file,
         .title = "history of a point, from the texels of the same surface around where it was",
         .formula = "mean of (AO, w) over the four texels with |d - d'| < epsilon d, by bilinear weights; j "
                    "of the heaviest",
         .source = "TSSAO (Mattausch et al.), eqs 7 and 8; validated bilinear taps"},
        [](const ImageSet& images, glm::dvec2 uv, glm::ivec2 size, double expected_depth, double epsilon) {
            const auto fetch = [&images](glm::ivec2 pixel) {
                return images.at(history_name).at<glm::dvec4>(pixel);
            };
            return reference::gloam_reprojected_history(uv, size, expected_depth, epsilon, fetch);
        },
        {.domain = {previous_coordinates(), image_size(), expected_depths(),
                    either(uniform(0, 0.05), constant(0.01F)).and_special()},
         .budget = {.ulp = 4, .absolute = 1.6e-5, .backward_ulp = 1},
         .codomain = {0, std::numeric_limits<double>::infinity()},
         .scenarios = scenarios}));
}

}  // namespace gloam::catalogue
