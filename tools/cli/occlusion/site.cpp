// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/framework/variants.hpp"
#include "cli/occlusion/render.hpp"
#include "cli/occlusion/render_pictures.hpp"
#include "cli/occlusion/renderer.hpp"
#include "cli/progress.hpp"
#include "effect/methods.hpp"
#include "pictures/sheet.hpp"
#include "report/output.hpp"
#include "site/site.hpp"

namespace gloam::cli {
namespace {

// Which pictures of a site to render.
struct PictureOptions {
    bool pictures = true;
    std::string device;                // name or index; empty: the default
    std::vector<std::string> methods;  // each gets a picture; empty: all
};

// The device, or null where there is none.
std::unique_ptr<RenderBench> open_bench(const PictureOptions& options) {
    try {
        return std::make_unique<RenderBench>(RenderOptions{.device = options.device});
    } catch (const std::exception&) {
        if (!options.device.empty()) throw;  // it was asked for
        return nullptr;
    }
}

// The room without and with occlusion, and with the true one (page/index.html). Returns their caption.
std::string render_room(const PictureOptions& options, RenderBench& bench, report::OutputFolder& folder) {
    const RenderOptions render_options{.source = "room",
                                       .frames = 16,
                                       .still = true,
                                       .size = "960x540",
                                       .device = options.device,
                                       .trace_truth = true,
                                       .truth_rays = 64,
                                       .quiet = true};
    bench.forget_light();
    const Rendered run = render(render_options, open_input(render_options), bench, {});
    const auto [width, height] = run.last.extent;
    folder.write("room-with.png", base::to_rgb_png(run.last.shaded, width, height));
    folder.write("room-without.png", base::to_rgb_png(run.last.plain, width, height));
    folder.write("room-occlusion.png", base::to_rgb_png(run.last.visibility, width, height));
    folder.write("room-truth.png", base::to_rgb_png(run.last.truth_lit, width, height));
    return fmt::format("A room, rendered on {}: {}", bench.device.info().name, caption_of(run.report));
}

// What a method makes of the room, in the preset that the page begins with. Returns the caption of any
// method.
std::string render_method(const std::string& name, const PictureOptions& options, RenderBench& bench,
                          report::OutputFolder& folder) {
    const RenderOptions render_options{
        .source = "room",
        .method = name,
        .frames = 4,
        .still = true,
        .size = fmt::format("{}x{}", site::method_picture_width, site::method_picture_height),
        .device = options.device,
        .quiet = true};
    const Rendered run = render(render_options, open_input(render_options), bench, {});
    const Pictures& last = run.last;
    folder.write("method-" + name + ".png",
                 base::to_rgb_png(last.visibility, last.extent.width, last.extent.height));
    return fmt::format(
        "The room, {}x{} pixels: visibility after {} frames of the preset {} with this method, on {}.",
        last.extent.width, last.extent.height, run.report.frames.size(), run.report.preset,
        bench.device.info().name);
}

// The names of the methods that get a picture.
std::vector<std::string> methods_of(const PictureOptions& options) {
    std::vector<std::string> names = options.methods;
    if (names.empty())
        for (const effect::MethodInfo& method : effect::methods()) names.push_back(method.name);
    for (const std::string& name : names) (void)effect::method_named(name);
    return names;
}

// Renders the pictures of the room and of the methods into the folder. Without a Vulkan device there are
// none. Throws std::invalid_argument for an unknown method.
site::SitePictures write_site_pictures(const PictureOptions& options, report::OutputFolder& folder) {
    site::SitePictures pictures;
    const std::vector<std::string> methods = methods_of(options);
    const std::unique_ptr<RenderBench> bench = options.pictures ? open_bench(options) : nullptr;
    if (!bench) return pictures;
    pictures.room = render_room(options, *bench, folder);
    bench->forget_light();
    for (const std::string& name : methods) pictures.methods = render_method(name, options, *bench, folder);
    return pictures;
}

struct SiteCommand {
    std::filesystem::path folder;
    site::SiteOptions options;
    PictureOptions pictures;
    bool quiet = false;
};

void run_site(SiteCommand command) {
    report::OutputFolder folder(command.folder);
    command.options.files = site_directory();
    command.options.documents = documents_directory();
    command.pictures.methods = command.options.methods;
    // An unknown name is reported before the pictures are drawn, which takes longest.
    (void)catalogue::select(catalogue::all_entries(glsl_directory()), command.options.equations);
    command.options.pictures = write_site_pictures(command.pictures, folder);
    command.options.versions = versions();
    const check::Lab lab({.device = std::string(check::interpreter_name),
                          .include_roots = {glsl_directory()},
                          .cache_directory = cache_directory()});
    const std::function<void(double)> bar = command.quiet ? [](double) {} : progress_bar("checks");
    const site::SiteSummary written =
        site::write_site(lab, command.options, folder, [&bar](std::size_t done, std::size_t all) {
            bar(static_cast<double>(done) / static_cast<double>(all));
        });
    folder.keep();
    if (command.quiet) return;
    fmt::print("{}: {} checks\n", (folder.path() / "index.html").string(), written.checks);
    if (written.unsupported > 0)
        fmt::print("{} functions are no GLSL ES 3.00 and are only listed\n", written.unsupported);
    if (written.left_out > 0)
        fmt::print("{} entries have no accuracy to judge and are left out\n", written.left_out);
}

// Empty for an address that a page can be appended to, otherwise what is wrong.
std::string is_address(const std::string& text) {
    const bool starts = text.starts_with("https://") || text.starts_with("http://");
    if (starts && text.ends_with('/') && text.find_first_of(" \t\r\n") == std::string::npos) return "";
    return "\"" + text + "\": expected an address like https://example.org/gloam/";
}

}  // namespace

void add_site(CLI::App& app) {
    auto command = std::make_shared<SiteCommand>();
    CLI::App* site = app.add_subcommand(
        "site", "write a static site: the effect live, its methods, and checks of the visitor's browser");
    site->add_option("folder", command->folder, "folder for the site")->required();
    site->add_option("equation", command->options.equations, "IDs, functions or globs; none: all");
    site->add_option("--inputs", command->options.inputs, "inputs of each check")
        ->check(CLI::Range(1, 65'536))
        ->capture_default_str();
    site->add_option("--seed", command->options.seed, "of the inputs")->capture_default_str();
    site->add_option("--method", command->options.methods,
                     "methods that the page of methods shows; none: all");
    site->add_option("--address", command->options.address,
                     "address of the published site, ending in /: previews of its pages need it")
        ->check(is_address);
    site->add_flag("!--no-pictures", command->pictures.pictures, "render no pictures");
    site->add_option("--device", command->pictures.device,
                     "name or index of the device that renders the pictures (gloam devices)");
    site->add_flag("--quiet", command->quiet, "print nothing");
    site->callback([command] { run_site(*command); });
}

}  // namespace gloam::cli
