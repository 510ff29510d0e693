// SPDX-License-Identifier: MIT
#include "module/compile.hpp"

#include <nlohmann/json.hpp>

#include "base/cached_file.hpp"
#include "module/include.hpp"
#include "module/spirv.hpp"

namespace gloam::module {

using Json = nlohmann::json;

// Functions in the cache. A type has members that have types.
static void to_json(Json& json, const Member& member);
static void from_json(const Json& json, Member& member);
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Type, scalar, columns, rows, name, members, sizes)
static void to_json(Json& json, const Member& member) {
    json = Json::array({member.name, member.type});
}
static void from_json(const Json& json, Member& member) {
    json.at(0).get_to(member.name);
    json.at(1).get_to(member.type);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Parameter, name, type, direction, global)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Function, name, result, parameters, defined, globals, other_number)

namespace {

std::string bytes_of_functions(const std::vector<Function>& functions) {
    std::string bytes;
    Json::to_cbor(functions, bytes);
    return bytes;
}

std::optional<std::vector<Function>> functions_of(std::string_view bytes) {
    try {
        return Json::from_cbor(bytes).get<std::vector<Function>>();
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

// A hash of everything on which the result depends.
base::Hash key_of(std::string_view kind, const source::Source& source, const CompileOptions& options) {
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
    for (const IncludedFile& file : include_closure(source, options.include_roots)) {
        if (options.lines) fingerprint.add(file.path.string());  // else no module names its files
        fingerprint.add(file.text);
    }
    return fingerprint.hash();
}

// The decoded entry; if there is none, the result of `make`, which is then stored.
template <class Make, class Encode, class Decode>
auto stored_or_made(const std::filesystem::path& directory, std::string_view kind,
                    const source::Source& source, const CompileOptions& options, Make&& make, Encode&& encode,
                    Decode&& decode) {
    if (directory.empty()) return make(source, options);
    const base::Hash key = key_of(kind, source, options);
    const std::filesystem::path file = directory / (base::to_hex(key) + "." + std::string(kind));
    if (const auto payload = base::read_cached(file, key))
        if (auto stored = decode(*payload)) return std::move(*stored);
    auto made = make(source, options);
    // If an include has changed meanwhile, the result must not be stored under the key of the old text.
    if (key_of(kind, source, options) == key) base::write_cached(file, key, encode(made));
    return made;
}

}  // namespace

SpirvCache::SpirvCache(std::filesystem::path directory) : directory_(std::move(directory)) {}

Spirv SpirvCache::compile(const source::Source& source, const CompileOptions& options) const {
    return stored_or_made(directory_, "spv", source, options, module::compile, bytes_of, module_of);
}

std::vector<Function> SpirvCache::functions(const source::Source& source,
                                            const CompileOptions& options) const {
    const CompileOptions any_variant{.stage = options.stage, .include_roots = options.include_roots};
    return stored_or_made(directory_, "functions", source, any_variant, module::functions, bytes_of_functions,
                          functions_of);
}

}  // namespace gloam::module
