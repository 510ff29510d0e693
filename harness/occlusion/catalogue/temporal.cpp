// SPDX-License-Identifier: MIT
// The history: what it holds, when it is kept, how it grows.
#include <array>
#include <cmath>
#include <limits>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

// Numbers of samples: integers, which are usual, and any others.
Values weights() {
    const Values whole =
        made_by<float>([](numeric::Random& random) { return static_cast<float>(random.below(1600)); });
    return either(whole, log_uniform(1e-6, 1e8)).and_near({16777216.0}).and_special();
}

Values occlusions() {
    return either(uniform(0, 1).and_near({0.0, 1.0}), log_uniform(1e-30, 2)).and_special();
}

void append_accumulation(Entries& entries) {
    const Values convergence = either(uniform(0, 1.1), log_uniform(1e-30, 1)).and_special();
    const Values threshold = uniform(0, 1).and_near({0.2, 0.3, 0.5}).and_special();
    const auto usual = [](double, double weight, double, double k, double weight_max) {
        return moderate(1e-30, 1e36, weight, k, weight_max);
    };
    add(entries, "TSSAO-5", &reference::gloam_blend,
        Domain{occlusions(), weights(), occlusions(), weights(), weights()}.tied(4, 1).tied(2, 0),
        {.ulp = 0.5, .absolute = 1e-7}, {0, numeric::largest_float}, usual);
    add(entries, "TSSAO-5-weight", &reference::gloam_history_weight,
        Domain{occlusions(), weights(), weights()}.tied(2, 1), {}, {0, numeric::largest_float});
    add(entries, "TSSAO-6", &reference::gloam_convergence,
        Domain{weights(), weights().and_near({0x1p-126})}.tied(0, 1), {.ulp = 2.5}, {0, 1},
        [](double, double most) { return !(most > 0x1p126); });
    add(entries, "TSSAO-ROT", &reference::gloam_rotation_enabled, Domain{convergence, threshold}.tied(0, 1));
    add(entries, "TSSAO-AS", &reference::gloam_sample_count,
        Domain{convergence, threshold, integers(0, 64).and_near_integers({0, -2147483647L}),
               integers(0, 64).and_near_integers({0, 2147483646L})}
            .tied(0, 1));
}

Values buffer_weights() {
    return either(uniform(0, 1500), log_uniform(1e-30, 1e30)).and_special();
}

Values depths() {
    return log_uniform(1e-3, 1e6).and_near({0x1p-126, 0x1.fffffep127}).and_special();
}

// A function of a history that has nothing special except its domain: no error is allowed, and no result is
// below 0.
void add_exact(Entries& entries, const char* id, auto reference, Domain domain) {
    add(entries, id, reference, std::move(domain), {}, {0, numeric::infinity});
}

// Histories and texels, their members drawn independently; each special member beside ordinary ones.
Values histories() {
    return vector(
        {shares(), buffer_weights(), log_integers(4294967295).and_near_integers({16777216}), depths()});
}

Values texels() {
    const Values index =
        either(made_by<float>([](numeric::Random& random) { return static_cast<float>(random.below(2048)); }),
               uniform(0, 16777216))
            .and_near({1.0, 16777216.0})
            .and_special();
    return vector({shares(), buffer_weights(), index, depths()}).and_special();
}

void append_history(Entries& entries) {
    add_exact(entries, "TSSAO-BUF-empty", &reference::gloam_history_empty, {depths()});
    add(entries, "TSSAO-BUF-usable", &reference::gloam_history_usable, {shares(), buffer_weights()});
    add_exact(entries, "TSSAO-BUF-sanitize", &reference::gloam_history_sanitize, {histories()});
    add_exact(entries, "TSSAO-BUF-pack", &reference::gloam_history_pack, {histories()});
    add_exact(entries, "TSSAO-BUF-unpack", &reference::gloam_history_unpack, {texels()});
    const Values integer = log_integers(4294967295).and_near_integers({16777216, 4294967295});
    add_exact(entries, "TSSAO-BUF-index", &reference::gloam_next_index, {integer, integer, integer});
    const Values part = uniform(0, 1).and_near({0.0, 1.0});
    add(entries, "BILINEAR", &reference::gloam_bilinear_weights,
        {vector(2, either(part, log_uniform(1e-30, 1))).and_special()}, {.ulp = 2.5}, {0, 1});
    add(entries, "BILINEAR-valid", &reference::gloam_validated_weights,
        {vector(4, either(part, log_uniform(1e-37, 1))).and_special(), vector(4, booleans())}, {.ulp = 3},
        {0, 1});
}

void append_disocclusion(Entries& entries) {
    const Values depth = either(uniform(1, 4), log_uniform(1e-3, 1e6))
                             .and_near({0x1p-126, numeric::largest_float})
                             .and_special();
    const Values epsilon = either(uniform(0.005, 0.05), log_uniform(1e-6, 2)).and_special();
    add(entries, "TSSAO-8", &reference::gloam_depth_consistent,
        Domain{depth, depth, epsilon}
            .tied(1, 0)
            .tied(1, 0, 1.01)
            .tied(1, 0, 0.99)
            .tied(1, 0, 1.005)
            .tied(1, 0, 1.02),
        {.backward_ulp = 2}, {}, [](double stored, double expected, double epsilon) {
            // Beside a stored depth 2^24 times as large the expected one is lost in the difference, which is
            // then as large as a threshold of 1.
            const bool is_decided = expected > 1.2e-7 * stored || std::abs(epsilon - 1.0) > 2.4e-7;
            return is_decided && moderate(1e-30, 1e37, stored, expected) && moderate(1e-7, 1e37, epsilon);
        });
    const Values position = either(vector(3, uniform(-8, 8)), vector(3, uniform(-0.5, 0.5)))
                                .and_value(glm::vec3(0))
                                .and_special();
    const auto near = [](glm::dvec3 p) { return moderate(1e-30, 16, p); };
    add(entries, "TSSAO-9", &reference::gloam_neighborhood_change, {position, position, position, position},
        {.ulp = 4, .absolute = 6e-6}, {0, numeric::largest_float},
        [near](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
            return near(a) && near(b) && near(c) && near(d);
        });
    const Values change = either(log_uniform(1e-6, 1), uniform(0, 0.1)).and_special();
    add(entries, "TSSAO-9-test", &reference::gloam_neighborhood_unchanged, Domain{change, change}.tied(0, 1));
    add(entries, "TSSAO-9-probe", &reference::gloam_probe_useful, {position, normals()}, {.backward_ulp = 4},
        {}, [](glm::dvec3 offset, glm::dvec3 normal) { return moderate(1e-15, 1e15, offset, normal); });
    add(entries, "TSSAO-9-reach", &reference::gloam_probe_change,
        {position, position, normals(), uniform(0, 16)}, {.absolute = 2e-6, .backward_ulp = 4},
        {0, numeric::largest_float}, [](glm::dvec3 now, glm::dvec3 before, glm::dvec3 normal, double reach) {
            return moderate(1e-15, 16, now) && moderate(1e-15, 16, before) && moderate(1e-15, 1, normal) &&
                   moderate(1e-15, 16, reach);
        });
}

void append_invalidation(Entries& entries) {
    add(entries, "TSSAO-SI-a", &reference::gloam_invalidate_clamp,
        Domain{buffer_weights(), uniform(32, 64).and_special()}.tied(0, 1), {}, {0, numeric::infinity});
    add(entries, "TSSAO-SI-b", &reference::gloam_confidence,
        {either(uniform(0, 1), signed_log_uniform(1e-30, 1e30)).and_special(),
         either(uniform(15, 30), log_uniform(1e-6, 1e6)).and_special()},
        {.ulp = 3}, {0, 1});
    add(entries, "TSSAO-SI-b-weight", &reference::gloam_invalidate_confidence, {buffer_weights(), shares()},
        {.ulp = 0.5}, {0, numeric::largest_float});
    add(entries, "TSSAO-SI", &reference::gloam_invalidated_weight,
        Domain{uniform(0, 1500), uniform(0, 1), uniform(0.1, 2), integers(0, 3), log_uniform(1e-6, 1),
               uniform(32, 64), uniform(15, 30)}
            .tied(4, 1),
        {.ulp = 4, .backward_ulp = 1}, {0, 1500},
        [](double weight, double change, double radius, unsigned, double tolerance, double, double) {
            return weight > 1e-30 && change >= 0.0 && radius > 1e-3 && tolerance >= 0.0;
        });
}

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

void append_reprojection(Entries& entries) {
    add(entries, "TSSAO-RP-texel", &reference::gloam_texel_position,
        {uniform(0, 1).and_near({0.0, 1.0, 0.5}).and_special(), log_integers(4096).and_near_integers({0})},
        {.absolute = 1.25e-4}, {-1, 4096}, off_a_step);
    auto scenarios = image_scenarios(striped_history);
    scenarios.push_back({.name = "poisoned", .size = {7, 5}, .make = poisoned_history});
    add(
        entries, "TSSAO-RP-history",
        [](const ImageSet& images, glm::dvec2 uv, glm::ivec2 size, double expected_depth, double epsilon) {
            return reference::gloam_reprojected_history(uv, size, expected_depth, epsilon,
                                                        fetch_of<glm::dvec4>(images, history_name));
        },
        {previous_coordinates(), image_size(), expected_depths(),
         either(uniform(0, 0.05), constant(0.01F)).and_special()},
        {.ulp = 4, .absolute = 1.6e-5, .backward_ulp = 1}, {0, numeric::infinity}, nullptr, scenarios);
    const Values point = vector({uniform(-1.1, 1.1), uniform(-1.1, 1.1), expected_depths()});
    add(
        entries, "TSSAO-RP-point",
        [](const ImageSet& images, glm::dvec3 previous, const reference::GloamCamera& camera, unsigned taps,
           double epsilon) {
            return reference::gloam_reprojected_point(previous, camera, taps, epsilon,
                                                      fetch_of<glm::dvec4>(images, history_name));
        },
        Domain{point, cameras(), integers(0, 2), either(uniform(0, 0.05), constant(0.01F)).and_special()}
            .adjusted(place_before_camera(0, 3)),
        {.ulp = 4, .absolute = 1.6e-5, .backward_ulp = 4}, {0, numeric::infinity}, nullptr, scenarios);
}

}  // namespace

void append_temporal(Entries& entries) {
    append_accumulation(entries);
    append_history(entries);
    append_disocclusion(entries);
    append_invalidation(entries);
    append_reprojection(entries);
    add(entries, "CS-G", &reference::gloam_temporal_smooth, {shares(), booleans(), shares(), shares()},
        {.absolute = 2e-7}, {0, 1});
}

}  // namespace gloam::catalogue
