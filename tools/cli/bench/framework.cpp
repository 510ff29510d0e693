// SPDX-License-Identifier: MIT
#include "cli/bench/options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "base/version.hpp"
#include "catalogue/catalogue.hpp"
#include "check/lab.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "numeric/numbers.hpp"
#include "report/output.hpp"

namespace gloam::cli {
namespace {

constexpr std::uint32_t group = 64;

std::string text_of(std::size_t words_in, std::size_t words_out) {
    std::string loads;
    for (std::size_t i = 0; i < words_in; ++i)
        loads += fmt::format("uint word{} = i[at * {}u + {}u];\n", i, words_in, i);
    std::string stores;
    for (std::size_t i = 0; i < words_out; ++i)
        stores += fmt::format("o[at * {}u + {}u] = word{};\n", words_out, i, i % words_in);
    return fmt::format(
        "#version 450\nlayout(local_size_x = {}) in;\n"
        "layout(push_constant) uniform Run {{ uint count; }};\n"
        "layout(std430, binding = 0) readonly buffer In {{ uint i[]; }};\n"
        "layout(std430, binding = 1) writeonly buffer Out {{ uint o[]; }};\n"
        "void main() {{ uint at = gl_GlobalInvocationID.x; if (at >= count) return;\n{}{}}}\n",
        group, loads, stores);
}

gpu::ComputePipeline pipeline_of(const check::Lab& lab, std::size_t words_in, std::size_t words_out) {
    const shader::Spirv spirv = lab.compile({.name = "copy", .text = text_of(words_in, words_out)});
    return {lab.device(),
            {.spirv = spirv,
             .bindings = {gpu::BindingKind::storage_buffer, gpu::BindingKind::storage_buffer},
             .push_constant_bytes = sizeof(std::uint32_t)}};
}

// A dispatch that only copies words from buffer to buffer: the minimal cost of evaluating a function. Each
// invocation copies the `words_in` words of its input to `words_out` words of output, repeating them if there
// are fewer.
class BareCopy {
  public:
    // Throws like gpu::Buffer and gpu::ComputePipeline.
    BareCopy(const check::Lab& lab, std::size_t count, std::size_t words_in, std::size_t words_out);

    // Uploads the inputs, copies, downloads the outputs. Throws like gpu::Commands::submit().
    void run(std::span<const check::Word> inputs);

  private:
    const gpu::Device* device_;
    std::size_t count_;
    gpu::ComputePipeline pipeline_;
    gpu::Buffer inputs_;
    gpu::Buffer outputs_;
    std::vector<check::Word> received_;
};

BareCopy::BareCopy(const check::Lab& lab, std::size_t count, std::size_t words_in, std::size_t words_out)
    : device_(&lab.device()),
      count_(count),
      pipeline_(pipeline_of(lab, words_in, words_out)),
      inputs_(lab.device(), count * words_in * sizeof(check::Word)),
      outputs_(lab.device(), count * words_out * sizeof(check::Word)),
      received_(count * words_out) {}

void BareCopy::run(std::span<const check::Word> inputs) {
    std::ranges::copy(inputs, inputs_.as<check::Word>().begin());
    gpu::Commands commands(*device_);
    const std::vector<gpu::Resource> resources{std::cref(inputs_), std::cref(outputs_)};
    const auto count = static_cast<std::uint32_t>(count_);
    commands.dispatch(pipeline_, resources, {(count + group - 1) / group, 1, 1},
                      std::as_bytes(std::span(&count, 1)));
    commands.submit();
    std::ranges::copy(outputs_.as<check::Word>(), received_.begin());
}

// A figure of the framework.
struct Figure {
    std::string name;
    std::string unit;
    double value = 0.0;
};

using Clock = std::chrono::steady_clock;

constexpr std::size_t evaluations = 1U << 20U;
constexpr const char* cheap = "gloam_falloff_linear";
constexpr const char* costly = "gloam_halton_3d";

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

double median_of(const std::vector<double>& values) {
    return numeric::spread_of(values).median;
}

check::LabOptions options_for(const std::string& device, const std::filesystem::path& cache) {
    return {.device = device, .include_roots = {glsl_directory()}, .cache_directory = cache};
}

check::Question question_of(const std::string& equation) {
    return catalogue::select(catalogue::all_entries(glsl_directory()), {equation}).front().question;
}

// Framework and copy alternate, so that the machine's drift affects both.
void add_rate(std::vector<Figure>& figures, const check::Lab& lab, const std::string& equation, int repeat) {
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

void add_starts(std::vector<Figure>& figures, const std::string& device, bool warm, int repeat) {
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

std::vector<Figure> framework_figures(const std::string& device, int repeat,
                                      const std::function<void(double)>& progress) {
    std::vector<Figure> figures;
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

struct FrameworkOptions {
    int repeat = 5;
    std::string device;
    bool validation = false;
    std::filesystem::path json;
};

int run_framework(const FrameworkOptions& options) {
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    const std::vector<Figure> figures =
        framework_figures(options.device, options.repeat, progress_bar("framework"));
    nlohmann::ordered_json document{{"gloam", base::version()},
                                    {"versions", versions()},
                                    {"device", device.info().name},
                                    {"framework", nlohmann::ordered_json::array()}};
    fmt::print("| figure | value |\n| --- | --- |\n");
    for (const Figure& figure : figures) {
        fmt::print("| {} | {:.4g} {} |\n", figure.name, figure.value, figure.unit);
        document["framework"].push_back(
            {{"name", figure.name}, {"unit", figure.unit}, {"value", figure.value}});
    }
    json.write(document.dump(2) + "\n");
    return validation_status(device);
}

}  // namespace

void add_framework(CLI::App& bench, int& status) {
    auto options = std::make_shared<FrameworkOptions>();
    CLI::App* command = bench.add_subcommand("framework", "what the shader-test framework itself costs");
    command->add_option("--repeat", options->repeat, "rounds, whose medians are printed")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->callback([options, &status] { status = run_framework(*options); });
}

}  // namespace gloam::cli
