// SPDX-License-Identifier: MIT
#include "cli/bench/temporal_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/image.hpp"
#include "report/plot.hpp"

namespace gloam::cli {
namespace {

using namespace effect;

constexpr double full_error = 0.1;  // as bright as the scale of the error maps goes

report::Curve curve_of(const std::string& name, const std::vector<int>& frames,
                       const std::vector<Score>& scores, PixelClass which) {
    report::Curve curve{.name = name};
    for (std::size_t i = 0; i < scores.size(); ++i)
        curve.points.emplace_back(frames[i], scores[i].rmse_filtered(Against::limit, which));
    return curve;
}

report::Plot convergence_plot(const TemporalReport& report) {
    report::Plot plot{.title = report.scene + ", still view",
                      .x = "samples",
                      .y = "RMSE against the limit",
                      .logarithmic = true};
    report::Curve raw{.name = "raw"};
    report::Curve filtered{.name = "filtered"};
    report::Curve independent{.name = "independent samples"};
    const double first = report.still.front().raw[0] * std::sqrt(report.still.front().samples);
    for (std::size_t i = 0; i < report.still.size(); ++i) {
        if (i >= 64 && i % 16 != 0) continue;  // a long run needs no more
        const StillFrame& frame = report.still[i];
        raw.points.emplace_back(frame.samples, frame.raw[0]);
        filtered.points.emplace_back(frame.samples, frame.filtered[0]);
        independent.points.emplace_back(frame.samples, first / std::sqrt(frame.samples));
    }
    plot.curves = {raw, filtered, independent};
    return plot;
}

// Errors of a class, frame by frame; nullopt where the scene has no such pixels.
std::optional<report::Plot> class_plot(const TemporalReport& report, PixelClass which) {
    const MotionStudy& study = report.motion;
    if (std::isnan(total(study.single).rmse_filtered(Against::limit, which))) return std::nullopt;
    report::Plot plot{.title = fmt::format("{}, {} pixels, filtered", report.scene, name_of(which)),
                      .x = "frame",
                      .y = "RMSE against the limit"};
    for (const MotionRun& run : study.runs) {
        const std::string& name = run.variant.name;
        if (name == "full" || name == "preset moving" || name == "neighbourhood (9)")
            plot.curves.push_back(curve_of(name == "full"            ? name
                                           : name == "preset moving" ? name
                                                                     : "without (9)",
                                           study.frames, run.scores, which));
    }
    plot.curves.push_back(curve_of("single frame", study.frames, study.single, which));
    plot.curves.push_back(curve_of("same view, still", study.frames, study.still, which));
    return plot;
}

void write_last(report::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                const MotionRun& run, const Truth& limit) {
    const Frame& frame = run.last;
    std::vector<float> errors;
    for (std::size_t i = 0; i < limit.size(); ++i) errors.push_back(std::abs(frame.filtered[i] - limit[i]));
    const auto heat = [&](const char* name, const std::vector<float>& values, double full) {
        folder.write(prefix + name, report::to_heat_png(values, size.width, size.height, full));
    };
    folder.write(prefix + "ao.png", report::to_visibility_png(frame.filtered, size.width, size.height));
    heat("error.png", errors, full_error);
    heat("convergence.png", frame.convergence, 1.0);
    heat("samples.png", frame.kept, double{run.variant.settings.weight_max});
}

}  // namespace

void write_pictures(report::OutputFolder& folder, const TemporalReport& report) {
    const MotionStudy& study = report.motion;
    folder.write(report.scene + "-convergence.svg", report::to_svg(convergence_plot(report)));
    for (const PixelClass which : {PixelClass::settled, PixelClass::disoccluded, PixelClass::near_moving}) {
        if (const auto plot = class_plot(report, which))
            folder.write(fmt::format("{}-{}.svg", report.scene, name_of(which)), report::to_svg(*plot));
    }
    folder.write(report.scene + "-limit-ao.png",
                 report::to_visibility_png(study.last[0], report.extent.width, report.extent.height));
    for (const MotionRun& run : study.runs) {
        const std::string& name = run.variant.name;
        if (name == "full") write_last(folder, report.scene + "-full-", report.extent, run, study.last[0]);
        if (name == "preset moving")
            write_last(folder, report.scene + "-moving-", report.extent, run, study.last[0]);
        if (name == "neighbourhood (9)")
            write_last(folder, report.scene + "-without-9-", report.extent, run, study.last[0]);
    }
}

}  // namespace gloam::cli
