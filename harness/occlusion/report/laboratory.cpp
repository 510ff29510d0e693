// SPDX-License-Identifier: MIT
#include "report/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "report/internal/json_fields.hpp"

namespace gloam::report {

namespace {

// Part of a device's or driver's name, in lower case, and whose it is. The first that is found counts, so
// those that run on others' hardware come first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> marks{
    {{"llvmpipe", "Mesa"},  {"softpipe", "Mesa"},  {"swiftshader", "Google"},  {"nvidia", "NVIDIA"},
     {"geforce", "NVIDIA"}, {"quadro", "NVIDIA"},  {"radeon", "AMD"},          {"amd ", "AMD"},
     {"radv", "AMD"},       {"intel", "Intel"},    {"adreno", "Qualcomm"},     {"qualcomm", "Qualcomm"},
     {"mali", "Arm"},       {"immortalis", "Arm"}, {"powervr", "Imagination"}, {"xclipse", "Samsung"},
     {"apple", "Apple"},    {"v3d", "Broadcom"},   {"videocore", "Broadcom"},  {"interpreter", "gloam"}}};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Where the version begins: at the first word that starts with a digit, or with v and a digit.
std::size_t version_at(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
        const std::size_t digit = text[i] == 'v' || text[i] == 'V' ? i + 1 : i;
        if (starts && digit < text.size() && is_digit(text[digit])) return i;
    }
    return text.size();
}

std::string trimmed(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" (");
    return std::string(text.substr(0, last == std::string_view::npos ? 0 : last + 1));
}

}  // namespace

DriverGroup group_of(const DeviceSummary& device) {
    const std::string names = lower(device.name + " " + device.driver);
    const auto* mark = std::ranges::find_if(
        marks, [&](const auto& each) { return names.find(each.first) != std::string::npos; });
    const std::string& text = device.driver.empty() ? device.name : device.driver;
    const std::size_t at = version_at(text);
    return {.vendor = mark == marks.end() ? "other" : std::string(mark->second),
            .driver = trimmed(std::string_view(text).substr(0, at)),
            .version = text.substr(at),
            .api = api_of(device)};
}

std::string name_of(const DriverGroup& group) {
    const char* between = group.driver.empty() || group.version.empty() ? "" : " ";
    return group.driver + between + group.version + ", " + group.api;
}

namespace {

constexpr std::size_t most_groups = 10'000;
constexpr std::size_t most_devices = 1'000;
constexpr std::size_t most_checks = 2'000'000;

void add(CheckTally& tally, const CheckTally& other) {
    tally.runs += other.runs;
    tally.failed += other.failed;
    tally.not_judged += other.not_judged;
    tally.inputs += other.inputs;
    tally.outside += other.outside;
    tally.worst = std::max(tally.worst, other.worst);
    tally.reasons.insert(other.reasons.begin(), other.reasons.end());
}

CheckTally tally_of(const ResultRow& row) {
    const bool failed = row.outcome == check::Outcome::failed;
    CheckTally tally{.runs = 1,
                     .failed = failed ? 1U : 0U,
                     .not_judged = row.outcome == check::Outcome::not_judged ? 1U : 0U,
                     .inputs = row.inputs,
                     .outside = row.outside,
                     .worst = row.fraction > 0.0 ? row.fraction : 0.0};
    if (failed && !row.reason.empty()) tally.reasons.insert(row.reason);
    return tally;
}

void require_at_most(std::size_t most, std::size_t found, const char* what) {
    if (found > most)
        throw std::runtime_error(fmt::format("more than {} {}: summarise fewer files at once", most, what));
}

}  // namespace

std::size_t GroupSummary::failing() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(checks, [](const auto& each) { return each.second.failed > 0; }));
}

std::size_t GroupSummary::not_judged() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        checks, [](const auto& each) { return each.second.not_judged == each.second.runs; }));
}

void LaboratorySummary::add_file(std::string_view text) {
    LaboratorySummary one;
    read_results(text, [&](const DeviceSummary& device, const ResultRow& row) {
        GroupSummary& group = one.groups_[group_of(device)];
        group.files = 1;
        group.devices.insert(device.name);
        add(group.checks[{row.equation, row.variant}], tally_of(row));
    });
    one.files_ = 1;
    merge(one);
}

void LaboratorySummary::merge(const LaboratorySummary& other) {
    for (const auto& [key, from] : other.groups_) {
        GroupSummary& group = groups_[key];
        group.files += from.files;
        group.devices.insert(from.devices.begin(), from.devices.end());
        for (const auto& [name, tally] : from.checks) add(group.checks[name], tally);
    }
    files_ += other.files_;
    require_bounds();
}

void LaboratorySummary::require_bounds() const {
    require_at_most(most_groups, groups_.size(), "groups of drivers");
    std::size_t checks = 0;
    for (const auto& [key, group] : groups_) {
        require_at_most(most_devices, group.devices.size(), "devices of one driver");
        checks += group.checks.size();
    }
    require_at_most(most_checks, checks, "checks");
}

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
