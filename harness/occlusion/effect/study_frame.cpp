// SPDX-License-Identifier: MIT
#include "effect/internal/study_frame.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame.hpp"

namespace gloam::effect {
namespace {

using Origin = PlannedImage::Origin;

// An image of the view's size, where there is one.
struct ImageRow {
    const char* name;
    bool exists;
    backend::vulkan::Format format;
    Origin origin = Origin::frame;
};

std::vector<ImageRow> images_of(const Moment& m) {
    using enum backend::vulkan::Format;
    const bool converts = m.converted.has_value();
    const bool remapped = remaps(m.settings);
    const bool alone = shows_alone(m.settings);
    const bool filtered = filters(m.settings);
    const backend::vulkan::Format output = format_of(m.settings.output);
    return {{"depth", true, r32f, Origin::engine},  // as it is stored, or eye-linear in world units
            {"normal", m.has_normals || !converts, rgba32f, m.has_normals ? Origin::engine : Origin::frame},
            {"linear_depth", converts, r32f},  // of what is stored otherwise; background 0 or not finite
            {"view_normal", converts, rgba32f},
            // Where each surface point was, in the view space of the frame before.
            {"previous_position", m.has_positions, rgba32f, Origin::engine},
            {"layers", m.settings.own.layers > 1, rgba32f, Origin::engine},  // 1 to 3 behind the first in xyz
            {"history_before", !alone, rgba32f, Origin::history},
            {"history_reprojected", m.settings.history, rgba32f},  // the same at the pixels of this frame
            {"history_after", !alone, rgba32f},
            {"half_filtered", filtered, r32f},  // along x
            {"filtered", alone || filtered, r32f},
            {"mapped", remapped, output},  // what is shown of the occlusion
            {"filtered_mapped", remapped && filtered, output}};
}

// The resource that the table names.
std::string_view resource_of(std::string_view name, const Moment& moment) {
    if (name == "stored_depth") return "depth";
    if (name == "stored_normal") return "normal";
    if (name == "depth" && moment.converted) return "linear_depth";
    if (name == "normal" && moment.converted) return "view_normal";
    if (name == "history") return moment.moves_history() ? "history_reprojected" : "history_before";
    if (name == "occlusion") return shows_alone(moment.settings) ? "filtered" : "history_after";
    return name;
}

bool has(const Plan& plan, std::string_view name) {
    const auto among = [&](const auto& all) {
        return std::ranges::any_of(all, [&](const auto& one) { return one.name == name; });
    };
    return among(plan.images) || among(plan.buffers);
}

// The state of the study's frame: the last view, images and histories, and what the next frame runs.
class StudyPasses : public FramePasses {
  public:
    StudyPasses(const backend::vulkan::Device& device, const scene::PassLibrary& passes)
        : device_(&device), executor_(device, passes), resources_(device) {
        moment_.shows_unfiltered = true;
    }

    void take(const scene::GBuffer& view, const Settings& settings, bool follows) override;
    [[nodiscard]] Frame next(int repeat, const PassWatcher& watcher) override;

  private:
    [[nodiscard]] Frame collect() const;

    const backend::vulkan::Device* device_;
    Executor executor_;
    Resources resources_;
    Moment moment_;           // the next frame, or the last one
    Plan plan_;               // its images and buffers; passes after the first frame
    bool follows_ = false;    // the view: it has the history of the one before
    std::size_t frames_ = 0;  // of the view, so far
};

void StudyPasses::take(const scene::GBuffer& view, const Settings& settings, bool follows) {
    require_layers(view, settings);
    require_centred(view);
    follows_ = follows && view.extent == moment_.view.extent && view.camera.previous_from_current;
    frames_ = 0;
    moment_.settings = settings;
    moment_.converted = view.stored ? std::optional(view.stored->encoding) : std::nullopt;
    moment_.has_normals = !view.normal.empty();
    moment_.has_positions = !view.previous_position.empty();
    const View now{view.camera, view.extent, view.border};
    moment_.look(now, follows_ ? View(moment_.view) : now);
    plan_ = planned_resources(moment_);
    resources_.provide(plan_);
    upload(view, true, resources_);
    if (!follows_) resources_.restart(plan_);
}

// Mean over the pixels with a surface; k_1 where nothing tells which they are.
double samples_asked(const Frame& frame, const Settings& settings) {
    const auto whole = [&](std::uint32_t samples) {
        return static_cast<double>(samples_taken(method_named(settings.method), samples, settings.own.steps));
    };
    double sum = 0.0;
    double surfaces = 0.0;
    for (std::size_t i = 0; i < frame.kept.size(); ++i) {
        if (!(frame.convergence[i] > 0.0F)) continue;
        const bool converged = frame.kept[i] / settings.weight_max >= settings.c_spatial;
        sum += whole(converged ? settings.samples_converged : settings.samples);
        surfaces += 1.0;
    }
    return surfaces > 0.0 ? sum / surfaces : whole(settings.samples);
}

Frame StudyPasses::collect() const {
    const Settings& settings = moment_.settings;
    const bool mapped = remaps(settings);
    Frame frame;
    if (shows_alone(settings)) {
        frame.occlusion = resources_.image(mapped ? "mapped" : "filtered").download();
        frame.convergence = frame.kept = std::vector<float>(frame.occlusion.size(), 0.0F);
    } else {
        const char* before = moment_.moves_history() ? "history_reprojected" : "history_before";
        const std::vector<float> history = resources_.image("history_after").download();
        frame.occlusion = mapped ? resources_.image("mapped").download() : channel(history, 0);
        frame.convergence = channel(history, 1);
        frame.kept = channel(resources_.image(before).download(), 1);
    }
    const char* filtered = mapped ? "filtered_mapped" : "filtered";
    frame.filtered = filters(settings) ? resources_.image(filtered).download() : frame.occlusion;
    for (float& value : frame.convergence) value = std::min(value / settings.weight_max, 1.0F);
    crop({.extent = moment_.view.extent, .border = moment_.view.border}, frame);
    frame.samples = samples_asked(frame, settings);
    return frame;
}

Frame StudyPasses::next(int repeat, const PassWatcher& watcher) {
    moment_.new_view = frames_ == 0;
    moment_.moved = follows_ && frames_ == 0;
    plan_.passes = planned_passes(
        moment_, plan_, [this](const PassSource& source) { return executor_.interface_of(source); });
    // Each run reads the same history and writes the same images, so a repeated run changes nothing.
    const std::vector<Step> steps = executor_.steps(plan_.passes, resources_);
    std::vector<PassTime> times = run(*device_, steps, repeat, watcher);
    Frame frame = collect();
    frame.memory_bytes = memory_of(steps);
    frame.times = std::move(times);
    ++frames_;
    resources_.exchange(plan_.exchanged);
    return frame;
}

}  // namespace

Plan planned_resources(const Moment& moment) {
    Plan plan;
    for (const ImageRow& row : images_of(moment))
        if (row.exists) plan.images.push_back({row.name, row.format, row.origin, moment.view.extent});
    if (moment.preparation)
        plan.images.push_back(
            {"prepared", moment.preparation->format, Origin::frame, moment.preparation->image});
    const auto own = std::as_bytes(std::span(&moment.settings.own, 1));
    plan.buffers.push_back({"method", {own.begin(), own.end()}});
    if (!shows_alone(moment.settings)) plan.exchanged.push_back({"history_before", "history_after"});
    return plan;
}

std::vector<PlannedPass> planned_passes(Moment moment, const Plan& resources,
                                        const InterfaceOf& interface_of) {
    Values values = values_of(moment);  // of all passes, and those of the last pass alone
    std::vector<PlannedPass> passes;
    for (const PassRow& row : pass_table()) {
        const std::size_t times = row.when(moment);
        for (moment.step = 0; moment.step < times; ++moment.step) {
            for (const auto& [name, number] : row.own) values.set(name, number(moment));
            std::vector<std::string> names;
            for (const char* resource : row.resources) {
                const std::string_view name = resource_of(resource, moment);
                names.emplace_back(has(resources, name) ? name : nothing_image);
            }
            passes.push_back(planned_pass(row.own_name ? row.own_name(moment) : row.name, row.source(moment),
                                          std::move(names), values, interface_of,
                                          row.groups ? row.groups(moment) : groups_for(moment.view.extent)));
        }
    }
    return passes;
}

std::unique_ptr<FramePasses> study_passes(const backend::vulkan::Device& device,
                                          const scene::PassLibrary& passes) {
    return std::make_unique<StudyPasses>(device, passes);
}

}  // namespace gloam::effect
