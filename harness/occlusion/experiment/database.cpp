// SPDX-License-Identifier: MIT
#include "experiment/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "experiment/internal/sql.hpp"

namespace gloam::experiment {
namespace {

constexpr int most_progress = 50'000;  // thousands of SQLite's steps that a SELECT may take: seconds

using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

[[noreturn]] void fail(sqlite3* handle) {
    throw std::runtime_error(sqlite3_errmsg(handle));
}

Statement prepared(sqlite3* handle, const std::string& text) {
    sqlite3_stmt* made = nullptr;
    const char* rest = nullptr;
    if (sqlite3_prepare_v2(handle, text.c_str(), -1, &made, &rest) != SQLITE_OK) fail(handle);
    Statement statement(made, sqlite3_finalize);
    if (!statement || std::string_view(rest).find_first_not_of(" \n\t;") != std::string_view::npos)
        throw std::runtime_error("expected one SELECT");
    return statement;
}

// Stops a SELECT that takes too many steps.
class Bound {
  public:
    explicit Bound(sqlite3* handle) : handle_(handle) {
        const auto count = [](void* left) { return --*static_cast<int*>(left) < 0 ? 1 : 0; };
        sqlite3_progress_handler(handle, 1000, count, &left_);
    }
    ~Bound() { sqlite3_progress_handler(handle_, 0, nullptr, nullptr); }
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;

  private:
    sqlite3* handle_;
    int left_ = most_progress;
};

// A row is left. false: there is none.
bool step(sqlite3* handle, const Statement& statement) {
    const int result = sqlite3_step(statement.get());
    if (result == SQLITE_INTERRUPT)
        throw std::runtime_error("too many steps: expected a SELECT that takes seconds");
    if (result != SQLITE_ROW && result != SQLITE_DONE) fail(handle);
    return result == SQLITE_ROW;
}

void set_text(const Statement& statement, int place, const std::string& text) {
    if (place > 0)
        sqlite3_bind_text(statement.get(), place, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT);
}

// A SELECT reads, and calls functions.
int permit(void* /*unused*/, int action, const char* /*unused*/, const char* /*unused*/,
           const char* /*unused*/, const char* /*unused*/) {
    const bool reads = action == SQLITE_SELECT || action == SQLITE_READ || action == SQLITE_FUNCTION ||
                       action == SQLITE_RECURSIVE;
    return reads ? SQLITE_OK : SQLITE_DENY;
}

std::string one_line(const unsigned char* bytes) {
    std::string text(bytes == nullptr ? "" : reinterpret_cast<const char*>(bytes));
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return text;
}

Value value_in(const Statement& statement, int column) {
    switch (sqlite3_column_type(statement.get(), column)) {
        case SQLITE_NULL:
            return {};
        case SQLITE_INTEGER:
            return std::int64_t{sqlite3_column_int64(statement.get(), column)};
        case SQLITE_FLOAT:
            return sqlite3_column_double(statement.get(), column);
        default:
            return one_line(sqlite3_column_text(statement.get(), column));
    }
}

// One remap of each candidate at each size, fitted to the cases of the tuning half, is applied to all of its
// cases: the error that is left for each visit.
std::vector<std::optional<double>> fits_of(const std::vector<Visit>& visits) {
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::string>;
    const auto key_of = [](const Visit& visit) {
        return Key(visit.size.width, visit.size.height, visit.candidate);
    };
    const auto has_bins = [](const Visit& visit) { return visit.quality && visit.quality->bins; };
    std::map<Key, std::vector<effect::RemapBin>> tuning;
    for (const Visit& visit : visits) {
        if (visit.shown.half != "tuning" || !has_bins(visit)) continue;
        const std::vector<effect::RemapBin>& bins = *visit.quality->bins;
        std::vector<effect::RemapBin>& all = tuning[key_of(visit)];
        all.insert(all.end(), bins.begin(), bins.end());
    }
    std::map<Key, effect::Remap> remaps;
    for (const auto& [key, bins] : tuning) remaps.emplace(key, effect::best_remap(bins));
    std::vector<std::optional<double>> fits;
    for (const Visit& visit : visits) {
        std::optional<double>& fit = fits.emplace_back();
        const auto found = remaps.find(key_of(visit));
        if (has_bins(visit) && found != remaps.end())
            fit = effect::remapped_rmse(*visit.quality->bins, found->second);
    }
    return fits;
}

}  // namespace

Database::Database(const Record& record, const Record* before, const std::set<std::string>& without)
    : handle_(nullptr, sqlite3_close) {
    sqlite3* handle = nullptr;
    const int opened = sqlite3_open(":memory:", &handle);
    handle_.reset(handle);
    if (opened != SQLITE_OK) fail(handle);
    add_functions(handle);
    load(record);
    for (const std::string& name : without)
        run(((name.starts_with("class_") ? "DROP TABLE " : "ALTER TABLE result DROP COLUMN ") + name)
                .c_str());
    if (before != nullptr) copy(Database(*before));
    sqlite3_set_authorizer(handle, permit, nullptr);
}

void Database::load(const Record& record) {
    run("CREATE TABLE visit(number INTEGER PRIMARY KEY, line TEXT, rmse_fit REAL); BEGIN");
    const Statement insert =
        prepared(handle_.get(), "INSERT INTO visit(line, rmse_fit) VALUES (:line, :rmse_fit)");
    const std::vector<std::optional<double>> fits = fits_of(record.visits());
    for (std::size_t i = 0; i < fits.size(); ++i) {
        Visit visit = record.visits()[i];
        if (visit.quality) visit.quality->bins.reset();
        set_text(insert, 1, line_of(visit));
        if (fits[i])
            sqlite3_bind_double(insert.get(), 2, *fits[i]);
        else
            sqlite3_bind_null(insert.get(), 2);
        (void)step(handle_.get(), insert);
        sqlite3_reset(insert.get());
    }
    run("COMMIT");
    run(schema());
}

void Database::copy(const Database& before) {
    run("ATTACH ':memory:' AS before");
    sqlite3_backup* backup = sqlite3_backup_init(handle_.get(), "before", before.handle_.get(), "main");
    if (backup == nullptr) fail(handle_.get());
    sqlite3_backup_step(backup, -1);
    if (sqlite3_backup_finish(backup) != SQLITE_OK) fail(handle_.get());
}

void Database::run(const char* statements) {
    if (sqlite3_exec(handle_.get(), statements, nullptr, nullptr, nullptr) != SQLITE_OK) fail(handle_.get());
}

Rows Database::select(const std::string& text, const std::string& size) const {
    const Bound bound(handle_.get());
    const Statement statement = prepared(handle_.get(), text);
    set_text(statement, sqlite3_bind_parameter_index(statement.get(), ":size"), size);
    const int columns = sqlite3_column_count(statement.get());
    Rows rows;
    for (int i = 0; i < columns; ++i)
        rows.headings.push_back(
            one_line(reinterpret_cast<const unsigned char*>(sqlite3_column_name(statement.get(), i))));
    while (step(handle_.get(), statement)) {
        std::vector<Value>& row = rows.all.emplace_back();
        for (int i = 0; i < columns; ++i) row.push_back(value_in(statement, i));
    }
    return rows;
}

std::vector<std::string> Database::texts(const std::string& select, const std::string& size) const {
    std::vector<std::string> texts;
    for (const std::vector<Value>& row : this->select(select, size).all) texts.push_back(text_of(row.at(0)));
    return texts;
}

std::string text_of(const Value& value) {
    if (const auto* const count = std::get_if<std::int64_t>(&value)) return std::to_string(*count);
    if (const auto* const number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    const auto* const text = std::get_if<std::string>(&value);
    return text == nullptr ? "-" : *text;
}

}  // namespace gloam::experiment
