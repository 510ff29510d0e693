// SPDX-License-Identifier: MIT
#include "report/laboratory/summary_lines.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "report/internal/json_fields.hpp"

namespace gloam::report {
namespace {

using internal::JsonReader;
using nlohmann::ordered_json;

constexpr std::streamsize longest_line = 65'536;
constexpr std::size_t most_lines = 2'000'000;

ordered_json line_of(const DriverGroup& key, const GroupSummary& group, const CheckName& name,
                     const CheckTally& tally) {
    return {{"vendor", key.vendor},
            {"driver", key.driver},
            {"version", key.version},
            {"api", key.api},
            {"files", group.files},
            {"devices", group.devices.size()},
            {"equation", name.first},
            {"variant", name.second},
            {"runs", tally.runs},
            {"failed", tally.failed},
            {"not_judged", tally.not_judged},
            {"inputs", tally.inputs},
            {"outside", tally.outside},
            {"worst", internal::number_json(tally.worst)},
            {"reasons", tally.reasons}};
}

void read_line(std::string_view line, EarlierSummary& earlier) {
    const ordered_json json = internal::parse_json(line);
    const JsonReader reader(json, "");
    const DriverGroup group{.vendor = reader.member("vendor").name(),
                            .driver = reader.member("driver").name(),
                            .version = reader.member("version").name(),
                            .api = reader.member("api").name()};
    const CheckName name{reader.member("equation").name(), reader.member("variant").name()};
    earlier.failed[group][name] = reader.member("failed").count() > 0;
}

}  // namespace

std::string to_json_lines(const LaboratorySummary& summary) {
    std::string text;
    for (const auto& [key, group] : summary.groups())
        for (const auto& [name, tally] : group.checks)
            text += line_of(key, group, name, tally)
                        .dump(-1, ' ', false, ordered_json::error_handler_t::replace) +
                    "\n";
    return text;
}

EarlierSummary earlier_from_lines(std::istream& lines) {
    EarlierSummary earlier;
    std::string line(longest_line, '\0');
    for (std::size_t number = 1; lines.getline(line.data(), longest_line) || lines.gcount() > 0; ++number) {
        const std::string_view text(line.data());
        try {
            if (lines.fail() && !lines.eof())
                throw std::runtime_error(fmt::format("longer than {} bytes", longest_line));
            if (number > most_lines) throw std::runtime_error(fmt::format("more than {} lines", most_lines));
            if (!text.empty()) read_line(text, earlier);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(fmt::format("line {}: {}", number, error.what()));
        }
    }
    return earlier;
}

News news_since(const EarlierSummary& before, const LaboratorySummary& now) {
    News news;
    for (const auto& [key, group] : now.groups()) {
        const auto known = before.failed.find(key);
        if (known == before.failed.end()) {
            news.new_groups.push_back(key);
            continue;
        }
        for (const auto& [name, tally] : group.checks) {
            const auto check = known->second.find(name);
            const bool failed_before = check != known->second.end() && check->second;
            if (tally.failed > 0 && !failed_before) news.newly_failed.push_back({key, name});
            if (tally.failed == 0 && failed_before) news.mended.push_back({key, name});
        }
    }
    for (const auto& [key, checks] : before.failed)
        if (!now.groups().contains(key)) news.missing_groups.push_back(key);
    return news;
}

}  // namespace gloam::report
