// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "audit/audit.hpp"
#include "cli/commands.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/framework/own_file.hpp"
#include "interpreter/program.hpp"
#include "record/audit_report.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

struct AuditCommand {
    std::vector<std::string> words;  // a file and functions, or equations
    OwnFileOptions own;
    std::vector<std::string> devices;
    std::string json;
    std::string html;
    audit::AuditOptions options;
};

// One function after the other, each shown as soon as it is known: what is stopped has said what it knew.
std::vector<audit::Audit> audits_of(const AuditCommand& command, const std::string& file,
                                    const FileFunctions& read) {
    std::vector<audit::Audit> audits;
    const subject::Ranges ranges = ranges_from(command.own.ranges);
    const subject::Lab interpreter = lab_of(read.file);
    if (!command.devices.empty()) require_good_drivers();
    std::vector<subject::Lab> labs;
    for (const std::string& device : command.devices) labs.push_back(lab_of(read.file, device));
    for (const subject::OwnFunction& function : read.functions.found) {
        try {
            audits.push_back(audit::audit(interpreter, function, ranges, command.options));
        } catch (const interpreter::Error& error) {
            throw std::runtime_error(fmt::format("{}: {}: {}", file, function.name, error.what()));
        }
        for (const subject::Lab& lab : labs)
            add_witness(audits.back(), lab, judge::question_of(lab, function, ranges), command.options);
        fmt::print("{}\n", to_text(audits.back()));
        (void)std::fflush(stdout);
    }
    return audits;
}

int run_audit(const AuditCommand& command, EquationsNamed* equations) {
    const auto [file, functions] = file_and_functions(command.words, equations);
    const record::OutputFile json(command.json);
    const record::OutputFile html(command.html);
    const FileFunctions read = functions_of(file, functions, command.own);
    for (const std::string& note : read.notes(file)) fmt::print("{}\n", note);
    if (read.functions.found.empty()) throw nothing_was("audited", file, read.functions.left_out);
    int status = read.is_complete(!functions.empty()) ? 0 : 2;
    const record::AuditReport report{
        .file = file, .source = read.file->text, .audits = audits_of(command, file, read)};
    for (const audit::Audit& audit : report.audits) {
        if (!audit.was_run() && status == 0) status = 2;
        if (audit.is_broken()) status = 1;
    }
    if (!command.json.empty()) json.write(to_audit_json(report));
    if (!command.html.empty()) html.write(to_audit_page(report));
    return status;
}

}  // namespace

Command audit_command(EquationsNamed* equations) {
    static AuditCommand command;
    return {
        .name = "audit",
        .about = "show where a shader function itself goes wrong: NaN, lost digits, what drivers may do",
        .options = {{"file", &command.words, required,
                     "a GLSL file, and functions that it defines (all when none is given); or equations"},
                    {"--range", &command.own.ranges, "NAME=LOW:HIGH: what a parameter is drawn from"},
                    include_option(command.own.includes),
                    define_option(command.own.defines),
                    {"--inputs", &command.options.inputs, between(2, 1e7),
                     "inputs for each function: a part at random, others with special values or by search"},
                    {"--seed", &command.options.seed, "seed of the inputs"},
                    {"--device", &command.devices,
                     "run the worst inputs on these devices as well (names or indices of gloam devices)"},
                    driver_option(),
                    {"--json", &command.json, "file for all results"},
                    {"--html", &command.html,
                     "file for a page: the source coloured by what its lines lose, worst inputs, rewrites"}},
        .run = [equations] { return run_audit(command, equations); },
        .examples =
            "  gloam audit tone.glsl                              every function, in the domain that it "
            "prints first\n"
            "  gloam audit tone.glsl curve --range x=0:16 --html audit.html\n"
            "  gloam audit tone.glsl --device 0 1                 what two drivers give for the worst "
            "inputs\n"};
}

}  // namespace gloam::cli
