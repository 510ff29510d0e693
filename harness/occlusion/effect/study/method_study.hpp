// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/study/own_value.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/scene.hpp"
#include "scene/truth.hpp"

namespace gloam::effect {

struct ClosedFormOptions {
    std::uint32_t pixels = 129;        // on each side of the image, odd
    int frames = 16;                   // >= 2
    std::uint32_t samples = 1'024;     // of each frame
    bool reconstruct_normals = false;  // from the depth, instead of the view's own normals
};

// Measures methods on closed-form views with the real passes: with history, without filter, remap and
// rotation.
class ClosedFormStudy {
  public:
    // The device must outlive this object. Throws like AmbientOcclusion.
    ClosedFormStudy(const gpu::Device& device, const scene::PassLibrary& passes, std::uint32_t pixels);

    // The occlusion of the view's point: the mean over all frames, with a standard error from the spread of
    // the frames' means. Consecutive frames of a low-discrepancy sequence have opposite errors, so the actual
    // error of the mean is smaller than this estimate. Settings are for a radius of 1. Throws like
    // AmbientOcclusion, and std::invalid_argument for fewer than two frames and for another size than that of
    // the study.
    [[nodiscard]] Estimate measure(const scene::ClosedFormView& view, const Settings& settings,
                                   const ClosedFormOptions& options);

  private:
    AmbientOcclusion effect_;
    std::uint32_t pixels_;
};

// A method with settings. Lengths are for a radius of 1.
struct MethodConfiguration {
    std::string name;  // the method's, or a preset's
    Settings settings;
};

// Every method with its defaults, each followed by its preset NAME-quality if there is one.
[[nodiscard]] std::vector<MethodConfiguration> method_configurations();

// Whether two configurations differ in nothing but the number of samples and the filter, so that they
// converge to the same values.
[[nodiscard]] bool same_estimate(const Settings& a, const Settings& b);

// Result of a configuration on a closed-form view: occlusion before the remap, except `shown`.
struct ViewResult {
    std::string view;
    double truth = 0.0;  // cosine-weighted, linear falloff
    Estimate measured;
    // The value to which the method converges on ever finer images, or on this image if it grows with
    // resolution.
    std::optional<Estimate> own;  // nullopt: unknown
    double shown = 0.0;           // the measured value after the remap
};

// Results on all perspective views. Throws like ClosedFormStudy::measure().
[[nodiscard]] std::vector<ViewResult> study_views(ClosedFormStudy& study,
                                                  const MethodConfiguration& configuration,
                                                  const ClosedFormOptions& options);

// Result of a configuration on a scene.
struct SceneResult {
    std::vector<float> limit;   // after the remap: the mean of many samples
    Metrics geometry;           // of `limit`, against the geometry truth (cosine-weighted, linear falloff)
    Errors depth;               // of `limit`, against the depth truth
    std::optional<Errors> own;  // of `limit`, against (G) with the method's weighting and falloff
    Errors frame;               // of one frame with filter and remap, against the geometry truth
    std::uint64_t samples = 0;  // of a pixel in that frame
    double gather_ms = 0.0;     // on the device: the occlusion pass
    double frame_ms = 0.0;      // all passes
};

struct SceneOptions {
    gpu::Extent extent{192, 108};
    int rays = 256;  // of the truth, for each pixel
    std::uint32_t limit_samples = 1'024;
    int repeat = 3;                          // number of timed runs
    std::function<void(double)> progress{};  // of the truth, in [0, 1]
};

// Compares methods on a built-in scene's first frame.
class SceneStudy {
  public:
    // The device and the cache must outlive this object. Throws like scene::rasterize() and
    // scene::trace_geometry().
    SceneStudy(const gpu::Device& device, const scene::PassLibrary& passes, const scene::TruthCache& cache,
               scene::Scene scene, SceneOptions options);

    // Measures a configuration. Throws like AmbientOcclusion.
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
