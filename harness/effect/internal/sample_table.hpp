// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/settings.hpp"
#include "gpu/image.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Push constants of sample_table.comp.
struct SampleTableParameters {
    std::uint32_t first;
    std::uint32_t last;
};

constexpr std::uint32_t sample_table_group = 64;  // samples of one group of the pass

// The last sample that a table for these settings holds, and the size of its image.
[[nodiscard]] std::uint32_t last_tabulated(const Settings& settings);
[[nodiscard]] gpu::Extent sample_table_extent(const Settings& settings);

// The shader that fills the table. samples: name of the points, a file of glsl/passes/samples.
[[nodiscard]] PassSource sample_table_source(const std::string& samples);

// A table of what all pixels share of their samples. The device computes each sample once, as far as the
// frames need them. Nothing is allocated or compiled until a method shares something.
class SampleTable {
  public:
    SampleTable(const gpu::Device& device, const scene::PassLibrary& library);

    // Takes the settings of the next frames. The table stays valid as long as the method uses the same
    // points.
    void take(const Settings& settings);

    // Resets the count of taken samples: no pixel has taken one yet.
    void restart() { taken_ = 0; }

    // Call it after each frame: its samples have been taken and are in the table.
    void advance();

    // The table, or `other` if there is none.
    [[nodiscard]] const gpu::Image& image_or(const gpu::Image& other) const {
        return used_ ? *image_ : other;
    }

    // Appends the pass that computes the samples that the next frame may read and the table lacks, if there
    // are any. The step is valid until the next call of a member.
    void append_step(std::vector<Step>& steps);

  private:
    [[nodiscard]] std::uint32_t last_needed() const;
    [[nodiscard]] const gpu::ComputePipeline& pipeline();

    const gpu::Device* device_;
    scene::PassLibrary library_;
    bool used_ = false;
    std::string samples_;  // the points in the table: a file of glsl/passes/samples
    std::optional<gpu::Image> image_;
    std::uint32_t most_ = 0;        // samples of a frame
    std::uint32_t table_size_ = 0;  // samples after which the sequence starts over
    std::uint32_t taken_ = 0;       // by any pixel, largest number
    std::uint32_t filled_ = 0;      // samples in the table
    SampleTableParameters range_{};
    std::map<std::string, gpu::ComputePipeline> pipelines_;
};

// Whether the settings' frames read a table. False for a sequence of more than 131,072 samples.
[[nodiscard]] bool tabulates_samples(const Settings& settings);

// Preprocessor definition of a shader that reads or writes a table of the points with this name
// (samples/table.glsl).
[[nodiscard]] std::string sample_point_of(std::string_view points);

}  // namespace gloam::effect
