// SPDX-License-Identifier: MIT
#include "report/laboratory.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text.hpp"

namespace gloam::report {
namespace {

using nlohmann::json;

constexpr std::size_t deepest = 64;  // arrays and objects within each other

// A row while it is read: numbers of both kinds of verdict, until its end says which counts.
struct Row {
    ResultRow row;
    std::string verdict;
    std::string outcome;
    double width_fraction = 0.0;
    double budget_fraction = 0.0;
    bool fault = false;
    bool error = false;
};

// Receives the parser's events. Levels are counted from the report: 1 is its object, 2 its device and its
// results, 3 a row; deeper values are skipped.
class Events final : public nlohmann::json_sax<json> {
  public:
    explicit Events(const TakeResults& take) : take_(&take) {}

    bool start_object(std::size_t) override {
        enter();
        if (level_ == 1) run_ = {}, rows_.clear(), has_device_ = has_results_ = false;
        if (level_ == 3 && section_ == "results") row_ = {};
        return true;
    }
    bool end_object() override {
        if (level_ == 3 && section_ == "results") finish_row();
        if (level_ == 2 && section_ == "device") has_device_ = true;
        if (level_ == 1) finish_report();
        --level_;
        return true;
    }
    bool start_array(std::size_t) override {
        if (level_ == 0 && !in_list_) {  // of reports
            in_list_ = true;
            return true;
        }
        enter();
        if (level_ == 2 && section_ == "results") has_results_ = true;
        return true;
    }
    bool end_array() override {
        if (level_ > 0) --level_;
        return true;
    }
    bool key(std::string& name) override {
        if (level_ == 1) section_ = name;
        key_ = std::move(name);
        return true;
    }
    bool string(std::string& value) override {
        if (level_ == 1 && key_ == "versions") run_.versions = name("versions", value);
        if (level_ == 2 && section_ == "device") take_device(value);
        if (in_row()) take_text(value);
        return true;
    }
    bool number_unsigned(json::number_unsigned_t value) override {
        if (level_ == 1 && key_ == "inputs") run_.inputs = value;
        if (level_ == 1 && key_ == "seed") run_.seed = value;
        if (in_row() && key_ == "inputs") row_.row.inputs = value;
        if (in_row() && key_ == "outside") row_.row.outside = value;
        return number_float(static_cast<double>(value), "");
    }
    bool number_integer(json::number_integer_t value) override {
        return number_float(static_cast<double>(value), "");
    }
    bool number_float(double value, const std::string&) override {
        if (in_row() && key_ == "width_fraction") row_.width_fraction = value;
        if (in_row() && key_ == "budget_fraction") row_.budget_fraction = value;
        return true;
    }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool binary(json::binary_t&) override { return true; }
    bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
        throw std::runtime_error(base::shortened(error.what(), 200));
    }

    [[nodiscard]] std::size_t reports() const { return reports_; }

  private:
    [[nodiscard]] bool in_row() const { return level_ == 3 && section_ == "results"; }

    void enter() {
        if (++level_ > deepest) throw std::runtime_error(fmt::format("deeper than {} levels", deepest));
    }

    static std::string name(const char* what, const std::string& value) {
        if (!value.empty() && !base::is_name(value))
            throw std::runtime_error(
                fmt::format("{}: expected a name: one line of at most 1000 bytes", what));
        return value;
    }

    void take_device(const std::string& value) {
        if (key_ == "name") run_.device.name = name("device.name", value);
        if (key_ == "driver") run_.device.driver = name("device.driver", value);
        if (key_ == "type") run_.device.type = name("device.type", value);
        if (key_ == "api_version") run_.device.api_version = name("device.api_version", value);
    }

    void take_text(const std::string& value) {
        if (key_ == "equation") row_.row.equation = name("equation", value);
        if (key_ == "variant") row_.row.variant = name("variant", value);
        if (key_ == "reason") row_.row.reason = name("reason", value);
        if (key_ == "verdict") row_.verdict = value;
        if (key_ == "outcome") row_.outcome = value;
        if (key_ == "fault") row_.fault = !value.empty();
        if (key_ == "error") row_.error = !value.empty();
        const double infinite = value == "inf" ? std::numeric_limits<double>::infinity() : 0.0;
        if (key_ == "width_fraction") row_.width_fraction = infinite;
        if (key_ == "budget_fraction") row_.budget_fraction = infinite;
    }

    // Results of earlier versions do not say their outcome.
    [[nodiscard]] check::Outcome outcome() const {
        for (const check::Reason reason : check::all_reasons)
            if (is_no_verdict(reason) && row_.row.reason == name_of(reason))
                return check::Outcome::not_judged;
        if (row_.error || row_.fault || row_.row.outside > 0) return check::Outcome::failed;
        return row_.outcome == name_of(check::Outcome::not_judged) ? check::Outcome::not_judged
                                                                   : check::Outcome::ok;
    }

    void finish_report() {
        if (!has_device_ || !has_results_)
            throw std::runtime_error("expected an object with a device and results");
        (*take_)(run_, rows_);
        ++reports_;
    }

    void finish_row() {
        if (row_.row.equation.empty()) throw std::runtime_error("results: a row without an equation");
        row_.row.fraction = row_.verdict == "rules" ? row_.width_fraction : row_.budget_fraction;
        row_.row.outcome = outcome();
        rows_.push_back(std::move(row_.row));
    }

    const TakeResults* take_;
    std::size_t level_ = 0;
    bool in_list_ = false;
    std::string section_;  // the member of the report
    std::string key_;
    ResultRun run_;
    std::vector<ResultRow> rows_;
    bool has_device_ = false;
    bool has_results_ = false;
    Row row_;
    std::size_t reports_ = 0;
};

}  // namespace

void read_results(std::string_view text, const TakeResults& take) {
    Events events(take);
    (void)json::sax_parse(text.begin(), text.end(), &events);
    if (events.reports() == 0)
        throw std::runtime_error("no report: expected an object with a device and results");
}

}  // namespace gloam::report
