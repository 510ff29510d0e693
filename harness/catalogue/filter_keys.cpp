// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/filter.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* sao = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)";
constexpr const char* mssao = "Hoang and Low 2012 (MSSAO)";
constexpr const char* key_file = "gloam/filter/depth_key.glsl";
constexpr const char* downsample_file = "gloam/filter/mssao_downsample.glsl";

void append_quad(Entries& entries) {
    entries.push_back(equation<float(float, float, float, int, float)>(
        {.id = "CS-Q-quad",
         .function = "gloam_quad_box",
         .file = "gloam/filter/quad_box.glsl",
         .title = "mean of the two pixels of a quad along one axis",
         .formula = "A - dA ((x & 1) - 1/2), if |dz| < edge",
         .source = sao},
        &reference::gloam_quad_box,
        {.domain = Domain{uniform(0, 1).and_special(), uniform(-1, 1).and_special(),
                          signed_log_uniform(1e-3, 1).and_special(), integers(0, 9),
                          log_uniform(0.01, 1).and_special()}
                       .tied(2, 4),
         .budget = {.absolute = 1e-7},
         .codomain = {0, 1}}));
}

void append_keys(Entries& entries) {
    const Values depth = either(uniform(0.5, 320), log_uniform(1e-37, 1e38)).and_special();
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-Q-key",
         .function = "gloam_depth_key",
         .file = key_file,
         .title = "depth as a key for a blur",
         .formula = "clamp(d / z_key, 0, 1)",
         .source = sao},
        &reference::gloam_depth_key,
        {.domain = Domain{depth, either(constant(300.0F), log_uniform(1e-37, 1e38)).and_special()}.tied(0, 1),
         .budget = {.ulp = 1.5},
         .codomain = {0, 1}}));
    entries.push_back(equation<glm::vec2(float)>(
        {.id = "CS-Q-pack",
         .function = "gloam_pack_key",
         .file = key_file,
         .title = "key as two bytes",
         .formula = "k = round(65535 key); (k >> 8, k & 255) / 255",
         .source = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance), made exact"},
        &reference::gloam_pack_key,
        {.domain = {uniform(0, 1).and_near({0.5}).and_special()},
         .budget = {.ulp = 1.5, .backward_ulp = 2},
         .codomain = {0, 1}}));
    const Values byte = made_by<float>(
        [](numeric::Random& random) { return static_cast<float>(random.below(256)) / 255.0F; });
    entries.push_back(equation<float(glm::vec2)>(
        {.id = "CS-Q-unpack",
         .function = "gloam_unpack_key",
         .file = key_file,
         .title = "key from its two bytes",
         .formula = "(256 high + low) / 65535",
         .source = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance), made exact"},
        &reference::gloam_unpack_key,
        {.domain = {either(vector(2, byte), vector(2, uniform(0, 1))).and_special()},
         .budget = {.ulp = 1.5, .backward_ulp = 2},
         .codomain = {0, 1}}));
}

void append_blur(Entries& entries) {
    entries.push_back(equation<float(int, float, float)>(
        {.id = "CS-Q-blur",
         .function = "gloam_sao_blur_weight",
         .file = "gloam/filter/sao_blur.glsl",
         .title = "weight of a tap of SAO's blur",
         .formula = "(0.3 + g_r) max(0, 1 - slope |dkey|)",
         .source = sao},
        &reference::gloam_sao_blur_weight,
        {.domain = {integers(-6, 6).and_near_integers({-2147483647, 2147483646}),
                    either(signed_log_uniform(1e-6, 1), any_float()).and_special(),
                    either(log_uniform(10, 10000), any_float()).and_special()},
         .budget = {.absolute = 2e-7},
         .codomain = {0, 0.445}}));
}

void append_downsample(Entries& entries) {
    const Values depth = either(uniform(1, 3), log_uniform(1e-37, 1e38)).and_special();
    const Values near_ones = made_by<glm::vec4>([](numeric::Random& random) {
        glm::vec4 depths(0);
        for (int i = 0; i < 4; ++i) depths[i] = 2.0F + 0.125F * static_cast<float>(random.below(5));
        return depths;
    });
    entries.push_back(equation<int(glm::vec4, int)>(
        {.id = "CS-F-rank",
         .function = "gloam_depth_rank",
         .file = downsample_file,
         .title = "place of one of four depths in their order",
         .formula = "how many are smaller, or equal and before it",
         .source = "definition"},
        &reference::gloam_depth_rank, {.domain = {either(vector(4, depth), near_ones), integers(-1, 4)}}));
    entries.push_back(equation<glm::vec4(glm::vec4, float)>(
        {.id = "CS-F-weights",
         .function = "gloam_mssao_weights",
         .file = downsample_file,
         .title = "weights of four pixels in the one that stands for them",
         .formula = "z_4 - z_1 <= tolerance: (0, 1/2, 1/2, 0), else (0, 1, 0, 0), by depth",
         .source = mssao},
        &reference::gloam_mssao_weights,
        {.domain = {either(vector(4, depth), near_ones),
                    either(uniform(0, 1), constant(0.25F)).and_special()},
         .budget = {.backward_ulp = 1},
         .codomain = {0, 1}}));
    using Normals = glm::vec3(glm::vec3, glm::vec3);
    entries.push_back(
        equation<Normals>({.id = "CS-F-normal",
                           .function = "gloam_mssao_normal",
                           .file = downsample_file,
                           .title = "normal of the pixel that stands for two",
                           .formula = "(n_2 + n_3) / |n_2 + n_3|, n_2 if opposite",
                           .source = mssao},
                          &reference::gloam_mssao_normal,
                          {.domain = {unit_vector(3).and_special(), unit_vector(3).and_special()},
                           .budget = {.absolute = 4e-7},
                           .codomain = {-1.000001, 1.000001},
                           .promised = make_predicate<Normals>([](glm::dvec3 a, glm::dvec3 b) {
                               return moderate(0.0, 1e18, a, b) && glm::length(a + b) >= 0.25;
                           })}));
}

void append_upsample(Entries& entries) {
    using Signature = float(float, float, float, float, float);
    const Values power = either(uniform(0.25, 10), constant(1.0F)).and_near({0.0}).and_special();
    entries.push_back(equation<Signature>(
        {.id = "CS-F-upsample",
         .function = "gloam_mssao_upsample_weight",
         .file = "gloam/filter/mssao_upsample.glsl",
         .title = "weight of a pixel of the coarser level",
         .formula = "bilinear (1 / (1 + |dz|))^a ((n . n' + 1) / 2)^b",
         .source = mssao},
        &reference::gloam_mssao_upsample_weight,
        {.domain = {uniform(0, 1).and_special(),
                    either(signed_log_uniform(1e-3, 10), any_float()).and_special(),
                    uniform(-1, 1).and_near({-1.0, 1.0}).and_special(), power, power},
         .budget = {.absolute = 3e-6},
         .codomain = {0, 1},
         .promised = make_predicate<Signature>([](double, double dz, double cosine, double a, double b) {
             return moderate(0.0, 1e18, dz) && moderate(0.0, 1e9, cosine) && moderate(0.25, 16, a, b) &&
                    a < 1e9 && b < 1e9;
         })}));
}

constexpr const char* occlusion_name = "gloam_fetch_occlusion";

// Noise of a small range, with a few invalid values.
ImageSet occlusion_image(glm::ivec2 size, numeric::Random& random) {
    const auto value = [&](glm::ivec2) {
        if (random.below(64) == 0) return random.below(2) == 0 ? NAN : 1.5F;
        return static_cast<float>(random.uniform(0.2, 0.4));
    };
    return {{occlusion_name, make_image<float>(size, value)}};
}

void append_dual(Entries& entries) {
    entries.push_back(equation<bool(glm::ivec2, glm::ivec2, float)>(
        {.id = "CS-E-dual",
         .function = "gloam_dual_resolution_disagrees",
         .file = "gloam/filter/dual_resolution.glsl",
         .title = "where occlusion of half the resolution does not do",
         .formula = "max - min > tolerance over 3 x 3",
         .source = "derived, after Bavoil and Sainz 2009"},
        [](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 size, double tolerance) {
            const auto fetch = [&images](glm::ivec2 at) { return images.at(occlusion_name).at<double>(at); };
            return reference::gloam_dual_resolution_disagrees(pixel, size, tolerance, fetch);
        },
        {.domain = {image_pixel(), image_size().only_as_drawn(), uniform(0, 0.3).and_special()},
         .budget = {.backward_ulp = 1},
         .scenarios = image_scenarios(occlusion_image)}));
}

}  // namespace

void append_filter_keys(Entries& entries) {
    append_dual(entries);
    append_quad(entries);
    append_keys(entries);
    append_blur(entries);
    append_downsample(entries);
    append_upsample(entries);
}

}  // namespace gloam::catalogue
