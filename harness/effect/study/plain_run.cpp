// SPDX-License-Identifier: MIT
#include "effect/study/plain_run.hpp"

namespace gloam::effect {

PlainRun::PlainRun(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
                   SliceTaps taps, int blurs)
    : slices_(device, passes, extent, taps, blurs) {}

ConfigurationVisit PlainRun::visit(BenchmarkViews& views, CopyClock& clock, int round) {
    const BenchmarkFrames& frames = views.frames();
    const auto radius = static_cast<float>(views.scene().ao_radius);
    if (round > 0) {
        slices_.take(views.view(views.first_scored() + round % frames.scored, {}), radius);
        const double copy = clock.measure();
        const PlainFrame frame = slices_.next();
        return {.readings = {{{{"plain_slices", frame.slices_ms}, {"plain_blur", frame.blur_ms}}, copy}}};
    }
    FrameQuality sum;
    for (int i = views.first_scored(); i < frames.frames; ++i) {
        slices_.take(views.view(i, {}), radius);
        const PlainFrame frame = slices_.next();
        const Truth& truth = views.scored(i).geometry;
        sum.raw_geometry += errors_of(frame.occlusion, truth).rmse / frames.scored;
        const Errors shown = errors_of(frame.blurred, truth);
        sum.geometry += shown.rmse / frames.scored;
        sum.bias += shown.bias / frames.scored;
    }
    return {.quality = sum};
}

}  // namespace gloam::effect
