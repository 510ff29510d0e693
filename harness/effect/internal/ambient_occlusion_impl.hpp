// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/half_resolution.hpp"
#include "effect/internal/open_search.hpp"
#include "effect/internal/pipelines.hpp"
#include "effect/internal/prepared_image.hpp"
#include "effect/internal/progress.hpp"
#include "effect/internal/sample_table.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/surface_inputs.hpp"
#include "effect/internal/tiles.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The state of the effect: views, images and histories, and what the next frame runs.
struct AmbientOcclusion::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes, gpu::Extent size)
        : device(&the_device),
          library(passes),
          pipelines(the_device, passes),
          nothing(the_device, {1, 1}, gpu::Format::rgba32f),
          no_displacement(the_device, {1, 1}, gpu::Format::r32ui),
          method(the_device, sizeof(MethodValues)),
          prepared(the_device, passes),
          samples(the_device, passes) {
        allocate(size);
    }

    const gpu::Device* device;
    scene::PassLibrary library;
    Pipelines pipelines;
    View given;  // the engine's view
    View view;   // the same at the size of the images that the passes read
    View previous_given;
    View previous_view;
    Settings settings;
    Progress progress;
    SurfaceInputs surfaces;
    Listing listing;
    OpenSearch open_search;
    bool second_is_after = false;  // which of the two images of the history, which are swapped
    gpu::Image nothing;            // for bindings that are not read
    gpu::Image no_displacement;    // the same, of integers
    gpu::Buffer method;            // MethodValues
    PreparedImage prepared;
    SampleTable samples;
    std::optional<FrameImages> images;
    std::unique_ptr<HalfResolution> half;  // with Resolution::half
    ReprojectionParameters reprojection_constants{};
    OcclusionParameters occlusion_constants{};
    FilterParameters filter_constants{};
    RemapParameters remap_constants{};
    SelectParameters select_constants{};
    SelectFilteredParameters select_filtered_constants{};
    PassWatcher watcher;  // empty: no watcher

    void allocate(gpu::Extent size);
    void take(const scene::GBuffer& new_view);
    [[nodiscard]] bool moves_history() const { return progress.history_lags() && settings.history; }
    [[nodiscard]] bool knows_motion() const;
    [[nodiscard]] bool watches_objects() const {
        return knows_motion() && settings.invalidation != Invalidation::none;
    }
    [[nodiscard]] bool filters_frame() const { return filters(settings, progress.frames_since_cut()); }
    [[nodiscard]] bool lists_tiles() const {
        return selects_tiles(settings) && listing.due(progress.history_lags());
    }
    [[nodiscard]] Program program() const;
    [[nodiscard]] ReprojectionProgram reprojection_program() const;
    [[nodiscard]] const gpu::Image& history() const;
    [[nodiscard]] const gpu::Image& history_after() const;
    [[nodiscard]] std::optional<TileLists> listed(TileLists list) const;
    [[nodiscard]] Step over(TileLists list, Step pass) const;
    [[nodiscard]] std::vector<Step> steps();
    [[nodiscard]] gpu::Extent unshaded_band() const;
    [[nodiscard]] SelectParameters select_parameters() const;
    [[nodiscard]] std::array<std::uint32_t, 3> tile_groups() const;
    // Whether the remap pass runs. At half the resolution the pass that upsamples remaps as well, but only
    // what is displayed.
    [[nodiscard]] bool remaps_images() const { return remaps(settings) && (!half || filters_frame()); }
    void append_inputs(std::vector<Step>& passes);
    void append_result(std::vector<Step>& passes);
    void append_selection(std::vector<Step>& passes);
    [[nodiscard]] bool finds_open_tiles() const;
    void append_filter(std::vector<Step>& passes);
    void append_remap(std::vector<Step>& passes);
    [[nodiscard]] Frame collect() const;
    [[nodiscard]] Work work(std::span<const float> convergence) const;
};

}  // namespace gloam::effect
