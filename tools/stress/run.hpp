// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "effect/methods.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "subject/lab.hpp"

namespace gloam::catalogue {
struct Entry;
}

namespace gloam::stress {

// One measured number of a stress run, and the largest value that the documentation allows it.
struct Row {
    std::string run;                // the run that measured it, "long-run"
    std::string varied;             // what was varied: "k 32, w_max 500"
    std::string quantity;           // what was measured, with its unit: "farthest from the exact mean"
    double measured = 0.0;          // NaN only where the quantity does not exist
    std::optional<double> bound{};  // nothing: measured for the documentation only, promised nowhere

    // Written so that NaN breaks a bound.
    [[nodiscard]] bool passed() const { return !bound || measured <= *bound; }
};

// How much the runs try.
struct Scope {
    bool brief = false;  // seconds, for tests; otherwise it takes minutes
    std::uint64_t seed = 1;
    std::uint64_t frames = 1'000'000;  // of the long runs
    // Whose worst inputs are searched: IDs or functions, shell globs; none: all.
    std::vector<std::string> equations{};
};

// What a run works with. The lab includes from the library, tools/stress/shaders and MethodFunctions' folder.
struct Context {
    const subject::Lab& lab;
    const scene::PassLibrary& passes;
    Scope scope{};
    std::vector<effect::MethodInfo> methods = effect::methods();  // whose passes and gathers are tried
    std::string run{};                                            // its name
    std::function<void(const Row&)> found{};                      // is given each row
    std::function<void(const std::string&)> progress = [](const std::string&) {};  // what is done now

    void add(const std::string& varied, const std::string& quantity, double measured,
             std::optional<double> bound) const {
        found({run, varied, quantity, measured, bound});
    }
};

// Each of these finds rows. They throw what the backend, check and effect rooms throw.

// For every equation of the catalogue, the worst input that a guided search finds (audit/worst.hpp), as a
// fraction of what its documentation states, beside the worst of its random inputs alone. The search is made
// of the default variant: inputs that break a budget are rows that fail. Or for one of them.
void worst_inputs(const Context& context);
void worst_inputs(const Context& context, const catalogue::Entry& entry);

// The history carried over Scope::frames frames on the device, as a pass does it, for constant, alternating,
// jumping, noisy and rare contributions, beside the mean in double: the farthest from it, and the average
// over time (bias), at most E (w_max + k) / k with the error E of gloam_blend; weight and index, exact.
void long_run(const Context& context);

// A scene and its moving camera at 1e2 to 1e7 units from the origin: previous positions, reprojection,
// TSSAO-8 and the effect's frames, with what is centred on the eye and what is not; and depths in halves.
void far_away(const Context& context);

// NaN, infinities, negative, subnormal and huge values, one texel at a time and everywhere: in the depth and
// normals of the passes of methods, in the images that methods fetch from, in history texels and in
// contributions. Occlusion stays in [0, 1]; pixels beyond the footprint stay as they were; a poisoned history
// counts as none. Nothing is fetched outside an image. All the same without robustBufferAccess.
void poisoned_passes(const Context& context);
void poisoned_gathers(const Context& context);
void poisoned_history(const Context& context);

// What several runs are made with.

// The larger of two errors; NaN where one is.
inline double worse(double a, double b) {
    return a >= b || std::isnan(a) ? a : b;
}

// NaN, infinities, negative, zero, subnormal (the least and the largest), tiny and huge.
inline constexpr float bad_values[]{NAN,    -NAN,  INFINITY,     -INFINITY,       0.0F,
                                    -0.0F,  -1.0F, FLT_TRUE_MIN, 1.17549421e-38F, FLT_MIN,
                                    1e-20F, 1e20F, -1e20F,       FLT_MAX,         -FLT_MAX};

// A wall across the whole view, at depth 3 along the axis. slope: by how much it recedes to the right.
[[nodiscard]] inline scene::GBuffer wall(backend::Extent extent, double slope = 0.0) {
    scene::GBuffer view{.extent = extent};
    view.camera =
        scene::make_frame({}, static_cast<double>(extent.width) / static_cast<double>(extent.height));
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    view.normal.assign(pixels, glm::vec3(glm::normalize(glm::dvec3(slope, 0.0, 1.0))));
    for (std::size_t i = 0; i < pixels; ++i)
        view.depth.push_back(
            static_cast<float>(3.0 / (1.0 - slope * scene::PixelPositions(view).at(i, 1.0).x)));
    return view;
}

}  // namespace gloam::stress
