// SPDX-License-Identifier: MIT
#include "module/compile.hpp"

#include "base/cached_file.hpp"
#include "module/include.hpp"
#include "module/internal/compiler_process.hpp"

namespace gloam::shader {
namespace {

// A hash of everything on which the result depends.
base::Hash key_of(std::string_view kind, const Source& source, const CompileOptions& options) {
    base::Fingerprint fingerprint;
    fingerprint.add(kind);
    fingerprint.add(compiler_version());
    fingerprint.add(static_cast<std::uint64_t>(options.stage));
    const Variant& variant = options.variant;
    fingerprint.add(static_cast<std::uint64_t>(variant.optimization));
    for (const bool step : {variant.strict, variant.relaxed, options.lines})
        fingerprint.add(std::uint64_t{step});
    fingerprint.add(source.name);
    fingerprint.add(source.text);
    const auto folder = std::filesystem::path(source.name).parent_path();
    for (const IncludedFile& file : include_closure(source.text, options.include_roots, folder)) {
        fingerprint.add(file.path.string());
        fingerprint.add(file.text);
    }
    return fingerprint.hash();
}

// The decoded entry; if there is none, the bytes from `make`, which are then stored.
template <class Decode, class Make>
auto stored_or_made(const std::filesystem::path& directory, std::string_view kind, const Source& source,
                    const CompileOptions& options, Decode&& decode, Make&& make) {
    if (directory.empty()) return *decode(make(source, options));
    const base::Hash key = key_of(kind, source, options);
    const std::filesystem::path file = directory / (base::to_hex(key) + "." + std::string(kind));
    if (const auto payload = base::read_cached(file, key))
        if (auto stored = decode(*payload)) return std::move(*stored);
    const std::string made = make(source, options);
    // If an include has changed meanwhile, the result must not be stored under the key of the old text.
    if (key_of(kind, source, options) == key) base::write_cached(file, key, made);
    return *decode(made);
}

}  // namespace

SpirvCache::SpirvCache(std::filesystem::path directory) : directory_(std::move(directory)) {}

Spirv SpirvCache::compile(const Source& source, const CompileOptions& options) const {
    return stored_or_made(directory_, "spv", source, options, internal::module_of, internal::compiled_bytes);
}

std::vector<Function> SpirvCache::functions(const Source& source, const CompileOptions& options) const {
    CompileOptions any_variant = options;
    any_variant.variant = {};
    any_variant.lines = false;
    return stored_or_made(directory_, "functions", source, any_variant, internal::decode,
                          internal::functions_bytes);
}

}  // namespace gloam::shader
