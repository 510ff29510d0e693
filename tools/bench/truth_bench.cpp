// SPDX-License-Identifier: MIT
// truth_bench [SCENE...]: how fast the rays of the truth are and how their standard error falls with their
// number. One line for each scene and number of rays, 128 x 72 pixels; then the slope of the error over the
// rays on logarithmic scales: -0.5 for independent rays.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include "cli/environment.hpp"
#include "scene/rasterize.hpp"
#include "scene/truth.hpp"

namespace {

using namespace gloam;

double mean_error(const scene::TracedTruth& truth) {
    double sum = 0.0;
    for (const float error : truth.standard_error) sum += double{error};
    return sum / static_cast<double>(truth.pixels);
}

// The slope of the least-squares line.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    const auto count = static_cast<double>(x.size());
    double sx = 0.0;
    double sy = 0.0;
    double sxx = 0.0;
    double sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

void measure(const gpu::Device& device, const scene::PassLibrary& passes, const std::string& name) {
    const scene::Scene scene = scene::make_scene(name);
    const scene::GBuffer view = scene::rasterize(device, passes, scene, {128, 72});
    std::vector<double> log_rays;
    std::vector<double> log_error;
    for (int rays = 64; rays <= 4096; rays *= 4) {
        const auto start = std::chrono::steady_clock::now();
        const scene::TracedTruth truth =
            scene::trace_geometry(scene, 0, view, {.rays = {.radius = scene.ao_radius, .rays = rays}});
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double error = mean_error(truth);
        fmt::print("{:<8} {:>5} rays: standard error {:.6f}, {:.2f} million rays a second\n", name, rays,
                   error, 1e-6 * static_cast<double>(truth.rays * truth.pixels) / seconds);
        log_rays.push_back(std::log(static_cast<double>(rays)));
        log_error.push_back(std::log(error));
    }
    fmt::print("{:<8} slope {:.2f}\n", name, slope(log_rays, log_error));
}

int run(std::vector<std::string> names) {
    if (names.empty()) {
        for (const scene::SceneInfo& info : scene::built_in_scenes()) names.push_back(info.name);
    }
    const gpu::Device device({.cache_directory = cli::cache_directory()});
    const scene::PassLibrary passes(cli::glsl_directory(), cli::cache_directory());
    for (const std::string& name : names) measure(device, passes, name);
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        return run({arguments + 1, arguments + count});
    } catch (const std::exception& error) {
        fmt::print(stderr, "truth_bench: {}\n", error.what());
        return 2;
    }
}
