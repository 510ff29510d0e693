// SPDX-License-Identifier: MIT
#include "effect/internal/frame.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "effect/internal/frame_images.hpp"

namespace gloam::effect {
namespace {

using Origin = PlannedImage::Origin;

enum class Size {
    view,  // the engine's view
    read   // the images that the passes read
};

struct ImageRow {
    const char* name;
    bool exists;
    gpu::Format format;
    Origin origin;
    Size size;
    const char* meaning;
};

std::vector<ImageRow> images_of_inputs(const Moment& m) {
    using enum gpu::Format;
    const char* linear = "eye-linear depth, world units; background 0 or not finite";
    const char* normals = "view-space unit normals that face the eye, in xyz";
    const bool converts = m.converted.has_value();
    const bool layers = m.settings.own.layers > 1;
    return {
        {"depth", true, r32f, Origin::engine, Size::view,
         converts ? "depth as the engine stores it, any format that is sampled" : linear},
        {"normal", m.has_normals || !converts, rgba32f, m.has_normals ? Origin::engine : Origin::frame,
         Size::view, converts ? "normals as the engine stores them, any format" : normals},
        {"linear_depth", converts, r32f, Origin::frame, Size::view, linear},
        {"view_normal", converts, rgba32f, Origin::frame, Size::view, normals},
        {"motion", m.from_motion, rgba32f, Origin::engine, Size::view,
         "motion vectors in xy, any format: by how much each point has moved in the image since the frame "
         "before"},
        {"previous_position", m.has_positions, rgba32f, m.from_motion ? Origin::frame : Origin::engine,
         Size::view, "where each surface point was, in the view space of the frame before, in xyz"},
        {"layers", layers, rgba32f, Origin::engine, Size::view,
         "depth layers 1 to 3 behind the first in xyz"},
        {"half_depth", m.half(), r32f, Origin::frame, Size::read, "eye-linear depth of every second pixel"},
        {"half_normal", m.half(), rgba32f, Origin::frame, Size::read,
         "normals of these, in the half-size image's view space"},
        {"half_previous_position", m.half() && m.has_positions, rgba32f, Origin::frame, Size::read,
         "where their points were, likewise"},
        {"half_layers", m.half() && layers, rgba32f, Origin::frame, Size::read, "depth layers of these"}};
}

std::vector<ImageRow> images_of_results(const Moment& m) {
    using enum gpu::Format;
    const Settings& settings = m.settings;
    const gpu::Format history = format_of(settings.precision);
    const gpu::Format output = format_of(settings.output);
    const bool alone = shows_alone(settings);
    const bool filtered = filters(settings);
    return {
        {"filtered", alone, r32f, Origin::frame, Size::read, "the occlusion"},
        {"history_before", !alone, history, Origin::history, Size::read, "the history of the frame before"},
        {"history_reprojected", settings.history, history, Origin::frame, Size::read,
         "the same at the pixels of this frame"},
        {"history_after", !alone, history, Origin::frame, Size::read, "the history of this frame"},
        {"half_filtered", filtered, r32f, Origin::frame, Size::read, "the occlusion filtered along x"},
        {"filtered", filtered, r32f, Origin::frame, Size::read, "and along y"},
        {"mapped", m.maps_images(), output, Origin::frame, Size::read, "what is shown of the occlusion"},
        {"filtered_mapped", m.maps_images() && filtered && !m.half(), output, Origin::frame, Size::read,
         "what is shown of the filtered occlusion"},
        {"upsampled", m.half(), output, Origin::frame, Size::view, "what is shown, at the size of the view"},
        {"bent_parts", m.bent_normals, rgba32f, Origin::frame, Size::view,
         "each pixel's part of the open directions, not normalized"},
        {"bent_normal", m.bent_normals, rgba32f, Origin::frame, Size::view,
         "the mean open direction, a unit vector in view space, in xyz; half the angle of its cone in w, "
         "radians"}};
}

void add_images(const Moment& m, const std::vector<ImageRow>& rows, Plan& plan) {
    for (const ImageRow& row : rows) {
        if (!row.exists) continue;
        const bool of_view = row.size == Size::view;
        plan.images.push_back({.name = row.name,
                               .meaning = row.meaning,
                               .format = row.format,
                               .origin = row.origin,
                               .extent = of_view ? m.given.extent : m.view.extent,
                               .divisor = m.half() && !of_view ? 2U : 1U});
    }
}

// Images whose size is not that of the view.
void add_fixed_images(const Moment& m, Plan& plan) {
    if (m.preparation) {
        PlannedImage image{.name = "prepared",
                           .meaning = "what the method's preparation passes write",
                           .format = m.preparation->format,
                           .extent = m.preparation->image,
                           .divisor = 0};
        if (image.extent == m.view.extent) image.divisor = m.half() ? 2 : 1;
        if (image.extent == half_of(m.view.extent)) image.divisor = m.half() ? 4 : 2;
        plan.images.push_back(std::move(image));
    }
}

void add_buffers(const Moment& m, Plan& plan) {
    const auto own = std::as_bytes(std::span(&m.settings.own, 1));
    plan.buffers.push_back({.name = "method",
                            .meaning = "the method's settings",
                            .bytes = sizeof(MethodValues),
                            .contents = {own.begin(), own.end()}});
}

// The table for one frame.
class Evaluation {
  public:
    Evaluation(const Moment& moment, const Plan& resources) : moment_(moment), resources_(resources) {}

    std::vector<PlannedPass> run() {
        std::vector<PlannedPass> passes;
        for (const PassRow& row : pass_table()) {
            const std::size_t times = row.when(moment_);
            for (moment_.step = 0; moment_.step < times; ++moment_.step) passes.push_back(pass(row));
        }
        return passes;
    }

  private:
    [[nodiscard]] PlannedPass pass(const PassRow& row) const {
        Constants filled = row.fill(moment_);
        PlannedPass pass{.name = row.own_name ? row.own_name(moment_) : row.name,
                         .source = row.source(moment_),
                         .turn = row.turn,
                         .resources = {},
                         .parameters = filled.bytes,
                         .odd_parameters = std::move(filled.bytes),
                         .of_view = std::move(filled.of_view)};
        for (const char* resource : row.resources) pass.resources.push_back(present(named(resource)));
        if (row.cover != Cover::view && row.cover != Cover::halved) pass.divisor = moment_.half() ? 2 : 1;
        set_groups(row, pass);
        return pass;
    }

    void set_groups(const PassRow& row, PlannedPass& pass) const {
        if (row.groups) pass.groups = row.groups(moment_);
        pass.pixels = pixels_of_group(row);
        if (row.groups) return;
        const gpu::Extent view = moment_.given.extent;
        pass.groups = {(view.width + pass.pixels[0] - 1) / pass.pixels[0],
                       (view.height + pass.pixels[1] - 1) / pass.pixels[1], 1};
    }

    // Pixels of the engine's view.
    [[nodiscard]] std::array<std::uint32_t, 2> pixels_of_group(const PassRow& row) const {
        const std::uint32_t side = moment_.half() && row.cover != Cover::view ? 2 * tile_side : tile_side;
        switch (row.cover) {
            case Cover::own:
                return row.name == std::string_view("preparation") ? pixels_of_preparation()
                                                                   : std::array<std::uint32_t, 2>{};
            default:
                return {side, side};
        }
    }

    // A group of 8 x 8 texels of half the resolution covers 16 x 16 pixels of the view, and so on.
    [[nodiscard]] std::array<std::uint32_t, 2> pixels_of_preparation() const {
        const std::uint32_t width = moment_.preparation->passes[moment_.step].invocations.width;
        std::uint32_t scale = 1;
        while (width * scale + scale <= moment_.view.extent.width) scale *= 2;
        const std::uint32_t side = tile_side * scale * (moment_.half() ? 2 : 1);
        return {side, side};
    }

    // The resource that the table names.
    [[nodiscard]] std::string named(std::string_view name) const {
        const bool half = moment_.half();
        const auto full = [&](const char* given, const char* converted) {
            return moment_.converted ? converted : given;
        };
        if (name == "stored_depth") return "depth";
        if (name == "stored_normal") return "normal";
        if (name == "full_depth") return full("depth", "linear_depth");
        if (name == "full_normal") return full("normal", "view_normal");
        if (name == "full_positions") return "previous_position";
        if (name == "full_layers") return "layers";
        if (name == "depth") return half ? "half_depth" : full("depth", "linear_depth");
        if (name == "normal") return half ? "half_normal" : full("normal", "view_normal");
        if (name == "positions") return half ? "half_previous_position" : "previous_position";
        if (name == "layers") return half ? "half_layers" : "layers";
        if (name == "history") return moment_.moves_history() ? "history_reprojected" : "history_before";
        if (name == "occlusion") return shows_alone(moment_.settings) ? "filtered" : "history_after";
        return std::string(name);
    }

    [[nodiscard]] std::string present(std::string name) const {
        const auto among = [&](const auto& all) {
            return std::ranges::any_of(all, [&](const auto& one) { return one.name == name; });
        };
        if (among(resources_.images) || among(resources_.buffers)) return name;
        return nothing_image;
    }

    Moment moment_;
    const Plan& resources_;
};

}  // namespace

Plan planned_resources(const Moment& moment) {
    Plan plan;
    add_images(moment, images_of_inputs(moment), plan);
    add_images(moment, images_of_results(moment), plan);
    add_fixed_images(moment, plan);
    add_buffers(moment, plan);
    plan.tile = moment.half() ? 2 * tile_side : tile_side;
    if (!shows_alone(moment.settings)) plan.exchanged.push_back({"history_before", "history_after"});
    return plan;
}

std::vector<PlannedPass> planned_passes(const Moment& moment, const Plan& resources) {
    return Evaluation(moment, resources).run();
}

}  // namespace gloam::effect
