// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/preparation.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

// Push constants of the passes of glsl/passes/preparation, with the layout of pass.glsl.
struct PreparationParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    glm::ivec2 border;
    float radius;
    float bias;
    float c_spatial;
    float weight_max;
    float c_rot;
    float least_radius;
    std::uint32_t orthographic;
    std::uint32_t shade_border;
    float samples_distance;
    float samples_radius;
    std::uint32_t samples_least;
    float radius_cap;
    float bias_depth;
    std::int32_t level;
};

[[nodiscard]] PreparationParameters preparation_parameters(const View& view, const Settings& settings,
                                                           int level);

// What the pipeline of a preparation pass is compiled for.
struct PreparationProgram {
    HistoryPrecision precision = HistoryPrecision::float32;
    std::uint32_t layers = 1;
    bool reject_taps = false;
    bool keeps_history = true;
    std::uint32_t samples = 0;
    std::uint32_t samples_converged = 0;
    std::uint32_t steps = 0;

    friend auto operator<=>(const PreparationProgram&, const PreparationProgram&) = default;
};

[[nodiscard]] PreparationProgram preparation_program_for(const Settings& settings);

// The shader of a preparation pass. file: in glsl/passes/preparation. format: of the prepared image.
[[nodiscard]] PassSource preparation_source(const std::string& file, const PreparationProgram& program,
                                            gpu::Format format);

// The image that a method's preparation passes write, and what these passes need. Nothing is allocated or
// compiled for a method without preparation passes.
class PreparedImage {
  public:
    PreparedImage(const gpu::Device& device, const scene::PassLibrary& library);

    // Takes a view and its settings for the next frames.
    void take(const View& view, const Settings& settings);

    // The prepared image, or `other` if the method has no preparation passes.
    [[nodiscard]] const gpu::Image& image_or(const gpu::Image& other) const {
        return image_ ? *image_ : other;
    }

    // The inputs of the passes besides their own image.
    struct Sources {
        const gpu::Image& depth;
        const gpu::Image& normal;
        const gpu::Image& history;
        const gpu::Buffer& method;
        const gpu::Image& layers;
    };

    // Appends the passes and compiles the missing ones. The steps are valid until the next take().
    void append_steps(const Sources& sources, std::vector<Step>& steps);

  private:
    [[nodiscard]] const gpu::ComputePipeline& pipeline(const std::string& file);

    const gpu::Device* device_;
    scene::PassLibrary library_;
    PreparationProgram program_;
    std::optional<Preparation> preparation_;
    std::optional<gpu::Image> image_;
    std::vector<PreparationParameters> constants_;  // for each pass
    std::map<std::pair<std::string, PreparationProgram>, gpu::ComputePipeline> pipelines_;
};

}  // namespace gloam::effect
