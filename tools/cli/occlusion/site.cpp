// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/render.hpp"
#include "cli/progress.hpp"
#include "effect/methods.hpp"
#include "pictures/sheet.hpp"
#include "report/output.hpp"
#include "site/site.hpp"

namespace gloam::cli {
namespace {

struct SiteCommand {
    std::filesystem::path folder;
    site::SiteOptions options;
    std::vector<std::string> equations;  // IDs, functions or globs; empty: all
    std::vector<std::string> methods;    // that are shown; empty: all
    bool pictures = true;
    std::string device;  // name or index; empty: the default
    bool quiet = false;
};

// The device that renders the pictures, or null where there is none.
std::unique_ptr<RenderBench> open_bench(const SiteCommand& command) {
    if (!command.pictures) return nullptr;
    try {
        return std::make_unique<RenderBench>(RenderOptions{.device = command.device});
    } catch (const std::exception&) {
        if (!command.device.empty()) throw;  // it was asked for
        return nullptr;
    }
}

// The same view of the room each time.
Rendered render_room(RenderOptions options, RenderBench& bench) {
    options.source = "room";
    options.still = options.quiet = true;
    return render(options, open_input(options), bench, {});
}

// Renders the pictures of the room (page/index.html) and of the methods, in the preset that the page begins
// with, into the folder. Without a Vulkan device there are none.
site::SitePictures write_site_pictures(const SiteCommand& command, report::OutputFolder& folder) {
    site::SitePictures captions;
    const std::unique_ptr<RenderBench> bench = open_bench(command);
    if (!bench) return captions;
    const std::string device = bench->device.info().name;
    const auto write = [&folder](const std::string& name, const Pictures& of, const base::RgbBytes& picture) {
        folder.write(name + ".png", base::to_rgb_png(picture, of.extent.width, of.extent.height));
    };
    const Rendered room =
        render_room({.frames = 16, .size = "960x540", .trace_truth = true, .truth_rays = 64}, *bench);
    write("room-with", room.last, room.last.shaded);
    write("room-without", room.last, room.last.plain);
    write("room-occlusion", room.last, room.last.visibility);
    write("room-truth", room.last, room.last.truth_lit);
    captions.room = fmt::format("A room, rendered on {}: {}", device, caption_of(room.report));
    bench->forget_light();
    for (const effect::MethodInfo& method : command.options.methods) {
        const Rendered run = render_room(
            {.method = method.name,
             .frames = 4,
             .size = fmt::format("{}x{}", site::method_picture_width, site::method_picture_height)},
            *bench);
        write("method-" + method.name, run.last, run.last.visibility);
        captions.methods = fmt::format(
            "The room, {}x{} pixels: visibility after {} frames of the preset {} with this method, on {}.",
            run.last.extent.width, run.last.extent.height, run.report.frames.size(), run.report.preset,
            device);
    }
    return captions;
}

void run_site(SiteCommand command) {
    report::OutputFolder folder(command.folder);
    command.options.files = site_directory();
    command.options.documents = documents_directory();
    for (const std::string& name : command.methods)
        command.options.methods.push_back(effect::method_named(name));
    if (command.methods.empty()) command.options.methods = effect::methods();
    // Before the pictures are drawn, which takes longest: an unknown name is reported here.
    command.options.entries = catalogue::select(catalogue::all_entries(glsl_directory()), command.equations);
    command.options.pictures = write_site_pictures(command, folder);
    command.options.versions = versions();
    const check::Lab lab({.device = std::string(check::interpreter_name),
                          .include_roots = {glsl_directory()},
                          .cache_directory = cache_directory()});
    const site::SiteSummary written =
        site::write_site(lab, command.options, folder, progress_bar("checks", !command.quiet));
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
    site->add_option("equation", command->equations, "IDs, functions or globs; none: all");
    site->add_option("--inputs", command->options.inputs, "inputs of each check")
        ->check(CLI::Range(1, 65'536))
        ->capture_default_str();
    site->add_option("--seed", command->options.seed, "of the inputs")->capture_default_str();
    site->add_option("--method", command->methods, "methods that the page of methods shows; none: all");
    site->add_option("--address", command->options.address,
                     "address of the published site, ending in /: previews of its pages need it")
        ->check(is_address);
    site->add_flag("!--no-pictures", command->pictures, "render no pictures");
    site->add_option("--device", command->device,
                     "name or index of the device that renders the pictures (gloam devices)");
    site->add_flag("--quiet", command->quiet, "print nothing");
    site->callback([command] { run_site(*command); });
}

}  // namespace gloam::cli
