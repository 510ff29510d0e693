// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// Debian's glmark2-data.
constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";
constexpr std::size_t few_inputs = 4096;
constexpr std::size_t most_named = 3;  // failures

struct DemoOptions {
    std::string device;
    fs::path out = "gloam-demo";
    bool quiet = false;
};

// A scene of the demo, rendered.
struct Shown {
    std::string name;
    std::string what;
    Rendered run;
};

// Prints and flushes a line, because the next step takes time.
void say(const DemoOptions& demo, const std::string& line) {
    if (demo.quiet) return;
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

std::vector<Shown> demo_scenes() {
    std::error_code none;
    return {{"room", "a furnished room, seen by a camera that moves", {}},
            {fs::is_regular_file(bunny, none) ? "bunny" : "knot", "a mesh on a plane, in the sun", {}},
            {"moving", "a rolling ball and a turning box, followed with their history", {}}};
}

void render_scene(Shown& scene, const DemoOptions& demo, const backend::vulkan::Device& device) {
    const RenderOptions options = demo_options(scene.name == "bunny" ? bunny : scene.name, demo.quiet);
    scene.run = std::move(render(options, open_input(options), device, nullptr).front());
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

record::Page page_of(const std::vector<Shown>& scenes, record::OutputFolder& out) {
    record::Page page("gloam demo");
    page.paragraph(
        "Ambient occlusion, rendered on " + scenes.front().run.report["device"]["name"].get<std::string>() +
        ". Choose above each picture: the light with ambient occlusion, without it, and more. The error "
        "is the root mean square error against occlusion traced with rays.");
    for (const Shown& scene : scenes) {
        page.heading(scene.name + ": " + scene.what);
        add_pictures(page, out, scene.name + "_", scene.run);
    }
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
    std::vector<Shown> scenes = demo_scenes();
    for (Shown& scene : scenes) {
        render_scene(scene, demo, device);
        if (&scene != &scenes.front()) continue;
        out.write("sheet.png", sheet_of({scene.run}));
        out.keep();
        say(demo, "sheet     " + (folder / "sheet.png").string() + " (one picture)");
    }
    record::Page page = page_of(scenes, out);
    out.write("index.html", page.html());
    out.keep();
    const Rendered& first = scenes.front().run;
    say(demo, fmt::format("pictures  {} scenes of {} x {} pixels: a frame of the {} takes {:.3g} ms, its "
                          "occlusion is {:.3f} off the truth",
                          scenes.size(), first.frame.extent.width, first.frame.extent.height,
                          scenes.front().name, first.ms(), first.error.value_or(0.0)));
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
                  " (pictures, the live effect, and the check's table)");
    say(demo, "next      gloam check --help, gloam render --help");
    return std::max(validation_status(device), outcome.counts.exit_status());
}

}  // namespace

Command demo_command() {
    static DemoOptions options;
    return {
        .name = "demo",
        .about = "render three scenes, check the default device, make a page of both, with the live effect",
        .options = {device_option(options.device),
                    {"--out", &options.out, "folder for the page and its pictures"},
                    {"--quiet", &options.quiet, "print nothing but errors"},
                    driver_option()},
        .run = [] { return run_demo(options); },
        .examples = "  gloam demo --out first-look\n"};
}

}  // namespace gloam::cli
