// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "module/texts.hpp"
#include "subject/lab.hpp"
#include "subject/own_function.hpp"

// What a fault in a shader file changes, without any test.
namespace gloam::audit {

// What a fault changes in the modules that are compiled from a file.
enum class Change {
    invalid,  // one of them no longer compiles
    same,     // nothing, after the optimizer
    other
};

// How the results of a function with a fault differ from those without, by the interpreter.
enum class Difference {
    none,        // on no input that was tried
    unpromised,  // only where the original has no promised result: undefined, or of no stated precision
    budget,      // all differences are within Vulkan's rules for the original, or within 4 ULP
    real,
    unknown  // the function cannot be interpreted
};
[[nodiscard]] std::string name_of(Difference difference);  // "within the budget"

struct MutantComparison {
    Difference difference = Difference::unknown;
    std::string function;
    std::size_t inputs = 0;            // that were tried
    std::vector<subject::Word> words;  // the simplest input found that shows the difference; empty: none does
    std::string values;                // "x = 0.5"
    std::string before;                // the results, "0.25"
    std::string after;
};

// A file whose faults are judged: its functions are compiled as `gloam check` compiles them, and a whole
// shader as it is. Thread-safe.
class MutantFile {
  public:
    // Throws source::CompileError for a text that the preprocessor rejects.
    MutantFile(std::filesystem::path path, std::string text, std::vector<std::filesystem::path> roots);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::vector<source::Mutation>& mutations() const { return mutations_; }
    // What the compiler says of the text by itself; empty: it is valid. An include may need what stands
    // before it: which of its faults compile is then not known.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

    // What other files make of a fault outside of functions, and what code is under other conditions of the
    // preprocessor, is not known: such a fault is never `same`.
    [[nodiscard]] Change change_of(const source::Mutation& mutation) const;

    // Compares the function of a fault, or all that use its place, on this many inputs.
    [[nodiscard]] MutantComparison compare(const source::Mutation& mutation, std::size_t inputs,
                                           std::uint64_t seed) const;

  private:
    struct Own {
        subject::OwnFunction function;
        module::Spirv module;  // optimised, without names
    };
    [[nodiscard]] module::Spirv module_of(const subject::OwnFunction& own, const std::string& text) const;
    [[nodiscard]] std::optional<module::Spirv> whole(const std::string& text) const;
    // Our functions with their text in the changed file, if it differs.
    [[nodiscard]] std::vector<std::pair<const Own*, std::string>> changed_in(const std::string& text) const;
    [[nodiscard]] MutantComparison compare(const Own& own, const std::string& changed, std::size_t inputs,
                                           std::uint64_t seed) const;

    std::filesystem::path path_;
    std::string text_;
    std::vector<std::filesystem::path> roots_;
    std::vector<source::Mutation> mutations_;
    std::string trouble_;
    bool conditional_ = false;
    std::optional<subject::Lab> lab_;  // of the interpreter, with the excerpts of the file
    std::vector<Own> own_;
    std::optional<module::Spirv> whole_;  // of a text with a main
};

}  // namespace gloam::audit
