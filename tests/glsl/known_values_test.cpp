// SPDX-License-Identifier: MIT
// Known values of the library's functions: known/*.txt holds them, and each function is a test.
//
//   gloam/shading/ambient.glsl                    the file of the functions below
//   gloam_remap(ao, a, b, c)                      a function with its parameters, as the file names them
//       0.25, 0.5, 1, 2 = 0.5625 +- 1e-6          arguments and result
//       {nan, inf}, 0, 1, 1 = 1                   one row for each alternative
//
// Results are equal, or within a tolerance, or in a range: "> 0.1", "< 0.2", "> 0.1 < 0.2". A vector, a
// matrix and a structure are the list of their components: (1, 0, 0). A single number stands for all
// components. The values of out parameters follow the result. From # on a line is a comment.
#include <fmt/format.h>

#include "support/entries.hpp"
#include "support/lab.hpp"

namespace gloam::known_values_test {

using subject::Word;

struct Row {
    std::string arguments;
    std::string result;
    std::string least, most, within;  // bounds of the result's only number, its tolerance; empty: none
};

struct Known {
    std::string file;
    std::string function;
    std::vector<std::string> parameters;
    std::vector<Row> rows;
};

std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
}

// The parts between commas that no bracket encloses.
std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        if (i < text.size() && (text[i] == '(' || text[i] == '{')) ++depth;
        if (i < text.size() && (text[i] == ')' || text[i] == '}')) --depth;
        if (i < text.size() && (text[i] != ',' || depth > 0)) continue;
        parts.push_back(trimmed(text.substr(begin, i - begin)));
        begin = i + 1;
    }
    return parts;
}

// The line once for each of its alternatives.
std::vector<std::string> alternatives_of(const std::string& line) {
    const std::size_t open = line.find('{');
    if (open == std::string::npos) return {line};
    const std::size_t close = line.find('}', open);
    std::vector<std::string> lines;
    for (const std::string& one : parts_of(std::string_view(line).substr(open + 1, close - open - 1)))
        for (std::string& whole : alternatives_of(line.substr(0, open) + one + line.substr(close + 1)))
            lines.push_back(std::move(whole));
    return lines;
}

// What stands behind a mark and before the next one; empty without the mark.
std::string behind(const std::string& line, std::string_view mark) {
    const std::size_t at = line.find(mark);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + mark.size();
    const std::size_t end = std::min({line.find(" +-", begin), line.find(" <", begin), line.size()});
    return trimmed(std::string_view(line).substr(begin, end - begin));
}

Row row_of(const std::string& line) {
    return {.arguments = trimmed(std::string_view(line).substr(0, line.find_first_of("=<>"))),
            .result = behind(line, "= "),
            .least = behind(line, "> "),
            .most = behind(line, "< "),
            .within = behind(line, "+- ")};
}

std::vector<Known> known_in(const std::filesystem::path& path) {
    std::ifstream stream(path);
    std::vector<Known> all;
    std::string file;
    for (std::string line; std::getline(stream, line);) {
        line = line.substr(0, line.find('#'));
        const std::string text = trimmed(line);
        if (text.empty()) continue;
        if (text.ends_with(".glsl")) {
            file = text;
        } else if (line.front() != ' ') {
            const std::size_t bracket = text.find('(');
            all.push_back({.file = file,
                           .function = text.substr(0, bracket),
                           .parameters = parts_of(text.substr(bracket + 1, text.size() - bracket - 2)),
                           .rows = {}});
        } else {
            for (const std::string& one : alternatives_of(text)) all.back().rows.push_back(row_of(one));
        }
    }
    return all;
}

const std::vector<Known>& all_known() {
    static const std::vector<Known> all = [] {
        std::vector<Known> found;
        for (const auto& entry : std::filesystem::directory_iterator(KNOWN_VALUES))
            for (Known& known : known_in(entry.path())) found.push_back(std::move(known));
        std::ranges::sort(found, {}, &Known::function);
        return found;
    }();
    return all;
}

double number_from(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text == "true" || text == "false") return text == "true" ? 1.0 : 0.0;
    if (text.empty() || *end != '\0')
        throw std::invalid_argument(fmt::format("\"{}\": expected a number", text));
    return number;
}

// The numbers of a value of a type.
std::vector<std::string> components_of(const module::Type& type, const std::string& text) {
    const bool is_list = text.starts_with('(') && text.ends_with(')');
    std::vector<std::string> all = is_list ? parts_of(text.substr(1, text.size() - 2)) : std::vector{text};
    const std::size_t count = subject::scalars_of(type).size();
    if (all.size() == 1) all.resize(count, all.front());
    if (all.size() != count)
        throw std::invalid_argument(fmt::format("{}: expected {} components", text, count));
    return all;
}

Word word_from(module::Scalar scalar, const std::string& text) {
    if (scalar == module::Scalar::float_) return subject::to_word(std::strtof(text.c_str(), nullptr));
    return static_cast<Word>(static_cast<std::int64_t>(number_from(text)));
}

Word word_of(module::Scalar scalar, double number) {
    if (scalar == module::Scalar::float_) return subject::to_word(static_cast<float>(number));
    return static_cast<Word>(static_cast<std::int64_t>(number));
}

double number_of(module::Scalar scalar, Word word) {
    if (scalar == module::Scalar::float_) return double{subject::from_word<float>(word)};
    return scalar == module::Scalar::int_ ? static_cast<double>(subject::from_word<int>(word))
                                          : static_cast<double>(word);
}

class KnownValues : public testing::TestWithParam<std::size_t> {
  protected:
    const Known& known = all_known()[GetParam()];
    subject::Lab lab = test::make_lab();

    // As the compiler reads it.
    [[nodiscard]] module::Function function() const {
        for (const module::Function& one :
             module::functions(subject::probe_of(known.file), lab.compile_options()))
            if (one.name == known.function && one.defined) return one;
        throw std::invalid_argument(fmt::format("{} has no {}", known.file, known.function));
    }

    // Words of a row's arguments, for all parameters that take some.
    [[nodiscard]] static std::vector<Word> inputs_of(const Row& row, const subject::Signature& signature) {
        const std::vector<std::string> arguments = parts_of(row.arguments);
        std::vector<Word> words;
        std::size_t next = 0;
        for (const module::Parameter& parameter : signature.parameters) {
            if (parameter.direction == source::Direction::out) continue;
            if (next == arguments.size()) throw std::invalid_argument(row.arguments + ": too few arguments");
            const std::vector<module::Scalar> scalars = subject::scalars_of(parameter.type);
            const std::vector<std::string> numbers = components_of(parameter.type, arguments[next++]);
            for (std::size_t i = 0; i < scalars.size(); ++i)
                words.push_back(word_from(scalars[i], numbers[i]));
        }
        if (next < arguments.size()) throw std::invalid_argument(row.arguments + ": too many arguments");
        return words;
    }

    // The numbers of a row's result and of its out parameters.
    [[nodiscard]] static std::vector<std::string> results_of(const Row& row,
                                                             const subject::Signature& signature) {
        std::vector<module::Type> types{signature.result};
        for (const module::Parameter& parameter : signature.parameters)
            if (parameter.direction != source::Direction::in) types.push_back(parameter.type);
        const std::vector<std::string> values = parts_of(row.result);
        if (values.size() != types.size())
            throw std::invalid_argument(row.result + ": another number of results");
        std::vector<std::string> all;
        for (std::size_t i = 0; i < types.size(); ++i)
            for (std::string& one : components_of(types[i], values[i])) all.push_back(std::move(one));
        return all;
    }

    // rounding: of what calculated the words.
    void expect_result(const Row& row, const subject::Signature& signature, std::span<const Word> words,
                       double rounding = 0.0) const {
        const std::string call = fmt::format("{}({})", known.function, row.arguments);
        const std::vector<module::Scalar> scalars = signature.output_scalars();
        if (row.result.empty()) {
            ASSERT_FALSE(row.least.empty() && row.most.empty()) << call << " has no result";
            const double got = number_of(scalars[0], words[0]);
            EXPECT_TRUE(row.least.empty() || got > number_from(row.least)) << call << ": " << got;
            EXPECT_TRUE(row.most.empty() || got < number_from(row.most)) << call << ": " << got;
            return;
        }
        const std::vector<std::string> wanted = results_of(row, signature);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const double got = number_of(scalars[i], words[i]);
            const double want = row.within.empty() ? number_of(scalars[i], word_from(scalars[i], wanted[i]))
                                                   : number_from(wanted[i]);
            const double within = row.within.empty() ? rounding : number_from(row.within);
            EXPECT_TRUE(got == want || std::abs(got - want) <= within ||
                        (std::isnan(got) && std::isnan(want)))
                << call << ", component " << i << ": " << got << ", expected " << wanted[i];
        }
    }
};

TEST_P(KnownValues, AreItsResults) {
    const module::Function compiled = function();
    const subject::Signature signature{.result = compiled.result, .parameters = compiled.parameters};
    std::vector<std::string> names;
    for (const module::Parameter& parameter : compiled.parameters) names.push_back(parameter.name);
    ASSERT_EQ(names, known.parameters);
    std::vector<Word> inputs;
    for (const Row& row : known.rows)
        for (const Word word : inputs_of(row, signature)) inputs.push_back(word);
    const subject::KernelCore kernel = lab.kernel(known.file, known.function, signature);
    const subject::KernelCore::Result result = kernel.run(inputs, known.rows.size());
    lab.require_silent_validation();
    for (std::size_t i = 0; i < known.rows.size(); ++i)
        expect_result(known.rows[i], signature,
                      std::span(result.outputs).subspan(i * kernel.output_words(), kernel.output_words()));
}

// A slip that shader and reference share leaves no error between them.
TEST_P(KnownValues, AreTheResultsOfTheReference) {
    const auto& entries = test::entries();
    const auto entry = std::ranges::find_if(entries, [this](const catalogue::Entry& one) {
        return one.description.function == known.function && one.description.file == known.file;
    });
    ASSERT_NE(entry, entries.end());
    const subject::Signature& signature = entry->question.signature;
    const std::vector<module::Scalar> scalars = signature.output_scalars();
    for (const Row& row : known.rows) {
        // Nothing is promised of an infinite bias: the shader's quotient is 0 before.
        if (known.function == "gloam_depth_bias" && row.arguments.starts_with("inf")) continue;
        std::vector<double> outputs;
        entry->question.reference({}, inputs_of(row, signature), outputs);
        std::vector<Word> words;
        for (std::size_t i = 0; i < outputs.size(); ++i) words.push_back(word_of(scalars[i], outputs[i]));
        expect_result(row, signature, words, 1e-15);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, KnownValues, testing::Range(std::size_t{0}, all_known().size()),
                         [](const auto& info) { return all_known()[info.param].function; });

}  // namespace gloam::known_values_test
