// SPDX-License-Identifier: MIT
#include "cli/render_gallery.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gloam::cli {
namespace {

// Writes one picture and returns its file name.
std::string write(report::OutputFolder& folder, const Pictures& pictures, const std::string& name,
                  const report::RgbBytes& rgb) {
    folder.write(name, report::to_rgb_png(rgb, pictures.extent.width, pictures.extent.height));
    return name;
}

report::PageTable comparison(const std::vector<Rendered>& runs) {
    report::PageTable table{
        .columns = {{.title = "method"},
                    {.title = "ms",
                     .meaning = "time of all passes of the last frame on the device",
                     .numeric = true},
                    {.title = "error",
                     .meaning = "root mean square error of the occlusion against the truth, 0 to 1",
                     .numeric = true},
                    {.title = "samples", .meaning = "taken for each pixel in a frame", .numeric = true}},
        .rows = {}};
    for (const Rendered& run : runs) {
        const effect::Settings& settings = run.report.frames.back().settings;
        const double ms = frame_ms(run.report);
        const auto error = frame_error(run.report);
        table.rows.push_back({{settings.method},
                              {std::isfinite(ms) ? fmt::format("{:.3f}", ms) : "-", ms},
                              {error ? fmt::format("{:.4f}", *error) : "-", error},
                              {fmt::format("{}", settings.samples), static_cast<double>(settings.samples)}});
    }
    return table;
}

}  // namespace

void add_pictures(report::Page& page, report::OutputFolder& folder, const std::string& prefix,
                  const Rendered& run) {
    const Pictures& last = run.pictures.back();
    const std::string plain = write(folder, last, prefix + "plain.png", last.plain);
    const std::string shaded = write(folder, last, prefix + "shaded.png", last.shaded);
    page.compare({plain, "without ambient occlusion"}, {shaded, "with ambient occlusion"},
                 caption_of(run.report));
    std::vector<report::PagePicture> more{
        {write(folder, last, prefix + "visibility.png", last.visibility), "the occlusion alone"}};
    if (!last.error.empty()) {
        more.push_back({write(folder, last, prefix + "error.png", last.error),
                        fmt::format("its error: black 0, pale yellow {} and more", brightest_error)});
    }
    page.pictures(more);
    if (run.pictures.size() < 2) return;
    std::vector<report::PagePicture> views;
    for (const Pictures& view : run.pictures) {
        const std::string name = fmt::format("{}view{:04}.png", prefix, views.size());
        views.push_back({write(folder, view, name, view.shaded), fmt::format("view {}", views.size())});
    }
    page.turntable(views, fmt::format("{} views around it", views.size()));
}

void write_gallery(report::OutputFolder& folder, const std::vector<Rendered>& runs) {
    const RenderReport& first = runs.front().report;
    report::Page page(fmt::format("{}: ambient occlusion", first.source));
    page.paragraph(fmt::format("Rendered on {}.{}", first.device.name,
                               first.truth.empty() ? "" : " The truth is the " + first.truth + "."));
    if (runs.size() > 1) page.table(comparison(runs));
    for (const Rendered& run : runs) {
        const std::string method = run.report.frames.back().settings.method;
        page.heading(method);
        add_pictures(page, folder, method + "_", run);
    }
    folder.write("index.html", page.html());
}

}  // namespace gloam::cli
