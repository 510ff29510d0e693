// SPDX-License-Identifier: MIT
#include "effect/plan.hpp"

#include "base/number.hpp"
#include "effect/internal/frame.hpp"
#include "effect/internal/study_frame.hpp"

namespace gloam::effect {

ImageName image_name_of(const std::string& resource) {
    const std::size_t slash = resource.find('/');
    if (slash == std::string::npos) return {resource, std::nullopt};
    const std::string image = resource.substr(0, slash);
    if (resource.ends_with("/linear")) return {image, std::nullopt, true};
    return {image, base::number_from<std::uint32_t>(resource.substr(slash + 1))};
}

View view_of(const PlanOptions& options) {
    constexpr double fovy = 0.9;
    scene::Camera camera{
        .target = {0.3 * fovy, 0.2 * fovy, -1.0}, .fovy_rad = fovy, .view_height = fovy, .near = 0.1 * fovy};
    if (options.orthographic) camera.projection = scene::Projection::orthographic;
    scene::Camera previous = camera;
    previous.eye = {fovy, 0.5 * fovy, 2.0 * fovy};
    const double aspect = static_cast<double>(options.view.width) / static_cast<double>(options.view.height);
    return {scene::make_frame(camera, aspect, previous), options.view, {}};
}

namespace {

// The frame in which everything runs that runs in any.
Moment moment_of(const Settings& settings, const PlanOptions& options) {
    Moment moment{.settings = settings};
    const View view = view_of(options);
    moment.look(view, view);
    if (options.encoding != scene::Encoding{}) moment.converted = options.encoding;
    moment.has_normals = options.normals;
    moment.has_positions = options.moving_objects;
    if (options.first) {
        moment.shows_unfiltered = true;
        moment.moved = false;
    }
    return moment;
}

// The planned image whose first channel is shown.
std::string shown_image(const Settings& settings) {
    const bool filtered = filters(settings);
    if (remaps(settings)) return filtered ? "filtered_mapped" : "mapped";
    return filtered || shows_alone(settings) ? "filtered" : "history_after";
}

}  // namespace

Plan plan_of(const Settings& settings, const PlanOptions& options, const scene::PassLibrary& library) {
    validate(settings);
    if (settings.passes == Passes::frame) return frame_plan(settings, options);
    Moment moment = moment_of(settings, options);
    Plan plan = planned_resources(moment);
    plan.passes = planned_passes(
        moment, plan, [&](const PassSource& source) { return module::reflect(module_of(source, library)); });
    plan.result = shown_image(settings);
    return plan;
}

}  // namespace gloam::effect
