// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "check/audit.hpp"
#include "cli/commands.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/checker.hpp"
#include "cli/framework/open_device.hpp"
#include "interpreter/program.hpp"
#include "module/include.hpp"
#include "report/audit_report.hpp"
#include "report/output.hpp"

namespace gloam::cli {
namespace {

struct AuditCommand {
    std::filesystem::path file;
    std::vector<std::string> functions;
    std::vector<std::string> ranges;
    std::vector<std::string> includes;
    std::vector<std::string> devices;
    std::string json;
    std::string html;
    check::AuditOptions options;
};

// The functions of the file on one device.
class AuditedFile {
  public:
    explicit AuditedFile(const AuditCommand& command)
        : command_(command),
          own_(own_file(command.file.string(), command.functions, command.ranges, command.includes)),
          text_(shader::read_text(command.file)) {
        for (const check::LeftOut& function : own_.functions.left_out)
            fmt::print("{}\n", base::one_line(fmt::format("{}: {} was left out: {}", command.file.string(),
                                                          function.name, function.why)));
        for (const std::string& made : own_.by_macro)
            fmt::print("{}: {}: functions that a macro makes are not looked at\n", command.file.string(),
                       made);
        if (functions().empty())
            throw std::runtime_error(fmt::format("{}: nothing was audited: {}", command.file.string(),
                                                 why_nothing(own_.functions.left_out)));
    }

    [[nodiscard]] const std::vector<check::OwnFunction>& functions() const { return own_.functions.found; }
    [[nodiscard]] const std::string& text() const { return text_; }

    [[nodiscard]] check::Lab lab(const std::string& device) const {
        return lab_of_file(command_.file, command_.includes, device);
    }

    [[nodiscard]] check::Audit audit(const check::Lab& lab, const check::OwnFunction& function) const {
        return check::audit(lab, name(), function, ranges_from(command_.ranges), command_.options);
    }

    void add_witness(check::Audit& audit, const check::Lab& lab, const check::OwnFunction& function) const {
        check::add_witness(audit, lab,
                           check::question_of(lab, name(), function, ranges_from(command_.ranges)),
                           command_.options);
    }

  private:
    [[nodiscard]] std::string name() const { return command_.file.filename().string(); }

    const AuditCommand& command_;
    OwnFile own_;
    std::string text_;
};

// One function after the other, each shown as soon as it is known: what is stopped has said what it knew.
std::vector<check::Audit> audits_of(const AuditCommand& command, const AuditedFile& file) {
    std::vector<check::Audit> audits;
    const check::Lab interpreter = file.lab(std::string(check::interpreter_name));
    if (!command.devices.empty()) require_good_drivers();
    std::vector<check::Lab> labs;
    for (const std::string& device : command.devices) labs.push_back(file.lab(device));
    for (const check::OwnFunction& function : file.functions()) {
        try {
            audits.push_back(file.audit(interpreter, function));
        } catch (const interpreter::Error& error) {
            throw std::runtime_error(
                fmt::format("{}: {}: {}", command.file.string(), function.name, error.what()));
        }
        for (const check::Lab& lab : labs) file.add_witness(audits.back(), lab, function);
        fmt::print("{}\n", to_text(audits.back()));
        (void)std::fflush(stdout);
    }
    return audits;
}

int run_audit(const AuditCommand& command) {
    const report::OutputFile json(command.json);
    const report::OutputFile html(command.html);
    const AuditedFile file(command);
    const report::AuditReport report{
        .file = command.file.string(), .source = file.text(), .audits = audits_of(command, file)};
    int status = 0;
    for (const check::Audit& audit : report.audits) {
        if (audit.is_broken()) status = 1;
        if (!audit.was_run() && status == 0) status = 2;
    }
    if (!command.json.empty()) json.write(to_audit_json(report));
    if (!command.html.empty()) html.write(to_audit_page(report));
    return status;
}

}  // namespace

void add_audit(CLI::App& app, int& status) {
    auto command = std::make_shared<AuditCommand>();
    CLI::App* audit = app.add_subcommand(
        "audit",
        "show where a shader function itself goes wrong: NaN, lost digits, jumps, what drivers may do");
    audit->add_option("file", command->file, "a GLSL file")->required();
    audit->add_option("function", command->functions, "functions that it defines (all when none is given)");
    audit->add_option("--range", command->ranges, "NAME=LOW:HIGH: what a parameter is drawn from");
    add_include_option(*audit, command->includes);
    audit->add_option("--inputs", command->options.inputs, "inputs for each function, half of them by search")
        ->check(CLI::Range(std::size_t{2}, std::size_t{10'000'000}))
        ->capture_default_str();
    audit->add_option("--seed", command->options.seed, "seed of the inputs")->capture_default_str();
    audit->add_option("--device", command->devices,
                      "run the worst inputs on these devices as well (names or indices of gloam devices)");
    add_driver_option(*audit);
    audit->add_option("--json", command->json, "file for all results");
    audit->add_option("--html", command->html,
                      "file for a page: the source coloured by what its lines lose, worst inputs, rewrites");
    audit->callback([command, &status] { status = run_audit(*command); });
}

}  // namespace gloam::cli
