// SPDX-License-Identifier: MIT
#include "cli/occlusion/bench/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"
#include "experiment/table.hpp"
#include "pictures/sheet.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
using experiment::Experiment;

// A part of a page that a command generates: the text between the lines "<!-- begin NAME -->" and "<!-- end
// NAME -->".
struct PageBlock {
    std::string name;
    std::string text;  // whole lines
};

// The position of a line that must occur exactly once.
std::size_t line_in(const std::string& page, const std::string& line) {
    const std::size_t at = page.find(line);
    if (at == std::string::npos || page.find(line, at + 1) != std::string::npos)
        throw std::invalid_argument(fmt::format("the page: expected one line \"{}\"", line));
    return at;
}

// The page with its blocks replaced. Throws std::invalid_argument with the block's name unless the page
// contains its two lines, in this order, exactly once.
std::string with_blocks(std::string page, const std::vector<PageBlock>& blocks) {
    for (const PageBlock& block : blocks) {
        const std::string begin = fmt::format("<!-- begin {} -->\n", block.name);
        const std::string end = fmt::format("<!-- end {} -->", block.name);
        const std::size_t first = line_in(page, begin) + begin.size();
        const std::size_t last = line_in(page, end);
        if (last < first)
            throw std::invalid_argument(fmt::format("the page: block {} ends before it begins", block.name));
        page.replace(first, last - first, "\n" + block.text + "\n");
    }
    return page;
}

// Blocks of a page: of the tables that have names, or one of all.
std::vector<PageBlock> blocks_of(const Experiment& what, const experiment::Text& tables,
                                 const std::string& heading) {
    std::vector<PageBlock> blocks;
    for (const experiment::Table& table : what.tables)
        if (!table.name.empty())
            blocks.push_back(
                {table.name, tables.named.contains(table.name) ? tables.named.at(table.name) : ""});
    if (blocks.empty()) blocks.push_back({what.name, heading + tables.text});
    return blocks;
}

// Without what leads into another folder or has to be quoted.
std::string file_name(std::string name) {
    std::erase_if(name, [](char c) { return c == ',' || c == ':' || c == '(' || c == ')'; });
    std::ranges::replace(name, ' ', '-');
    return base::file_name_of(name);
}

std::string report_text(const Measured& measured, const std::string& heading) {
    return fmt::format("# {}\n\n{}.\n\n{}{}\n", measured.what.name, measured.what.about, heading,
                       measured.tables.report);
}

}  // namespace

std::string heading_of(const Measured& measured) {
    const experiment::Conditions& conditions = measured.record.conditions();
    std::string text = measured.database.text("SELECT count(*) FROM cases");
    text += fmt::format(" cases on {} ({})", conditions.device, conditions.driver);
    for (const auto& row : measured.database.select("SELECT size FROM sizes").all)
        text += fmt::format(",\n{} pixels", experiment::text_of(row[0]));
    text += fmt::format(", {} rounds", measured.database.text("SELECT coalesce(max(round), 0) FROM rounds"));
    if (conditions.rays > 0)
        text += fmt::format(",\nthe last {} of {} frames, the truth of {} rays a pixel", conditions.scored,
                            conditions.frames, conditions.rays);
    return text + ".\n";
}

ExperimentFiles::ExperimentFiles(const ExperimentPaths& paths, const Experiment& what)
    : paths_(paths),
      old_page_(paths.page.empty() ? "" : base::read_file(paths.page)),
      json_(paths.json),
      csv_(paths.csv),
      page_(paths.page),
      report_(paths.report) {
    if (!paths.page.empty()) (void)with_blocks(old_page_, blocks_of(what, {}, ""));
    if (!paths.out.empty()) out_.emplace(paths.out);
}

fs::path ExperimentFiles::journal() {
    if (!out_) return {};
    out_->keep();  // even if the run fails, because of the journal
    return out_->path() / "journal.jsonl";
}

void ExperimentFiles::show(const experiment::Picture& picture) {
    constexpr double full_error = 0.1;  // as bright as the scale goes
    const auto [width, height] = picture.extent;
    const bool error = picture.kind == "error";
    const bool part = picture.kind == "convergence" || picture.kind == "samples";
    out_->write(file_name(picture.name) + ".png",
                error || part
                    ? base::to_png(base::heat_rgb(picture.values, error ? full_error : 1.0), width, height)
                    : pictures::to_visibility_png(picture.values, width, height));
    out_->keep();  // a run that is taken up again does not measure what the picture shows
}

void ExperimentFiles::write(const Measured& measured, const std::string& heading,
                            const std::string& versions) {
    const std::string json = to_json(measured.database, measured.record, versions);
    const std::string csv = to_csv(measured.database);
    json_.write(json);
    csv_.write(csv);
    if (!paths_.page.empty())
        page_.write(with_blocks(old_page_, blocks_of(measured.what, measured.tables, heading)));
    report_.write(report_text(measured, heading));
    if (!out_) return;
    out_->write("results.json", json);
    out_->write("results.csv", csv);
    out_->keep();
}

}  // namespace gloam::cli
