// SPDX-License-Identifier: MIT
#include "report/check_row.hpp"

#include "report/internal/row_json.hpp"

namespace gloam::report {

using internal::JsonReader;
using internal::number_json;
using nlohmann::ordered_json;

std::string_view name_of(Reason reason) {
    switch (reason) {
        case Reason::crash:
            return "crash";
        case Reason::hang:
            return "hang";
        case Reason::device_lost:
            return "device lost";
        case Reason::out_of_memory:
            return "out of memory";
        case Reason::error:
            return "error";
        case Reason::fault:
            return "fault";
        case Reason::none:
            break;
    }
    return "";
}

namespace internal {
namespace {

Reason read_reason(const JsonReader& json) {
    const std::string text = json.text();
    for (const Reason reason : all_reasons) {
        if (name_of(reason) == text) return reason;
    }
    json.expected("\"\", crash, hang, device lost, out of memory, error or fault");
}

ordered_json classes_json(const std::vector<ClassNumbers>& classes) {
    ordered_json json = ordered_json::object();
    for (const ClassNumbers& c : classes) {
        json[c.name] = {{"inputs", c.inputs}, {"outside", c.outside}, {"recorded", c.recorded}};
    }
    return json;
}

std::vector<ClassNumbers> read_classes(const JsonReader& json) {
    std::vector<ClassNumbers> classes;
    for (const auto& [name, value] : json.members()) {
        classes.push_back({.name = name,
                           .inputs = value.member("inputs").count(),
                           .outside = value.member("outside").count(),
                           .recorded = value.member("recorded").count()});
    }
    return classes;
}

ordered_json worst_json(const std::optional<WorstInput>& worst) {
    if (!worst) return nullptr;
    ordered_json allowed = ordered_json::array();
    for (const AllowedNumbers& a : worst->allowed) {
        allowed.push_back({{"low", number_json(a.low)}, {"high", number_json(a.high)}, {"nan", a.nan}});
    }
    return {{"input", worst->input},
            {"class", worst->input_class},
            {"images", worst->images},
            {"values", worst->values},
            {"input_words", worst->input_words},
            {"got_words", worst->got_words},
            {"want", numbers_json(worst->want)},
            {"allowed", allowed},
            {"ulp", number_json(worst->ulp)},
            {"abs", number_json(worst->absolute)}};
}

std::optional<WorstInput> read_worst(const JsonReader& json) {
    if (json.is_null()) return std::nullopt;
    WorstInput worst{.input = json.member("input").count(),
                     .input_class = json.member("class").text(),
                     .images = json.member("images").text(),
                     .values = json.member("values").text(),
                     .input_words = json.member("input_words").words(),
                     .got_words = json.member("got_words").words(),
                     .want = json.member("want").numbers(),
                     .allowed = {},
                     .ulp = json.member("ulp").number(),
                     .absolute = json.member("abs").number()};
    for (const JsonReader& allowed : json.member("allowed").elements()) {
        worst.allowed.push_back({.low = allowed.member("low").number(),
                                 .high = allowed.member("high").number(),
                                 .nan = allowed.member("nan").flag()});
    }
    return worst;
}

ordered_json guarantee_json(const std::optional<GuaranteeNumbers>& guarantee) {
    if (!guarantee) return nullptr;
    return {{"ulp", number_json(guarantee->ulp)},
            {"abs", number_json(guarantee->absolute)},
            {"fraction", number_json(guarantee->fraction)}};
}

std::optional<GuaranteeNumbers> read_guarantee(const JsonReader& json) {
    if (json.is_null()) return std::nullopt;
    return GuaranteeNumbers{.ulp = json.member("ulp").number(),
                            .absolute = json.member("abs").number(),
                            .fraction = json.member("fraction").number()};
}

ordered_json budget_json(const BudgetNumbers& budget) {
    return {{"ulp", budget.ulp},
            {"abs", budget.absolute},
            {"backward_ulp", budget.backward_ulp},
            {"text", budget.text}};
}

BudgetNumbers read_budget(const JsonReader& json) {
    return {.ulp = json.member("ulp").number(),
            .absolute = json.member("abs").number(),
            .backward_ulp = static_cast<int>(json.member("backward_ulp").count()),
            .text = json.member("text").text()};
}

}  // namespace

ordered_json row_json(const CheckRow& row) {
    return {{"equation", row.equation},
            {"function", row.function},
            {"file", row.file},
            {"variant", row.variant},
            {"verdict", row.verdict},
            {"inputs", row.inputs},
            {"outside", row.outside},
            {"recorded", row.recorded},
            {"unbounded", row.unbounded},
            {"differs", row.differs},
            {"max_ulp", number_json(row.max_ulp)},
            {"max_abs", number_json(row.max_abs)},
            {"width_fraction", row.width_fraction ? number_json(*row.width_fraction) : ordered_json(nullptr)},
            {"budget_fraction", number_json(row.budget_fraction)},
            {"guarantee", guarantee_json(row.guarantee)},
            {"unbounded_at", row.unbounded_at},
            {"budget", budget_json(row.budget)},
            {"classes", classes_json(row.classes)},
            {"worst", worst_json(row.worst)},
            {"fault", row.fault},
            {"error", row.error},
            {"reason", name_of(row.reason)},
            {"seconds", row.seconds},
            {"story", row.story}};
}

CheckRow read_row(const JsonReader& json) {
    CheckRow row{.equation = json.member("equation").name(),
                 .function = json.member("function").name(),
                 .file = json.member("file").name(),
                 .variant = json.member("variant").name(),
                 .verdict = json.member("verdict").name(),
                 .inputs = json.member("inputs").count(),
                 .outside = json.member("outside").count(),
                 .recorded = json.member("recorded").count(),
                 .unbounded = json.member("unbounded").count(),
                 .differs = json.member("differs").count(),
                 .max_ulp = json.member("max_ulp").number(),
                 .max_abs = json.member("max_abs").number(),
                 .width_fraction = std::nullopt,
                 .budget_fraction = json.member("budget_fraction").number(),
                 .guarantee = read_guarantee(json.member("guarantee")),
                 .unbounded_at = json.member("unbounded_at").text(),
                 .budget = read_budget(json.member("budget")),
                 .classes = read_classes(json.member("classes")),
                 .worst = read_worst(json.member("worst")),
                 .fault = json.member("fault").text(),
                 .error = json.member("error").text(),
                 .reason = read_reason(json.member("reason")),
                 .seconds = json.member("seconds").number(),
                 .story = json.member("story").text()};
    const JsonReader width = json.member("width_fraction");
    if (!width.is_null()) row.width_fraction = width.number();
    if (row.verdict != "budget" && row.verdict != "rules") json.member("verdict").expected("budget or rules");
    return row;
}

}  // namespace internal

std::string to_json(const CheckRow& row) {
    return internal::row_json(row).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

CheckRow row_from_json(std::string_view text) {
    const ordered_json json = internal::parse_json(text);
    return internal::read_row(JsonReader(json, ""));
}

}  // namespace gloam::report
