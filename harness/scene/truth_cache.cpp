// SPDX-License-Identifier: MIT
#include "scene/truth_cache.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "base/write_file.hpp"
#include "scene/internal/sobol.hpp"

namespace gloam::scene {
namespace {

namespace fs = std::filesystem;

// Increase it whenever the tracer's results change for the same input.
constexpr std::uint64_t version = 1;

// A hash of 128 bits over all added data.
class Hash {
  public:
    void add(std::uint64_t word) {
        a_ = mixed(a_ ^ word);
        b_ = mixed(b_ + 0x9e3779b97f4a7c15U * (word + 1));
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }

    template <class T>
    void add_all(const std::vector<T>& values) {
        add(std::uint64_t{values.size()});
        const std::span bytes = std::as_bytes(std::span(values));
        for (std::size_t i = 0; i < bytes.size(); i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
            add(word);
        }
    }

    [[nodiscard]] std::uint64_t word() const { return a_ ^ b_; }

    [[nodiscard]] std::string text() const {
        std::string digits;
        for (const std::uint64_t word : {a_, b_})
            for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15U];
        return digits;
    }

  private:
    std::uint64_t a_ = version;
    std::uint64_t b_ = ~version;
};

void add_view(Hash& hash, const GBuffer& view, const TruthSettings& settings) {
    hash.add(std::uint64_t{view.extent.width});
    hash.add(std::uint64_t{view.extent.height});
    hash.add_all(view.depth);
    hash.add_all(view.normal);
    hash.add(double{view.camera.p00_p11().x});
    hash.add(double{view.camera.p00_p11().y});
    hash.add(std::uint64_t{view.camera.orthographic()});
    hash.add(settings.rays.radius);
    hash.add(static_cast<std::uint64_t>(settings.rays.falloff));
    hash.add(static_cast<std::uint64_t>(settings.rays.rays));
    // Adds nothing for the default weighting, so that files from before the choice stay valid.
    if (settings.rays.weighting == Weighting::uniform) hash.add(std::uint64_t{1});
}

// Three counts, two images, and a hash of these and of the input. The hash detects a file under a wrong name.
using Counts = std::array<std::uint64_t, 3>;

std::uint64_t check_word(const Hash& of, const Counts& counts, const std::vector<float>& values) {
    Hash hash = of;
    for (const std::uint64_t count : counts) hash.add(count);
    hash.add_all(values);
    return hash.word();
}

template <class T>
bool read_into(std::ifstream& file, std::span<T> values) {
    const std::span bytes = std::as_writable_bytes(values);
    return static_cast<bool>(
        file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())));
}

template <class T>
void append(std::string& bytes, std::span<const T> values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

std::optional<TracedTruth> read(const fs::path& path, const Hash& of, std::size_t pixels) {
    std::ifstream file(path, std::ios::binary);
    Counts counts{};
    std::vector<float> values(2 * pixels);
    std::uint64_t check = 0;
    if (!read_into(file, std::span<std::uint64_t>(counts)) || !read_into(file, std::span<float>(values)) ||
        !read_into(file, std::span<std::uint64_t>(&check, 1)) || check != check_word(of, counts, values))
        return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(pixels);
    return TracedTruth{.occlusion = {values.begin(), middle},
                       .standard_error = {middle, values.end()},
                       .rays = counts[0],
                       .pixels = counts[1],
                       .unmatched = counts[2]};
}

void write(const fs::path& path, const Hash& of, const TracedTruth& truth) {
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    const Counts counts{truth.rays, truth.pixels, truth.unmatched};
    std::vector<float> values = truth.occlusion;
    values.insert(values.end(), truth.standard_error.begin(), truth.standard_error.end());
    const std::uint64_t check = check_word(of, counts, values);
    std::string bytes;
    append(bytes, std::span<const std::uint64_t>(counts));
    append(bytes, std::span<const float>(values));
    append(bytes, std::span<const std::uint64_t>(&check, 1));
    try {
        base::write_file(path, bytes);
    } catch (const std::runtime_error&) {  // the cache is optional
    }
}

template <class Trace>
TracedTruth kept(const fs::path& folder, const Hash& hash, std::size_t pixels, const Trace& trace) {
    if (folder.empty()) return trace();
    const fs::path path = folder / (hash.text() + ".truth");
    if (auto truth = read(path, hash, pixels)) return *std::move(truth);
    TracedTruth truth = trace();
    write(path, hash, truth);
    return truth;
}

}  // namespace

TracedTruth TruthCache::geometry(const Scene& scene, int frame, const GBuffer& view,
                                 const TruthSettings& settings) const {
    validate(scene);
    Hash hash;
    hash.add(std::uint64_t{'G'});
    add_view(hash, view, settings);
    const Mesh mesh = view_space_mesh(scene, frame);
    hash.add_all(mesh.positions);
    hash.add_all(mesh.indices);
    return kept(folder_, hash, view.depth.size(),
                [&] { return trace_geometry(scene, frame, view, settings); });
}

TracedTruth TruthCache::depth(const GBuffer& view, const TruthSettings& settings) const {
    Hash hash;
    hash.add(std::uint64_t{'D'});
    add_view(hash, view, settings);
    hash.add(settings.thickness);
    return kept(folder_, hash, view.depth.size(), [&] { return trace_depth(view, settings); });
}

}  // namespace gloam::scene
