// SPDX-License-Identifier: MIT
#include "shader/internal/compiler_process.hpp"

#include <cstring>
#include <utility>

#include "base/apart.hpp"
#include "shader/internal/dependencies.hpp"
#include "shader/internal/function_codec.hpp"

namespace gloam::shader::internal {
namespace {

const base::ProcessLimits limits{.memory_bytes = std::uint64_t{3} << 30,
                                 .cpu = std::chrono::seconds(60),
                                 .patience = std::chrono::minutes(5)};

// Serialises texts and numbers, one after another.
class Writer {
  public:
    void add(std::string_view text) {
        add(text.size());
        bytes_ += text;
    }
    void add(std::uint64_t number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
    std::string take() { return std::move(bytes_); }

  private:
    std::string bytes_;
};

// Reads what a Writer of this program has written; never untrusted bytes.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t number() {
        std::uint64_t value = 0;
        std::memcpy(&value, bytes_.substr(0, sizeof value).data(), sizeof value);
        bytes_.remove_prefix(sizeof value);
        return value;
    }
    std::string text() {
        const std::uint64_t size = number();
        std::string value(bytes_.substr(0, size));
        bytes_.remove_prefix(size);
        return value;
    }

  private:
    std::string_view bytes_;
};

std::string question_of(bool wants_functions, const Source& source, const CompileOptions& options) {
    Writer writer;
    writer.add(std::uint64_t{wants_functions});
    writer.add(dependency_list());
    writer.add(source.name);
    writer.add(source.text);
    writer.add(static_cast<std::uint64_t>(options.stage));
    writer.add(static_cast<std::uint64_t>(options.variant.optimization));
    writer.add(static_cast<std::uint64_t>(options.variant.through));
    for (const bool step : {options.variant.strict, options.variant.relaxed, options.lines})
        writer.add(std::uint64_t{step});
    writer.add(options.include_roots.size());
    for (const auto& root : options.include_roots) writer.add(root.string());
    return writer.take();
}

std::string answer_to(std::string_view question) {
    Reader reader(question);
    const bool wants_functions = reader.number() != 0;
    use_dependency_list(reader.text());  // the process outlives the test that it was started in
    Source source{.name = reader.text(), .text = reader.text()};
    CompileOptions options{.stage = static_cast<Stage>(reader.number()), .include_roots = {}, .variant = {}};
    options.variant.optimization = static_cast<Optimization>(reader.number());
    options.variant.through = static_cast<Variant::Through>(reader.number());
    for (bool* step : {&options.variant.strict, &options.variant.relaxed, &options.lines})
        *step = reader.number() != 0;
    for (std::uint64_t left = reader.number(); left > 0; --left)
        options.include_roots.emplace_back(reader.text());
    if (wants_functions) return encode(functions(source, options));
    const Spirv module = compile(source, options);
    return {reinterpret_cast<const char*>(module.data()), module.size() * sizeof(Spirv::value_type)};
}

std::string asked(const Source& source, const std::string& question) {
    thread_local base::Apart compiler(answer_to, limits);
    try {
        return compiler.ask(question);
    } catch (const base::WorkError& error) {
        throw CompileError(error.what());
    } catch (const base::LimitError& error) {
        throw CompileError(source.name + ": the compiler " + error.what());
    }
}

}  // namespace

std::string compiled_apart(const Source& source, const CompileOptions& options) {
    return asked(source, question_of(false, source, options));
}

std::string functions_apart(const Source& source, const CompileOptions& options) {
    return asked(source, question_of(true, source, options));
}

}  // namespace gloam::shader::internal
