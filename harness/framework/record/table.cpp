// SPDX-License-Identifier: MIT
#include "record/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gloam::record {
namespace {

// The titles, then the texts of each row.
std::vector<std::vector<std::string>> lines_of(const Table& table) {
    std::vector<std::vector<std::string>> lines(1);
    for (const Column& column : table.columns) lines.front().push_back(column.title);
    for (const auto& row : table.rows)
        for (std::vector<std::string>& line = lines.emplace_back(); const Cell& cell : row)
            line.push_back(cell.text);
    return lines;
}

}  // namespace

std::string aligned(const Table& table) {
    std::vector<std::size_t> widths(table.columns.size(), 0);
    const auto lines = lines_of(table);
    for (const auto& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    std::string text;
    for (const auto& line : lines) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) row += fmt::format("{:<{}}  ", line[i], widths[i]);
        text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string to_markdown(const Table& table) {
    std::string text;
    for (const auto& line : lines_of(table)) {
        const bool first = text.empty();
        text += "|";
        for (const std::string& cell : line) {
            text += cell.empty() ? "" : " ";
            for (const char c : cell) text += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
            text += " |";
        }
        text += "\n";
        if (!first) continue;
        text += "|";
        for (const Column& column : table.columns) text += column.numeric ? " --: |" : " --- |";
        text += "\n";
    }
    return text;
}

}  // namespace gloam::record
