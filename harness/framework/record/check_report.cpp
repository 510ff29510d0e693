// SPDX-License-Identifier: MIT
#include "record/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/version.hpp"
#include "numeric/numbers.hpp"
#include "record/answer_json.hpp"
#include "record/page.hpp"

namespace gloam::record {

void complete(const JsonReader& json, judge::Answer& answer) {
    const JsonReader classes = json.member("classes");
    for (const auto& [name, value] : classes.members()) (void)value_named<judge::InputClass>(classes, name);
    for (const auto& [name, count] : {std::pair{"inputs", answer.inputs()},
                                      {"outside", answer.outside()},
                                      {"recorded", answer.recorded()}}) {
        if (json.member(name).count() != count) json.member(name).expected("the sum over the classes");
    }
    if (json.has("outcome") && json.member("outcome").text() != name_of(answer.outcome()))
        json.member("outcome").expected(fmt::format("{}, by its counts", name_of(answer.outcome())));
    const JsonReader width = json.member("width_fraction");
    if (width.is_null() == answer.rules_alone())
        width.expected("a number where the verdict is rules, else null");
    for (std::size_t i = 0; answer.worst && i < answer.worst->outcomes.size(); ++i)
        if (answer.worst->outcomes[i].size() != answer.worst->permitted.size())
            json.member("worst").member("outcomes").elements()[i].expected("a range for each of \"allowed\"");
    if (!answer.rules_alone()) answer.fraction = answer.largest.fraction;
    const std::string unbounded_at = json.member("unbounded_at").text();
    if (!unbounded_at.empty()) answer.first_unbounded = judge::Sample{.values = unbounded_at};
}

namespace {

using nlohmann::ordered_json;

CheckReport read_report(const JsonReader& json) {
    CheckReport report{.device = from_json<DeviceSummary>(json.member("device")), .rows = {}};
    if (json.has("versions")) report.versions = json.member("versions").name();
    if (json.has("inputs")) report.inputs = json.member("inputs").count();
    if (json.has("seed")) report.seed = json.member("seed").count();
    if (json.has("shards"))
        for (const JsonReader& shard : json.member("shards").elements())
            if (report.shards.insert(shard.name()).first->find('/') == std::string::npos)
                shard.expected("INDEX/COUNT");
    report.rows = from_json<std::vector<judge::Answer>>(json.member("results"));
    return report;
}

}  // namespace

std::string name_of(const DeviceSummary& device) {
    const std::string name = device.driver.empty() ? device.name : device.name + " (" + device.driver + ")";
    return device.manifest.empty() ? name : name + ", " + device.manifest;
}

std::string api_of(const DeviceSummary& device) {
    const bool names_itself = device.type.starts_with("opengl") || device.type.starts_with("webg");
    return names_itself ? device.api_version : "Vulkan " + device.api_version;
}

std::string to_json(const std::vector<CheckReport>& reports) {
    ordered_json all = ordered_json::array();
    for (const CheckReport& report : reports) {
        ordered_json& object =
            all.emplace_back(ordered_json{{"gloam", base::version()}, {"device", json_of(report.device)}});
        if (!report.versions.empty()) object["versions"] = report.versions;
        if (report.inputs > 0) {
            object["inputs"] = report.inputs;
            object["seed"] = report.seed;
        }
        if (!report.shards.empty()) object["shards"] = report.shards;
        object["results"] = json_of(report.rows);
    }
    return to_text(all.size() == 1 ? all.front() : all);
}

std::vector<CheckReport> reports_from_json(std::string_view text) {
    const ordered_json json = parse_json(text);
    const JsonReader all(json, "");
    if (!all.is_array()) return {read_report(all)};
    std::vector<CheckReport> reports;
    for (const JsonReader& report : all.elements()) reports.push_back(read_report(report));
    return reports;
}

namespace {

// In an attribute of XML.
std::string escaped(std::string_view text) {
    return base::replaced(escaped_html(text), "\n", "&#10;");
}

std::string test_case(const judge::Answer& row) {
    std::string xml =
        fmt::format("    <testcase classname=\"{}\" name=\"{} {}\" time=\"{:.3f}\"", escaped(row.file),
                    escaped(row.equation), escaped(row.variant), row.seconds);
    if (row.passed()) return xml + "/>\n";
    if (!row.failed())
        return xml + fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n",
                                 escaped(row.not_judged_because()));
    return xml + fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\"/>\n    </testcase>\n",
                             row.ran() ? "failure" : "error",
                             row.reason == judge::Reason::none ? "outside" : name_of(row.reason),
                             escaped(row.ran() ? row.story : row.error));
}

}  // namespace

std::string to_junit(const std::vector<CheckReport>& reports) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const CheckReport& report : reports) {
        const auto errors = static_cast<std::size_t>(std::ranges::count_if(
            report.rows, [](const judge::Answer& row) { return row.failed() && !row.ran(); }));
        xml += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
            escaped(report.device.name), report.rows.size(), report.count(judge::Outcome::failed) - errors,
            errors, report.count(judge::Outcome::not_judged));
        if (!report.versions.empty())
            xml += fmt::format("    <properties><property name=\"versions\" value=\"{}\"/></properties>\n",
                               escaped(report.versions));
        for (const judge::Answer& row : report.rows) xml += test_case(row);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

namespace {

// Widths of the longest ID, function and variant.
constexpr std::string_view line_format = "{:<21} {:<43} {:<14} {:>9} {:>10} {:>10} {:>10}  {:<9} {}";

// Where the rules alone are the verdict, an infinite error may be right: for an overflow, say.
Cell error_cell(const judge::Answer& row, double error, const std::string& text) {
    const bool permitted = row.rules_alone() && row.passed() && std::isinf(error);
    return {permitted ? "permitted" : text, error};
}

}  // namespace

std::size_t CheckReport::count(judge::Outcome outcome) const {
    return static_cast<std::size_t>(std::ranges::count(rows, outcome, &judge::Answer::outcome));
}

OutcomeCounts counts_of(const std::vector<CheckReport>& reports) {
    OutcomeCounts all;
    for (const CheckReport& report : reports) {
        all.checks += report.rows.size();
        all.failed += report.count(judge::Outcome::failed);
        all.not_judged += report.count(judge::Outcome::not_judged);
    }
    return all;
}

int OutcomeCounts::exit_status() const {
    constexpr int could_not_run = 2;
    if (failed > 0) return 1;
    return checks > 0 && not_judged == checks ? could_not_run : 0;
}

std::string to_text(const OutcomeCounts& counts) {
    std::string text = fmt::format("{} checks, {} failed", counts.checks, counts.failed);
    return counts.not_judged == 0 ? text : text + fmt::format(", {} not judged", counts.not_judged);
}

const std::vector<Column>& error_columns() {
    static const std::vector<Column> columns{
        {.title = "judged", .meaning = "inputs for which some result would have failed", .numeric = true},
        {.title = "worst ulp",
         .meaning = "largest error in units in the last place of the printed equation, or of a function of "
                    "your own, in double precision, without errors within a documented absolute one; "
                    "permitted: it is infinite, and the rules permit that",
         .numeric = true},
        {.title = "worst abs", .meaning = "largest absolute error", .numeric = true},
        {.title = "of allowed",
         .meaning = "the largest error as a fraction of what is allowed; more than 1 fails",
         .numeric = true}};
    return columns;
}

std::vector<Cell> error_cells(const judge::Answer& row) {
    if (!row.ran()) return std::vector<Cell>(error_columns().size(), "-");
    const double used = row.fraction_of_allowed();
    return {row.judged(),
            error_cell(row, row.largest.ulp, fmt::format("{:.3g}", row.largest.ulp)),
            error_cell(row, row.largest.absolute, fmt::format("{:.2e}", row.largest.absolute)),
            {numeric::to_short_text(used), used}};
}

std::string table_header() {
    const std::vector<Column>& c = error_columns();
    return fmt::format(line_format, "equation", "function", "variant", c[0].title, c[1].title, c[2].title,
                       c[3].title, "judged by", "verdict");
}

std::string table_legend() {
    std::string text;
    for (const Column& column : error_columns()) text += column.title + ": " + column.meaning + "\n";
    return text +
           "judged by: rules = what Vulkan's precision rules permit, budget = the accuracy that the function "
           "documents\n";
}

std::string verdict_of(const judge::Answer& row) {
    if (!row.ran())
        return row.reason == judge::Reason::error ? "could not run" : std::string(name_of(row.reason));
    std::string verdict =
        row.failed() ? fmt::format("{} outside", row.outside()) : std::string(name_of(row.outcome()));
    if (!row.fault.empty()) verdict += ", reads outside its image";
    if (row.differs > 0) verdict += fmt::format(", {} differ from run time", row.differs);
    return verdict;
}

std::string remark_on(const judge::Answer& row) {
    const std::string why = row.not_judged_because();
    if (!why.empty() || !row.ran()) return why;
    std::string remark;
    if (row.open() > 0)
        remark = fmt::format(
            "any result would pass for {} of {}{}", row.open(),
            row.rules_alone() ? row.bounded : row.inputs(),
            row.rules_alone() && row.bounded < row.inputs() ? " whose bounds were calculated" : "");
    std::string separator = remark.empty() ? "not promised: " : "; not promised: ";
    for (const judge::InputClass input_class : row.not_promised()) {
        remark += separator + std::string(name_of(input_class));
        separator = ", ";
    }
    return remark;
}

std::string table_line(const judge::Answer& row, const std::string& verdict) {
    const std::vector<Cell> cells = error_cells(row);
    const std::string why = row.reason == judge::Reason::unsupported ? base::one_line(row.error) : "";
    const std::string remark = row.ran() ? remark_on(row) : why;
    return fmt::format(line_format, row.equation, row.function, row.variant_before_steps(), cells[0].text,
                       cells[1].text, cells[2].text, cells[3].text, row.ran() ? name_of(row.criterion) : "-",
                       verdict.empty() ? verdict_of(row) : verdict) +
           (remark.empty() ? "" : "; " + remark) + (row.steps().empty() ? "" : "; after " + row.steps());
}

}  // namespace gloam::record
