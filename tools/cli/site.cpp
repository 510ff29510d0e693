// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/progress.hpp"
#include "cli/render.hpp"
#include "cli/render_pictures.hpp"
#include "cli/renderer.hpp"
#include "cli/site_gallery.hpp"
#include "report/output.hpp"
#include "site/site.hpp"

namespace gloam::cli {
namespace {

using nlohmann::ordered_json;

struct Shown {
    const char* name;
    const char* title;
};

// Scenes that show much occlusion, each in its own light.
constexpr Shown scenes[] = {{"columns", "A hall of columns, lit by a lamp"},
                            {"knot", "A knot on a plane, in the sun"},
                            {"room", "A room, lit by a lamp"}};

ordered_json empty_gallery(const std::string& reason) {
    return {{"device", "There are no pictures: " + reason}, {"scenes", ordered_json::array()}};
}

// Writes pictures and counts their bytes.
class PictureFolder {
  public:
    explicit PictureFolder(report::OutputFolder& folder) : folder_(folder) {}

    // Returns the name.
    std::string write(const std::string& name, const report::RgbBytes& rgb, gpu::Extent extent) {
        const std::string png = report::to_rgb_png(rgb, extent.width, extent.height);
        folder_.write(name, png);
        bytes_ += png.size();
        return name;
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    report::OutputFolder& folder_;
    std::size_t bytes_ = 0;
};

ordered_json render_scene(const Shown& shown, const GalleryOptions& options, RenderBench& bench,
                          PictureFolder& folder) {
    const RenderOptions render_options{
        .source = shown.name, .frames = 16, .size = "640x360", .device = options.device, .quiet = true};
    const RenderInput input = open_input(render_options);
    bench.forget_light();
    const Rendered run = render(render_options, input, bench, {});
    const Pictures& last = run.pictures.back();
    const std::string prefix = std::string("gallery-") + shown.name + "-";
    return {{"title", shown.title},
            {"before", folder.write(prefix + "plain.png", last.plain, last.extent)},
            {"after", folder.write(prefix + "shaded.png", last.shaded, last.extent)},
            {"occlusion", folder.write(prefix + "occlusion.png", last.visibility, last.extent)},
            {"caption", caption_of(run.report)}};
}

// The device, or why there is none.
std::unique_ptr<RenderBench> open_bench(const GalleryOptions& options, std::string& reason) {
    try {
        return std::make_unique<RenderBench>(RenderOptions{.device = options.device});
    } catch (const std::exception& error) {
        if (!options.device.empty()) throw;  // it was asked for
        reason = base::one_line(error.what());
        return nullptr;
    }
}

}  // namespace

SiteGallery write_site_gallery(const GalleryOptions& options, report::OutputFolder& folder) {
    if (!options.pictures) return {empty_gallery("the site was written without them.").dump()};
    std::string reason;
    const std::unique_ptr<RenderBench> bench = open_bench(options, reason);
    if (!bench) return {empty_gallery(reason).dump()};
    ordered_json json{{"device", "Rendered on " + bench->device.info().name + "."},
                      {"scenes", ordered_json::array()}};
    PictureFolder pictures(folder);
    for (const Shown& shown : scenes)
        json["scenes"].push_back(render_scene(shown, options, *bench, pictures));
    return {json.dump(), pictures.bytes()};
}

namespace {

struct SiteCommand {
    std::filesystem::path folder;
    site::SiteOptions options;
    GalleryOptions gallery;
    bool quiet = false;
};

void run_site(SiteCommand command) {
    report::OutputFolder folder(command.folder);
    command.options.files = site_directory();
    command.options.documents = documents_directory();
    const SiteGallery gallery = write_site_gallery(command.gallery, folder);
    command.options.gallery = gallery.json;
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
    fmt::print("{}: {} checks, {:.1f} MB\n", (folder.path() / "index.html").string(), written.checks,
               static_cast<double>(written.bytes + gallery.bytes) / 1e6);
    if (written.unsupported > 0)
        fmt::print("{} functions are no GLSL ES 3.00 and are only listed\n", written.unsupported);
    if (written.left_out > 0)
        fmt::print("{} entries have no accuracy to judge and are left out\n", written.left_out);
}

}  // namespace

void add_site(CLI::App& app) {
    auto command = std::make_shared<SiteCommand>();
    CLI::App* site = app.add_subcommand("site", "write a static site that checks the browser of its visitor");
    site->add_option("folder", command->folder, "folder for the site")->required();
    site->add_option("equation", command->options.equations, "IDs, functions or globs; none: all");
    site->add_option("--inputs", command->options.inputs, "inputs of each check")
        ->check(CLI::Range(1, 65'536))
        ->capture_default_str();
    site->add_option("--seed", command->options.seed, "of the inputs")->capture_default_str();
    site->add_option(
            "--measured", command->options.measured,
            "Markdown of gloam bench, gloam report --accuracy or gloam pack --lines, for the page of "
            "measurements")
        ->check(CLI::ExistingFile);
    site->add_flag("!--no-pictures", command->gallery.pictures, "render no pictures for the gallery");
    site->add_option("--device", command->gallery.device,
                     "name or index of the device that renders the pictures (gloam devices)");
    site->add_flag("--quiet", command->quiet, "print nothing");
    site->callback([command] { run_site(*command); });
}

}  // namespace gloam::cli
