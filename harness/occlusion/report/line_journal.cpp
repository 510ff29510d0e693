// SPDX-License-Identifier: MIT
#include "report/line_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <stdexcept>
#include <utility>

#include "base/files.hpp"
#include "base/text.hpp"

namespace gloam::report {
namespace {

constexpr std::size_t longest_journal = std::size_t{1} << 30;  // bytes
constexpr std::size_t longest_quote = 300;

}  // namespace

LineJournal::LineJournal(std::filesystem::path path, const std::string& heading, bool resume)
    : path_(std::move(path)) {
    if (path_.empty()) return;
    std::string kept = heading + "\n";
    if (resume && std::filesystem::exists(path_)) {
        const std::string text = base::read_file(path_, longest_journal);
        const std::string whole = text.substr(0, text.rfind('\n') + 1);
        if (!whole.empty()) {
            take_over(whole, heading);
            kept = whole;
        }
    }
    base::write_file(path_, kept);
}

void LineJournal::take_over(std::string_view text, const std::string& heading) {
    const std::size_t first = text.find('\n');
    const std::string_view found = text.substr(0, first);
    if (found != heading) {
        throw std::runtime_error(
            fmt::format("{}: cannot resume what was measured otherwise: expected {}, found {}",
                        path_.string(), heading, base::shortened(found, longest_quote)));
    }
    for (std::size_t at = first + 1; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        lines_.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
}

void LineJournal::add(std::string_view line) const {
    if (path_.empty()) return;
    const base::FileDescriptor file(open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW));
    if (!file.is_open()) base::fail_to_write(path_, errno);
    std::string text(line);
    text += '\n';
    if (const int error = base::write_all(file.get(), text)) base::fail_to_write(path_, error);
}

}  // namespace gloam::report
