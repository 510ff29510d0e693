// SPDX-License-Identifier: MIT
#include "cli/bench/front.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <stdexcept>

#include "cli/bench/front_report.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/bench/page_blocks.hpp"
#include "cli/bench/slice_taps.hpp"
#include "cli/bench/view_options.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/render_settings.hpp"
#include "effect/study/plain_run.hpp"
#include "report/benchmark/summary.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

constexpr const char* front_block = "front";

// SLICESxSTEPS+BLURS.
PlainLoop plain_loop(const std::string& text) {
    const std::size_t plus = text.find('+');
    const std::string blurs = plus == std::string::npos ? "" : text.substr(plus + 1);
    if (blurs.size() != 1 || blurs[0] < '0' || blurs[0] > '9')
        throw std::invalid_argument(
            fmt::format("--plain {}: expected SLICESxSTEPS+BLURS, at most 9 blurs, such as 3x3+2", text));
    return {slice_taps(text.substr(0, plus)), blurs[0] - '0'};
}

std::string name_of(const PlainLoop& loop) {
    const std::string blurs = loop.blurs == 0   ? ""
                              : loop.blurs == 1 ? " and a blur"
                                                : fmt::format(" and {} blurs", loop.blurs);
    return fmt::format("plain loop, {} x {}{}", loop.taps.slices, loop.taps.steps, blurs);
}

// PRESET[,NAME=VALUE...].
effect::Settings settings_of(const std::string& text) {
    std::vector<std::string> parts = CLI::detail::split(text, ',');
    RenderOptions render{.preset = parts.front()};
    render.set.assign(parts.begin() + 1, parts.end());
    return settings_for(render, 1.0);
}

std::vector<FrontRun> runs_of(const BenchFrontOptions& options) {
    std::vector<FrontRun> runs;
    for (const std::string& text : options.plain) {
        const PlainLoop loop = plain_loop(text);
        runs.push_back({.name = name_of(loop), .plain = loop});
    }
    for (const std::string& text : options.single)
        runs.push_back({.name = text + ", single", .settings = settings_of(text)});
    for (const std::string& text : options.sequence)
        runs.push_back({.name = text + ", sequence", .settings = settings_of(text), .sequence = true});
    if (runs.empty()) throw std::invalid_argument("nothing to measure: give --plain, --single or --sequence");
    return runs;
}

// The views asked for; the plain loop knows perspective cameras alone.
std::vector<scene::ViewInfo> views_asked(const BenchFrontOptions& options,
                                         const std::filesystem::path& meshes) {
    std::vector<scene::ViewInfo> asked = views_named(options.views);
    std::erase_if(asked, [&](const scene::ViewInfo& view) {
        return scene::name_of(view.half) != options.half ||
               scene::make_view(view.name, meshes).camera.projection == scene::Projection::orthographic;
    });
    if (asked.empty()) throw std::invalid_argument("no perspective view of this half");
    return asked;
}

// The runs at one size of image.
class SizeBench {
  public:
    SizeBench(const gpu::Device& device, const scene::PassLibrary& passes, const std::vector<FrontRun>& runs,
              const effect::BenchmarkFrames& frames, int rounds)
        : device_(device),
          passes_(passes),
          runs_(runs),
          frames_(frames),
          rounds_(rounds),
          study_(device, passes, frames.extent),
          clock_(device, passes, frames.extent) {
        for (const FrontRun& run : runs) {
            if (!run.plain) continue;
            loops_.emplace_back(device, passes, frames.extent, run.plain->taps, run.plain->blurs);
        }
    }

    [[nodiscard]] FrontRow measured(const scene::ViewInfo& info, const std::filesystem::path& meshes) {
        const scene::TruthCache cache(truth_cache_directory());
        const std::string name =
            fmt::format("{}, {} x {}", info.name, frames_.extent.width, frames_.extent.height);
        effect::BenchmarkViews views(device_, passes_, scene::make_view(info.name, meshes), frames_, cache,
                                     progress_bar(name + ", truth"));
        FrontRow row{.view = info, .cells = std::vector<FrontCell>(runs_.size())};
        std::vector<std::vector<double>> copies(runs_.size());
        const auto progress = progress_bar(name);
        for (int round = 0; round <= rounds_; ++round) {
            for (std::size_t i = 0; i < runs_.size(); ++i) visit(views, i, round, row.cells[i], copies[i]);
            progress(static_cast<double>(round + 1) / (rounds_ + 1));
        }
        for (std::size_t i = 0; i < runs_.size(); ++i)
            row.cells[i].copies = report::spread_of(copies[i]).median;
        return row;
    }

  private:
    // Round 0 gives the errors and warms up; the others give times.
    void visit(effect::BenchmarkViews& views, std::size_t index, int round, FrontCell& cell,
               std::vector<double>& copies) {
        const effect::ConfigurationVisit found = visited(views, index, round);
        if (found.quality) {
            cell.rmse = found.quality->geometry;
            cell.flicker = found.quality->flicker;
        }
        if (round == 0) return;
        for (const effect::FrameReading& reading : found.readings) {
            double sum = 0.0;
            for (const effect::PassTime& pass : reading.passes) sum += pass.ms;
            copies.push_back(sum / reading.copy_ms);
        }
    }

    // The plain loops are the first of the runs.
    [[nodiscard]] effect::ConfigurationVisit visited(effect::BenchmarkViews& views, std::size_t index,
                                                     int round) {
        if (index < loops_.size()) return loops_[index].visit(views, clock_, round);
        const FrontRun& run = runs_[index];
        const effect::Settings settings =
            with_radius(run.settings, static_cast<float>(views.scene().ao_radius));
        return study_.visit(views, settings, run.sequence, round);
    }

    const gpu::Device& device_;
    const scene::PassLibrary& passes_;
    const std::vector<FrontRun>& runs_;
    effect::BenchmarkFrames frames_;
    int rounds_;
    effect::ConfigurationStudy study_;
    effect::CopyClock clock_;
    std::vector<effect::PlainRun> loops_;
};

}  // namespace

int run_bench_front(const BenchFrontOptions& options) {
    FrontReport report{
        .runs = runs_of(options), .frames = options.frames, .scored = options.scored, .rays = options.rays};
    require_scored(options.scored, options.frames);
    for (const std::string& size : options.sizes) report.sizes.push_back({.extent = image_size(size)});
    const std::filesystem::path meshes = options.meshes.empty() ? scene::installed_meshes() : options.meshes;
    const std::vector<scene::ViewInfo> views = views_asked(options, meshes);
    const std::string old_page = options.page.empty() ? "" : read_page(options.page);
    if (!options.page.empty()) (void)with_blocks(old_page, {{front_block, ""}});
    const report::OutputFile page(options.page);
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    effect::require_timestamps(device.info());
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    report.device = device.info();
    for (FrontSize& size : report.sizes) {
        SizeBench bench(device, passes, report.runs,
                        {.extent = size.extent,
                         .frames = options.frames,
                         .scored = options.scored,
                         .rays = options.rays,
                         .depth_truth = false},
                        options.rounds);
        for (const scene::ViewInfo& view : views) size.rows.push_back(bench.measured(view, meshes));
    }
    const std::string text = to_text(report);
    fmt::print("{}", text);
    json.write(to_json(report));
    if (!options.page.empty()) page.write(with_blocks(old_page, {{front_block, text}}));
    return validation_status(device);
}

void add_bench_front(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchFrontOptions>();
    CLI::App* command = bench.add_subcommand(
        "front", "error against time of presets beside a plain loop over slices, on views, at two sizes");
    command->add_option("--view", options->views, "views of the half with perspective; without it all");
    command->add_option("--half", options->half, "the half of the views")
        ->check(CLI::IsMember({"tuning", "unseen"}))
        ->capture_default_str();
    command
        ->add_option(
            "--plain", options->plain,
            "SLICESxSTEPS+BLURS of single frames of the plain loop; the first is the base of the ratios")
        ->capture_default_str();
    command->add_option("--single", options->single, "PRESET or PRESET,NAME=VALUE,..., each frame alone")
        ->capture_default_str();
    command->add_option("--sequence", options->sequence, "the same, in sequence with their history")
        ->capture_default_str();
    command->add_option("--size", options->sizes, "WIDTHxHEIGHT of the images, one or more")
        ->capture_default_str();
    command->add_option("--frames", options->frames, "of each view")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--scored", options->scored, "the last ones of these")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--rays", options->rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    command->add_option("--rounds", options->rounds, "that are timed")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--meshes", options->meshes, "folder of the meshes; without it that of glmark2-data");
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--page", options->page, "page whose tables are written anew (docs/benchmark.md)");
    command->callback([options, &status] { status = run_bench_front(*options); });
}

}  // namespace gloam::cli
