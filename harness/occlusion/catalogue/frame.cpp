// SPDX-License-Identifier: MIT
// The parts of the frame: a slice in the axes of the tangent plane, its two sides, levels of depth, packed
// texels, the history.
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "catalogue/inputs.hpp"
#include "reference/filter.hpp"
#include "reference/occlusion_slices.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

using Pair = reference::GloamSweepPair;

// (cos n, sin n) of a normal that faces the eye.
Values planes() {
    return made_by<glm::vec2>([](numeric::Random& random) {
               const double n = random.uniform(-1.4, 1.4);
               return glm::vec2(std::cos(n), std::sin(n));
           })
        .and_value(glm::vec2(1, 0))
        .only_as_drawn();
}

// Unit, away from the image plane.
Values views() {
    return made_by<glm::vec3>([](numeric::Random& random) {
               const double z = random.uniform(0.3, 1);
               const double turn = random.uniform(-std::numbers::pi, std::numbers::pi);
               const double r = std::sqrt(1.0 - z * z);
               return glm::vec3(r * std::cos(turn), r * std::sin(turn), z);
           })
        .and_value(glm::vec3(0, 0, 1))
        .only_as_drawn();
}

void append_axes(Entries& entries) {
    add(entries, "FRAME-axes", &reference::gloam_tangent_axes,
        {unit_vector(2).only_as_drawn(), views(), unit_vector(3).only_as_drawn()}, {.absolute = 3e-6}, {},
        [](glm::dvec2 d, glm::dvec3 v, glm::dvec3 n) {
            const double across = glm::dot(d, glm::dvec2(v));
            const double facing = glm::dot(n, v);
            const double beside = glm::dot(glm::dvec2(n), d) - across * facing;
            const bool units = std::abs(glm::length(d) - 1.0) <= 1e-6 && is_unit(v) && is_unit(n);
            return units && facing > 0.01 &&
                   facing * facing + beside * beside / (1.0 - across * across) > 0.1;
        });
    add(entries, "FRAME-whole", &reference::gloam_tangent_whole, {planes()}, {.absolute = 0.009},
        {0.98, 1.58});
    const Values values = vector(2, uniform(-2, 2)).only_as_drawn();
    add(entries, "FRAME-pair", &reference::gloam_tap_pair,
        {values, values, values, uniform(0.5, 50).only_as_drawn(),
         vector(2, uniform(0.5, 50)).only_as_drawn(), booleans()},
        {.absolute = 4e-5});
}

// Both sides within a march.
Values pairs() {
    return made_by<Pair>([](numeric::Random& random) {
               const auto two = [&](double low, double high) {
                   return glm::vec2(random.uniform(low, high), random.uniform(low, high));
               };
               const auto rise = [&] { return random.unit() < 0.5 ? 1e-10 : random.uniform(0.01, 1); };
               return Pair{two(0, 0.7),
                           two(0.5, 1),
                           two(0, 1),
                           two(0, 1),
                           glm::vec2(rise(), rise()),
                           two(0, 0.5),
                           two(-1, 1),
                           static_cast<float>(random.uniform(0, 0.5))};
           })
        .only_as_drawn();
}

void append_pairs(Entries& entries) {
    add(entries, "FRAME-start", &reference::gloam_sweep_pair, {}, {.ulp = 1}, {0, 1});
    const Values directions = made_by<glm::vec2>([](numeric::Random& random) {
                                  return glm::vec2(random.uniform(-0.588, 1), random.uniform(-0.588, 1));
                              }).only_as_drawn();
    add(entries, "FRAME-behind", &reference::gloam_pair_behind,
        Domain{directions, directions, planes()}.adjusted([](std::span<Word> row) {
            for (int i = 0; i < 2; ++i) {
                const auto cosine = std::bit_cast<float>(row[static_cast<std::size_t>(i)]);
                const float sine = std::sqrt(std::max(1.0F - cosine * cosine, 0.0F));
                row[static_cast<std::size_t>(i) + 2] = std::bit_cast<Word>(sine);
            }
        }),
        {.absolute = 0.005});
    const Values nearer = vector(2, uniform(-1, 1)).only_as_drawn();
    const Values thickness = uniform(0, 3).and_value(1e18F).only_as_drawn();
    const Values place = uniform(0.5, 1).only_as_drawn();
    add(entries, "FRAME-end", &reference::gloam_pair_end, {pairs(), nearer, place, thickness},
        {.absolute = 4e-7, .backward_ulp = 4});
    const Values taps = made_by<glm::vec4>([](numeric::Random& random) {
                            const auto one = [&] { return static_cast<float>(random.uniform(-1.2, 1.2)); };
                            return glm::vec4(one(), one(), one(), one());
                        }).only_as_drawn();
    add(entries, "FRAME-tap", &reference::gloam_pair_tap,
        {pairs(), taps, nearer, place, planes(), uniform(0, 0.01).only_as_drawn(), thickness},
        {.absolute = 2e-6, .backward_ulp = 4});
    add(entries, "FRAME-bent", &reference::gloam_bent_slice,
        {vector(2, uniform(0, 0.6).and_value(0.5F)).only_as_drawn(), planes()}, {.absolute = 4e-6},
        {-13, 13});
}

void append_levels(Entries& entries) {
    const auto pairs_of = [](glm::vec2 (*make)(numeric::Random& random)) {
        return made_by<glm::vec2>(make).only_as_drawn();
    };
    const Values numerators = pairs_of([](numeric::Random& random) {
        if (random.unit() < 0.4) return glm::vec2(random.uniform(0.01, 5), 0);
        return random.unit() < 0.5 ? glm::vec2(0, random.uniform(0.1, 10)) : glm::vec2(1.1, -1);
    });
    const Values divisors = pairs_of([](numeric::Random& random) {
        if (random.unit() < 0.5) return glm::vec2(1, 0);
        return glm::vec2(random.unit() < 0.5 ? random.uniform(-1.1, -1) : random.uniform(0, 0.1), 1);
    });
    Values stored = either(uniform(0, 1), log_uniform(1e-6, 1e6)).only_as_drawn();
    for (const double edge : {0.0, 1.0, -1.0, numeric::infinity, -numeric::infinity, std::nan("")})
        stored = stored.and_value(static_cast<float>(edge));
    const Values far =
        made_by<float>([](numeric::Random& random) { return random.unit() < 0.5 ? 0.0F : 1.0F; })
            .and_value(static_cast<float>(numeric::infinity))
            .only_as_drawn();
    add(entries, "FRAME-depth", &reference::gloam_level_depth, {stored, numerators, divisors, far},
        {.ulp = 3, .backward_ulp = 4}, {0, 65504},
        [](double b, glm::dvec2, glm::dvec2, double) { return b == 0.0 || !(std::abs(b) < 1e-30); });
    add(entries, "FRAME-level", &reference::gloam_depth_level, {log_uniform(1e-3, 16384).only_as_drawn()},
        {.absolute = 2e-6}, {-154, 124});
    const Values blocks = vector(2, either(integers(0, 64), integers(0, 10000))).only_as_drawn();
    add(entries, "FRAME-middle", &reference::gloam_is_level_middle, {blocks, integers(2, 6).only_as_drawn()});
}

bool off_a_half(double value) {
    return std::abs(value - std::floor(value) - 0.5) > 1e-4;
}

void append_texels(Entries& entries) {
    const Values halves = made_by<float>([](numeric::Random& random) {
                              const auto mantissa = static_cast<float>(1024 + random.below(1024));
                              return std::ldexp(mantissa, static_cast<int>(random.below(30)) - 24);
                          })
                              .and_value(65504.0F)
                              .only_as_drawn();
    add(entries, "FRAME-texel", &reference::gloam_frame_code,
        {halves, uniform(0, 1).and_value(1.0F).only_as_drawn(),
         uniform(0, 1.6).and_value(1.6F).only_as_drawn()},
        {}, {}, [](double, double occlusion, double weight) {
            return off_a_half(255.0 * occlusion) && off_a_half(127.0 * weight / 1.6);
        });
    add(entries, "FRAME-texel-of", &reference::gloam_frame_texel,
        Domain{either(log_integers(4294967295), integers(0, 4294967295))}.adjusted([](std::span<Word> row) {
            row[0] &= 0xFFFF7FFFU;  // the sign, then what is no number
            if ((row[0] & 0x7C00U) == 0x7C00U) row[0] ^= 0x4000U;
            if ((row[0] & 0x7C00U) == 0U) row[0] |= 0x400U;  // a subnormal one
        }),
        {}, {0, 65504});
    const Values near = uniform(0.9, 1.1).only_as_drawn();
    const Values scale = either(uniform(0, 60), log_uniform(1e-3, 1e4));
    add(entries, "FRAME-near", &reference::gloam_near_pair,
        {vector(2, near).only_as_drawn(), near, vector(2, scale).only_as_drawn(),
         uniform(0, 1).and_value(0.0F).only_as_drawn()},
        {.absolute = 2e-7}, {0, 1});
    // Of 36 texels with one of two values.
    const Values code = integers(0, 255).only_as_drawn();
    add(entries, "FRAME-mark", &reference::gloam_tile_deviation,
        Domain{code, code, integers(0, 36).only_as_drawn()}.adjusted([](std::span<Word> row) {
            const Word one = row[0];
            const Word other = row[1];
            const Word count = row[2];
            row[0] = count * one + (36 - count) * other;
            row[1] = count * one * one + (36 - count) * other * other;
            row[2] = 36;
        }),
        {.absolute = 3e-5}, {0, 127.5});
}

// What brings a pixel of an image of 100 x 100 to the frame before.
Values cameras_before() {
    return made_by<glm::mat4x3>([](numeric::Random& random) {
               const auto column = [&](int own, float size, float most) {
                   const auto part = [&] { return static_cast<float>(random.uniform(-most, most)); };
                   glm::vec3 made(part(), part(), part());
                   made[own] += size;
                   return made;
               };
               return glm::mat4x3(column(0, 0.01F, 1e-4F), column(1, 0.01F, 1e-4F), column(2, 1.0F, 0.1F),
                                  column(2, 0.5F, 0.1F));
           })
        .only_as_drawn();
}

}  // namespace

void append_frame(Entries& entries) {
    append_axes(entries);
    append_pairs(entries);
    append_levels(entries);
    append_texels(entries);
    const Values depth = uniform(0.5, 10).only_as_drawn();
    add(entries, "FRAME-before", &reference::gloam_frame_before,
        {vector(2, uniform(0, 100)).only_as_drawn(), depth, cameras_before(), booleans()},
        {.absolute = 5e-6});
    const Values near = uniform(0.9, 1.1).and_value(65504.0F).only_as_drawn();
    add(entries, "FRAME-moved", &reference::gloam_frame_moved,
        {near, vector(4, near).only_as_drawn(), uniform(1, 1e4).and_value(32752.0F).only_as_drawn(),
         uniform(0, 0.05).only_as_drawn()},
        {.backward_ulp = 4});
    const Values part = uniform(0, 1).and_near({0.0, 1.0}).only_as_drawn();
    const Values sums = made_by<glm::vec2>([](numeric::Random& random) {
                            const double weight = random.uniform(0.1, 1);
                            return glm::vec2(weight * random.unit(), weight);
                        }).only_as_drawn();
    add(entries, "FRAME-sharp", &reference::gloam_frame_sharp, {sums, sums, part}, {.absolute = 1.5e-6},
        {0, 1.00001});
    add(entries, "FRAME-blend", &reference::gloam_frame_blend, {part, part, part, part, part, part},
        {.absolute = 4e-7}, {-1e-6, 1.00001});
}

}  // namespace gloam::catalogue
