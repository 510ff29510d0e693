// SPDX-License-Identifier: MIT
#include "report/results_database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text.hpp"

namespace gloam::report {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_groups = 10'000;
constexpr std::size_t most_devices = 1'000;
constexpr std::size_t most_checks = 2'000'000;
constexpr int patience_ms = 60'000;

// docs/laboratory.md documents the view.
constexpr const char* schema = R"sql(
CREATE TABLE driver (id INTEGER PRIMARY KEY, vendor TEXT NOT NULL, driver TEXT NOT NULL, version TEXT NOT NULL,
                     api TEXT NOT NULL, UNIQUE (vendor, driver, version, api)) STRICT;
CREATE TABLE device (id INTEGER PRIMARY KEY, driver INTEGER NOT NULL, device TEXT NOT NULL,
                     UNIQUE (driver, device)) STRICT;
CREATE TABLE run (id INTEGER PRIMARY KEY, device INTEGER NOT NULL, versions TEXT NOT NULL, asked INTEGER NOT NULL,
                  seed INTEGER NOT NULL, UNIQUE (device, versions, asked, seed)) STRICT;
CREATE TABLE question (id INTEGER PRIMARY KEY, equation TEXT NOT NULL, variant TEXT NOT NULL,
                       UNIQUE (equation, variant)) STRICT;
CREATE TABLE answer (run INTEGER NOT NULL, question INTEGER NOT NULL, outcome TEXT NOT NULL, reason TEXT NOT NULL,
                     inputs INTEGER NOT NULL, outside INTEGER NOT NULL, worst REAL NOT NULL,
                     PRIMARY KEY (run, question)) STRICT, WITHOUT ROWID;
CREATE VIEW result AS
    SELECT vendor, driver.driver, version, api, device.device, versions, asked, seed, equation, variant,
           outcome, reason, inputs, outside, worst
    FROM answer JOIN question ON question.id = answer.question JOIN run ON run.id = answer.run
         JOIN device ON device.id = run.device JOIN driver ON driver.id = device.driver;
)sql";

constexpr const char* put_answer = R"sql(
INSERT INTO answer VALUES (?, ?, ?, ?, ?, ?, ?)
ON CONFLICT DO UPDATE SET outcome = excluded.outcome, reason = excluded.reason, inputs = excluded.inputs,
                          outside = excluded.outside, worst = excluded.worst
WHERE (excluded.outcome = 'failed', excluded.reason <> '', excluded.outside, excluded.worst)
    > (answer.outcome = 'failed', answer.reason <> '', answer.outside, answer.worst)
)sql";

constexpr const char* tallies = R"sql(
SELECT driver, question, count(*), sum(outcome = 'failed'), sum(outcome = 'not judged'), sum(inputs), sum(outside),
       max(worst), group_concat(DISTINCT CASE WHEN outcome = 'failed' AND reason <> '' THEN reason END)
FROM answer JOIN run ON run.id = answer.run JOIN device ON device.id = run.device GROUP BY driver, question
)sql";

}  // namespace

namespace sql {

// A connection to a database.
class Connection {
  public:
    Connection(const std::string& file, int flags) {
        const int status = sqlite3_open_v2(file.c_str(), &database_, flags, nullptr);
        if (status == SQLITE_OK) {
            // Nothing in a file from elsewhere is run.
            sqlite3_db_config(database_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
            sqlite3_db_config(database_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
            sqlite3_busy_timeout(database_, patience_ms);
            return;
        }
        const std::string why = sqlite3_errstr(status);
        sqlite3_close(database_);
        throw std::runtime_error(why);
    }
    ~Connection() { sqlite3_close(database_); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    [[nodiscard]] sqlite3* get() const { return database_; }

    [[noreturn]] void fail() const { throw std::runtime_error(sqlite3_errmsg(database_)); }

    void run(const char* commands) const {
        if (sqlite3_exec(database_, commands, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
    }

  private:
    sqlite3* database_ = nullptr;
};

// A prepared command. Texts that it is given must live until it is reset.
class Statement {
  public:
    Statement(const Connection& database, const char* command) : database_(&database) {
        if (sqlite3_prepare_v2(database.get(), command, -1, &statement_, nullptr) != SQLITE_OK)
            database.fail();
    }
    ~Statement() { sqlite3_finalize(statement_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    template <class... Values>
    void start(const Values&... values) {
        sqlite3_reset(statement_);
        int at = 0;
        (bind(++at, values), ...);
    }

    // Goes on to the next row; false: there is none.
    bool next() {
        const int status = sqlite3_step(statement_);
        if (status != SQLITE_ROW && status != SQLITE_DONE) database_->fail();
        return status == SQLITE_ROW;
    }

    // Of the current row.
    [[nodiscard]] std::int64_t whole(int column) const { return sqlite3_column_int64(statement_, column); }
    [[nodiscard]] double number(int column) const { return sqlite3_column_double(statement_, column); }
    [[nodiscard]] std::string text(int column) const {
        const auto* begin = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
        return begin == nullptr ? "" : begin;
    }
    // A file from elsewhere may hold other values.
    [[nodiscard]] std::size_t count(int column) const {
        if (whole(column) < 0)
            throw std::runtime_error(fmt::format("expected a count, found {}", whole(column)));
        return static_cast<std::size_t>(whole(column));
    }
    [[nodiscard]] std::string name(int column) const {
        std::string value = text(column);
        if (!value.empty() && !base::is_name(value))
            throw std::runtime_error("expected a name: one line of at most 1000 bytes");
        return value;
    }

  private:
    void bind(int at, std::int64_t value) { check(sqlite3_bind_int64(statement_, at, value)); }
    void bind(int at, double value) { check(sqlite3_bind_double(statement_, at, value)); }
    void bind(int at, std::string_view value) {
        check(sqlite3_bind_text(statement_, at, value.data(), static_cast<int>(value.size()), SQLITE_STATIC));
    }
    void check(int status) const {
        if (status != SQLITE_OK) database_->fail();
    }

    const Connection* database_;
    sqlite3_stmt* statement_ = nullptr;
};

}  // namespace sql

namespace {

using sql::Connection;
using sql::Statement;

// What the tables and the view of a database were made with.
std::string schema_of(const Connection& database) {
    Statement all(database, "SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY name");
    std::string text;
    while (all.next()) text += all.text(0) + "\n";
    return text;
}

const std::string& expected_schema() {
    static const std::string text = [] {
        const Connection empty(":memory:", SQLITE_OPEN_READWRITE);
        empty.run(schema);
        return schema_of(empty);
    }();
    return text;
}

std::int64_t stored(std::size_t value, const char* what) {
    constexpr std::size_t most = 1'000'000'000'000;
    if (value > most) throw std::runtime_error(fmt::format("{}: expected at most {}", what, most));
    return static_cast<std::int64_t>(value);
}

void require_at_most(std::size_t most, std::size_t found, const char* what) {
    if (found > most)
        throw std::runtime_error(fmt::format(
            "more than {} {} for one summary: query the database, or make one for each driver", most, what));
}

const char* name_of_file(const fs::path& file) {
    return file.empty() ? "the temporary database" : file.c_str();
}

}  // namespace

struct ResultsDatabase::Store {
    Store(fs::path path, Access access)
        : file(std::move(path)),
          is_new(!file.empty() && !fs::exists(file)),
          adds(access == Access::add),
          database(file.empty() ? "" : fs::absolute(file).string(),
                   adds ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY) {
        database.run(adds ? "BEGIN IMMEDIATE" : "BEGIN");  // ends with commit()
        if (adds && schema_of(database).empty()) database.run(schema);
        if (schema_of(database) != expected_schema())
            throw std::runtime_error("it has other tables than `gloam report --sqlite` makes");
    }

    ~Store() {
        std::error_code remains;
        if (is_new && adds) fs::remove(file, remains);
    }

    // The number of a row with these values; it is made if it is missing.
    template <class... Values>
    std::int64_t id_of(const char* find, const char* make, const Values&... values) {
        Statement known(database, find);
        known.start(values...);
        if (known.next()) return known.whole(0);
        Statement added(database, make);
        added.start(values...);
        added.next();
        return sqlite3_last_insert_rowid(database.get());
    }

    std::int64_t id_of_run(const ResultRun& run) {
        const DriverGroup group = group_of(run.device);
        const std::int64_t driver =
            id_of("SELECT id FROM driver WHERE (vendor, driver, version, api) = (?, ?, ?, ?)",
                  "INSERT INTO driver VALUES (NULL, ?, ?, ?, ?)", group.vendor, group.driver, group.version,
                  group.api);
        const std::int64_t device = id_of("SELECT id FROM device WHERE (driver, device) = (?, ?)",
                                          "INSERT INTO device VALUES (NULL, ?, ?)", driver, run.device.name);
        return id_of("SELECT id FROM run WHERE (device, versions, asked, seed) = (?, ?, ?, ?)",
                     "INSERT INTO run VALUES (NULL, ?, ?, ?, ?)", device, run.versions,
                     stored(run.inputs, "inputs"), static_cast<std::int64_t>(run.seed));
    }

    std::int64_t id_of_question(const CheckName& check) {
        const auto known = questions.find(check);
        if (known != questions.end()) return known->second;
        return questions[check] =
                   id_of("SELECT id FROM question WHERE (equation, variant) = (?, ?)",
                         "INSERT INTO question VALUES (NULL, ?, ?)", check.first, check.second);
    }

    // The file or what it holds is at fault.
    [[noreturn]] void fail(const std::exception& error) const {
        throw std::runtime_error(fmt::format("{}: {}", name_of_file(file), error.what()));
    }

    fs::path file;
    bool is_new;
    bool adds;
    Connection database;
    std::mutex mutex;  // of what is written
    std::map<CheckName, std::int64_t> questions{};
};

ResultsDatabase::ResultsDatabase(const fs::path& file, Access access) {
    try {
        store_ = std::make_unique<Store>(file, access);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("{} cannot be used as a database of results: {}", name_of_file(file), error.what()));
    }
}

ResultsDatabase::~ResultsDatabase() = default;

void ResultsDatabase::add(std::string_view text) {
    std::vector<std::pair<ResultRun, std::vector<ResultRow>>> runs;
    read_results(text, [&](const ResultRun& run, const std::vector<ResultRow>& rows) {
        (void)stored(run.inputs, "inputs");
        for (const ResultRow& row : rows) {
            (void)stored(row.inputs, "inputs");
            (void)stored(row.outside, "outside");
        }
        runs.emplace_back(run, rows);
    });
    const std::lock_guard lock(store_->mutex);
    Statement put(store_->database, put_answer);
    for (const auto& [run, rows] : runs) {
        const std::int64_t id = store_->id_of_run(run);
        for (const ResultRow& row : rows) {
            const double worst = row.fraction > 0.0 ? row.fraction : 0.0;
            put.start(id, store_->id_of_question({row.equation, row.variant}), name_of(row.outcome),
                      std::string_view(row.reason), static_cast<std::int64_t>(row.inputs),
                      static_cast<std::int64_t>(row.outside), worst);
            put.next();
        }
    }
}

void ResultsDatabase::commit() {
    try {
        store_->database.run("COMMIT");
        store_->is_new = false;
    } catch (const std::runtime_error& error) {
        store_->fail(error);
    }
}

LaboratorySummary ResultsDatabase::summary() const {
    const Connection& database = store_->database;
    LaboratorySummary summary;
    try {
        std::map<std::int64_t, GroupSummary*> groups;
        for (Statement each(database, "SELECT id, vendor, driver, version, api FROM driver"); each.next();) {
            const DriverGroup group{each.name(1), each.name(2), each.name(3), each.name(4)};
            groups[each.whole(0)] = &summary[group];
            require_at_most(most_groups, groups.size(), "groups of drivers");
        }
        for (Statement each(database, "SELECT driver, device FROM device"); each.next();) {
            auto& devices = groups.at(each.whole(0))->devices;
            devices.insert(each.name(1));
            require_at_most(most_devices, devices.size(), "devices of one driver");
        }
        for (Statement each(database, "SELECT driver FROM run JOIN device ON device.id = run.device");
             each.next();)
            ++groups.at(each.whole(0))->runs;
        std::map<std::int64_t, CheckName> names;
        for (Statement each(database, "SELECT id, equation, variant FROM question"); each.next();)
            names[each.whole(0)] = {each.name(1), each.name(2)};
        std::size_t checks = 0;
        for (Statement each(database, tallies); each.next();) {
            require_at_most(most_checks, ++checks, "checks");
            CheckTally& tally = groups.at(each.whole(0))->checks[names.at(each.whole(1))];
            tally = {.runs = each.count(2),
                     .failed = each.count(3),
                     .not_judged = each.count(4),
                     .inputs = each.count(5),
                     .outside = each.count(6),
                     .worst = each.number(7),
                     .reasons = base::shortened(base::one_line(each.text(8)), 200)};
        }
    } catch (const std::out_of_range&) {
        store_->fail(std::runtime_error("a row refers to one that is missing"));
    } catch (const std::runtime_error& error) {
        store_->fail(error);
    }
    return summary;
}

}  // namespace gloam::report
