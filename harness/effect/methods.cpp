// SPDX-License-Identifier: MIT
#include "effect/methods.hpp"

#include <stdexcept>

#include "effect/internal/named.hpp"

namespace gloam::effect {
namespace {

// An intensity that comes near the occlusion; the published values are presets.
void alchemy(Settings& s) {
    s.intensity = 0.4F;
    s.bias = 0.005F;
    s.epsilon = 3.2e-4F;
}

// The paper's lengths at its radius of 1 m, but for its intensity of 1, which is too dark for one radius.
void sao(Settings& s) {
    s.intensity = 0.3F;
    s.bias = 0.01F;
    s.epsilon = 0.1F;
    s.mip_distance = 16.0F;
}

// The paper's figure 3: radius 1.75, phi 0.4, psi 0.022, lambda 1.06, sigma 0.00016.
void issao(Settings& s) {
    s.intensity = 1.06F * 0.4F / 1.75F;
    s.bias = 0.022F / 1.75F;
    s.epsilon = 0.0126491F / 1.75F;
}

// The study's: 6 steps, a bias of 0.3 radians.
void hbao(Settings& s) {
    s.angle_bias = 0.3F;
    s.steps = 6;
}

void mixture(Settings& s) {
    s.angle_bias = 0.3F;
}

// The engine's: 0.8 of its unit, up to 3 steps on a side.
void unreal(Settings& s) {
    s.epsilon = 0.8F;
    s.steps = 3;
}

}  // namespace

const std::vector<MethodInfo>& methods() {
    using enum Measure;
    static const std::vector<MethodInfo> all{
        {"hemisphere", "occlusion by points in the half ball (TSSAO-3, TSSAO-14)", cosine, "linear", nullptr,
         OpenProof::points, false, "hemisphere_cosine"},
        {"disc", "how concave the surface is, by surface points under a disc (TSSAO-12, TSSAO-13)", shape,
         "none", nullptr, OpenProof::taps, false, "disc"},
        {"crytek", "points of a whole ball (Mittring 2007)", volume, "none",
         [](Settings& s) { s.remap_a = 0.5F, s.bias = 0.0F; }, OpenProof::none, false, "hemisphere_uniform"},
        {"filion", "points of the half ball, uniform (Filion and McNaughton 2008)", uniform, "linear",
         nullptr, OpenProof::points, false, "hemisphere_uniform"},
        {"alchemy", "surface points under a disc (McGuire et al. 2011)", cosine, "alchemy", alchemy,
         OpenProof::taps, false, "disc"},
        {"sao", "surface points on a spiral, far ones from a depth chain (McGuire et al. 2012)", cosine,
         "cubic", sao},
        {"sao_chain", "sao with its depth chain in an image: the same result (McGuire et al. 2012)", cosine,
         "cubic", sao},
        {"issao", "surface points under the covering circle, dense near the pixel (ISSAO)", cosine, "alchemy",
         issao},
        {"aksoy_phaneuf", "surface points under a disc by their distance (Aksoy and Phaneuf 2011)", shape,
         "linear", nullptr, OpenProof::none, false, "disc"},
        {"volumetric", "solid share of a ball, by paired lines (Loos and Sloan 2010)", volume, "none",
         [](Settings& s) { s.remap_a = 0.5F; }, OpenProof::none, false, "disc"},
        {"tangent_sphere", "solid share of the ball on the surface, by lines (Szirmay-Kalos et al. 2009)",
         volume, "none", nullptr, OpenProof::none, false, "disc"},
        {"angle", "angles between opposite samples, as in Unreal Engine 4 (Mittring 2012)", shape, "none",
         [](Settings& s) { s.angle_bias = 0.08F; }, OpenProof::none, false, "disc"},
        {"hbao",
         "horizons above the image plane, all directions alike (after Bavoil and Sainz 2008): steps dense "
         "nearby, what the bias takes off given back",
         uniform, "quadratic", hbao},
        {"hbao_study", "the same as the comparative study has it (Aalund and Baerentzen 2013)", uniform,
         "quadratic", hbao},
        {"gtao", "horizon slices, cosine-weighted, divided by their weights (Jimenez et al. 2016)", cosine,
         "linear"},
        {"dual_resolution",
         "hbao at half the resolution, in full where that disagrees (Bavoil and Sainz 2009)", uniform,
         "quadratic", hbao},
        {"separable",
         "slices in two directions, the first one's carried along the second (Huang et al. 2011)", cosine,
         "linear", [](Settings& s) { s.epsilon = 0.1F; }},
        {"mssao", "surface points under discs at several resolutions (Hoang and Low 2012)", cosine,
         "quadratic", [](Settings& s) { s.range = 0.25F, s.steps = 5; }},
        {"hsao", "the same horizons, marched in eye space (Dimitrov, Bavoil and Sainz 2008)", uniform,
         "quadratic", hbao},
        {"poisson", "rays of a lifted Poisson disc (Sourimant et al. 2011)", cosine, "none up to the radius"},
        {"ssdo", "what of light from everywhere does not arrive (Ritschel, Grosch and Seidel 2009)", cosine,
         "linear", [](Settings& s) { s.steps = 1; }},
        {"sphere_proxy", "pixels as balls (Shanmugam and Arikan 2007)", shape, "none up to the radius"},
        {"disc_proxy", "pixels as discs of their surface (Bunnell 2005)", cosine, "none up to the radius",
         nullptr, OpenProof::none, true},
        {"mixture", "pixels as balls above the biased tangent plane (Song 2010)", shape, "linear", mixture},
        {"unreal", "nearest steps to both sides, the later shader of Unreal Engine 4", shape, "1 / distance",
         unreal},
        {"curvature", "the quadric through the pixel's surroundings (after Hattori et al. 2012)", shape,
         "none up to the radius", nullptr, OpenProof::none, true},
        {"depth_darkening", "unsharp mask of the depth (Luft, Colditz and Deussen 2006)", shape, "none",
         nullptr, OpenProof::none, false, "disc"},
        {"aksoy_phaneuf_two", "aksoy_phaneuf at a fine and a broad radius", shape, "linear", nullptr,
         OpenProof::none, false, "disc"},
        {"bitmask", "slices of 32 sectors between front and back (Therrien et al. 2023)", cosine, "linear"},
    };
    return all;
}

const MethodInfo& method_named(std::string_view name) {
    return named(methods(), name, "method");
}

Settings with_method(Settings settings, std::string_view name) {
    const MethodInfo& info = method_named(name);
    settings.method = info.name;
    if (info.adapt != nullptr) info.adapt(settings);
    return settings;
}

std::string to_string(Measure measure) {
    switch (measure) {
        case Measure::cosine:
            return "cosine-weighted";
        case Measure::uniform:
            return "uniform";
        case Measure::volume:
            return "volume";
        case Measure::shape:
            return "shape";
    }
    throw std::invalid_argument("a measure without a name");
}

}  // namespace gloam::effect
