// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/progress.hpp"
#include "cli/site_pictures.hpp"
#include "report/output.hpp"
#include "shader/steps.hpp"
#include "site/site.hpp"

namespace gloam::cli {
namespace {

struct SiteCommand {
    std::filesystem::path folder;
    site::SiteOptions options;
    PictureOptions pictures;
    std::optional<std::uint64_t> changes;  // seed of the metamorphic changes of WebGPU's kernels
    bool quiet = false;
};

void run_site(SiteCommand command) {
    report::OutputFolder folder(command.folder);
    command.options.files = site_directory();
    command.options.documents = documents_directory();
    command.pictures.methods = command.options.methods;
    const RenderedPictures pictures = write_site_pictures(command.pictures, folder);
    command.options.pictures = pictures.of_site;
    command.options.versions = versions();
    const std::string variant =
        command.changes ? fmt::format("shipped{}metamorphic {}", shader::step_separator, *command.changes)
                        : "shipped";
    const check::Lab lab({.device = std::string(check::interpreter_name),
                          .include_roots = {glsl_directory()},
                          .cache_directory = cache_directory(),
                          .variant = shader::variant(variant)});
    const std::function<void(double)> bar = command.quiet ? [](double) {} : progress_bar("checks");
    const site::SiteSummary written =
        site::write_site(lab, command.options, folder, [&bar](std::size_t done, std::size_t all) {
            bar(static_cast<double>(done) / static_cast<double>(all));
        });
    folder.keep();
    if (command.quiet) return;
    fmt::print("{}: {} checks, {:.1f} MB\n", (folder.path() / "index.html").string(), written.checks,
               static_cast<double>(written.bytes + pictures.bytes) / 1e6);
    if (written.unsupported > 0)
        fmt::print("{} functions are no GLSL ES 3.00 and are only listed\n", written.unsupported);
    if (written.left_out > 0)
        fmt::print("{} entries have no accuracy to judge and are left out\n", written.left_out);
}

}  // namespace

namespace {

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
    site->add_option(
            "--measured", command->options.measured,
            "Markdown of gloam bench, gloam report --accuracy or gloam pack --lines, for the page of "
            "measurements")
        ->check(CLI::ExistingFile);
    site->add_option("--method", command->options.methods, "methods that get a page; none: all");
    site->add_option("--address", command->options.address,
                     "address of the published site, ending in /: previews of its pages need it")
        ->check(is_address);
    site->add_option("--metamorphic", command->changes,
                     "check WebGPU with kernels changed without a change of meaning, by this seed");
    site->add_flag("!--no-pictures", command->pictures.pictures, "render no pictures");
    site->add_option("--device", command->pictures.device,
                     "name or index of the device that renders the pictures (gloam devices)");
    site->add_flag("--quiet", command->quiet, "print nothing");
    site->callback([command] { run_site(*command); });
}

}  // namespace gloam::cli
