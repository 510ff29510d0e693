// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::report {

// Why a check has no result, or a result that cannot be believed.
enum class Reason {
    none,           // it ran to its end
    crash,          // the process that ran it ended by itself or by a signal
    hang,           // the time limit passed
    device_lost,    // the device was lost
    out_of_memory,  // of the host or of the device
    error,          // any other error: a shader that does not compile, say
    fault           // the shader reached outside an image
};
inline constexpr Reason all_reasons[] = {Reason::none,        Reason::crash,         Reason::hang,
                                         Reason::device_lost, Reason::out_of_memory, Reason::error,
                                         Reason::fault};

// "", "crash", "hang", "device lost", "out of memory", "error", "fault".
[[nodiscard]] std::string_view name_of(Reason reason);

// The documented accuracy, as numbers and in words.
struct BudgetNumbers {
    double ulp = 0.0;
    double absolute = 0.0;
    int backward_ulp = 0;
    std::string text;
};

// Inputs of one class ("ordinary", "nan" ...).
struct ClassNumbers {
    std::string name;
    std::size_t inputs = 0;
    std::size_t outside = 0;
    std::size_t recorded = 0;  // not judged: the device promises nothing here
};

// The results that one output word may have, in words of the report: low <= result <= high, or NaN when
// `nan`.
struct AllowedNumbers {
    double low = 0.0;
    double high = 0.0;
    bool nan = false;
};

// The largest errors that Vulkan's rules permit any driver, over the ordinary inputs for which the budget is
// promised and the rules bound the result.
struct GuaranteeNumbers {
    double ulp = 0.0;
    double absolute = 0.0;
    double fraction = 0.0;  // of the budget
};

// The input with the largest error.
struct WorstInput {
    std::size_t input = 0;  // its position in the run
    std::string input_class;
    std::string images;  // the scenario it ran with; empty without images
    std::string values;  // of the inputs, in decimal and hexadecimal
    std::vector<std::uint32_t> input_words;
    std::vector<std::uint32_t> got_words;
    std::vector<double> want;
    std::vector<AllowedNumbers> allowed;  // for each output word; empty where the verdict is the budget
    double ulp = 0.0;
    double absolute = 0.0;
};

// One equation in one variant on one device: what the check found, or why it could not run. Plain data: it
// travels between processes and machines as JSON.
struct CheckRow {
    std::string equation;  // its ID
    std::string function;
    std::string file;
    std::string variant;
    std::string verdict = "budget";  // what the results were held against: "budget" or "rules"
    std::size_t inputs = 0;
    std::size_t outside = 0;    // failed
    std::size_t recorded = 0;   // not judged
    std::size_t unbounded = 0;  // Vulkan's rules permit anything; 0 where that was not calculated
    std::size_t differs = 0;    // bits differ from those of the run-time kernel; 0 where not compared
    double max_ulp = 0.0;
    double max_abs = 0.0;
    std::optional<double> width_fraction;  // worst error by the permitted width; nothing without an interval
    double budget_fraction = 0.0;          // worst error by the documented budget
    std::optional<GuaranteeNumbers> guarantee;  // where the verdict is the rules
    std::string unbounded_at;  // the first input for which the rules permit anything; empty: none
    BudgetNumbers budget;
    std::vector<ClassNumbers> classes;  // those that had inputs
    std::optional<WorstInput> worst;
    std::string fault;  // an access outside an image; empty: none
    std::string error;  // why it could not run; empty: it ran
    Reason reason = Reason::none;
    double seconds = 0.0;
    std::string story;  // of a failure, in several lines for people

    [[nodiscard]] bool ran() const { return error.empty(); }
    [[nodiscard]] bool passed() const { return ran() && outside == 0 && fault.empty(); }
};

// One line of JSON, and back. Reading throws std::runtime_error that names the field and what was expected.
[[nodiscard]] std::string to_json(const CheckRow& row);
[[nodiscard]] CheckRow row_from_json(std::string_view text);

}  // namespace gloam::report
