// SPDX-License-Identifier: MIT
#include "cli/demo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/check.hpp"
#include "cli/drivers.hpp"
#include "cli/render.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

// Debian's glmark2-data.
constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";
constexpr std::size_t few_inputs = 4096;

struct DemoOptions {
    std::string device;
    fs::path out = "gloam-demo";
};

int render(const DemoOptions& demo, const std::string& source, const std::string& name) {
    fmt::print("\n");
    RenderOptions options{.source = source, .frames = 8, .size = "480x270", .device = demo.device};
    options.out = demo.out / name;
    const int status = run_render(options);
    std::fflush(stdout);
    return status;
}

// The pictures come first: the check takes longer than all of them.
int run_demo(const DemoOptions& demo) {
    int status = 0;
    std::error_code none;
    if (fs::is_regular_file(bunny, none)) {
        status = render(demo, bunny, "bunny");
    } else {
        fmt::print("no bunny: {} is missing (package glmark2-data)\n", bunny);
    }
    status = std::max(status, render(demo, "columns", "columns"));
    status = std::max(status, render(demo, "moving", "moving"));
    status = std::max(status, render(demo, "corner", "corner"));
    fmt::print("\npictures: {}\n\n", fs::absolute(demo.out).string());
    std::fflush(stdout);
    return std::max(status, run_check({.device = demo.device, .inputs = few_inputs}));
}

}  // namespace

void add_demo(CLI::App& app, int& status) {
    auto options = std::make_shared<DemoOptions>();
    CLI::App* command = app.add_subcommand(
        "demo", "render four scenes, say where the pictures are, check the default device");
    command->add_option("--device", options->device, "name or index of the device (gloam devices)");
    command->add_option("--out", options->out, "folder for the pictures")->capture_default_str();
    add_driver_option(*command);
    command->callback([options, &status] { status = run_demo(*options); });
}

}  // namespace gloam::cli
