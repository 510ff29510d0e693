// SPDX-License-Identifier: MIT
#include "cli/strict_options.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace gloam::cli {
namespace {

std::string refuse_empty(const std::string& text) {
    return text.empty() ? "expected a value, found an empty text" : "";
}

std::string refuse_nan(const std::string& text) {
    const bool is_nan = CLI::detail::to_lower(text).find("nan") != std::string::npos;
    return is_nan ? "expected a number, found " + text : "";
}

std::string refuse_negative(const std::string& text) {
    return text.starts_with('-') ? "expected a count, 0 or more, found " + text : "";
}

void make_strict(CLI::Option& option) {
    const bool takes_value = option.get_items_expected_max() > 0 && option.get_type_size_max() > 0;
    if (!takes_value) return;  // a flag
    // CLI11 names the type "FLOAT" or "UINT", and appends the descriptions of the option's own checks.
    const std::string type = option.get_type_name();
    const auto add = [&option](std::string (*refuse)(const std::string&)) {
        option.check(CLI::Validator(refuse, ""));
    };
    if (type.starts_with("UINT")) add(refuse_negative);
    if (type.starts_with("FLOAT")) add(refuse_nan);
    if (option.get_items_expected_min() > 0) add(refuse_empty);
}

}  // namespace

void refuse_meaningless_values(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) make_strict(*option);
    for (CLI::App* command : app.get_subcommands({})) refuse_meaningless_values(*command);
}

}  // namespace gloam::cli
