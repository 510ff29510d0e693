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

namespace gloam::experiment::internal {
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

}  // namespace gloam::experiment::internal
