// SPDX-License-Identifier: MIT
#include "cli/framework/cost.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/process.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/environment.hpp"
#include "cli/framework/own_file.hpp"
#include "module/include.hpp"
#include "module/spirv.hpp"
#include "subject/kernel_code.hpp"

namespace gloam::cli {
namespace {

struct CostCommand {
    std::string file;
    std::vector<std::string> functions;
    std::string preset;
    std::vector<std::string> set;  // NAME=VALUE, of the preset
    std::optional<double> tiles;   // share that is swept in full
    OwnFileOptions own;
    cost::CostOptions options;
    std::optional<double> below;
    bool json = false;
};

struct CostRow {
    FramePass pass;  // of a frame; otherwise its name alone
    cost::Cost cost;

    // Of a pixel of the view, as all below.
    [[nodiscard]] double valu() const { return pass.share * static_cast<double>(cost.valu) / pass.pixels; }
    [[nodiscard]] double bytes() const { return pass.share * pass.bytes; }

    // Of a view of 1920 x 1080 pixels: the model of docs/cost.md.
    [[nodiscard]] double microseconds() const {
        const double loads = pass.share * static_cast<double>(cost.loads) / pass.pixels;
        return 4.92 + std::max({0.00062 * pass.share * pass.groups, 0.0345 * valu() + 2.25 * loads,
                                0.302 * bytes()});
    }
};

// The text with definitions behind its #version line, and its own numbers of lines.
std::string with_definitions(std::string text, const std::vector<std::string>& defines) {
    if (defines.empty()) return text;
    const std::size_t version = text.find("#version");
    const std::size_t end = version == std::string::npos ? std::string::npos : text.find('\n', version);
    const std::size_t at = end == std::string::npos ? 0 : end + 1;
    return text.insert(
        at, fmt::format("{}#line {}\n", module::definitions_of(defines),
                        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1));
}

std::vector<CostRow> cost_of_shader(const CostCommand& command, const std::filesystem::path& file) {
    const std::string text = with_definitions(module::read_text(file), command.own.defines);
    const module::Spirv module = base::tried(file, [&] {
        return subject::shader_cache({.cache_directory = cache_directory()})
            .compile({std::filesystem::absolute(file).string(), text},
                     {.include_roots = include_roots_of(file, command.own.includes)});
    });
    return {{{.name = file.filename().string()}, cost_of(module, command.options)}};
}

std::vector<CostRow> cost_of_functions(const CostCommand& command, const std::filesystem::path& file,
                                       bool& complete) {
    FileFunctions read = functions_of(file, command.functions, command.own);
    auto& [own, functions] = read;
    std::vector<subject::Skipped>& left_out = functions.left_out;
    std::erase_if(functions.found, [&](const subject::OwnFunction& one) {
        const bool of_quad = one.team.kind == backend::Team::Kind::quad;
        if (of_quad) left_out.push_back({one.name, "it needs the derivatives of a fragment shader"});
        return of_quad;
    });
    if (functions.found.empty()) throw nothing_was("counted", file.string(), left_out);
    for (const subject::Skipped& one : left_out)
        fmt::print(stderr, "{}\n", base::one_line(fmt::format("{} was left out: {}", one.name, one.why)));
    complete = read.is_complete(!command.functions.empty());
    const subject::Lab lab = lab_of(own);
    std::vector<module::Spirv> kernels;
    for (const subject::OwnFunction& one : functions.found)
        kernels.push_back(cost_kernel(lab, one.file, one.function.name, one.signature()));
    std::vector<CostRow> rows;
    for (const cost::Cost& one : costs_of(kernels, command.options))
        rows.push_back({{.name = functions.found[rows.size()].name}, one});
    return rows;
}

std::vector<CostRow> cost_of_frame(const CostCommand& command, const PresetFrame& frame) {
    std::vector<CostRow> rows;
    for (const FramePass& pass : frame.passes) {
        cost::CostOptions of_pass = command.options;
        of_pass.constants = pass.constants;
        rows.push_back({pass, cost_of(pass.module, of_pass)});
    }
    return rows;
}

std::string text_of_costs(const CostCommand& command, const std::vector<CostRow>& rows, double memory) {
    const bool frame = !command.preset.empty();
    std::size_t width = 4;
    for (const CostRow& row : rows) width = std::max(width, row.pass.name.size());
    std::string text =
        fmt::format("{:{}}", command.options.family, std::max(width, command.options.family.size()));
    width = text.size();
    for (const cost::CostField& field : cost::cost_fields)
        text += fmt::format(" {:>{}}", field.name, field.name.size());
    text += frame ? "  pixels  share  valu/px  bytes/px     us\n" : "\n";
    double valu = 0.0;
    double bytes = 0.0;
    double microseconds = 0.0;
    for (const CostRow& row : rows) {
        text += fmt::format("{:{}}", base::one_line(row.pass.name), width);
        for (const cost::CostField& field : cost::cost_fields)
            text += fmt::format(" {:>{}}", row.cost.*field.value, field.name.size());
        if (frame)
            text += fmt::format(" {:>7.3g} {:>6.3g} {:>8.1f} {:>9.1f} {:>6.1f}", row.pass.pixels,
                                row.pass.share, row.valu(), row.bytes(), row.microseconds());
        text += '\n';
        valu += row.valu();
        bytes += row.bytes();
        microseconds += row.microseconds();
    }
    if (frame)
        text += fmt::format(
            "a frame of {}: {:.0f} vector instructions, {:.1f} bytes a pixel; {:.0f} us by the model; {:.1f} "
            "MB\n",
            command.preset, valu, bytes, microseconds, 1e-6 * memory);
    return text;
}

nlohmann::ordered_json json_of_costs(const CostCommand& command, const std::vector<CostRow>& rows,
                                     double memory) {
    nlohmann::ordered_json json{{"gloam", base::version()}, {"family", command.options.family}};
    const bool frame = !command.preset.empty();
    if (frame) json["preset"] = command.preset;
    if (frame) json["memory_bytes"] = memory;
    auto& shaders = json[frame ? "passes" : "shaders"] = nlohmann::ordered_json::array();
    for (const CostRow& row : rows) {
        nlohmann::ordered_json one{{"name", row.pass.name}};
        for (const cost::CostField& field : cost::cost_fields)
            one[std::string(field.name)] = row.cost.*field.value;
        if (frame) {
            one["pixels"] = row.pass.pixels;
            one["share"] = row.pass.share;
            one["valu_per_pixel"] = row.valu();
            one["bytes_per_pixel"] = row.bytes();
            one["microseconds"] = row.microseconds();
        }
        shaders.push_back(std::move(one));
    }
    return json;
}

// Whether a frame, or a shader, costs more than --below. Says so.
bool costs_more(const CostCommand& command, const std::vector<CostRow>& rows) {
    std::vector<std::pair<std::string, double>> all;
    if (!command.preset.empty()) all.emplace_back(command.preset, 0.0);
    for (const CostRow& row : rows) {
        if (command.preset.empty()) all.emplace_back(row.pass.name, 0.0);
        all.back().second += row.valu();
    }
    bool more = false;
    for (const auto& [name, valu] : all) {
        if (!command.below || valu <= *command.below) continue;
        more = true;
        fmt::print(stderr, "{}\n",
                   base::one_line(fmt::format("{}: {:g} vector instructions, allowed are {:g}", name, valu,
                                              *command.below)));
    }
    return more;
}

int run_cost(CostCommand& command, EquationsNamed* equations, FrameOf* frame_of) {
    if (command.file.empty() == command.preset.empty())
        throw std::invalid_argument("expected a file, or --preset NAME");
    if (!command.file.empty()) {
        if (!command.set.empty()) throw std::invalid_argument("--set: expected --preset NAME");
        if (command.tiles) throw std::invalid_argument("--tiles: expected --preset NAME");
        command.functions.insert(command.functions.begin(), command.file);
        std::tie(command.file, command.functions) = file_and_functions(command.functions, equations);
    }
    PresetFrame frame;
    if (command.file.empty()) frame = frame_of(command.preset, command.set, command.tiles);
    const std::filesystem::path file = command.file;
    const bool whole = file.extension() == ".comp" && command.functions.empty();
    bool complete = true;
    const std::vector<CostRow> rows = file.empty() ? cost_of_frame(command, frame)
                                      : whole      ? cost_of_shader(command, file)
                                                   : cost_of_functions(command, file, complete);
    if (command.json)
        fmt::print("{}\n", json_of_costs(command, rows, frame.memory)
                               .dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    else
        fmt::print("{}", text_of_costs(command, rows, frame.memory));
    if (costs_more(command, rows)) return 1;
    return complete ? 0 : 2;
}

}  // namespace

module::Spirv cost_kernel(const subject::Lab& lab, const std::string& file, const std::string& function,
                          const subject::Signature& signature) {
    subject::KernelSource source = lab.source(file, function, signature);
    source.preserve_nan = false;
    return lab.compile_kernel({"kernel of " + function, kernel_code(source)}, source.images);
}

Command cost_command(EquationsNamed* equations, FrameOf* frame) {
    static CostCommand command;
    return {
        .name = "cost",
        .about = "count what a GPU pays for a shader, by a GPU's compiler, without a GPU",
        .options =
            {{"file", &command.file, "a GLSL file, a whole compute shader (.comp), or an equation"},
             {"function", &command.functions, "functions that it defines (all when none is given)"},
             {"--preset", &command.preset,
              "the passes of one frame of 1920 x 1080 pixels instead (gloam list presets)"},
             {"--set", &command.set, repeated, "with --preset: SETTING=VALUE; may be repeated"},
             {"--tiles", &command.tiles, between(0, 1),
              "with --preset: the share of tiles that are swept in full, 0 to 1; otherwise that of its "
              "views"},
             include_option(command.own.includes),
             define_option(command.own.defines),
             {"--family", &command.options.family,
              fmt::format("the chip: {}", fmt::join(cost::families, ", "))},
             {"--below", &command.below,
              "most vector instructions, of an invocation or of a frame's pixel; above it the status is 1"},
             validation_option(command.options.validation),
             {"--json", &command.json, "as JSON"}},
        .run = [=] { return run_cost(command, equations, frame); },
        .examples =
            "  gloam cost tone.glsl curve --below 40              a function; status 1 above 40 vector "
            "instructions\n"
            "  gloam cost blur.comp --define RADIUS=3             a whole compute shader\n"
            "  gloam cost --preset balanced --family NAVI31       the passes of a frame\n"};
}

}  // namespace gloam::cli
