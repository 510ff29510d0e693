// SPDX-License-Identifier: MIT
#include "effect/internal/frame.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/values.hpp"

namespace gloam::effect {
namespace {

using Origin = PlannedImage::Origin;

struct ImageRow {
    const char* name;
    bool exists;
    gpu::Format format;
    Origin origin;
    const char* meaning;
};

std::vector<ImageRow> images_of_inputs(const Moment& m) {
    using enum gpu::Format;
    const char* linear = "eye-linear depth, world units; background 0 or not finite";
    const char* normals = "view-space unit normals that face the eye, in xyz";
    const bool converts = m.converted.has_value();
    const bool layers = m.settings.own.layers > 1;
    return {
        {"depth", true, r32f, Origin::engine,
         converts ? "depth as the engine stores it, any format that is sampled" : linear},
        {"normal", m.has_normals || !converts, rgba32f, m.has_normals ? Origin::engine : Origin::frame,
         converts ? "normals as the engine stores them, any format" : normals},
        {"linear_depth", converts, r32f, Origin::frame, linear},
        {"view_normal", converts, rgba32f, Origin::frame, normals},
        {"motion", m.from_motion, rgba32f, Origin::engine,
         "motion vectors in xy, any format: by how much each point has moved in the image since the frame "
         "before"},
        {"previous_position", m.has_positions, rgba32f, m.from_motion ? Origin::frame : Origin::engine,
         "where each surface point was, in the view space of the frame before, in xyz"},
        {"layers", layers, rgba32f, Origin::engine, "depth layers 1 to 3 behind the first in xyz"}};
}

std::vector<ImageRow> images_of_results(const Moment& m) {
    using enum gpu::Format;
    const Settings& settings = m.settings;
    const gpu::Format output = format_of(settings.output);
    const bool alone = shows_alone(settings);
    const bool filtered = filters(settings);
    return {{"filtered", alone, r32f, Origin::frame, "the occlusion"},
            {"history_before", !alone, rgba32f, Origin::history, "the history of the frame before"},
            {"history_reprojected", settings.history, rgba32f, Origin::frame,
             "the same at the pixels of this frame"},
            {"history_after", !alone, rgba32f, Origin::frame, "the history of this frame"},
            {"half_filtered", filtered, r32f, Origin::frame, "the occlusion filtered along x"},
            {"filtered", filtered, r32f, Origin::frame, "and along y"},
            {"mapped", m.maps_images(), output, Origin::frame, "what is shown of the occlusion"},
            {"filtered_mapped", m.maps_images() && filtered, output, Origin::frame,
             "what is shown of the filtered occlusion"},
            {"bent_parts", m.bent_normals, rgba32f, Origin::frame,
             "each pixel's part of the open directions, not normalized"},
            {"bent_normal", m.bent_normals, rgba32f, Origin::frame,
             "the mean open direction, a unit vector in view space, in xyz; half the angle of its cone in w, "
             "radians"}};
}

void add_images(const Moment& m, const std::vector<ImageRow>& rows, Plan& plan) {
    for (const ImageRow& row : rows) {
        if (!row.exists) continue;
        plan.images.push_back({.name = row.name,
                               .meaning = row.meaning,
                               .format = row.format,
                               .origin = row.origin,
                               .extent = m.view.extent});
    }
}

// Images whose size is not that of the view.
void add_fixed_images(const Moment& m, Plan& plan) {
    if (m.preparation) {
        plan.images.push_back({.name = "prepared",
                               .meaning = "what the method's preparation passes write",
                               .format = m.preparation->format,
                               .extent = m.preparation->image});
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
    Evaluation(const Moment& moment, const Plan& resources, const InterfaceOf& interface_of)
        : moment_(moment), resources_(resources), interface_of_(interface_of) {}

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
        PassSource source = row.source(moment_);
        Values values = values_of(moment_);
        for (const auto& [name, number] : row.own) values.set(name, number);
        const shader::ModuleInterface interface = interface_of_(source);
        source.constants = values.constants(interface, source.file);
        PushConstants filled = values.push_constants(interface, source.file);
        PlannedPass pass{.name = row.own_name ? row.own_name(moment_) : row.name,
                         .source = std::move(source),
                         .turn = row.turn,
                         .resources = {},
                         .parameters = std::move(filled.bytes),
                         .of_view = std::move(filled.of_view)};
        for (const char* resource : row.resources) pass.resources.push_back(present(named(resource)));
        set_groups(row, pass);
        return pass;
    }

    void set_groups(const PassRow& row, PlannedPass& pass) const {
        pass.pixels = row.groups ? pixels_of_preparation() : std::array{tile_side, tile_side};
        pass.groups = row.groups ? row.groups(moment_) : groups_for(moment_.view.extent);
    }

    // A group of 8 x 8 texels of half the resolution covers 16 x 16 pixels of the view, and so on.
    [[nodiscard]] std::array<std::uint32_t, 2> pixels_of_preparation() const {
        const std::uint32_t width = moment_.preparation->passes[moment_.step].invocations.width;
        std::uint32_t scale = 1;
        while (width * scale + scale <= moment_.view.extent.width) scale *= 2;
        const std::uint32_t side = tile_side * scale;
        return {side, side};
    }

    // The resource that the table names.
    [[nodiscard]] std::string named(std::string_view name) const {
        if (name == "stored_depth") return "depth";
        if (name == "stored_normal") return "normal";
        if (name == "depth" && moment_.converted) return "linear_depth";
        if (name == "normal" && moment_.converted) return "view_normal";
        if (name == "positions") return "previous_position";
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
    const InterfaceOf& interface_of_;
};

}  // namespace

Plan planned_resources(const Moment& moment) {
    Plan plan;
    add_images(moment, images_of_inputs(moment), plan);
    add_images(moment, images_of_results(moment), plan);
    add_fixed_images(moment, plan);
    add_buffers(moment, plan);
    if (!shows_alone(moment.settings)) plan.exchanged.push_back({"history_before", "history_after"});
    return plan;
}

std::vector<PlannedPass> planned_passes(const Moment& moment, const Plan& resources,
                                        const InterfaceOf& interface_of) {
    return Evaluation(moment, resources, interface_of).run();
}

}  // namespace gloam::effect
