// SPDX-License-Identifier: MIT
#include "experiment/table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/number.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "record/table.hpp"

namespace gloam::experiment {
namespace {

using nlohmann::ordered_json;

constexpr const char* measured = "SELECT * FROM result WHERE measured ORDER BY rowid";

// The SELECT, in which lines with "{}" that stand together are repeated for each of the names. These stand
// there in single quotes.
std::string expanded(const Table& table, const Database& database, const std::string& size) {
    std::vector<std::string> names;
    if (!table.each.empty())
        for (const std::string& name : database.texts(table.each, size))
            names.push_back(base::replaced(name, "'", "''"));
    std::string text;
    const auto repeats = [](const std::string& line) { return line.find("{}") != std::string::npos; };
    for (auto line = table.select.begin(); line != table.select.end();) {
        if (!repeats(*line)) {
            text += *line++ + "\n";
            continue;
        }
        const auto end = std::find_if_not(line, table.select.end(), repeats);
        for (const std::string& name : names)
            for (auto repeated = line; repeated != end; ++repeated)
                text += base::replaced(*repeated, "{}", name) + "\n";
        line = end;
    }
    return text;
}

// "1.5", "**1.5**", "15 %", "1.50, at most 2: met".
bool is_number(std::string_view cell) {
    cell.remove_prefix(std::min(cell.find_first_not_of("*+"), cell.size()));
    const std::string_view digits = cell.substr(0, cell.find_first_of("*, "));
    return base::number_from<double>(digits) &&
           (digits.size() == cell.size() || cell[digits.size()] != ' ' || cell.substr(digits.size()) == " %");
}

// Columns of numbers are aligned at the right.
record::Table shown(const Rows& rows) {
    record::Table table;
    for (std::size_t i = 0; i < rows.headings.size(); ++i)
        table.columns.push_back(
            {.title = rows.headings[i], .numeric = std::ranges::all_of(rows.all, [&](const auto& row) {
                                            const std::string cell = text_of(row[i]);
                                            return cell == "-" || is_number(cell);
                                        })});
    for (const std::vector<Value>& row : rows.all)
        for (auto& cells = table.rows.emplace_back(); const Value& value : row)
            cells.emplace_back(text_of(value));
    return table;
}

// Once for each size that there is, or once if the SELECT does not name it.
void add_table(Text& all, const Table& table, const Database& database) {
    std::vector<std::string> sizes;
    if (std::ranges::any_of(table.select, [](const auto& line) { return line.find(":size") != line.npos; }))
        sizes = database.texts("SELECT size FROM sizes");
    if (sizes.empty()) sizes.emplace_back();
    for (const std::string& size : sizes) {
        const Rows rows = database.select(expanded(table, database, size), size);
        if (rows.all.empty()) continue;
        const record::Table cells = shown(rows);
        for (const auto& row : cells.rows)
            for (const record::Cell& cell : row) all.missed |= cell.text.ends_with("missed");
        const std::string text = (sizes.size() > 1 ? size + ":\n\n" : "") + record::to_markdown(cells);
        all.report += "\n" + text;
        if (!table.in_report) all.text += "\n" + text;
        if (table.name.empty()) continue;
        std::string& block = all.named[table.name];
        block += (block.empty() ? "" : "\n") + text;
    }
}

ordered_json json_of(const Value& value) {
    if (std::holds_alternative<std::monostate>(value)) return nullptr;
    if (const auto* const number = std::get_if<double>(&value)) return *number;
    if (const auto* const count = std::get_if<std::int64_t>(&value)) return *count;
    return std::get<std::string>(value);
}

ordered_json json_of(const Rows& rows) {
    ordered_json all = ordered_json::array();
    for (const std::vector<Value>& row : rows.all) {
        ordered_json& object = all.emplace_back(ordered_json::object());
        for (std::size_t i = 0; i < row.size(); ++i) object[rows.headings[i]] = json_of(row[i]);
    }
    return all;
}

std::string csv_of(const Value& value) {
    if (std::holds_alternative<std::monostate>(value)) return "";
    if (!std::holds_alternative<std::string>(value)) return text_of(value);
    return '"' + base::replaced(text_of(value), "\"", "\"\"") + '"';
}

}  // namespace

Text to_text(const Experiment& experiment, const Database& database) {
    Text all;
    for (std::size_t i = 0; i < experiment.tables.size(); ++i) {
        try {
            add_table(all, experiment.tables[i], database);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("experiment {}: tables[{}]: {}", experiment.name, i, error.what()));
        }
    }
    return all;
}

std::string to_json(const Database& database, const Record& record, const std::string& versions) {
    ordered_json document{{"gloam", base::version()}, {"versions", versions}};
    document.update(ordered_json::parse(line_of(record.conditions())));
    document["results"] = json_of(database.select(measured));
    document["passes"] = json_of(database.select("SELECT * FROM passes ORDER BY rowid"));
    document["visits"] = ordered_json::array();
    for (const Visit& visit : record.visits())
        document["visits"].push_back(ordered_json::parse(line_of(visit)));
    return document.dump(1) + "\n";
}

std::string to_csv(const Database& database) {
    const Rows rows = database.select(measured);
    std::string text = fmt::format("{}\n", fmt::join(rows.headings, ","));
    for (const std::vector<Value>& row : rows.all) {
        std::vector<std::string> fields;
        std::ranges::transform(row, std::back_inserter(fields), csv_of);
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

}  // namespace gloam::experiment
