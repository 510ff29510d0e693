// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gloam::judge {
struct Question;
}

namespace gloam::cli {

// What the words of an option become; its type says which words are valid. Help shows the value that it has
// before, unless that is empty, 0 or infinite. A bool, and a function without parameter, make a flag.
using Target =
    std::variant<bool*, int*, std::uint32_t*, std::uint64_t*, double*, std::string*, std::filesystem::path*,
                 std::optional<int>*, std::optional<std::uint32_t>*, std::optional<std::uint64_t>*,
                 std::optional<float>*, std::optional<double>*, std::optional<std::string>*,
                 std::vector<int>*, std::vector<std::string>*, std::vector<std::filesystem::path>*,
                 std::function<void()>, std::function<void(const std::string&)>>;

// What holds of an option beside the type of its target.
struct Rules {
    std::optional<std::array<double, 2>> range = {};  // lowest and highest number
    bool positive = false;                            // a number above 0
    std::vector<std::string> one_of = {};             // the words that it takes
    bool folder = false;                              // that exists
    bool required = false;
    bool repeated = false;      // a list that gets one word each time that the option is given
    bool commas = false;        // between words of a list
    bool numbers = false;       // among its words, also below 0
    int words = 0;              // of a list, exactly; 0: any number
    std::string may_lack = {};  // name of a value that may be missing: the function then gets an empty text
    std::string shown = {};     // in help, in place of the value
    std::vector<std::string> needs = {};
    std::vector<std::string> excludes = {};
};

inline const Rules required{.required = true};
inline const Rules repeated{.repeated = true};
inline const Rules positive{.positive = true};
[[nodiscard]] Rules between(double low, double high);
[[nodiscard]] Rules one_of(std::vector<std::string> words);
// With the other option only, or without it; beside other rules.
[[nodiscard]] Rules needs(std::string other, Rules rules = {});
[[nodiscard]] Rules excludes(std::string other, Rules rules = {});

struct Option {
    Option(std::string names, Target target, Rules rules, std::string help, std::function<void()> before = {})
        : names(std::move(names)),
          target(std::move(target)),
          rules(std::move(rules)),
          help(std::move(help)),
          before(std::move(before)) {}
    Option(std::string names, Target target, std::string help = {})
        : Option(std::move(names), std::move(target), {}, std::move(help)) {}

    std::string names;  // "--rounds,--repeat"; or, without dashes, of what stands at its place
    Target target;      // which lives as long as the program
    Rules rules;
    std::string help;
    std::function<void()> before;  // called before the command runs
};

struct Command {
    std::string name;   // FILE.json: every file with this ending, which is its argument
    std::string about;  // empty: help does not list the command
    std::vector<Option> options = {};
    std::function<int()> run = {};  // returns the exit status: 0, or 1 where it found something wrong
    std::string examples = {};
    std::vector<Command> commands = {};                 // one of these may run in its place
    std::vector<std::string>* behind_dashes = nullptr;  // receives the words behind "--"
};

// Of several commands: further include roots and macros of a user's file, the device, the validation layers.
[[nodiscard]] Option include_option(std::vector<std::string>& further);
[[nodiscard]] Option define_option(std::vector<std::string>& defines);
[[nodiscard]] Option device_option(std::string& device);
[[nodiscard]] Option validation_option(bool& validation);

// Runs the program, or the command that the words name. Returns its exit status. Throws std::invalid_argument
// for words that do not fit, and what the command throws.
[[nodiscard]] int run_command(const Command& program, std::vector<std::string> words);

struct PresetFrame;

// What is about ambient occlusion, for the commands of the framework: the equations that names stand for, or
// all without names; the passes of a preset with NAME=VALUE set. Both throw std::invalid_argument.
using EquationsNamed = std::vector<judge::Question>(const std::vector<std::string>& names);
// tiles: the share of tiles that are swept in full; otherwise the preset's own, that of unseen views.
using FrameOf = PresetFrame(const std::string& preset, const std::vector<std::string>& set,
                            std::optional<double> tiles);

// The commands. Their help says what they do.
[[nodiscard]] Command demo_command();
[[nodiscard]] Command devices_command();
[[nodiscard]] Command list_command();
[[nodiscard]] Command check_command(EquationsNamed* equations);
[[nodiscard]] Command check_worker_command(EquationsNamed* equations);
[[nodiscard]] Command audit_command(EquationsNamed* equations);
[[nodiscard]] Command explain_command(EquationsNamed* equations);
[[nodiscard]] Command cost_command(EquationsNamed* equations, FrameOf* frame);
[[nodiscard]] Command mutate_command();
[[nodiscard]] Command report_command();
[[nodiscard]] Command render_command();
// With a command for each of gloam's descriptions, and for a user's own file.
[[nodiscard]] Command bench_command();
[[nodiscard]] Command stress_command();
[[nodiscard]] Command pack_command();

}  // namespace gloam::cli
