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

constexpr std::uint32_t sample_table_group = 64;  // samples of a group of the pass

// The last sample that a table of these settings has to hold, and the size of its image.
[[nodiscard]] std::uint32_t last_tabulated(const Settings& settings);
[[nodiscard]] gpu::Extent sample_table_extent(const Settings& settings);

// Of a file of glsl/passes/samples.
[[nodiscard]] PassSource sample_table_source(const std::string& samples);

// What all pixels share of their samples, computed once each, on the device, as far as the frames get.
// Nothing is allocated or compiled before a method shares something.
class SampleTable {
  public:
    SampleTable(const gpu::Device& device, const scene::PassLibrary& library);

    // For the next frames. What the table holds stays good as long as the method shares the same.
    void take(const Settings& settings);

    // No pixel has taken samples yet.
    void restart() { taken_ = 0; }

    // The frame has run: its samples have been taken, and are in the table.
    void advance();

    // The other one where there is no table.
    [[nodiscard]] const gpu::Image& image_or(const gpu::Image& other) const {
        return used_ ? *image_ : other;
    }

    // The pass that adds what the next frame may read and the table does not hold yet, if anything. The step
    // holds until the next call of a member.
    void append_step(std::vector<Step>& steps);

  private:
    [[nodiscard]] std::uint32_t last_needed() const;
    [[nodiscard]] const gpu::ComputePipeline& pipeline();

    const gpu::Device* device_;
    scene::PassLibrary library_;
    bool used_ = false;
    std::string samples_;  // what the table holds: a file of glsl/passes/samples
    std::optional<gpu::Image> image_;
    std::uint32_t most_ = 0;        // samples of a frame
    std::uint32_t table_size_ = 0;  // samples after which the sequence starts over
    std::uint32_t taken_ = 0;       // by any pixel, at most
    std::uint32_t filled_ = 0;      // samples in the table
    SampleTableParameters range_{};
    std::map<std::string, gpu::ComputePipeline> pipelines_;
};

// Whether the settings' frames read a table. A sequence of more than 131,072 samples has none.
[[nodiscard]] bool tabulates_samples(const Settings& settings);

// What a shader that has the points of that name in a table, or writes it, is compiled with
// (samples/table.glsl).
[[nodiscard]] std::string sample_point_of(std::string_view points);

}  // namespace gloam::effect
