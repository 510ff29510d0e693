// SPDX-License-Identifier: MIT
#include "cli/render_truth.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/environment.hpp"
#include "cli/progress.hpp"
#include "report/image.hpp"

namespace gloam::cli {

TruthSource::TruthSource(const RenderOptions& options, const RenderInput& input)
    : options_(options), input_(input) {
    const auto falloff = scene::falloff_named(options.truth_falloff);
    if (!falloff) {
        throw std::invalid_argument(
            fmt::format("--truth-falloff \"{}\": expected linear, quadratic or step", options.truth_falloff));
    }
    falloff_ = *falloff;
    if (options.truth_every && !options.trace_truth)
        throw std::invalid_argument("--truth-every goes with --truth that is traced, without a file");
    if (options.trace_truth) {
        scene::validate(scene::RaySettings{.radius = 1.0, .falloff = falloff_, .rays = options.truth_rays});
        if (!(options.truth_thickness > 0.0)) {
            throw std::invalid_argument(
                fmt::format("--truth-thickness {}: expected > 0", options.truth_thickness));
        }
    } else if (!options.truth.empty()) {
        reference_ = scene::read_pfm(options.truth);
    }
}

std::string TruthSource::name() const {
    if (options_.trace_truth) return input_.scene ? "traced geometry" : "traced depth buffer";
    return reference_ ? options_.truth : input_.truth_name;
}

bool TruthSource::every_view() const {
    return options_.trace_truth ? options_.truth_every : !reference_;
}

TracedView TruthSource::traced(const scene::GBuffer& view, int frame, double radius) const {
    const scene::TruthCache kept(truth_cache_directory());
    const auto settings = [&](const char* what) {
        return scene::TruthSettings{
            .rays = {.radius = radius, .falloff = falloff_, .rays = options_.truth_rays},
            .thickness = options_.truth_thickness,
            .progress = progress_bar(fmt::format("{}: truth of the {}", input_.name, what))};
    };
    TracedView result;
    if (input_.scene) {
        result.geometry = kept.geometry(*input_.scene, frame, view, settings("geometry"));
    }
    result.depth = kept.depth(view, settings("depth buffer"));
    return result;
}

ViewTruth TruthSource::of(const scene::GBuffer& view, int frame, double radius) const {
    if (options_.trace_truth) {
        ViewTruth result{.traced = traced(view, frame, radius)};
        const scene::TracedTruth& best =
            result.traced->geometry ? *result.traced->geometry : result.traced->depth;
        result.truth = effect::truth_from(view, best.occlusion);
        return result;
    }
    if (!reference_) {
        return {.truth = input_.truth ? effect::truth_of(view, radius, input_.truth) : effect::Truth{}};
    }
    if (reference_->extent == view.extent && reference_->channels == 1)
        return {.truth = effect::truth_from(view, reference_->texels)};
    throw std::invalid_argument(fmt::format(
        "{}: {} x {} with {} channels, expected {} x {} with 1", options_.truth, reference_->extent.width,
        reference_->extent.height, reference_->channels, view.extent.width, view.extent.height));
}

void write_truth(report::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                 const TracedView& traced) {
    const auto write = [&](const std::string& name, const std::vector<float>& image) {
        folder.write(prefix + name + ".pfm", report::to_pfm(image, size.width, size.height, 1));
        folder.write(prefix + name + ".png", report::to_visibility_png(image, size.width, size.height));
    };
    const scene::TracedTruth& best = traced.geometry ? *traced.geometry : traced.depth;
    write("truth", best.occlusion);
    write("truth_depth", traced.depth.occlusion);
    folder.write(prefix + "truth_error.pfm", report::to_pfm(best.standard_error, size.width, size.height, 1));
}

}  // namespace gloam::cli
