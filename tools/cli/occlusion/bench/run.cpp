// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/occlusion/bench/options.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "effect/settings.hpp"
#include "experiment/comparison.hpp"
#include "experiment/experiment.hpp"
#include "experiment/runner.hpp"
#include "experiment/table.hpp"
#include "pictures/sheet.hpp"
#include "record/output.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
constexpr const char* own_experiment = "FILE.json";
using experiment::Experiment;

// The position of a line that must occur exactly once.
std::size_t line_in(const std::string& page, const std::string& line) {
    const std::size_t at = page.find(line);
    if (at == std::string::npos || page.find(line, at + 1) != std::string::npos)
        throw std::invalid_argument(fmt::format("the page: expected one line \"{}\"", line));
    return at;
}

// Puts a text of whole lines between the lines "<!-- begin NAME -->" and "<!-- end NAME -->". Throws
// std::invalid_argument with the name unless the page contains these two, in this order, exactly once.
void replace_block(std::string& page, const std::string& name, const std::string& text) {
    const std::string begin = fmt::format("<!-- begin {} -->\n", name);
    const std::string end = fmt::format("<!-- end {} -->", name);
    const std::size_t first = line_in(page, begin) + begin.size();
    const std::size_t last = line_in(page, end);
    if (last < first)
        throw std::invalid_argument(fmt::format("the page: block {} ends before it begins", name));
    page.replace(first, last - first, "\n" + text + "\n");
}

// The page with the blocks of the tables that have names, or with one of all tables.
std::string page_with(std::string page, const Experiment& what, const experiment::Text& tables,
                      const std::string& heading) {
    bool named = false;
    for (const experiment::Table& table : what.tables) {
        if (table.name.empty()) continue;
        named = true;
        const auto text = tables.named.find(table.name);
        replace_block(page, table.name, text == tables.named.end() ? "" : text->second);
    }
    if (!named) replace_block(page, what.name, heading + tables.text);
    return page;
}

// Without what leads into another folder or has to be quoted.
std::string file_name(std::string name) {
    std::erase_if(name, [](char c) { return c == ',' || c == ':' || c == '(' || c == ')'; });
    std::ranges::replace(name, ' ', '-');
    return base::file_name_of(name);
}

// What was measured where, in a few lines.
std::string heading_of(const experiment::Conditions& conditions, const experiment::Database& database) {
    std::string text = fmt::format("{} cases on {} ({})", database.texts("SELECT count(*) FROM cases").at(0),
                                   conditions.device, conditions.driver);
    for (const std::string& size : database.texts("SELECT size FROM sizes"))
        text += fmt::format(",\n{} pixels", size);
    text += fmt::format(", {} rounds", database.texts("SELECT coalesce(max(round), 0) FROM rounds").at(0));
    if (conditions.rays > 0)
        text += fmt::format(",\nthe last {} of {} frames, the truth of {} rays a pixel", conditions.scored,
                            conditions.frames, conditions.rays);
    return text + ".\n";
}

// The files of one run. The constructor finds out whether they can be written, before the work.
class ExperimentFiles {
  public:
    // Throws std::runtime_error for a file that cannot be written, and std::invalid_argument for a page
    // without the experiment's blocks.
    ExperimentFiles(const ExperimentOptions& options, const Experiment& what)
        : options_(options), what_(what) {
        if (!options.page.empty()) (void)page_with(old_page_, what, {}, "");
        if (!options.out.empty()) out_.emplace(options.out);
    }

    // In the folder, which then stays even if the run fails; empty: there is none.
    [[nodiscard]] fs::path journal() {
        if (!out_) return {};
        out_->keep();
        return out_->path() / "journal.jsonl";
    }

    // Writes a picture into the folder.
    void show(const experiment::Picture& picture) {
        if (!out_) return;
        constexpr double full_error = 0.1;  // as bright as the scale goes
        const auto [width, height] = picture.extent;
        const bool error = picture.kind == "error";
        const bool part = picture.kind == "convergence" || picture.kind == "samples";
        out_->write(file_name(picture.name) + ".png",
                    error || part ? base::to_png(base::heat_rgb(picture.values, error ? full_error : 1.0),
                                                 width, height)
                                  : pictures::to_visibility_png(picture.values, width, height));
        out_->keep();  // a run that is taken up again does not measure what the picture shows
    }

    // Prints the tables and the answers, and writes all files. Returns the exit status.
    [[nodiscard]] int report(const experiment::Record& record) {
        const experiment::Database database(record);
        const experiment::Text tables = to_text(what_, database);
        const std::string heading = heading_of(record.conditions(), database);
        const experiment::Answers answers = answers_to(database, options_.budget, options_.error);
        fmt::print("{}{}{}", heading, tables.text, answers.text);
        const std::string json = to_json(database, record, versions());
        const std::string csv = to_csv(database);
        json_.write(json);
        csv_.write(csv);
        if (!options_.page.empty()) page_.write(page_with(old_page_, what_, tables, heading));
        report_.write(fmt::format("# {}\n\n{}.\n\n{}{}\n", what_.name, what_.about, heading, tables.report));
        if (out_) {
            out_->write("results.json", json);
            out_->write("results.csv", csv);
            out_->keep();
        }
        return !answers.all || (tables.missed && options_.fail_if_missed) ? 1 : 0;
    }

  private:
    const ExperimentOptions& options_;
    const Experiment& what_;
    std::string old_page_ = options_.page.empty() ? "" : base::read_file(options_.page);
    record::OutputFile json_{options_.json};
    record::OutputFile csv_{options_.csv};
    record::OutputFile page_{options_.page};
    record::OutputFile report_{options_.report};
    std::optional<record::OutputFolder> out_;
};

experiment::Record record_in(const fs::path& file) {
    return experiment::read_record(file.string(), base::read_file(file));
}

int compare_files(const ExperimentOptions& options) {
    const experiment::Comparison found =
        experiment::compared(record_in(options.compare.at(0)), record_in(options.compare.at(1)));
    fmt::print("{}", found.text);
    return options.fail_if_worse && found.got_worse ? 1 : 0;
}

int run_experiment(const ExperimentOptions& options) {
    if (options.query && !options.query->single && !options.query->sequence)
        throw std::invalid_argument("--temporal and --single: expected one of them, or none for both");
    if (options.resume && options.out.empty())
        throw std::invalid_argument("--resume: expected --out, the folder whose journal is taken up again");
    if (!options.budget.empty()) (void)experiment::time_budget(options.budget);
    if (!options.compare.empty()) return compare_files(options);
    Experiment what = described(options);
    if (!options.from.empty()) {
        std::vector<experiment::Record> parts;
        for (const fs::path& file : options.from) parts.push_back(record_in(file));
        const experiment::Record record = experiment::joined(parts);
        return ExperimentFiles(options, what).report(record);
    }
    const fs::path meshes = options.meshes.empty() ? scene::installed_meshes() : options.meshes;
    choose_candidates(what, options);
    choose_cases(what, options.cases, options.half, meshes);
    std::vector<backend::Extent> sizes;
    for (const std::string& size : what.sizes)
        sizes.push_back(parse_size(size, 16, 4096));  // a kernel, a window and a pixel's neighbours fit
    backend::vulkan::Device device = open_device(options.device, options.validation);
    scene::PassLibrary passes(glsl_directory(), cache_directory());
    if (options.inputs != "device")
        passes.inputs = options.inputs == "sampled" ? scene::Inputs::sampled : scene::Inputs::storage;
    experiment::Place place{.device = device,
                            .passes = passes,
                            .truth_cache = truth_cache_directory(),
                            .meshes = meshes,
                            .preset_of = preset_settings,
                            .progress = [](const std::string& what) { return progress_bar(what); }};
    require_possible(what, place);
    ExperimentFiles files(options, what);
    experiment::Record record({.experiment = what.name,
                               .device = device.info().name,
                               .driver = device.info().driver,
                               .frames = what.frames,
                               .scored = what.scored,
                               .repeat = what.repeat,
                               .rays = what.rays});
    const record::Journal journal(files.journal(), line_of(record.conditions()), options.resume,
                                  [&](std::string_view line) { record.add_line(line); });
    place.keep = [&](const std::string& line) { journal.add(line); };
    place.show = [&](const experiment::Picture& picture) { files.show(picture); };
    run(what, sizes, place, record);
    const int status = files.report(record);
    const int messages = validation_status(device);
    return messages == 0 ? status : messages;
}

// An empty one where it cannot be read.
Experiment description_in(const fs::path& file) {
    try {
        return experiment::read_experiment(file.string(), base::read_file(file));
    } catch (const std::exception&) {
        return {};
    }
}

// None where the program's files are missing: other commands need none of them.
std::set<fs::path> built_in_experiments() {
    std::set<fs::path> files;
    try {
        for (const fs::directory_entry& entry : fs::directory_iterator(data_directory("experiments")))
            if (entry.path().extension() == ".json") files.insert(entry.path());
    } catch (const std::runtime_error&) {
        files.clear();
    }
    return files;
}

// A command that runs the description in the file, or in the file that `options` name.
Command experiment_command(const std::string& name, const std::string& about, const fs::path& file,
                           bool has_query) {
    const auto options = std::make_shared<ExperimentOptions>();  // lives as long as the command
    options->file = file;
    Command command{
        .name = name, .about = about, .options = options_of(*options, has_query), .run = [options] {
            return run_experiment(*options);
        }};
    if (name == own_experiment)
        command.options.push_back({"FILE", &options->file, required, "its description in JSON"});
    return command;
}

}  // namespace

Command bench_command() {
    // Without a further command, its options run the description samples.json.
    Command bench = experiment_command(
        "bench", "time against error: which method with how many samples, on this device", {}, true);
    for (const fs::path& file : built_in_experiments()) {
        const Experiment what = description_in(file);
        bench.commands.push_back(
            experiment_command(file.stem().string(), what.about, file, what.candidate_query.has_value()));
    }
    bench.commands.push_back(
        experiment_command(own_experiment, "an experiment of your own: copy one of gloam's", {}, false));
    bench.examples =
        "  gloam bench --method gtao hemisphere --samples 4 16 --scene columns\n"
        "  gloam bench --from results.json --error 0.05\n";
    return bench;
}

}  // namespace gloam::cli
