// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gloam::record {

// The mark of a table cell.
enum class Tone { plain, good, bad };

// A cell of a table. Columns of a page are sorted by the value if there is one, otherwise by the text.
struct Cell {
    std::string text;
    std::optional<double> value;
    Tone tone;

    Cell(std::string shown, std::optional<double> sorted_by = {}, Tone mark = Tone::plain)
        : text(std::move(shown)), value(sorted_by), tone(mark) {}
    Cell(const char* shown) : Cell(std::string(shown)) {}
    // A count.
    Cell(std::size_t count, Tone mark = Tone::plain)
        : Cell(std::to_string(count), static_cast<double>(count), mark) {}
};

struct Column {
    std::string title{};
    std::string meaning{};  // one sentence, listed above the table; empty: the title suffices
    bool numeric = false;   // right-aligned on a page; the first click sorts the largest to the top
    bool filter = false;    // has few distinct texts, one of which can be selected
};

// A table as text, in Markdown, and on a page.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows = {};  // each with a cell for each column, no more
};

// In columns of spaces.
[[nodiscard]] std::string aligned(const Table& table);
[[nodiscard]] std::string to_markdown(const Table& table);

}  // namespace gloam::record
