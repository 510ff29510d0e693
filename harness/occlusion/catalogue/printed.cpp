// SPDX-License-Identifier: MIT
#include "catalogue/printed.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <map>
#include <ranges>

#include "catalogue/catalogue.hpp"

namespace gloam::catalogue {
namespace {

constexpr std::string_view table =
#include "catalogue/printed_rows.inc"
    ;

std::vector<std::string> parts_of(std::string_view text, std::string_view between) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(between, at), text.size());
        std::string_view part = text.substr(at, end - at);
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        if (!part.empty() || between != ";") parts.emplace_back(part);
        at = end + between.size();
    }
    return parts;
}

struct Table {
    std::vector<PrintedRow> rows;
    std::vector<Erratum> errata;
};

Table read() {
    Table all;
    std::string paper;
    for (const std::string& line : parts_of(table, "\n")) {
        if (line.starts_with("# ")) paper = line.substr(2);
        const std::vector<std::string> fields = parts_of(line, "|");
        if (line.starts_with("! "))
            all.errata.emplace_back(fields.at(0).substr(2), fields.at(1), fields.at(2));
        else if (fields.size() == 4)
            all.rows.emplace_back(paper, parts_of(fields[0], ";"), parts_of(fields[1], ";"), fields[2],
                                  parts_of(fields[3], ";"));
    }
    return all;
}

const Table& all() {
    static const Table all = read();
    return all;
}

// Lower case without signs, but for dots in numbers, brackets of references and globs; the source first, by
// its ID: "figure 3 of ISSAO" is "issao figure 3", "Mattausch (6)" is "cgf 6".
std::string plain(std::string_view text) {
    static const std::map<std::string, std::string> synonyms{
        {"mattausch", "cgf"}, {"aalund", "cs"}, {"study", "cs"},    {"qiu", "issao"}, {"equation", "eq"},
        {"equations", "eq"},  {"eqs", "eq"},    {"sec", "section"}, {"fig", "figure"}};
    std::string source;
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto is = [&](std::size_t at, std::string_view signs) {
            return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 ||
                                        signs.find(text[at]) != std::string_view::npos);
        };
        if (is(i, "[*?") || (is(i, ".") && i > 0 && is(i - 1, "") && is(i + 1, "*?")))
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
        else if (text[i] != '_' && !words.back().empty())
            words.emplace_back();
    }
    for (std::string& word : words) {
        if (const auto known = synonyms.find(word); known != synonyms.end()) word = known->second;
        if (source.empty() && (word == "tssao" || word == "cgf" || word == "issao" || word == "cs"))
            source = std::exchange(word, "");
    }
    std::string joined = source;
    for (const std::string& word : words)
        if (!word.empty() && word != "of" && (word != "eq" || source.empty()))
            joined += (joined.empty() ? "" : " ") + word;
    return joined;
}

struct Keys {
    std::vector<std::string> numbers, others;
};

Keys keys_of(const PrintedRow& row) {
    Keys keys;
    for (const std::string& place : row.places) {
        const std::size_t end = std::min(place.find_first_of(" -,"), place.size());
        const std::string rest = place.substr(std::min(end + 1, place.size()));
        const bool counted = !rest.empty() && std::isdigit(static_cast<unsigned char>(rest.front())) != 0;
        const bool number =
            counted && place[end] == '-' && rest.find_first_not_of("0123456789.") == std::string::npos;
        (number ? keys.numbers : keys.others).push_back(plain(place));
        if (number) keys.numbers.push_back(plain("eq " + rest));
        keys.others.push_back(plain(rest));
        for (const std::string& half : parts_of(place, ": "))
            for (const std::string& part : parts_of(half, ", "))
                if (!place.starts_with(part)) keys.others.push_back(plain(part));
        if (counted && !number)
            for (const std::string& source : {std::string(), place.substr(0, end)})
                keys.others.push_back(plain(source + " section " + rest));
    }
    for (const std::string& phrase : row.phrases) keys.others.push_back(plain(phrase));
    return keys;
}

}  // namespace

const std::vector<PrintedRow>& printed_rows() {
    return all().rows;
}

const std::vector<Erratum>& errata() {
    return all().errata;
}

std::vector<PrintedRow> rows_named(std::string_view name) {
    const std::string asked = plain(name);
    std::vector<PrintedRow> numbers, others, parts;
    const auto fits = [&](const std::string& key) { return matches_glob(key, asked); };
    for (const PrintedRow& row : printed_rows()) {
        const Keys keys = keys_of(row);
        if (std::ranges::any_of(keys.numbers, fits)) numbers.push_back(row);
        if (std::ranges::any_of(keys.others, fits)) others.push_back(row);
        std::string text = " " + plain(row.says);
        for (const std::string& key : keys.others) text += " . " + key;
        if ((text + " ").find(" " + asked + " ") != std::string::npos) parts.push_back(row);
    }
    return !numbers.empty() ? numbers : !others.empty() ? others : parts;
}

std::string function_of(const std::string& thing) {
    if (thing.starts_with("method ")) return "gloam_" + thing.substr(7);
    return thing.starts_with("gloam_") ? thing : "";
}

}  // namespace gloam::catalogue
