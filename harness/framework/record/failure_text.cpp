// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <string_view>
#include <tuple>

#include "base/text.hpp"
#include "numeric/numbers.hpp"
#include "record/failures.hpp"

namespace gloam::record {
namespace {

std::string allowed_text(const numeric::Bounds& allowed) {
    if (allowed.low > allowed.high) return allowed.nan ? "NaN" : "nothing";
    const std::string high =
        allowed.low < allowed.high ? " to " + numeric::to_text(allowed.high) : std::string{};
    return numeric::to_text(allowed.low) + high + (allowed.nan ? ", or NaN" : "");
}

// The ranges of an output, each once.
std::string permitted_text(const std::vector<judge::Sample::Outcome>& outcomes, std::size_t output) {
    std::vector<std::string> texts;
    for (const judge::Sample::Outcome& outcome : outcomes) {
        std::string text = allowed_text(outcome.at(output));
        if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
    }
    return fmt::format(", permitted {}", fmt::join(texts, ", or "));
}

// Several outcomes of several outputs, which are permitted together only.
std::string outcomes_text(const std::vector<judge::Sample::Outcome>& outcomes) {
    std::string text;
    for (std::size_t k = 0; k < outcomes.size() && outcomes.size() > 1 && outcomes[k].size() > 1; ++k) {
        std::vector<std::string> ranges;
        for (const numeric::Bounds& allowed : outcomes[k]) ranges.push_back(allowed_text(allowed));
        text += fmt::format("  {} {}\n",
                            k == 0 ? "permitted together:" : "or together:       ", fmt::join(ranges, "; "));
    }
    if (outcomes.size() >= judge::Sample::most_outcomes)
        text += fmt::format("  beyond {} outcomes, neighbours are merged\n", judge::Sample::most_outcomes);
    return text;
}

// Integers with many digits in decimal alone; their bits as a double carry no information.
std::string wanted_text(double number) {
    constexpr double many_digits = 65'536.0;
    constexpr double exact = 9'007'199'254'740'992.0;
    const double size = std::abs(number);
    const bool whole = size >= many_digits && size <= exact && number == std::floor(number);
    return whole ? fmt::format("{:.0f}", number) : numeric::to_text(number);
}

std::string input_text(const std::string& title, const judge::Sample& input) {
    std::string text = fmt::format("{}\n  input   {}\n", title, input.values);
    if (!input.scenario.empty()) text += fmt::format("  images  {}\n", input.scenario);
    const std::vector<judge::Sample::Outcome> outcomes = input.permitted_outcomes();
    for (std::size_t i = 0; i < input.got.size(); ++i) {
        const std::uint32_t word = input.got[i];
        text += fmt::format("  output {}: got 0x{:08x} (as a float {}, as an integer {})", i, word,
                            numeric::to_text(std::bit_cast<float>(word)), std::bit_cast<std::int32_t>(word));
        if (i < input.want.size()) text += fmt::format(", want {}", wanted_text(input.want[i]));
        if (!outcomes.empty() && i < outcomes.front().size()) text += permitted_text(outcomes, i);
        text += "\n";
    }
    return text + outcomes_text(outcomes) + fmt::format("  error   {}\n\n", error_text(input));
}

std::string yes_no(bool flag) {
    return flag ? "yes" : "no";
}

}  // namespace

std::string failure_text(const DeviceSummary& device, const judge::Answer& row, const FailureBundle& bundle,
                         const std::string& command, const std::string& versions,
                         const std::string& program_command) {
    const auto& [steps, rules, smallest] =
        std::tie(bundle.reproduction.steps, bundle.reproduction.rules, bundle.reproduction.failure);
    std::string text =
        fmt::format("{}: {} of {}, variant {}\n\n", row.equation, row.function, row.file, row.variant);
    text += row.ran() ? row.story + "\n" : fmt::format("{}: {}\n\n", name_of(row.reason), row.error);
    if (smallest) text += input_text("The simplest input found that fails:", *smallest);
    if (bundle.reproduction.count > 1)
        text += fmt::format("It fails only beside other inputs: the program runs its group of {}.\n\n",
                            bundle.reproduction.count);
    if (row.worst) text += input_text("The input farthest outside of what is allowed:", *row.worst);
    // A function that documents no accuracy has none to be exact by.
    const bool documents = !row.rules_alone() || to_text(row.budget) != to_text(judge::Budget{});
    if (row.ran())
        text += fmt::format(
            "Judged by: {}{}\n\n",
            row.rules_alone() ? "what Vulkan's precision rules permit" : "the documented accuracy",
            documents ? "; documented accuracy: " + to_text(row.budget) : "");
    text += fmt::format(
        "Device: {}\n  driver {}, {}, type {}\n"
        "  float32: keeps signed zero, infinity and NaN: {}; keeps subnormals: {}; flushes them: {}; "
        "rounds to even: {}\n\n",
        device.manifest.empty() ? device.name : device.name + ", " + device.manifest, device.driver,
        api_of(device), device.type, yes_no(device.float32.preserves_signed_zero_inf_nan),
        yes_no(device.float32.preserves_denormals), yes_no(device.float32.flushes_denormals),
        yes_no(device.float32.rounds_to_even));
    text += "Versions: " + versions + "\n\n";
    if (!bundle.error.empty())
        text += "The shader and a reproduction could not be made: " + bundle.error + "\n\n";
    text += fmt::format("Run it again: {}\n", command);
    if (!bundle.amber.empty())
        text +=
            "Run it without gloam: amber -v 1.2 -t spv1.5 repro.amber (https://github.com/google/amber)\n";
    if (row.rules_alone() && !rules.empty())
        text += fmt::format(
            "Vulkan specification, \"Precision and Operation of SPIR-V Instructions\", float32:\n  {}\n\n",
            fmt::join(rules, "\n  "));
    if (!steps.empty()) text += fmt::format("The fewest steps that fail: {}\n", fmt::join(steps, " | "));
    if (!bundle.c_program.empty()) text += "Run it on the Vulkan loader alone: " + program_command + "\n";
    return text;
}

std::string shell_word(const std::string& text) {
    const auto is_plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("-_./=,:+").find(c) != std::string_view::npos;
    };
    const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
    if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
    if (std::ranges::any_of(text, is_control)) {
        std::string word = "$'";
        for (const char c : text)
            word += is_control(c)            ? fmt::format("\\x{:02x}", static_cast<unsigned char>(c))
                    : c == '\'' || c == '\\' ? std::string("\\") + c
                                             : std::string(1, c);
        return word + "'";
    }
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

std::string slug(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 && byte < 0x80) {
            out += static_cast<char>(std::tolower(byte));
        } else if (!out.empty() && out.back() != '-') {
            out += '-';
        }
    }
    while (!out.empty() && out.back() == '-') out.pop_back();
    return out.empty() ? "unnamed" : base::file_name_of(out);
}

}  // namespace gloam::record
