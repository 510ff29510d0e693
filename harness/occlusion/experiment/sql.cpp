// SPDX-License-Identifier: MIT
#include "experiment/internal/sql.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "numeric/numbers.hpp"

namespace gloam::experiment {
namespace {

using Numbers = std::vector<double>;
using Aggregate = double (*)(const Numbers&);

// NaN for NULL, and a result of NaN becomes NULL.
double number_of(sqlite3_value* value) noexcept {
    return sqlite3_value_type(value) == SQLITE_NULL ? std::numeric_limits<double>::quiet_NaN()
                                                    : sqlite3_value_double(value);
}

void collect(sqlite3_context* context, int /*unused*/, sqlite3_value** arguments) noexcept {
    auto** const numbers = static_cast<Numbers**>(sqlite3_aggregate_context(context, sizeof(Numbers*)));
    if (numbers == nullptr) return sqlite3_result_error_nomem(context);
    if (*numbers == nullptr) *numbers = std::make_unique<Numbers>().release();
    (*numbers)->push_back(number_of(arguments[0]));
}

void finish(sqlite3_context* context) noexcept {
    auto** const numbers = static_cast<Numbers**>(sqlite3_aggregate_context(context, 0));
    if (numbers == nullptr || *numbers == nullptr) return sqlite3_result_null(context);
    const std::unique_ptr<Numbers> all(*numbers);
    if (std::ranges::none_of(*all, [](double x) { return std::isnan(x); }))
        sqlite3_result_double(context, (*static_cast<Aggregate*>(sqlite3_user_data(context)))(*all));
    else
        sqlite3_result_null(context);
}

double mean(const Numbers& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

double geometric_mean(const Numbers& numbers) {
    double sum = 0.0;
    for (const double x : numbers) sum += std::log(x);
    return std::exp(sum / static_cast<double>(numbers.size()));
}

template <double numeric::Spread::* member>
double spread(const Numbers& numbers) {
    return numeric::spread_of(numbers).*member;
}

// The format of a number and its digits.
void write(sqlite3_context* context, int /*unused*/, sqlite3_value** arguments) noexcept {
    const double number = number_of(arguments[0]);
    if (std::isnan(number)) return sqlite3_result_null(context);
    const auto* const format = static_cast<const char*>(sqlite3_user_data(context));
    const std::string text =
        fmt::format(fmt::runtime(format), number, std::clamp(sqlite3_value_int(arguments[1]), 0, 9));
    sqlite3_result_text(context, text.c_str(), -1, SQLITE_TRANSIENT);
}

void at_most(sqlite3_context* context, int /*unused*/, sqlite3_value** arguments) noexcept {
    const double number = number_of(arguments[0]);
    const double most = number_of(arguments[1]);
    if (std::isnan(number)) return sqlite3_result_null(context);
    const std::string text =
        fmt::format("{:.{}f}, at most {:g}: {}", number, std::clamp(sqlite3_value_int(arguments[2]), 0, 9),
                    most, number <= most ? "met" : "missed");
    sqlite3_result_text(context, text.c_str(), -1, SQLITE_TRANSIENT);
}

constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC;

}  // namespace

void add_functions(sqlite3* handle) {
    static std::pair<const char*, Aggregate> aggregates[]{{"median", spread<&numeric::Spread::median>},
                                                          {"quartile_low", spread<&numeric::Spread::low>},
                                                          {"quartile_high", spread<&numeric::Spread::high>},
                                                          {"mean", mean},
                                                          {"geometric_mean", geometric_mean}};
    for (auto& [name, of] : aggregates)
        sqlite3_create_function(handle, name, 1, flags, &of, nullptr, collect, finish);
    static char fixed[] = "{:.{}f}";
    static char with_sign[] = "{:+.{}f}";
    sqlite3_create_function(handle, "fixed", 2, flags, fixed, write, nullptr, nullptr);
    sqlite3_create_function(handle, "signed", 2, flags, with_sign, write, nullptr, nullptr);
    sqlite3_create_function(handle, "at_most", 3, flags, nullptr, at_most, nullptr, nullptr);
}

const char* schema() {
    return R"(
CREATE TABLE visits AS SELECT number,
  (line->>'width') || ' x ' || (line->>'height') AS size, line->>'width' AS width, line->>'height' AS height,
  line->>'case' AS [case], coalesce(line->>'what', '') AS what, coalesce(line->>'kind', '') AS kind,
  coalesce(line->>'half', '') AS half, nullif(line->>'target', 0) AS target,
  line->>'candidate' AS candidate, coalesce(line->>'group', '') AS [group], line->>'round' AS round
  FROM visit ORDER BY number;
CREATE TABLE sizes AS SELECT size, width, height FROM visits GROUP BY size ORDER BY min(number);
CREATE TABLE cases AS SELECT [case], what, kind, half, target FROM visits
  GROUP BY [case], what, kind ORDER BY min(number);
CREATE TABLE candidates AS SELECT candidate, [group] FROM visits GROUP BY candidate ORDER BY min(number);

-- Every candidate in every case, whether it was measured or not: a mean over cases that lack one is NULL.
CREATE TABLE cells AS SELECT sizes.*, cases.*, candidates.*, sizes.rowid AS size_number,
  cases.rowid AS case_number, candidates.rowid AS candidate_number
  FROM sizes, cases, candidates ORDER BY size_number, case_number, candidate_number;
CREATE UNIQUE INDEX cell_of ON cells(size, [case], what, kind, candidate);
CREATE TABLE rounds AS SELECT cells.rowid AS cell, round, number
  FROM visits JOIN cells USING (size, [case], what, kind, candidate);
CREATE VIEW steps AS SELECT cell, round, line, rmse_fit FROM rounds JOIN visit USING (number);

CREATE TABLE readings AS SELECT cell, round, r.key AS reading, min(p.key) AS place, p.value->>'pass' AS pass,
  sum(p.value->>'ms') AS ms
  FROM steps, json_each(line, '$.readings') AS r, json_each(r.value, '$.passes') AS p
  GROUP BY cell, round, reading, pass ORDER BY cell, round, reading, place;
CREATE INDEX reading_of ON readings(cell, round, reading, pass);
CREATE TABLE frames AS SELECT cell, round, reading, sum(ms) AS ms,
  coalesce(sum(ms) FILTER (WHERE pass GLOB 'ambient_occlusion*'), 0.0) AS gather_ms
  FROM readings GROUP BY cell, round, reading;
CREATE TABLE passes AS SELECT cells.*, pass, median(coalesce(readings.ms, 0.0)) AS ms,
  min(coalesce(readings.ms, 0.0)) AS least_ms
  FROM (SELECT cell, pass, min(rowid) AS first FROM readings GROUP BY cell, pass) AS known
  JOIN cells ON cells.rowid = cell JOIN frames USING (cell) LEFT JOIN readings USING (cell, round, reading, pass)
  GROUP BY cell, pass ORDER BY cell, first;

CREATE TABLE result AS WITH
times AS (SELECT cell, median(ms) AS ms, quartile_low(ms) AS low_ms, quartile_high(ms) AS high_ms,
  min(ms) AS least_ms, median(gather_ms) AS gather_ms FROM frames GROUP BY cell),
judged AS (SELECT cell, line->'$.quality' AS quality, line->'$.point' AS point, rmse_fit,
  line->>'$.rmse_own_radius' AS rmse_own_radius FROM steps WHERE round = 0),
last AS (SELECT cell, nullif(line->>'$.samples_asked', 0) AS samples_asked, max(round)
  FROM steps GROUP BY cell),
found AS MATERIALIZED (SELECT width, height, [case], what, candidate, ms,
  quality->>'rmse' AS rmse, quality->>'rmse_raw' AS rmse_raw, quality->>'rmse_depth' AS rmse_depth,
  quality->>'rmse_depth_raw' AS rmse_depth_raw, quality->>'bias' AS bias,
  quality->>'percentile_99' AS percentile_99, rmse_fit, quality->>'similarity' AS similarity,
  quality->>'$.tiles.background' AS background_tiles, quality->>'$.tiles.below_pixel' AS small_tiles,
  quality->>'$.tiles.half' AS half_tiles, quality->>'$.tiles.full' AS full_tiles,
  quality->>'samples' AS samples, (quality->>'memory_bytes') / 1048576.0 AS memory_mib,
  quality->>'flicker' AS flicker, rmse_own_radius,
  quality->>'rmse_remapped' AS rmse_remapped, samples_asked,
  quality->>'$.converged.geometry.rmse' AS converged_rmse, quality->>'$.converged.geometry.bias' AS converged_bias,
  quality->>'$.converged.remapped.rmse' AS converged_remapped,
  quality->>'$.converged.similarity' AS converged_similarity, quality->>'$.converged.depth.rmse' AS converged_depth,
  quality->>'$.converged.own.rmse' AS converged_own, point->>'truth' AS truth, point->>'occlusion' AS occlusion,
  point->>'shown' AS shown, (point->>'shown') - (point->>'truth') AS off_truth,
  kind, half, target, [group], size, low_ms, high_ms, least_ms, gather_ms, last.cell IS NOT NULL AS measured,
  size_number, case_number, candidate_number
  FROM cells LEFT JOIN last ON last.cell = cells.rowid LEFT JOIN judged ON judged.cell = cells.rowid
  LEFT JOIN times ON times.cell = cells.rowid)
SELECT *, ms + rmse IS NOT NULL AND NOT EXISTS (SELECT * FROM found AS other
  WHERE other.size_number = found.size_number AND other.case_number = found.case_number
  AND other.ms <= found.ms AND other.rmse <= found.rmse AND (other.ms < found.ms OR other.rmse < found.rmse
    OR other.candidate_number < found.candidate_number)) AS on_front
  FROM found ORDER BY size_number, case_number, candidate_number;

CREATE TABLE overall AS WITH
ratios AS (SELECT *, rmse / min(rmse) OVER (PARTITION BY size_number, case_number) AS of_best FROM result),
means AS MATERIALIZED (SELECT size, candidate, [group], geometric_mean(ms) AS ms, max(ms) AS worst_ms,
  mean(rmse) AS rmse, max(rmse) AS worst_rmse, geometric_mean(of_best) AS of_best, mean(similarity) AS similarity,
  mean(flicker) AS flicker, size_number, candidate_number FROM ratios GROUP BY size_number, candidate_number)
SELECT *, iif(EXISTS (SELECT * FROM means AS other WHERE other.size_number = means.size_number
    AND other.ms < means.ms AND other.rmse < means.rmse), '', '**') AS mark,
  ms + rmse IS NOT NULL AND NOT EXISTS (SELECT * FROM means AS other
  WHERE other.size_number = means.size_number AND other.ms <= means.ms AND other.of_best <= means.of_best
  AND (other.ms < means.ms OR other.of_best < means.of_best
    OR other.candidate_number < means.candidate_number)) AS on_front
  FROM means WHERE coalesce(ms, rmse) IS NOT NULL ORDER BY size_number, candidate_number;

CREATE TABLE scores AS SELECT cell, f.value->>'frame' AS frame, f.value->>'samples' AS samples,
  c.value->>'pixels' AS pixels, c.value->>'against' AS against, c.value->>'count' AS count,
  c.value->>'squares' AS squares, c.value->>'raw_squares' AS raw_squares, c.value->>'raw_errors' AS raw_errors
  FROM steps, json_each(line, '$.quality.by_class.frames') AS f, json_each(f.value, '$.classes') AS c
  WHERE round = 0;
CREATE INDEX score_of ON scores(cell, pixels, against);
CREATE TABLE class_frames AS SELECT cells.*, frame, samples, pixels, against,
  sqrt(squares / count) AS rmse, sqrt(raw_squares / count) AS rmse_raw, raw_errors / count AS bias_raw
  FROM scores JOIN cells ON cells.rowid = cell ORDER BY cell, frame;
CREATE TABLE class_errors AS WITH
flickers AS (SELECT cell, f.value->>'pixels' AS pixels, f.value->>'mean' AS flicker
  FROM steps, json_each(line, '$.quality.by_class.flicker') AS f WHERE round = 0)
SELECT cells.*, pixels, against, sqrt(sum(squares) / sum(count)) AS rmse,
  sqrt(sum(raw_squares) / sum(count)) AS rmse_raw, sum(raw_errors) / sum(count) AS bias_raw,
  coalesce(sum(squares), 0.0) / max(iif(pixels = 'all', sum(squares), NULL)) OVER (PARTITION BY cell, against) AS share,
  flicker
  FROM (SELECT DISTINCT cell FROM scores) JOIN (SELECT DISTINCT pixels FROM scores)
  JOIN (SELECT DISTINCT against FROM scores) JOIN cells ON cells.rowid = cell
  LEFT JOIN scores USING (cell, pixels, against) LEFT JOIN flickers USING (cell, pixels)
  GROUP BY cell, pixels, against;
)";
}

}  // namespace gloam::experiment
