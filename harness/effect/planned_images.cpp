// SPDX-License-Identifier: MIT
#include "effect/internal/planned_images.hpp"

#include <optional>
#include <utility>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/half_resolution.hpp"
#include "effect/internal/sample_table.hpp"
#include "effect/preparation.hpp"

namespace gloam::effect {
namespace {

using Origin = PlannedImage::Origin;

class ImageList {
  public:
    ImageList(const Settings& settings, const PlanOptions& options, gpu::Extent view)
        : settings_(settings),
          options_(options),
          half_(settings.resolution == Resolution::half),
          given_(view),
          read_(half_ ? half_of(view) : view),
          preparation_(preparation_of(settings, read_)),
          table_(tabulates_samples(settings)) {}

    std::vector<PlannedImage> run() {
        add_all();
        return std::move(images_);
    }

  private:
    [[nodiscard]] std::uint32_t divisor() const { return half_ ? 2 : 1; }

    void image(const char* name, gpu::Format format, Origin origin, const char* meaning) {
        images_.push_back({.name = name,
                           .meaning = meaning,
                           .format = format,
                           .origin = origin,
                           .extent = read_,
                           .divisor = divisor()});
    }

    // An image of the view's size.
    void full_image(const char* name, gpu::Format format, Origin origin, const char* meaning) {
        image(name, format, origin, meaning);
        images_.back().extent = given_;
        images_.back().divisor = 1;
    }

    void fixed_image(const char* name, gpu::Format format, gpu::Extent extent, const char* meaning) {
        image(name, format, Origin::frame, meaning);
        images_.back().extent = extent;
        images_.back().divisor = 0;
    }

    void add_all() {
        using enum gpu::Format;
        const gpu::Format history = format_of(settings_.precision);
        surfaces();
        if (options_.moving_objects) {
            full_image("previous_position", rgba32f, Origin::engine,
                       "where each surface point was, in the view space of the frame before, in xyz");
            image("displacement", r32ui, Origin::frame, "how surface points move otherwise than the camera");
        }
        if (settings_.layers > 1)
            full_image("layers", rgba32f, Origin::engine, "depth layers 1 to 3 behind the first in xyz");
        if (half_) halves();
        if (shows_alone(settings_)) {
            image("filtered", r32f, Origin::frame, "the occlusion");
        } else {
            image("history_before", history, Origin::history, "the history of the frame before");
            if (settings_.history)
                image("history_reprojected", history, Origin::frame, "the same at the pixels of this frame");
            image("history_after", history, Origin::frame, "the history of this frame");
        }
        if (filters(settings_)) {
            image("half_filtered", r32f, Origin::frame, "the occlusion filtered along x");
            image("filtered", r32f, Origin::frame, "and along y");
        }
        if (remaps(settings_) && !half_)
            image("mapped", format_of(settings_.output), Origin::frame, "what is shown of the occlusion");
        if (remaps(settings_) && filters(settings_) && !half_)
            image("filtered_mapped", format_of(settings_.output), Origin::frame,
                  "what is shown of the filtered occlusion");
        if (half_)
            full_image("upsampled", format_of(settings_.output), Origin::frame,
                       "what is shown, at the size of the view");
        if (preparation_) prepared_image();
        if (table_) {
            fixed_image("sample_table", rgba32f, sample_table_extent(settings_),
                        "what all pixels share of their samples");
            images_.back().origin = Origin::once;
        }
    }

    // Depth and normals of the engine, and what they are converted to.
    void surfaces() {
        using enum gpu::Format;
        const char* linear = "eye-linear depth, world units; background 0 or not finite";
        const char* normals = "view-space unit normals that face the eye, in xyz";
        const Origin of_normals = options_.normals ? Origin::engine : Origin::frame;
        if (options_.encoding == scene::Encoding{}) {
            full_image("depth", r32f, Origin::engine, linear);
            full_image("normal", rgba32f, of_normals, normals);
            return;
        }
        full_image("depth", r32f, Origin::engine,
                   "depth as the engine stores it, any format that is sampled");
        if (options_.normals)
            full_image("normal", rgba32f, Origin::engine, "normals as the engine stores them, any format");
        full_image("linear_depth", r32f, Origin::frame, linear);
        full_image("view_normal", rgba32f, Origin::frame, normals);
    }

    // What the passes read at half the resolution.
    void halves() {
        using enum gpu::Format;
        image("half_depth", r32f, Origin::frame, "eye-linear depth of every second pixel");
        image("half_normal", rgba32f, Origin::frame, "normals of these, in the half-size image's view space");
        if (options_.moving_objects)
            image("half_previous_position", rgba32f, Origin::frame, "where their points were, likewise");
        if (settings_.layers > 1) image("half_layers", rgba32f, Origin::frame, "depth layers of these");
    }

    void prepared_image() {
        const gpu::Extent extent = preparation_->image;
        fixed_image("prepared", preparation_->format, extent, "what the method's preparation passes write");
        for (std::uint32_t divisor = 1; divisor <= 2; ++divisor) {
            const gpu::Extent view = read_;
            if (extent ==
                gpu::Extent{(view.width + divisor - 1) / divisor, (view.height + divisor - 1) / divisor})
                images_.back().divisor = divisor * this->divisor();
        }
    }

    const Settings& settings_;
    const PlanOptions& options_;
    bool half_;
    gpu::Extent given_;  // size of the view
    gpu::Extent read_;   // and of the images that the passes read
    std::optional<Preparation> preparation_;
    bool table_;
    std::vector<PlannedImage> images_;
};

}  // namespace

std::vector<PlannedImage> planned_images(const Settings& settings, const PlanOptions& options,
                                         gpu::Extent view) {
    return ImageList(settings, options, view).run();
}

}  // namespace gloam::effect
