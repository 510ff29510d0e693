// SPDX-License-Identifier: MIT
#include "scene/mesh_reader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <span>
#include <stdexcept>

#include "base/process.hpp"
#include "base/text.hpp"
#include "base/write_file.hpp"

namespace gloam::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "gloam mesh 1\n";
constexpr int unreadable = 2;
constexpr int out_of_memory = 3;

template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
std::vector<T> take(std::string_view& bytes, std::uint64_t count) {
    if (count > bytes.size() / sizeof(T)) throw std::runtime_error("a mesh that is cut short");
    std::vector<T> values(count);
    std::memcpy(static_cast<void*>(values.data()), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return values;
}

// Limits of memory and time for a file: a constant part, and a part that grows with its size.
base::ProcessLimits limits_for(const fs::path& file) {
    std::error_code none;
    const std::uint64_t bytes = fs::is_regular_file(file, none) ? fs::file_size(file, none) : 0;
    constexpr std::uint64_t memory = std::uint64_t{1} << 30;
    constexpr std::uint64_t memory_for_byte = 64;
    const auto cpu = std::chrono::seconds(3 + 2 * (bytes >> 20));
    return {.memory_bytes = memory + memory_for_byte * bytes,
            .cpu = cpu,
            .patience = 20 * cpu,
            .output_bytes = memory + memory_for_byte * bytes};
}

[[noreturn]] void refuse(const fs::path& file, const base::ProcessResult& reader,
                         const base::ProcessLimits& limits) {
    using End = base::ProcessResult::End;
    if (reader.end == End::status && reader.number == unreadable && !reader.errors.empty())
        throw std::runtime_error(base::one_line(reader.errors));
    std::string why = "cannot be read: its reader " + base::one_line(reader.how());
    if (reader.end == End::status && reader.number == out_of_memory)
        why = fmt::format("takes more than {} MiB to read, the limit", limits.memory_bytes >> 20);
    if (reader.end == End::time || (reader.end == End::signal && reader.number == SIGXCPU))
        why = fmt::format("takes more than {} s to read, the limit", limits.cpu.count());
    throw std::runtime_error(fmt::format("mesh {}: {}", file.string(), why));
}

void require_whole(const Mesh& mesh) {
    bool good = mesh.normals.size() == mesh.positions.size() && mesh.indices.size() % 3 == 0;
    for (const std::uint32_t index : mesh.indices) good = good && index < mesh.positions.size();
    if (!good) throw std::runtime_error("a mesh that does not fit together");
}

}  // namespace

std::string mesh_bytes(const Mesh& mesh) {
    const std::array<std::uint64_t, 2> counts{mesh.positions.size(), mesh.indices.size()};
    std::string bytes(magic);
    bytes.append(reinterpret_cast<const char*>(counts.data()), sizeof counts);
    append_bytes(bytes, mesh.positions);
    append_bytes(bytes, mesh.normals);
    append_bytes(bytes, mesh.indices);
    return bytes;
}

Mesh mesh_from_bytes(std::string_view bytes) {
    if (!bytes.starts_with(magic)) throw std::runtime_error("no mesh");
    bytes.remove_prefix(magic.size());
    const std::vector<std::uint64_t> counts = take<std::uint64_t>(bytes, 2);
    Mesh mesh;
    mesh.positions = take<glm::vec3>(bytes, counts[0]);
    mesh.normals = take<glm::vec3>(bytes, counts[0]);
    mesh.indices = take<std::uint32_t>(bytes, counts[1]);
    if (!bytes.empty()) throw std::runtime_error("a mesh with more behind it");
    require_whole(mesh);
    return mesh;
}

Mesh read_mesh(const fs::path& file, std::vector<std::string> reader) {
    const base::ProcessLimits limits = limits_for(file);
    reader.push_back(fs::absolute(file).string());
    const base::ProcessResult result = base::run_process(reader, "", limits);
    if (!result.succeeded()) refuse(file, result, limits);
    try {
        return mesh_from_bytes(result.output);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("mesh {}: its reader gave {}", file.string(), error.what()));
    }
}

int run_mesh_reader(const fs::path& file) {
    try {
        const std::string bytes = mesh_bytes(load_mesh(file));
        return base::write_all(STDOUT_FILENO, bytes) == 0 ? 0 : unreadable;
    } catch (const std::bad_alloc&) {
        return out_of_memory;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return unreadable;
    }
}

}  // namespace gloam::scene
