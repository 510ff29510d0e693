// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "site/page_data.hpp"

namespace gloam::site {

namespace {

using nlohmann::ordered_json;

// Without links and emphasis.
std::string plain(std::string_view text) {
    static const std::regex link(R"(!?\[([^\]]*)\]\([^)]*\))");
    static const std::regex strong(R"(\*\*([^*]*)\*\*)");
    const std::string words = std::regex_replace(std::string(without_ends(text)), link, "$1");
    static const std::regex emphasis(R"((^|[ (])\*([^*` ][^*`]*)\*)");
    return std::regex_replace(std::regex_replace(words, strong, "$1"), emphasis, "$1$2");
}

// The cells of a row "| a | b |". A bar inside a `code` span or behind a backslash ends no cell.
std::vector<std::string> cells_of(std::string_view row) {
    std::vector<std::string> cells;
    std::string cell;
    bool in_code = false;
    const std::string_view inside = without_ends(row).substr(1);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (inside[i] == '`') in_code = !in_code;
        if (inside[i] == '|' && !in_code && (i == 0 || inside[i - 1] != '\\')) {
            cells.push_back(plain(cell));
            cell.clear();
        } else {
            cell += inside[i];
        }
    }
    return cells;
}

bool is_rule(std::string_view row) {
    return row.find("---") != std::string_view::npos &&
           row.find_first_not_of("|-: ") == std::string_view::npos;
}

// Reads lines one after another and adds the blocks that they end.
class Reader {
  public:
    void read(std::string_view line) {
        if (line.starts_with("```")) {
            flush();
            in_code_ = !in_code_;
            if (in_code_) kind_ = "code";
        } else if (in_code_) {
            text_.append(line).append("\n");
        } else {
            read_outside(line);
        }
    }

    [[nodiscard]] ordered_json end() {
        flush();
        return std::move(blocks_);
    }

  private:
    void read_outside(std::string_view line) {
        const std::string_view words = without_ends(line);
        if (words.empty()) return flush();
        if (line.starts_with('#')) return add_heading(line);
        if (words.starts_with('|')) return add_row(words);
        if (line.starts_with("    ") && kind_ != "list") return add_to("code", line.substr(4), "\n");
        if (is_item(words)) return begin_item(words);
        if (words.starts_with("![")) return;
        add_to(kind_ == "list" ? "list" : "paragraph", words, " ");
    }

    static bool is_item(std::string_view words) {
        const std::size_t digits = words.find_first_not_of("0123456789");
        return words.starts_with("- ") ||
               (digits > 0 && digits != std::string_view::npos && words.substr(digits).starts_with(". "));
    }

    void add_heading(std::string_view line) {
        flush();
        const std::size_t level = line.find_first_not_of('#');
        if (level == std::string_view::npos) return;
        blocks_.push_back({{"kind", "heading"}, {"level", level}, {"text", plain(line.substr(level))}});
    }

    void add_row(std::string_view row) {
        if (kind_ != "table") flush();
        kind_ = "table";
        if (!is_rule(row)) rows_.push_back(cells_of(row));
    }

    void begin_item(std::string_view words) {
        if (kind_ != "list") flush();
        kind_ = "list";
        end_item();
        text_ = words.substr(words.find(' ') + 1);
    }

    void add_to(const char* kind, std::string_view text, const char* between) {
        if (kind_ != kind) flush();
        kind_ = kind;
        if (!text_.empty() || kind_ == "code") text_ += kind_ == "code" ? "" : between;
        text_.append(text);
        if (kind_ == "code") text_ += between;
    }

    void end_item() {
        if (!text_.empty()) items_.push_back(plain(text_));
        text_.clear();
    }

    // Adds the block that has been read so far.
    void flush() {
        if (kind_ == "list") {
            end_item();
            blocks_.push_back({{"kind", kind_}, {"items", items_}});
        } else if (kind_ == "table" && !rows_.empty()) {
            const std::vector<std::string> head = rows_.front();
            rows_.erase(rows_.begin());
            blocks_.push_back({{"kind", kind_}, {"head", head}, {"rows", rows_}});
        } else if (!text_.empty()) {
            blocks_.push_back({{"kind", kind_}, {"text", kind_ == "code" ? text_ : plain(text_)}});
        }
        kind_.clear();
        text_.clear();
        items_.clear();
        rows_.clear();
    }

    ordered_json blocks_ = ordered_json::array();
    std::string kind_;
    std::string text_;
    std::vector<std::string> items_;
    std::vector<std::vector<std::string>> rows_;
    bool in_code_ = false;
};

}  // namespace

std::string document_json(std::string_view markdown) {
    Reader reader;
    for (std::size_t at = 0; at < markdown.size();) {
        const std::size_t end = std::min(markdown.find('\n', at), markdown.size());
        std::string_view line = markdown.substr(at, end - at);
        if (line.ends_with('\r')) line.remove_suffix(1);
        reader.read(line);
        at = end + 1;
    }
    return reader.end().dump(-1, ' ', true, ordered_json::error_handler_t::replace);
}

namespace {

// Position behind the comment that begins at `at`, or `at` where none does. The end of a line comment is its
// line's end.
std::size_t behind_comment(std::string_view text, std::size_t at) {
    const std::string_view begin = text.substr(at, 2);
    if (begin == "//") return std::min(text.find('\n', at), text.size());
    if (begin != "/*") return at;
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

}  // namespace

std::string_view without_ends(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

std::string condensed(std::string_view text) {
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t behind = behind_comment(text, at);
        code += behind == at ? text[at] : ' ';
        at = behind == at ? at + 1 : behind;
    }
    const bool macros = code.find("#define") != std::string::npos;
    std::string lines;
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = std::min(code.find('\n', at), code.size());
        const std::string_view line = without_ends(std::string_view(code).substr(at, end - at));
        const bool idle = line.empty() || (!macros && line.starts_with("#undef"));
        if (!idle) lines.append(line).append("\n");
        at = end + 1;
    }
    return lines;
}

}  // namespace gloam::site
