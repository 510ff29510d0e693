// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/metrics.hpp"
#include "effect/study/closed_form_study.hpp"
#include "scene/scene.hpp"
#include "scene/truth_cache.hpp"

namespace gloam::effect {

// One way to run a method. Lengths are for a radius of 1.
struct MethodConfiguration {
    std::string name;  // the method's, or a preset's
    Settings settings;
};

// Every method as it is by default, each followed by its preset NAME-quality where there is one.
[[nodiscard]] std::vector<MethodConfiguration> method_configurations();

// Whether two configurations differ in nothing but how many samples they take and how they are filtered, and
// so tend to the same.
[[nodiscard]] bool same_estimate(const Settings& a, const Settings& b);

// A configuration on a view in closed form. Occlusion before the remap but for `shown`.
struct ViewResult {
    std::string view;
    double truth = 0.0;  // cosine-weighted, linear falloff
    Estimate measured;
    // What the method's mean tends to on ever finer images, or on this one where it grows with them.
    std::optional<Estimate> own;  // nullopt: not known
    double shown = 0.0;           // what is measured, after the remap
};

// The perspective views. Throws like ClosedFormStudy::measure().
[[nodiscard]] std::vector<ViewResult> study_views(ClosedFormStudy& study,
                                                  const MethodConfiguration& configuration,
                                                  const ClosedFormOptions& options);

// A configuration on a scene.
struct SceneResult {
    std::vector<float> limit;   // the mean of many samples, after the remap: what the method tends to
    Metrics geometry;           // of it, against the truth of the geometry (cosine-weighted, linear falloff)
    Errors depth;               // of it, against that of the depth buffer
    std::optional<Errors> own;  // of it, against the geometry's by the method's own weighting and falloff
    Errors frame;               // of one frame with filter and remap, against the truth of the geometry
    std::uint64_t samples = 0;  // of a pixel in that frame
    double gather_ms = 0.0;     // on the device: the occlusion pass
    double frame_ms = 0.0;      // all passes
};

struct SceneOptions {
    gpu::Extent extent{192, 108};
    int rays = 256;  // of the truth, for each pixel
    std::uint32_t limit_samples = 1'024;
    int repeat = 3;                          // runs that are timed
    std::function<void(double)> progress{};  // of the truth
};

// Compares methods on a built-in scene's first frame.
class SceneStudy {
  public:
    // The device and the cache must outlive this. Throws like scene::rasterize() and scene::trace_geometry().
    SceneStudy(const gpu::Device& device, const scene::PassLibrary& passes, const scene::TruthCache& cache,
               scene::Scene scene, SceneOptions options);

    // Throws like AmbientOcclusion.
    [[nodiscard]] SceneResult run(const MethodConfiguration& configuration);

    [[nodiscard]] const std::string& name() const { return scene_.name; }
    [[nodiscard]] const Truth& geometry() const { return geometry_; }
    [[nodiscard]] const Truth& depth() const { return depth_; }

  private:
    using Measured = std::pair<scene::Weighting, scene::Falloff>;

    [[nodiscard]] std::vector<float> limit_of(const Settings& settings);
    [[nodiscard]] const Truth* own_truth(const MethodInfo& method);
    [[nodiscard]] Truth traced(const Measured& measured) const;

    const scene::TruthCache* cache_;
    scene::Scene scene_;
    SceneOptions options_;
    scene::GBuffer view_;
    AmbientOcclusion effect_;
    Truth geometry_;
    Truth depth_;
    std::map<Measured, Truth> own_;
};

}  // namespace gloam::effect
