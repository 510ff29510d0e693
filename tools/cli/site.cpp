// SPDX-License-Identifier: MIT
#include "cli/site.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "cli/environment.hpp"
#include "cli/progress.hpp"
#include "cli/site_gallery.hpp"
#include "cli/versions.hpp"
#include "report/output_folder.hpp"
#include "site/site.hpp"

namespace gloam::cli {
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
