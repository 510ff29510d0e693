// SPDX-License-Identifier: MIT
// The main() of a kernel: it calls the function, and moves its values and the pixels of its images. Its
// inputs come from memory, or are constants of its text.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "subject/internal/kernel_text.hpp"

namespace gloam::subject::internal {

using module::Scalar;
using module::Type;
using source::Direction;

namespace {

using ScalarPaths = std::vector<std::pair<Scalar, std::string>>;

// The GLSL expressions of all scalars of a variable, in order: "a.x", "m[1][2]", "s.depth", "w[3].x".
ScalarPaths scalar_paths(const Type& type, const std::string& variable) {
    ScalarPaths paths;
    const auto add = [&paths](const Type& part, const std::string& path) {
        std::ranges::copy(scalar_paths(part, path), std::back_inserter(paths));
    };
    if (!type.sizes.empty()) {
        for (std::uint32_t i = 0; i < type.sizes.front(); ++i)
            add(module::element_of(type), fmt::format("{}[{}]", variable, i));
    } else if (type.scalar == Scalar::structure) {
        for (const module::Member& member : type.members) add(member.type, variable + "." + member.name);
    } else if (type.scalar != Scalar::void_) {
        for (int column = 0; column < type.columns; ++column) {
            const std::string base = type.columns > 1 ? fmt::format("{}[{}]", variable, column) : variable;
            for (int row = 0; row < type.rows; ++row)
                paths.emplace_back(type.scalar, type.rows > 1 ? fmt::format("{}[{}]", base, row) : base);
        }
    }
    return paths;
}

// How a scalar becomes its word, and a word its scalar; those of uint are equal.
struct Conversion {
    Scalar scalar;
    const char* to_word;
    const char* to_scalar;
};
constexpr std::array conversions{
    Conversion{Scalar::float16_, "floatBitsToUint(float({}))", "float16_t(uintBitsToFloat({}))"},
    Conversion{Scalar::float_, "floatBitsToUint({})", "uintBitsToFloat({})"},
    Conversion{Scalar::int_, "uint({})", "int({})"},
    Conversion{Scalar::bool_, "({} ? 1u : 0u)", "({} != 0u)"}};

std::string converted(Scalar scalar, const char* Conversion::* how, const std::string& text) {
    const auto found = std::ranges::find(conversions, scalar, &Conversion::scalar);
    return found == conversions.end() ? text : fmt::format(fmt::runtime((*found).*how), text);
}

}  // namespace

std::string scalar_of_word(Scalar scalar, const std::string& word) {
    return converted(scalar, &Conversion::to_scalar, word);
}

void append_read(std::string& code, const Type& type, const std::string& variable, const InputText& input,
                 std::size_t offset) {
    for (const auto& [scalar, path] : scalar_paths(type, variable))
        code += fmt::format("    {} = {};\n", path, input(scalar, offset++));
}

std::string argument_name(std::size_t parameter) {
    return fmt::format("gloam_kernel_argument{}", parameter);
}

namespace {

// Appends statements that write a variable to the outputs, from gloam_kernel_output_at + `offset` on.
void append_write(std::string& code, const Type& type, const std::string& variable, std::size_t offset) {
    for (const auto& [scalar, path] : scalar_paths(type, variable))
        code += fmt::format("    gloam_kernel_outputs[gloam_kernel_output_at + {}u] = {};\n", offset++,
                            converted(scalar, &Conversion::to_word, path));
}

// A statement that writes the canary, of which every invocation of a team adds its part.
std::string write_canary(const backend::Team& team, std::size_t output_words) {
    const std::string canary = "gloam_kernel_canary ^ gloam_kernel_index";
    if (team.kind == backend::Team::Kind::alone)
        return fmt::format("    gloam_kernel_outputs[gloam_kernel_output_at + {}u] = {};\n", output_words,
                           canary);
    return fmt::format(
        "    atomicAdd(gloam_kernel_outputs[gloam_kernel_output_row + {}u],\n"
        "              gloam_kernel_lane == 0u ? ({}) - {}u : 1u);\n",
        output_words, canary, team.count() - 1);
}

bool may_discard(const module::Function& function) {
    return std::ranges::any_of(function.parameters,
                               [](const module::Parameter& p) { return p.name == source::discarded; });
}

// Nothing can be written behind a discard: until the function returns, the invocation counts as discarded.
// `discarded` is the last output.
std::string write_discarded(const KernelSource& source) {
    const std::size_t output_words = source.signature().output_words();
    return fmt::format("    gloam_kernel_outputs[gloam_kernel_output_row + {}u + gloam_kernel_lane] = 1u;\n",
                       output_words - source.team.count()) +
           write_canary(source.team, output_words);
}

// Calls visit(image's texel, the argument's) for each pixel, both as GLSL text.
template <class Visit>
void for_each_pixel(const std::string& argument, Visit visit) {
    for (std::uint32_t y = 0; y < image_sides[1]; ++y)
        for (std::uint32_t x = 0; x < image_sides[0]; ++x)
            visit(fmt::format("ivec3({}, {}, {})", x, y, source::image_layer),
                  fmt::format("{}[{}][{}]", argument, y, x));
}

// Statements that fill the input's layer of an image, and that read it.
std::string write_image(const module::Parameter& image, const std::string& argument) {
    Type texel = element_of(element_of(image.type));
    const char* rest = texel.rows == 4 ? "" : texel.rows == 2 ? ", 0, 1" : ", 0, 0, 1";
    texel.rows = 4;
    std::string code = fmt::format("    {} = int(gloam_kernel_index);\n", source::image_layer);
    for_each_pixel(argument, [&](const std::string& at, const std::string& value) {
        code +=
            fmt::format("    imageStore({}, {}, {}({}{}));\n", image.name, at, name_of(texel), value, rest);
    });
    return code;
}
std::string read_image(const module::Parameter& image, const std::string& argument) {
    const int rows = element_of(element_of(image.type)).rows;
    const char* channels = rows == 4 ? "" : rows == 2 ? ".xy" : ".x";
    std::string code;
    for_each_pixel(argument, [&](const std::string& at, const std::string& value) {
        code += fmt::format("    {} = imageLoad({}, {}){};\n", value, image.name, at, channels);
    });
    return code;
}

// Writes what an invocation does for its input: reads the arguments, calls the function, writes the results.
class Evaluator {
  public:
    Evaluator(const KernelSource& source, const InputText& input)
        : source_(source), function_(source.function), input_(input) {}

    Evaluation run() {
        for (std::size_t i = 0; i < function_.parameters.size(); ++i) read(i);
        call();
        for (std::size_t i = 0; i < function_.parameters.size(); ++i) {
            const module::Parameter& p = function_.parameters[i];
            if (p.direction == Direction::in) continue;
            if (!p.image.empty()) result_.code += read_image(p, variable_of(i));
            write(p.type, variable_of(i));
        }
        return std::move(result_);
    }

  private:
    // Of what a team takes and returns, each invocation has an element.
    [[nodiscard]] Type own_type(const Type& type, bool of_all) const {
        return is_alone() || of_all || type.scalar == Scalar::void_ ? type : module::element_of(type);
    }

    [[nodiscard]] bool is_alone() const { return source_.team.kind == backend::Team::Kind::alone; }

    // From where on the words of an invocation's element are read or written.
    std::size_t move_to_element(const char* at, const char* row, std::size_t words, std::size_t first,
                                bool of_all) {
        if (is_alone()) return first;
        result_.code += fmt::format("    {} = {} + {}u + {}u * {};\n", at, row, first, words,
                                    of_all ? "0u" : "gloam_kernel_lane");
        return 0;
    }

    [[nodiscard]] std::string variable_of(std::size_t i) const {
        const module::Parameter& p = function_.parameters[i];
        return p.global && p.image.empty() ? p.name : argument_name(i);
    }

    void read(std::size_t i) {
        const module::Parameter& p = function_.parameters[i];
        const std::string variable = variable_of(i);
        if (!p.global) arguments_ += (i > 0 ? ", " : "") + variable;
        if (p.type.scalar == Scalar::sampler) return;
        const Type type = own_type(p.type, p.uniform);
        if (!p.global || !p.image.empty())
            result_.code += fmt::format("    {} {};\n", name_of(type), variable);
        if (p.direction == Direction::out) return;
        const std::size_t first = move_to_element("gloam_kernel_input_at", "gloam_kernel_input_row",
                                                  scalars_of(type).size(), result_.input_words, p.uniform);
        append_read(result_.code, type, variable, input_, first);
        result_.input_words += scalars_of(p.type).size();
        if (!p.image.empty()) result_.code += write_image(p, variable);
    }

    void write(const Type& lifted, const std::string& variable) {
        const Type type = own_type(lifted, false);
        const std::size_t first = move_to_element("gloam_kernel_output_at", "gloam_kernel_output_row",
                                                  scalars_of(type).size(), result_.output_words, false);
        append_write(result_.code, type, variable, first);
        result_.output_words += scalars_of(lifted).size();
    }

    void call() {
        const bool discards = may_discard(function_);
        if (discards) result_.code += write_discarded(source_);
        const std::string text = fmt::format("{}({});\n", function_.name, arguments_);
        if (function_.result.scalar == Scalar::void_) {
            result_.code += "    " + text;
        } else {
            const std::string type = name_of(own_type(function_.result, false));
            result_.code += fmt::format("    {} gloam_kernel_result = {}", type, text);
            write(function_.result, "gloam_kernel_result");
        }
        if (discards) result_.code += fmt::format("    {} = false;\n", source::discarded);
    }

    const KernelSource& source_;
    const module::Function& function_;
    const InputText& input_;
    Evaluation result_;
    std::string arguments_;
};

// The beginning of main(): it declares `gloam_kernel_index`, `gloam_kernel_output_at` and (of a team)
// `gloam_kernel_lane`, and returns from invocations without an input.
std::string main_begin(const backend::Team& team, std::size_t output_words) {
    const bool alone = team.kind == backend::Team::Kind::alone;
    std::string code = fmt::format(
        "void main() {{\n"
        "    uint gloam_kernel_index = gloam_kernel_input();\n"
        "    if ({}gloam_kernel_index >= gloam_kernel_count) return;\n"
        "    uint gloam_kernel_output_at = gloam_kernel_index * {}u;\n",
        team.kind == backend::Team::Kind::group
            ? ""
            : fmt::format("{}.x >= gloam_kernel_row_length || ", input_position(team)),
        output_words + 1);
    if (alone) return code;
    return code + fmt::format(
                      "    uint gloam_kernel_output_row = gloam_kernel_output_at;\n"
                      "    uint gloam_kernel_lane = {};\n",
                      team.kind == backend::Team::Kind::group
                          ? "gl_LocalInvocationIndex"
                          : "(uint(gl_FragCoord.y) & 1u) * 2u + (uint(gl_FragCoord.x) & 1u)");
}

}  // namespace

Evaluation evaluation(const KernelSource& source, const InputText& input) {
    return Evaluator(source, input).run();
}

std::string main_of(const KernelSource& source) {
    const auto input = [](Scalar scalar, std::size_t word) {
        return scalar_of_word(scalar, fmt::format("gloam_kernel_inputs[gloam_kernel_input_at + {}u]", word));
    };
    const Evaluation calls = evaluation(source, input);
    const bool alone = source.team.kind == backend::Team::Kind::alone;
    return main_begin(source.team, calls.output_words) +
           fmt::format("    uint gloam_kernel_input_at = gloam_kernel_index * {}u;\n", calls.input_words) +
           (alone ? "" : "    uint gloam_kernel_input_row = gloam_kernel_input_at;\n") + calls.code +
           (may_discard(source.function) ? "}\n" : write_canary(source.team, calls.output_words) + "}\n");
}

void require_alone(const KernelSource& source, const char* what) {
    if (source.team.kind != backend::Team::Kind::alone)
        throw backend::Unsupported(fmt::format(
            "{}: runs in several invocations together, and {} runs each alone", source.function.name, what));
}

}  // namespace gloam::subject::internal

namespace gloam::subject {

using module::Scalar;
using Constants = module::Variant::Constants;

namespace {

// The GLSL literal of a scalar, exactly: finite floats as decimals, others by
// their bits.
std::string literal(Scalar scalar, Word word) {
    if (scalar == Scalar::bool_) return word != 0 ? "true" : "false";
    if (!module::is_float(scalar) || !std::isfinite(number_at(scalar, word)))
        return internal::scalar_of_word(scalar, fmt::format("0x{:08x}u", word));
    std::string text = fmt::format("{:.17g}", number_at(scalar, word));  // 17 digits identify a double
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return scalar == Scalar::float16_ ? fmt::format("float16_t({})", text) : text;
}

}  // namespace

std::string constant_kernel_code(KernelSource source, Constants constants, std::span<const Word> inputs,
                                 std::size_t count) {
    internal::require_alone(source, "a kernel with constants");
    source.preserve_nan = source.preserve_nan && constants != Constants::literals;
    std::string declared;
    for (std::size_t id = 0; constants == Constants::specialization && id < inputs.size(); ++id)
        declared += fmt::format("layout(constant_id = {0}) const uint gloam_kernel_constant{0} = 0u;\n", id);
    std::string cases;
    std::size_t output_words = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto input = [&, first = i * (inputs.size() / count)](Scalar scalar, std::size_t word) {
            if (constants == Constants::literals) return literal(scalar, inputs[first + word]);
            return internal::scalar_of_word(scalar, fmt::format("gloam_kernel_constant{}", first + word));
        };
        const internal::Evaluation evaluation = internal::evaluation(source, input);
        output_words = evaluation.output_words;
        cases += fmt::format("    case {}u: {{\n{}    break; }}\n", i, evaluation.code);
    }
    return internal::kernel_text(source, declared + internal::main_begin({}, output_words) +
                                             "    switch (gloam_kernel_index) {\n" + cases + "    }\n" +
                                             internal::write_canary({}, output_words) + "}\n");
}

}  // namespace gloam::subject
