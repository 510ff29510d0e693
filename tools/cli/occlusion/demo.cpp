// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/files.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/render.hpp"
#include "cli/progress.hpp"
#include "effect/methods.hpp"
#include "pictures/plot.hpp"
#include "record/check_report.hpp"
#include "record/page.hpp"
#include "site/site.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t few_inputs = 4096;
constexpr std::size_t most_named = 3;  // failures

struct DemoOptions {
    std::string device;
    fs::path out = "gloam-demo";
    bool quiet = false;
};

// Prints and flushes a line, because the next step takes time.
void say(const DemoOptions& demo, const std::string& line) {
    if (demo.quiet) return;
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

// The picture's error, with the command that prints it, and what its tiles are.
std::string caption_of(const RenderOptions& options, const Rendered& run) {
    const effect::TileShares tiles = effect::shares_of(run.frame.tiles);
    return fmt::format(
        "Error {:.4f} (root mean square, against rays), as gloam bench views --view {} --single {} --size {} "
        "--frames 1 --no-depth-truth prints it. Tiles of 8 x 8 pixels: {:.0f} % in full (orange), "
        "{:.0f} % at half size (white), {:.0f} % not at all (blue, green).",
        run.error.value(), options.shown.source, options.presets.front(), options.shown.size,
        100.0 * tiles.full, 100.0 * tiles.half, 100.0 * (tiles.background + tiles.below_pixel));
}

// Time against error: each preset as `gloam bench presets` has measured it.
std::string presets_plot() {
    std::vector<pictures::PlotPoint> points;
    for (const effect::Preset& preset : effect::presets())
        points.push_back({preset.name, preset.time, preset.error, !preset.published});
    return "<figure>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Time and error\">\n" +
           pictures::to_plot_svg(points, "time of a frame, in that of fast (llvmpipe)", "error") +
           "</div>\n<figcaption>gloam's own presets in blue, published ones in grey; error: root mean square "
           "against ray-traced occlusion, of sequences on unseen views (gloam bench presets).</figcaption>\n"
           "</figure>\n";
}

// The guides as texts beside the page, with a link to each.
void add_guides(record::Page& page, record::OutputFolder& out) {
    constexpr std::pair<const char*, const char*> guides[]{{"copy-a-shader", "Copy a shader"},
                                                           {"testing", "Test a function"},
                                                           {"judge-a-driver", "Judge a driver"}};
    page.heading("Guides");
    for (const auto& [name, title] : guides) {
        out.write(fmt::format("{}.txt", name),
                  base::read_file(data_directory("docs") / fmt::format("{}.md", name)));
        page.markup(fmt::format("<p><a href=\"{}.txt\">{}</a></p>\n", name, title));
    }
}

// The time of a frame, on devices that have timestamps.
std::string time_of(const Rendered& run) {
    return std::isfinite(run.ms()) ? fmt::format("{:.3g} ms a frame", run.ms()) : "no timestamps";
}

record::Page page_of(const RenderOptions& options, const Rendered& run, record::OutputFolder& out) {
    record::Page page("gloam demo");
    page.paragraph(fmt::format("Ambient occlusion whose error is known. The view {} on {}: preset {}, {}.",
                               options.shown.source, run.report["device"]["name"].get<std::string>(),
                               options.presets.front(), time_of(run)));
    add_pictures(page, out, run, caption_of(options, run));
    site::add_live_effect(page, out, glsl_directory(), data_directory("site"));
    page.heading("Time and error");
    page.markup(presets_plot());
    add_guides(page, out);
    return page;
}

void add_check(record::Page& page, const CheckOutcome& outcome) {
    page.markup("<details class=\"fold\"><summary>The check: " + to_text(outcome.counts) + "</summary>\n");
    page.paragraph(
        fmt::format("Every equation of the library ran on this device with {} inputs, and each result was "
                    "compared with the equation in double precision.",
                    few_inputs));
    page.table(record::check_table(outcome.reports));
    page.markup("</details>\n");
}

std::string check_line(const CheckOutcome& outcome) {
    const record::OutcomeCounts& counts = outcome.counts;
    std::string said = "all are as exact as they document";
    if (counts.not_judged > 0)
        said = fmt::format("{} could not be judged, all others are as exact as they document",
                           counts.not_judged);
    if (counts.failed > 0) {
        std::vector<std::string> names;
        for (const record::CheckReport& report : outcome.reports)
            for (const judge::Answer& row : report.rows)
                if (row.failed() && names.size() < most_named) names.push_back(row.function);
        if (counts.failed > most_named) names.emplace_back("...");
        said = fmt::format("{} failed ({})", counts.failed, fmt::join(names, ", "));
    }
    return fmt::format("check     {} equations, {} inputs each: {}", counts.checks, few_inputs,
                       colored(said, counts.failed == 0 ? Ink::good : Ink::bad));
}

// The pictures come first, beginning with the sheet, because the check takes longer than all of them.
int run_demo(const DemoOptions& demo) {
    record::OutputFolder out(demo.out);
    const fs::path folder = fs::absolute(demo.out);
    backend::vulkan::Device device = open_device(demo.device, false);
    say(demo, "device    " + device.info().name);
    const RenderOptions options = demo_options(demo.quiet);
    const Rendered run = render(options, open_input(options), device, nullptr).front();
    out.write("sheet.png", sheet_of({run}));
    out.keep();
    say(demo, "sheet     " + (folder / "sheet.png").string() + " (one picture)");
    record::Page page = page_of(options, run, out);
    out.write("index.html", page.html());
    out.keep();
    say(demo, fmt::format("picture   {}, {} pixels, {}: {}, its occlusion is {:.4f} off the truth",
                          options.shown.source, options.shown.size, options.presets.front(), time_of(run),
                          run.error.value()));
    const CheckOutcome outcome = check({.named = equations_named,
                                        .task = {.run = {.inputs = few_inputs}},
                                        .device = demo.device,
                                        .rows = false,
                                        .progress = !demo.quiet});
    add_check(page, outcome);
    out.write("index.html", page.html());
    out.keep();
    say(demo, check_line(outcome));
    say(demo, "look at   " + (folder / "index.html").string() +
                  " (the picture, the live effect, and the check's table)");
    say(demo, "next      gloam check --help, gloam render --help");
    return std::max(validation_status(device), outcome.counts.exit_status());
}

}  // namespace

Command demo_command() {
    static DemoOptions options;
    return {.name = "demo",
            .about = "render a view, check the default device, make a page of both, with the live effect",
            .options = {device_option(options.device),
                        {"--out", &options.out, "folder for the page and its pictures"},
                        {"--quiet", &options.quiet, "print nothing but errors"},
                        driver_option()},
            .run = [] { return run_demo(options); },
            .examples = "  gloam demo --out first-look\n"};
}

}  // namespace gloam::cli
