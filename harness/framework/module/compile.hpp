// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/text.hpp"

namespace gloam::module {

// `sampler`: see is_sampler_type(); it has no scalars. `unsupported`: another sampler, double, an integer of
// other than 32 bits ...; `oversized`: a type of more than most_scalars. Type::name then holds its GLSL text.
enum class Scalar { void_, bool_, int_, uint_, float_, float16_, structure, sampler, unsupported, oversized };

[[nodiscard]] constexpr bool is_float(Scalar scalar) {
    return scalar == Scalar::float_ || scalar == Scalar::float16_;
}
// Of a number.
[[nodiscard]] constexpr unsigned bits_of(Scalar scalar) {
    return scalar == Scalar::float16_ ? 16 : 32;
}

inline constexpr std::size_t most_scalars = 4096;

struct Member;

// A GLSL type: scalar, vector (columns 1, rows 2..4), matrix (columns and rows 2..4; columns x rows as in
// matCxR), structure, or an array of one of these.
struct Type {
    Scalar scalar = Scalar::void_;
    int columns = 1;
    int rows = 1;
    std::vector<Member> members;  // of a structure only
    std::string name;  // of a structure (not compared), or the text of an unsupported type (compared)
    // Of an array, outermost first: float[2][3] has 2, 3. The rest of the type is one element's.
    std::vector<std::uint32_t> sizes = {};

    // Equal layout: same scalar, columns, rows, and members of equal types; member names are not compared.
    friend bool operator==(const Type& a, const Type& b);
};

struct Member {
    std::string name;
    Type type;
};

struct Parameter {
    std::string name;
    Type type;
    source::Direction direction = source::Direction::in;
    bool global = false;     // no parameter, but a variable at file scope
    bool uniform = false;    // a global with one value for all invocations
    std::string image = {};  // of an image's pixels, rows of columns: its format, "r32f"
};

// A function as the compiler sees it: defined, or only declared (a prototype for another to define; its
// parameters then have no names).
struct Function {
    std::string name;
    Type result;
    std::vector<Parameter> parameters;
    bool defined = false;
    // Variables at file scope that it uses, itself or by what it calls; inout where it may write them.
    std::vector<Parameter> globals = {};
    std::string other_number = {};  // that it or what it calls has, and that is not judged: "double"
};

// An element of an array: that of float[2][3] is float[3].
[[nodiscard]] Type element_of(const Type& array);

// Scalars of a value; what is unsupported counts as one. At most most_scalars + 1.
[[nodiscard]] std::size_t scalar_count(const Type& type);

// "vec3", "mat4x3", "float[2]", "Name { float a; vec2[3] b; }".
[[nodiscard]] std::string to_glsl(const Type& type);
// The same with a structure by its name: "Name", "Name[2]".
[[nodiscard]] std::string name_of(const Type& type);
// "float f(vec2 uv, out float depth)"; a structure by its name only, an unnamed parameter by its type only.
// Without globals.
[[nodiscard]] std::string to_glsl(const Function& function);

// Optimisation by SPIRV-Tools after the front end.
enum class Optimization {
    none,
    performance,
    size,
    hoisting,  // performance, with loop invariants computed before their loops: not every driver does this
    unrolling  // hoisting, and drivers are asked to unroll loops: with long bodies not every driver does
};

// One way to make a module from a shader. The default is glslang's unchanged module.
struct Variant {
    // How a kernel gets its inputs: from memory, or as constants that the compiler (literals) or the driver
    // (specialization constants) may fold. compile() ignores it, because the text already contains the inputs
    // or does not.
    enum class Constants { none, literals, specialization };

    std::string name;
    std::string description;
    Optimization optimization = Optimization::none;
    bool strict = false;   // every float operation has NoContraction, as if all were `precise`
    bool relaxed = false;  // every float result has RelaxedPrecision, as if all were `mediump`
    Constants constants = Constants::none;
    // What the kernel of a function goes through after that, in order (steps.hpp). compile() ignores them.
    std::vector<std::string> steps = {};

    // Whether an OpenGL device takes it: one that is given the text, or, with compute shaders, the front
    // end's module after the steps as text again. The other variants are ways to make a module.
    [[nodiscard]] bool runs_on_opengl(bool has_compute) const {
        return optimization == Optimization::none && !strict && !relaxed && constants == Constants::none &&
               (has_compute || steps.empty());
    }
};

// All variants: shipped, strict, optimized, small, relaxed, literals, specialization.
[[nodiscard]] std::vector<Variant> variants();

// The variant with this name, which steps may follow: "shipped | spirv-opt --ccp". Throws
// std::invalid_argument for another name, with the known ones, and for what is no step.
[[nodiscard]] Variant variant(const std::string& name);

struct CompileOptions {
    source::Stage stage = source::Stage::compute;
    // Folders for #include "a/b.glsl", searched after the includer's own folder. A Source has such a folder
    // if its name is a path with a folder.
    std::vector<std::filesystem::path> include_roots;
    Variant variant;     // how the module is changed after the front end
    bool lines = false;  // the module records the file and line of each instruction
};

using Spirv = std::vector<std::uint32_t>;

// The compiler runs in this process. A text made to exhaust it (an expression 100,000 deep, macros that
// double) ends the process, or takes its memory: try texts of strangers in another one first
// (base::run_apart()). Includes must lie below the roots or the folder of the Source.

// Compiles GLSL for Vulkan 1.2 (SPIR-V 1.5) to a validated module of the variant; names are kept. #include
// needs no #extension line. Functions that main does not call may use prototypes without a body. Throws
// CompileError, also for an include that is missing or includes itself.
[[nodiscard]] Spirv compile(const source::Source& source, const CompileOptions& options);

// The functions that the text and its includes define, and the functions that they declare and call without a
// definition, in order of definition or first call. Types and names are those of the compiled module.
// Overloads are separate entries. The text needs no main; the variant has no effect. Throws like compile().
[[nodiscard]] std::vector<Function> functions(const source::Source& source, const CompileOptions& options);

// Name and version of the compiler, the optimizer, the validator and the translator back to GLSL; part of
// every cache key.
[[nodiscard]] std::string compiler_version();

// Compiled modules on disk, keyed by the text, every included file, the options and the compiler. A damaged,
// truncated or foreign entry is recompiled and replaced silently. Files are written completely or not at all.
// An unwritable directory costs only speed. Processes can share the directory.
class SpirvCache {
  public:
    // An empty directory means no cache.
    explicit SpirvCache(std::filesystem::path directory = {});

    // compile(source, options), or the stored result of an identical call.
    [[nodiscard]] Spirv compile(const source::Source& source, const CompileOptions& options) const;

    // functions(source, options), or the stored result of an identical call.
    [[nodiscard]] std::vector<Function> functions(const source::Source& source,
                                                  const CompileOptions& options) const;

  private:
    std::filesystem::path directory_;
};

}  // namespace gloam::module
