// SPDX-License-Identifier: MIT
#include "report/laboratory.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"

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
    const std::string names = base::lower(device.name + " " + device.driver);
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

std::size_t GroupSummary::failing() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(checks, [](const auto& each) { return each.second.failed > 0; }));
}

std::size_t GroupSummary::not_judged() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        checks, [](const auto& each) { return each.second.not_judged == each.second.runs; }));
}

namespace {

// The numbers of a version, in their order: by them "9.1" is older than "10.0".
std::vector<std::uint64_t> numbers_of(std::string_view version) {
    constexpr std::uint64_t most = 1'000'000'000'000'000;  // longer numbers are names of commits, say
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 0; i < version.size(); ++i) {
        if (!is_digit(version[i])) continue;
        if (i == 0 || !is_digit(version[i - 1])) numbers.push_back(0);
        numbers.back() = std::min(most, numbers.back() * 10 + static_cast<std::uint64_t>(version[i] - '0'));
    }
    return numbers;
}

// The build with which another one of the same driver is compared; none: end.
LaboratorySummary::const_iterator build_before(const LaboratorySummary& before, const DriverGroup& now) {
    const auto same = before.find(now);
    if (same != before.end()) return same;
    const auto wanted = numbers_of(now.version);
    auto best = before.end();
    for (auto each = before.begin(); each != before.end(); ++each) {
        const DriverGroup& group = each->first;
        if (group.vendor != now.vendor || group.driver != now.driver || group.api != now.api) continue;
        if (best == before.end()) {
            best = each;
            continue;
        }
        const auto numbers = numbers_of(group.version);
        const auto known = numbers_of(best->first.version);
        const bool older = numbers < wanted;
        const bool known_older = known < wanted;
        if (older != known_older ? older : (older ? known < numbers : numbers < known)) best = each;
    }
    return best;
}

bool exceeds(double larger, double smaller) {
    return larger > 1.1 * smaller && larger > smaller + 0.01;
}

void compare(const GroupSummary& earlier, const GroupSummary& later, const CheckChange& builds, News& news) {
    for (const auto& [name, tally] : later.checks) {
        const auto known = earlier.checks.find(name);
        CheckChange change = builds;
        change.check = name;
        change.worst_now = tally.worst;
        if (known == earlier.checks.end()) {
            if (tally.failed > 0) news.newly_failed.push_back(change);
            continue;
        }
        change.worst_before = known->second.worst;
        const bool failed_before = known->second.failed > 0;
        if (tally.failed > 0 && !failed_before) {
            news.newly_failed.push_back(change);
        } else if (tally.failed == 0 && failed_before) {
            if (tally.not_judged < tally.runs) news.mended.push_back(change);
        } else if (exceeds(change.worst_now, change.worst_before)) {
            news.grew.push_back(change);
        } else if (exceeds(change.worst_before, change.worst_now)) {
            news.shrank.push_back(change);
        }
    }
}

}  // namespace

News news_since(const LaboratorySummary& before, const LaboratorySummary& now) {
    News news;
    std::set<DriverGroup> compared;
    for (const auto& [key, group] : now) {
        const auto known = build_before(before, key);
        if (known == before.end()) {
            news.new_groups.push_back(key);
            continue;
        }
        compared.insert(known->first);
        if (known->first != key) news.builds.emplace_back(known->first, key);
        compare(known->second, group, {.before = known->first, .now = key, .check = {}}, news);
    }
    for (const auto& [key, group] : before)
        if (!compared.contains(key) && !now.contains(key)) news.missing_groups.push_back(key);
    return news;
}

}  // namespace gloam::report
