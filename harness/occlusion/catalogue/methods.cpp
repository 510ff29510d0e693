// SPDX-License-Identifier: MIT
// The methods: each a function of a shaded point in one of the views below.
#include <cmath>

#include <fmt/format.h>

#include "catalogue/inputs.hpp"
#include "reference/methods_levels.hpp"

namespace gloam::catalogue {
namespace {

using namespace judge;
using namespace subject;
using numeric::Random;

using Camera = reference::GloamCamera;
using Kernel = reference::GloamKernel;
using Estimate = reference::GloamEstimate;
using reference::ShadedPoint;

// Views in closed form, each of a size of its own, by which an input knows its view. `depth`: at a place in
// [-1, 1], y down as in the image.
struct View {
    const char* name;
    glm::ivec2 size;
    double (*depth)(glm::dvec2 at);
};

constexpr double none = std::numeric_limits<double>::infinity();

const View views[] = {
    {"plane", {17, 13}, [](glm::dvec2 at) { return 2.0 / (1.0 + 0.3 * at.x - 0.2 * at.y); }},
    {"step", {19, 13}, [](glm::dvec2 at) { return at.x + 0.3 * at.y < 0.15 ? 1.7 : 2.2; }},
    {"corner",
     {17, 15},
     [](glm::dvec2 at) {
         const double walls = std::max(0.3 + 0.4 * at.x, 0.28 - 0.3 * at.x);
         return 1.0 / std::max(walls, 0.35 + 0.35 * at.y);
     }},
    {"sphere before a plane",
     {21, 13},
     [](glm::dvec2 at) {
         const double squared = glm::dot(at - 0.1, at - 0.1) / 0.36;
         return squared < 1.0 ? 2.6 - 0.9 * std::sqrt(1.0 - squared) : 2.4 + 0.3 * at.y;
     }},
    {"thin bars",
     {23, 15},
     [](glm::dvec2 at) { return std::fmod(at.x + 1.0, 0.5) < 0.12 ? 1.5 : 2.0 - 0.2 * at.x; }},
    {"edges of the image and background",
     {21, 15},
     [](glm::dvec2 at) { return at.y < -0.3 ? none : 1.8 + 0.5 * at.x * at.y; }},
};

glm::dvec2 place_of(glm::ivec2 pixel, glm::ivec2 size) {
    return (2.0 * glm::dvec2(pixel) + 1.0) / glm::dvec2(size) - 1.0;
}

glm::dvec3 surface_at(const View& view, glm::dvec2 at, const Camera& camera) {
    const double depth = view.depth(at);
    const glm::dvec2 side = at / camera.p00_p11;
    return {camera.orthographic ? side : side * depth, -depth};
}

// Towards the eye, by the differences of the closed form.
glm::dvec3 normal_at(const View& view, glm::dvec2 at, const Camera& camera) {
    constexpr double step = 1e-4;
    const auto along = [&](glm::dvec2 axis) {
        return surface_at(view, at + step * axis, camera) - surface_at(view, at - step * axis, camera);
    };
    const glm::dvec3 normal = glm::cross(along({1, 0}), along({0, 1}));
    return glm::normalize(normal.z < 0.0 ? -normal : normal);
}

// Words of an input: the position comes first.
constexpr std::size_t normal_word = 3, camera_word = 6, orthographic_word = 10, bias_word = 12,
                      first_word = 14;

// Places half of the points on the surface under the middle of a pixel, with a normal of another length, half
// anywhere from `nearest` on: a position is drawn as (place, depth in [1, 4]); those nearer than 2.5 lie on
// the surface if there is a bias.
void place(std::span<Word> row, double nearest) {
    std::span<const Word> rest = row.subspan(camera_word);
    const auto camera = take_words<Camera>(rest);
    const auto view = std::ranges::find(views, camera.size, &View::size);
    const auto number = [&](std::size_t i) { return from_word<double>(row[i]); };
    const glm::dvec3 at(number(0), number(1), number(2));
    if (!(std::abs(at.x) <= 1.0 && std::abs(at.y) <= 1.0 && at.z >= 1.0 && at.z <= 4.0)) return;
    glm::dvec3 position(at.x, at.y, -std::lerp(4.0, nearest, (4.0 - at.z) / 3.0));
    position = {glm::dvec2(at) / camera.p00_p11 * (camera.orthographic ? 1.0 : -position.z), position.z};
    const bool on_surface = view != std::end(views) && at.z < 2.5 && number(bias_word) >= 1e-4;
    if (on_surface) {
        const glm::dvec2 middle =
            place_of(glm::ivec2((glm::dvec2(at) + 1.0) / 2.0 * glm::dvec2(view->size)), view->size);
        position = surface_at(*view, middle, camera);
        const glm::dvec3 facing = 2.0 * normal_at(*view, middle, camera);
        for (int i = 0; i < 3; ++i) row[normal_word + i] = to_word(facing[i]);
    }
    for (int i = 0; i < 3; ++i) row[i] = to_word(position[i]);
}
void place_in_view(std::span<Word> row) {
    place(row, 1.0);
}
// For methods whose points and rays may lie behind the eye.
void place_near(std::span<Word> row) {
    place(row, 0.3);
}

// The same, with normals that face the eye and the image plane: heights along the view vector, and slopes
// over the image plane, grow as one over these cosines.
void place_facing(std::span<Word> row) {
    place_in_view(row);
    glm::vec3 position, normal;
    for (int i = 0; i < 3; ++i) {
        position[i] = from_word<float>(row[i]);
        normal[i] = from_word<float>(row[normal_word + i]);
    }
    const glm::vec3 toward_eye =
        row[orthographic_word] != 0U ? glm::vec3(0, 0, 1) : -glm::normalize(position);
    for (const glm::vec3 view : {glm::vec3(0, 0, 1), toward_eye}) {
        const float length = glm::length(normal);
        const float lacking = 0.3F - glm::dot(view, normal) / length;
        if (lacking > 0.0F && lacking < 2.0F)
            normal = length * glm::normalize(normal / length + lacking * view);
    }
    for (int i = 0; i < 3; ++i) row[normal_word + i] = to_word(normal[i]);
    constexpr Word first_samples = 1000;  // later ones may lie so near the middle that rounding turns them
    row[first_word] %= first_samples;
}

// What preparation passes write: for each method another image, of random contents in their ranges.
using Prepared = glm::vec4 (*)(glm::ivec2 texel, glm::ivec2 size, Random& random);

ImageSet images_of(const View& view, Prepared prepared, Random& random) {
    const Camera camera{glm::dvec2(1.2, -1.6), view.size, false};
    const auto layer = [&](double first) {
        const double depth = first + random.uniform(0.0, 1.0);
        return static_cast<float>(std::array{0.0, -depth, depth, depth}.at(random.below(4)));
    };
    ImageSet images;
    images.emplace(depth_prototype, make_image<float>(view.size, [&](glm::ivec2 pixel) {
                       return static_cast<float>(view.depth(place_of(pixel, view.size)));
                   }));
    images.emplace("gloam_fetch_normal", make_image<glm::vec3>(view.size, [&](glm::ivec2 pixel) {
                       const glm::dvec2 at = place_of(pixel, view.size);
                       return std::isfinite(view.depth(at)) ? glm::vec3(2.0 * normal_at(view, at, camera))
                                                            : glm::vec3(0);
                   }));
    images.emplace("gloam_fetch_layers", make_image<glm::vec3>(view.size, [&](glm::ivec2 pixel) {
                       const double first = std::min(view.depth(place_of(pixel, view.size)), 4.0);
                       return glm::vec3(layer(first), layer(first), layer(first));
                   }));
    images.emplace("gloam_fetch_prepared", make_image<glm::vec4>(view.size + 16, [&](glm::ivec2 texel) {
                       return prepared(texel, view.size, random);
                   }));
    return images;
}

std::vector<ImageScenario> view_scenarios(Prepared prepared) {
    std::vector<ImageScenario> scenarios;
    for (const View& view : views)
        scenarios.push_back(
            {.name = view.name, .size = view.size, .make = [&view, prepared](glm::ivec2, Random& random) {
                 return images_of(view, prepared, random);
             }});
    return scenarios;
}

float part(Random& random, double most = 1.0) {
    return static_cast<float>(random.uniform(0.0, most));
}

// Results in [0, 1], then a normal.
glm::vec4 results(glm::ivec2, glm::ivec2, Random& random) {
    return {part(random), glm::vec3(part(random) - 0.5F, part(random) - 0.5F, 0.7F)};
}

glm::vec4 depths(glm::ivec2, glm::ivec2, Random& random) {
    return glm::vec4(random.below(8) == 0 ? 0.0F : 1.0F + part(random, 2.0));
}

// Which of three kinds of values a texel of the first level has (gloam/gather/pixels.glsl).
int kind_of(glm::ivec2 texel, glm::ivec2 size) {
    const glm::ivec2 first = (size + 1) / 2;
    return (texel.x >= first.x ? 1 : 0) + (texel.y >= first.y ? 2 : 0);
}

glm::vec3 surface_point(Random& random) {
    return {part(random, 3.0) - 1.5F, part(random, 2.0) - 1.0F, -1.0F - part(random, 2.0)};
}

// Positions, normals and results (largest, mean, levels).
glm::vec4 resolutions(glm::ivec2 texel, glm::ivec2 size, Random& random) {
    const int kind = kind_of(texel, size);
    if (kind == 0) return {surface_point(random), 0.0F};
    if (kind == 1) return {glm::normalize(glm::vec3(part(random) - 0.5F, part(random) - 0.5F, 0.5F)), 0.0F};
    return {part(random), part(random), part(random), 0.0F};
}

// Means with weights, variances, covariances.
glm::vec4 moments(glm::ivec2 texel, glm::ivec2 size, Random& random) {
    const int kind = kind_of(texel, size);
    if (kind == 0) return {surface_point(random), static_cast<float>(random.below(5))};
    if (kind == 1)
        return {0.02F + part(random, 0.1), 0.02F + part(random, 0.1), 0.02F + part(random, 0.1), 0.0F};
    return glm::vec4(part(random, 0.02) - 0.01F);
}

// Whether the accuracy is promised: the camera is one, no product overflows, the angle is known to a
// millionth of a turn, and the bias is above the rounding of the surface that the point lies on.
bool usual(const glm::vec3& position, const glm::vec3& normal, const Camera& camera, const Kernel& kernel) {
    const bool seen = moderate(0.01, 100, camera.p00_p11) && moderate(1e-9, 100, position) &&
                      !(-position.z < 0.05F * glm::length(position));
    return seen && !(kernel.radius < 0.1F * glm::length(position)) && kernel.radius < 100.0F &&
           moderate(1e-9, 1e9, normal, kernel.bias) && !(std::abs(kernel.angle) > 64.0F) &&
           !(kernel.bias < 1e-5 * std::max(-position.z, 1.0F));
}

// Slices of a surface seen edge-on are nearly parallel to its tangent plane.
bool seen_from_above(const glm::vec3& p, const glm::vec3& n, const Camera& camera, const Kernel& kernel) {
    const glm::vec3 view = camera.orthographic ? glm::vec3(0, 0, 1) : -glm::normalize(p);
    return usual(p, n, camera, kernel) && std::abs(glm::dot(glm::normalize(n), view)) > 0.2F;
}

Values points() {
    return vector({uniform(-1, 1), uniform(-1, 1), uniform(1, 4)}).and_special();
}

Values kernels() {
    return vector({log_uniform(0.3, 1.2).and_special(), log_uniform(1e-3, 0.1).and_special(),
                   uniform(0, 6.2831853).and_special(),
                   log_integers(16777216).and_near_integers({16777216, 4294967295}), integers(0, 8),
                   either(constant(1e18F), uniform(-0.5, 2)).and_special()});
}

Values lengths() {
    return log_uniform(0.05, 4);
}

constexpr double most_samples = 64;
using Promised = bool (*)(const glm::vec3&, const glm::vec3&, const Camera&, const Kernel&);

// What a person decides of a method beside its settings.
struct Stated {
    Budget budget;
    Promised promised = usual;
    Prepared prepared = results;
    void (*place)(std::span<Word> row) = place_in_view;
};

// A sample near the border of two pixels, or near the depth at which it is blocked, may fall to either side.
// Then its whole contribution differs, so budgets include inputs that are moved by a few ULP.
template <class... Own, class Method>
void add_gather(Entries& entries, const std::string& name, Method method, const Stated& stated,
                const std::vector<Values>& own) {
    std::vector<Values> all{points(), normals(), cameras(), kernels()};
    all.insert(all.end(), own.begin(), own.end());
    add(
        entries, "METHOD-" + name,
        [method](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const Camera& camera,
                 const Kernel& kernel, const Own&... settings) {
            const reference::MethodImages read{fetch_of<double>(images, depth_prototype),
                                               fetch_of<glm::dvec3>(images, "gloam_fetch_normal"),
                                               fetch_of<glm::dvec3>(images, "gloam_fetch_layers"),
                                               fetch_of<glm::dvec4>(images, "gloam_fetch_prepared")};
            const ShadedPoint at(read, position, normal, camera, kernel);
            return at.gathers ? method(at, settings...) : Estimate{};
        },
        Domain(all).adjusted(stated.place), stated.budget, {0, most_samples},
        [promised = stated.promised](const glm::vec3& p, const glm::vec3& n, const Camera& camera,
                                     const Kernel& kernel,
                                     const Own&...) { return promised(p, n, camera, kernel); },
        view_scenarios(stated.prepared));
    entries.back().known = known_results(name);
}
template <class Own>
void add_method(Entries& entries, const std::string& name, Estimate (*method)(const ShadedPoint&, const Own&),
                const std::vector<Values>& own, const Stated& stated) {
    add_gather<Own>(entries, name, method, stated, {vector(own).only_as_drawn()});
}
void add_method(Entries& entries, const std::string& name, Estimate (*method)(const ShadedPoint&),
                const Stated& stated) {
    add_gather<>(entries, name, method, stated, {});
}

// Budget of means of contributions, beside taps within rounding of a border.
Stated within(double absolute, Promised promised = usual, Prepared prepared = results) {
    return {{.absolute = absolute, .backward_ulp = 32}, promised, prepared};
}
Stated near_within(double absolute, Promised promised = usual) {
    return {{.absolute = absolute, .backward_ulp = 32}, promised, results, place_near};
}
Stated facing_within(double absolute, Prepared prepared = results) {
    return {{.absolute = absolute, .backward_ulp = 32}, seen_from_above, prepared, place_facing};
}

void append_points(Entries& e) {
    const Values layers = integers(1, 4);
    const Values steps = integers(0, 4);
    add_method(e, "hemisphere", reference::gloam_hemisphere, {lengths(), layers}, near_within(1e-7));
    add_method(e, "filion", reference::gloam_filion, near_within(2.4e-6, seen_from_above));
    add_method(e, "crytek", reference::gloam_crytek, near_within(1e-7));
    add_method(e, "poisson", reference::gloam_poisson, {lengths(), steps}, near_within(1e-7));
    add_method(e, "ssdo", reference::gloam_ssdo, {lengths(), steps, layers}, near_within(1.5e-6));
    add_method(e, "unreal", reference::gloam_unreal, {lengths(), uniform(0, 2), steps}, near_within(4e-6));
}

void append_discs(Entries& e) {
    const Values share = uniform(0, 1);
    const Values mip = either(constant(0.0F), log_uniform(1, 64));
    add_method(e, "disc", reference::gloam_disc, {lengths()}, within(1.8e-6));
    add_method(e, "alchemy", reference::gloam_alchemy, {lengths(), share}, within(4e-5));
    add_method(e, "sao", reference::gloam_sao, {lengths(), share, mip}, within(3e-6));
    add_method(e, "sao_chain", reference::gloam_sao_chain, {lengths(), share, mip},
               within(5e-6, usual, depths));
    add_method(e, "issao", reference::gloam_issao, {lengths(), share, booleans()}, within(7e-7));
    add_method(e, "issao_distinct", reference::gloam_issao_distinct, {lengths(), share, booleans()},
               within(1.2e-6));
    add_method(e, "issao_attenuated", reference::gloam_issao_attenuated, {lengths(), share}, within(1.8e-6));
    add_method(e, "issao_basic", reference::gloam_issao_basic, within(9e-7));
    add_method(e, "aksoy_phaneuf", reference::gloam_aksoy_phaneuf, within(7e-7));
    add_method(e, "aksoy_phaneuf_two", reference::gloam_aksoy_phaneuf_two, within(1.5e-6));
    add_method(e, "mssao", reference::gloam_mssao, {integers(0, 9)},
               {{.absolute = 8e-5, .backward_ulp = 256}, seen_from_above, resolutions, place_facing});
}

void append_pairs(Entries& e) {
    add_method(e, "volumetric", reference::gloam_volumetric, facing_within(2e-6));
    add_method(e, "volumetric_two", reference::gloam_volumetric_two, facing_within(4.5e-6));
    add_method(e, "volumetric_spiral", reference::gloam_volumetric_spiral, facing_within(1e-6));
    add_method(e, "volumetric_area", reference::gloam_volumetric_area, facing_within(6e-5, moments));
    add_method(e, "tangent_sphere", reference::gloam_tangent_sphere,
               {{.absolute = 4e-5, .backward_ulp = 256}, seen_from_above, results, place_facing});
    add_method(e, "angle", reference::gloam_angle, {lengths(), uniform(0, 0.5)}, facing_within(4e-4));
    add_method(e, "depth_darkening", reference::gloam_depth_darkening, {lengths(), uniform(0, 4)},
               facing_within(5e-6));
    add_method(e, "curvature", reference::gloam_curvature, {lengths()}, within(1e-2));
}

void append_slices(Entries& e) {
    const Values steps = integers(0, 4);
    const Values bias = uniform(0, 0.6);
    const Values contrast = uniform(0, 2);
    add_method(e, "hbao", reference::gloam_hbao, {bias, contrast, steps}, facing_within(4e-6));
    add_method(e, "hbao_study", reference::gloam_hbao_study, {bias, contrast, steps}, facing_within(2.8e-6));
    add_method(e, "hsao", reference::gloam_hsao, {bias, contrast, steps}, facing_within(7e-6));
    add_method(e, "dual_resolution", reference::gloam_dual_resolution,
               {bias, contrast, steps, uniform(0, 1), integers(1, 4)}, facing_within(5.5e-6));
    add_method(e, "gtao", reference::gloam_gtao, {steps}, within(6e-6, seen_from_above));
    add_method(e, "sweep", reference::gloam_sweep, {steps, uniform(0, 3).and_value(1e18F), integers(0, 3)},
               within(2.5e-6, seen_from_above));
    add_method(e, "bitmask", reference::gloam_bitmask, {lengths().and_value(0.0F).and_value(1e30F), steps},
               within(2.5e-6));
    add_method(e, "separable", reference::gloam_separable, {lengths()}, within(1.3e-6, seen_from_above));
}

void append_proxies(Entries& e) {
    const Values intensity = uniform(0, 1);
    add_method(e, "sphere_proxy", reference::gloam_sphere_proxy, {intensity}, within(3.5e-6));
    add_method(e, "mixture", reference::gloam_mixture, {uniform(0, 0.6), intensity}, within(2e-6));
    add_method(e, "disc_proxy", reference::gloam_disc_proxy, {intensity}, within(1.5e-4));
    add_method(e, "disc_proxy_two", reference::gloam_disc_proxy_two, {intensity}, within(1.5e-4));
}

}  // namespace

void append_methods(Entries& entries) {
    append_points(entries);
    append_discs(entries);
    append_pairs(entries);
    append_slices(entries);
    append_proxies(entries);
}

}  // namespace gloam::catalogue
