// SPDX-License-Identifier: MIT
#pragma once

struct sqlite3;

namespace gloam::experiment {

// Makes the tables of docs/measurements.md from the lines in the table `visit`.
[[nodiscard]] const char* schema();

// The functions that SELECTs have besides SQLite's own. NULL in, NULL out; an aggregate is NULL where any of
// its values is: median(x), quartile_low(x), quartile_high(x), mean(x), geometric_mean(x); fixed(x, digits),
// signed(x, digits) with a plus, at_most(x, most, digits) with "met" or "missed".
void add_functions(sqlite3* handle);

}  // namespace gloam::experiment
