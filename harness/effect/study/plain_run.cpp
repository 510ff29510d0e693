// SPDX-License-Identifier: MIT
#include "effect/study/plain_run.hpp"

#include <utility>

namespace gloam::effect {
namespace {

// The part of one of the scored frames in the means.
void add(FrameQuality& mean, const PlainFrame& frame, const Truth& truth, int scored) {
    mean.raw_geometry += errors_of(frame.occlusion, truth).rmse / scored;
    const Errors shown = errors_of(frame.blurred, truth);
    mean.geometry += shown.rmse / scored;
    mean.bias += shown.bias / scored;
}

}  // namespace

PlainRun::PlainRun(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
                   SliceTaps taps, int blurs)
    : slices_(device, passes, extent, taps, blurs) {}

ConfigurationVisit PlainRun::visit(BenchmarkViews& views, CopyClock& clock, int round) {
    const BenchmarkFrames& frames = views.frames();
    const auto radius = static_cast<float>(views.scene().ao_radius);
    ConfigurationVisit visit;
    FrameQuality sum;
    for (int i = views.first_scored(); i < frames.frames; ++i) {
        slices_.take(views.view(i, {}), radius);
        const double copy = round > 0 ? clock.measure() : 0.0;
        PlainFrame frame = slices_.next(round > 0 ? frames.repeat : 1);
        if (round > 0) {
            visit.readings.push_back(
                {{{"plain_slices", frame.slices_ms}, {"plain_blur", frame.blur_ms}}, copy});
            continue;
        }
        if (frames.rays > 0) add(sum, frame, views.scored(i).geometry, frames.scored);
        visit.shown = std::move(frame.blurred);
    }
    if (round == 0 && frames.rays > 0) visit.quality = sum;
    return visit;
}

}  // namespace gloam::effect
