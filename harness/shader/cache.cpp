// SPDX-License-Identifier: MIT
#include "shader/compile.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>
#include <bit>
#include <cstring>
#include <fstream>
#include <optional>
#include <random>
#include <type_traits>

#include "shader/include.hpp"
#include "shader/internal/compiler_process.hpp"
#include "shader/internal/entry.hpp"

namespace gloam::shader::internal {

void Fingerprint::add(std::string_view field) {
    add(static_cast<std::uint64_t>(field.size()));
    bytes_ += field;
}

void Fingerprint::add(std::uint64_t field) {
    for (int shift = 0; shift < 64; shift += 8) bytes_ += static_cast<char>((field >> shift) & 0xffu);
}

Hash Fingerprint::hash() const {
    return hash_of(bytes_);
}

Hash hash_of(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return {hash.high64, hash.low64};
}

std::string to_hex(const Hash& hash) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint64_t word : hash)
        for (int shift = 60; shift >= 0; shift -= 4) text += digits[(word >> shift) & 0xfu];
    return text;
}

namespace {

struct Header {
    std::array<char, 8> magic{'g', 'l', 'o', 'a', 'm', 'S', 'P', 'V'};
    std::uint64_t format = 1;
    Hash key{};
    std::uint64_t length = 0;
    Hash checksum{};

    friend bool operator==(const Header&, const Header&) = default;
};
static_assert(std::is_trivially_copyable_v<Header> && std::has_unique_object_representations_v<Header>);

Header header_of(const Hash& key, std::string_view payload) {
    Header header;
    header.key = key;
    header.length = payload.size();
    header.checksum = hash_of(payload);
    return header;
}

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
    std::random_device random;
    const Hash tag{(std::uint64_t{random()} << 32) | random(), (std::uint64_t{random()} << 32) | random()};
    std::filesystem::path temporary = file;
    temporary.concat(".").concat(to_hex(tag)).concat(".tmp");
    return temporary;
}

bool write_file(const std::filesystem::path& file, const Header& header, std::string_view payload) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    const auto bytes = std::bit_cast<std::array<char, sizeof(Header)>>(header);
    stream.write(bytes.data(), bytes.size());
    stream.write(payload.data(), static_cast<std::streamsize>(payload.size()));
    stream.close();
    return stream.good();
}

}  // namespace

std::optional<std::string> read_entry(const std::filesystem::path& file, const Hash& key) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size < sizeof(Header)) return std::nullopt;

    std::ifstream stream(file, std::ios::binary);
    std::array<char, sizeof(Header)> bytes{};
    if (!stream.read(bytes.data(), bytes.size())) return std::nullopt;
    const auto header = std::bit_cast<Header>(bytes);
    // Tested before the payload is read, because a foreign file may have any size.
    if (header.magic != Header{}.magic || header.length != size - sizeof(Header)) return std::nullopt;

    std::string payload(header.length, '\0');
    if (!stream.read(payload.data(), static_cast<std::streamsize>(payload.size()))) return std::nullopt;
    if (header != header_of(key, payload)) return std::nullopt;
    return payload;
}

void write_entry(const std::filesystem::path& file, const Hash& key, std::string_view payload) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    const std::filesystem::path temporary = temporary_beside(file);
    bool written = write_file(temporary, header_of(key, payload), payload);
    if (written) {
        std::filesystem::rename(temporary, file, error);
        // An empty folder of this name is removed; a folder with content is not.
        if (error && std::filesystem::is_directory(file, error) && std::filesystem::remove(file, error))
            std::filesystem::rename(temporary, file, error);
        written = !error;
    }
    if (!written) std::filesystem::remove(temporary, error);
}

}  // namespace gloam::shader::internal

namespace gloam::shader {
namespace {

// A hash of everything on which the result depends.
internal::Hash key_of(std::string_view kind, const Source& source, const CompileOptions& options) {
    internal::Fingerprint fingerprint;
    fingerprint.add(kind);
    fingerprint.add(compiler_version());
    fingerprint.add(static_cast<std::uint64_t>(options.stage));
    const Variant& variant = options.variant;
    fingerprint.add(static_cast<std::uint64_t>(variant.optimization));
    fingerprint.add(static_cast<std::uint64_t>(variant.through));
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
    const internal::Hash key = key_of(kind, source, options);
    const std::filesystem::path file = directory / (internal::to_hex(key) + "." + std::string(kind));
    if (const auto payload = internal::read_entry(file, key))
        if (auto stored = decode(*payload)) return std::move(*stored);
    const std::string made = make(source, options);
    // If an include has changed meanwhile, the result must not be stored under the key of the old text.
    if (key_of(kind, source, options) == key) internal::write_entry(file, key, made);
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
