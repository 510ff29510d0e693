// SPDX-License-Identifier: MIT
#include "cli/framework/check.hpp"

#include <fmt/format.h>
#include <array>
#include <map>

#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/check_run.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/progress.hpp"
#include "record/check_report.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

// What was not judged, which a table would say.
void print_not_judged(const judge::Answer& row) {
    if (row.outcome() == judge::Outcome::not_judged && row.reason != judge::Reason::unchanged)
        fmt::print("{} {}: not judged: {}\n", row.equation, row.variant,
                   base::one_line(row.ran() ? row.not_judged_because() : row.error));
}

// The coverage of a row, the inputs without a result, and the domain of a property.
void print_remarks(const judge::Answer& row) {
    const auto print = [&row](const std::string& remark) {
        fmt::print("{} {}: {}\n", row.equation, row.variant, remark);
    };
    if (row.coverage) print(to_text(*row.coverage));
    if (row.undefined > 0)
        print(fmt::format("{} {} of {} inputs, which were not judged: {}",
                          row.no_result == judge::NoResult::too_long ? "it takes too long for"
                                                                     : "the result is undefined for",
                          row.undefined, row.inputs(), row.first_undefined));
    if (!row.domain.empty()) print(row.domain);
}

void print_rows(const CheckOutcome& outcome, void (*print)(const judge::Answer& row)) {
    for (const record::CheckReport& report : outcome.reports) std::ranges::for_each(report.rows, print);
}

// What came of the steps, a line for each variant that has some. Empty if no variant has steps.
std::string step_summary(const std::vector<record::CheckReport>& reports) {
    std::map<std::string, std::array<std::size_t, 4>> counts;  // as the columns
    for (const record::CheckReport& report : reports) {
        for (const judge::Answer& row : report.rows) {
            if (row.steps().empty()) continue;
            auto& [modules, changed, failed, not_judged] = counts[row.variant];
            ++modules;
            if (!base::is_no_verdict(row.reason)) ++changed;
            if (row.failed()) ++failed;
            if (!row.failed() && !row.passed()) ++not_judged;
        }
    }
    std::string text;
    for (const auto& [variant, count] : counts)
        text +=
            fmt::format("{:>7} {:>8} {:>7} {:>11}  {}\n", count[0], count[1], count[2], count[3], variant);
    if (text.empty()) return text;
    const bool none = std::ranges::none_of(counts, [](const auto& count) { return count.second[1] > 0; });
    return "modules  changed  failed  not judged  variant\n" + text +
           (none ? "nothing is judged: no step changed a module\n" : "");
}

// Throws std::invalid_argument for options that a user's file has, or only equations.
void require_fitting(const CheckOptions& options) {
    if (is_of_file(options)) {
        if (options.resume) throw std::invalid_argument("--resume is for equations, not for a shader file");
        return;
    }
    for (const std::string& word : options.equations)
        if (std::filesystem::is_regular_file(word))
            throw std::invalid_argument(word +
                                        ": a shader file is checked alone, without equations before it");
    const OwnFileOptions& own = options.task.own;
    if (!own.ranges.empty()) throw std::invalid_argument("--range is for the functions of a shader file");
    if (!own.includes.empty()) throw std::invalid_argument("--include is for a shader file");
    if (!own.defines.empty()) throw std::invalid_argument("--define is for a shader file");
}

// Prints the story of each failure, and what the table does not say. Returns the exit status: 0, 1 or 2; 2
// for an outcome that is not complete, unless a check failed.
int print_outcome(const CheckOptions& options, const CheckOutcome& outcome) {
    for (const record::CheckReport& report : outcome.reports)
        for (const judge::Answer& row : report.rows) {
            if (!row.failed()) continue;
            const bool is_device = row.variant.empty();
            fmt::print("\n{} {}: {}\n", row.equation, is_device ? name_of(report.device) : row.variant,
                       base::for_terminal(row.ran() ? row.story : row.error));
            if (!is_device) fmt::print("run it again: {}\n", command_for(options, report.device, row));
        }
    if (options.rows)
        fmt::print("\n{}", record::table_legend());
    else
        print_rows(outcome, print_not_judged);
    fmt::print("{}", step_summary(outcome.reports));
    print_rows(outcome, print_remarks);
    for (const std::string& note : outcome.notes) fmt::print("{}\n", note);
    if (outcome.counts.not_judged > 0 && is_of_file(options) && options.task.own.ranges.empty())
        fmt::print("--range PARAMETER=LOW:HIGH limits the inputs to those that a function is made for\n");
    int status = outcome.counts.exit_status();
    if (status == 0 && !outcome.complete) status = 2;
    fmt::print("{}\n", colored(to_text(outcome.counts) + (outcome.complete ? "" : ", some left out"),
                               status == 0 ? Ink::good : Ink::bad));
    return status;
}

// What is checked, in which variants; how much of it, and how; files, and what is printed.
std::vector<Option> options_of(CheckOptions& options) {
    return {
        {"equation", &options.equations,
         "IDs, functions or globs (all when none is given), PASS-* for whole passes; or a GLSL file of your "
         "own, and its functions"},
        {"--range", &options.task.own.ranges,
         "NAME=LOW:HIGH: what a parameter of your own file's functions is drawn from"},
        include_option(options.task.own.includes),
        define_option(options.task.own.defines),
        {"--device", &options.device,
         "name or index of the device, or all: every Vulkan device; gl: every OpenGL and OpenGL ES device, "
         "or one's name; interpreter: no driver, every operation correctly rounded"},
        {"--variant", &options.variant, "how the shaders are compiled (gloam list variants), or all"},
        {"--compiler", &options.compilers,
         "steps that the modules take, judged by the modules before them: 'spirv-opt --ccp', 'spirv-opt "
         "{each}', a program with {in} or {glsl} and {out}; several joined by ' | '"},
        {"--inputs", &options.task.run.inputs, between(1, 1e8), "inputs for each equation"},
        {"--seed", &options.task.run.seed, "seed of the inputs"},
        {"--shard", &options.shard,
         "INDEX/COUNT: run only this part of the checks, counted from 0 (default: GTEST_SHARD_INDEX of "
         "GTEST_TOTAL_SHARDS)"},
        {"--coverage", &options.task.coverage,
         "report which lines and branches of the GLSL the inputs reach"},
        {"--validation", &options.validation, "Vulkan validation layers on; any message fails the check"},
        {"--timeout", &options.timeout, between(0.001, 1e6),
         "seconds that one check may take; one that takes longer is stopped and reported as a hang"},
        {"--jobs",
         &options.jobs,
         {.range = {{1, 1024}}, .shown = "one a core, fewer for a short check"},
         "worker processes for each device"},
        {"--in-process", &options.in_process, excludes("--jobs"),
         "no worker processes, for a debugger: a driver that crashes then ends the whole run"},
        {std::string(bisect_option), [] {},
         "for git bisect run: status 125 instead of 2, so that a build that cannot be judged is skipped"},
        {"--json", &options.json,
         "write the results to this file; until the run has ended, FILE.journal holds the results so far"},
        {"--resume", &options.resume, needs("--json"), "run only the checks that FILE.journal lacks"},
        {"--junit", &options.junit, "write the results as JUnit XML"},
        {"--html", &options.html, "write the results as a page: sortable, filterable, in one file"},
        {"--quiet", [&options] { options.rows = options.progress = false; },
         "print only the failures and the count"},
        {"--failures", &options.failures,
         "folder that receives each failure ready to report: the smallest input found, the shader, a program "
         "in C, an AmberScript"},
        driver_option()};
}

}  // namespace

CheckOutcome check(const CheckOptions& options) {
    const record::OutputFile json(options.json);
    const record::OutputFile junit(options.junit);
    const record::OutputFile html(options.html);
    CheckOutcome outcome;
    require_fitting(options);
    outcome.reports = run_tasks(options, tasks_of(options, outcome));
    for (record::CheckReport& report : outcome.reports) {
        report.versions = versions();
        report.inputs = options.task.run.inputs;
        report.seed = options.task.run.seed;
        if (!outcome.shard.empty()) report.shards = {outcome.shard};
    }
    outcome.counts = counts_of(outcome.reports);
    json.write(record::to_json(outcome.reports));
    junit.write(record::to_junit(outcome.reports));
    html.write(record::to_check_page(outcome.reports));
    if (!options.json.empty()) {      // the results are now in the result file
        std::error_code still_there;  // harmless: the next run starts it anew
        std::filesystem::remove(options.journal(), still_there);
    }
    return outcome;
}

Command check_command(EquationsNamed* equations) {
    static CheckOptions options{.named = equations};
    return {.name = "check",
            .about = "run equations on a Vulkan or OpenGL device and judge every result",
            .options = options_of(options),
            .run =
                [] {
                    if (!options.compilers.empty() && options.device.empty())
                        options.device = subject::interpreter_name;
                    return print_outcome(options, check(options));
                },
            .examples =
                R"(  gloam check                                          every equation on the default device
  gloam check 'gloam_linear_depth_*' 'TSSAO-*'         some of them
  gloam check --device all --variant all --html r.html every device, every compiler setting
  gloam check --quiet --junit results.xml              for continuous integration
  gloam check --failures failures                      each failure ready to report
  gloam check shader.frag 'luma(vec3)' --range c=0:1   a function of a file of your own
)"};
}

}  // namespace gloam::cli
