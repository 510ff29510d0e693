// SPDX-License-Identifier: MIT
#include "cli/bench/framework.hpp"

#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "catalogue/catalogue.hpp"
#include "check/lab.hpp"
#include "cli/bench/bare_copy.hpp"
#include "cli/environment.hpp"
#include "report/benchmark/summary.hpp"

namespace gloam::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t evaluations = 1U << 20U;
constexpr const char* cheap = "gloam_falloff_linear";
constexpr const char* costly = "gloam_halton_3d";

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

double median_of(const std::vector<double>& values) {
    return report::spread_of(values).median;
}

check::LabOptions options_for(const std::string& device, const std::filesystem::path& cache) {
    return {.device = device, .include_roots = {glsl_directory()}, .cache_directory = cache};
}

check::Question question_of(const std::string& equation) {
    return catalogue::select(catalogue::all_entries(glsl_directory()), {equation}).front().question;
}

// Framework and copy alternate, so that the machine's drift affects both.
void add_rate(std::vector<report::Figure>& figures, const check::Lab& lab, const std::string& equation,
              int repeat) {
    const check::Question what = question_of(equation);
    const check::KernelCore kernel = lab.kernel(what.file, what.function, what.signature);
    const check::Domain::Inputs inputs = what.domain.draw(evaluations, 1);
    BareCopy copy(lab, evaluations, kernel.input_words(), kernel.output_words() + 1);  // and the canary
    copy.run(inputs.words);  // drivers compile at the first dispatch
    (void)kernel.run(inputs.words, evaluations);
    std::vector<double> rates;
    std::vector<double> ratios;
    for (int i = 0; i < repeat; ++i) {
        const auto begin = Clock::now();
        (void)kernel.run(inputs.words, evaluations);
        const auto middle = Clock::now();
        copy.run(inputs.words);
        const auto end = Clock::now();
        rates.push_back(static_cast<double>(evaluations) / seconds(middle - begin) * 1e-6);
        ratios.push_back(seconds(end - middle) / seconds(middle - begin));
    }
    figures.push_back({"evaluations of `" + equation + "`", "million a second", median_of(rates)});
    figures.push_back({"the same, of a copy", "", median_of(ratios)});
}

// Times of one start, in milliseconds.
struct Start {
    double device = 0.0;
    double kernel = 0.0;
    double result = 0.0;
};

Start start(const check::LabOptions& options) {
    const check::Question what = question_of(cheap);
    const check::Domain::Inputs inputs = what.domain.draw(1, 1);
    const auto begin = Clock::now();
    const check::Lab lab(options);
    const auto opened = Clock::now();
    const check::KernelCore kernel = lab.kernel(what.file, what.function, what.signature);
    const auto made = Clock::now();
    (void)kernel.run(inputs.words, 1);
    const auto end = Clock::now();
    return {1e3 * seconds(opened - begin), 1e3 * seconds(made - opened), 1e3 * seconds(end - made)};
}

void add_starts(std::vector<report::Figure>& figures, const std::string& device, bool warm, int repeat) {
    const auto cache = std::filesystem::temp_directory_path() / ("gloam-bench-" + std::to_string(::getpid()));
    std::filesystem::remove_all(cache);
    const check::LabOptions options = options_for(device, warm ? cache : std::filesystem::path{});
    if (warm) (void)start(options);
    std::vector<double> devices;
    std::vector<double> kernels;
    std::vector<double> all;
    for (int i = 0; i < repeat; ++i) {
        const Start times = start(options);
        devices.push_back(times.device);
        kernels.push_back(times.kernel);
        all.push_back(times.device + times.kernel + times.result);
    }
    std::filesystem::remove_all(cache);
    const std::string how = warm ? ", from the caches" : ", nothing kept";
    figures.push_back({"opening a device" + how, "ms", median_of(devices)});
    figures.push_back({"a kernel and its pipeline" + how, "ms", median_of(kernels)});
    figures.push_back({"start to the first result" + how, "ms", median_of(all)});
}

}  // namespace

std::vector<report::Figure> framework_figures(const std::string& device, int repeat,
                                              const std::function<void(double)>& progress) {
    std::vector<report::Figure> figures;
    {
        const check::Lab lab(options_for(device, {}));
        add_rate(figures, lab, cheap, repeat);
        progress(0.25);
        add_rate(figures, lab, costly, repeat);
        progress(0.5);
    }
    add_starts(figures, device, false, repeat);
    progress(0.75);
    add_starts(figures, device, true, repeat);
    progress(1.0);
    return figures;
}

}  // namespace gloam::cli
