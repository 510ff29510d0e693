// SPDX-License-Identifier: MIT
#include "cli/render_pictures.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/render_files.hpp"
#include "report/sheet.hpp"

namespace gloam::cli {
namespace {

constexpr std::size_t methods_in_a_row = 4;

std::string png_of(const Pictures& pictures, const report::RgbBytes& rgb) {
    return report::to_rgb_png(rgb, pictures.extent.width, pictures.extent.height);
}

std::vector<report::SheetPicture> pictures_of_one(const Rendered& run) {
    const Pictures& last = run.pictures.back();
    std::vector<report::SheetPicture> sheet{{last.plain, "Light without ambient occlusion"},
                                            {last.shaded, "With ambient occlusion"},
                                            {last.visibility, "Occlusion alone: " + caption_of(run.report)}};
    if (!last.error.empty()) {
        sheet.push_back({last.error, fmt::format("Error against the truth: black 0, pale yellow {} and more",
                                                 brightest_error)});
    }
    return sheet;
}

}  // namespace

Pictures pictures_of(const effect::Composite& composite, std::string name, gpu::Extent extent,
                     const scene::SplitLight& light, const std::vector<float>& occlusion,
                     const effect::Truth& truth) {
    Pictures pictures{.name = std::move(name),
                      .extent = extent,
                      .plain = report::srgb_of(components_of(composite.lit(extent, light, {}))),
                      .shaded = report::srgb_of(components_of(composite.lit(extent, light, occlusion))),
                      .visibility = report::visibility_rgb(occlusion),
                      .truth = {},
                      .error = {}};
    if (truth.empty()) return pictures;
    pictures.truth = report::visibility_rgb(truth);
    std::vector<float> errors;
    for (std::size_t i = 0; i < truth.size(); ++i) errors.push_back(std::abs(occlusion[i] - truth[i]));
    pictures.error = report::heat_rgb(errors, brightest_error);
    return pictures;
}

void write_pictures(report::OutputFolder& folder, const Pictures& pictures) {
    folder.write(pictures.name + "_plain.png", png_of(pictures, pictures.plain));
    folder.write(pictures.name + "_shaded.png", png_of(pictures, pictures.shaded));
    if (!pictures.error.empty()) folder.write(pictures.name + "_error.png", png_of(pictures, pictures.error));
}

double frame_ms(const RenderReport& report) {
    double sum = 0.0;
    for (const effect::PassTime& time : report.frames.back().times) sum += time.ms;
    return sum;
}

std::optional<double> frame_error(const RenderReport& report) {
    const auto& errors = report.frames.back().errors;
    if (!errors) return std::nullopt;
    return errors->filtered.rmse;
}

std::string caption_of(const RenderReport& report) {
    std::string text = report.frames.back().settings.method;
    if (const double ms = frame_ms(report); std::isfinite(ms)) text += fmt::format(", {:.3g} ms", ms);
    if (const auto error = frame_error(report)) text += fmt::format(", error {:.3f}", *error);
    return text;
}

std::string sheet_of(const std::vector<Rendered>& runs) {
    std::vector<report::SheetPicture> sheet;
    if (runs.size() == 1) {
        sheet = pictures_of_one(runs.front());
    } else {
        if (!runs.empty() && !runs.front().pictures.back().truth.empty())
            sheet.push_back({runs.front().pictures.back().truth, "truth: " + runs.front().report.truth});
        for (const Rendered& run : runs)
            sheet.push_back({run.pictures.back().visibility, caption_of(run.report)});
    }
    const gpu::Extent extent = runs.empty() ? gpu::Extent{} : runs.front().pictures.back().extent;
    const std::size_t columns = runs.size() == 1 ? 2 : methods_in_a_row;
    return report::to_sheet_png(sheet, extent.width, extent.height, columns);
}

}  // namespace gloam::cli
