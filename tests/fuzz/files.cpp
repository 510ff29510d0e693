// SPDX-License-Identifier: MIT
// What `gloam render` reads: the description of an engine's frame (fNNNN.json), its images (PFM), and what
// the process sends that reads a mesh or an EXR image.
#include "base/image_files.hpp"
#include "fuzz/fuzz.hpp"
#include "scene/internal/bytes.hpp"
#include "scene/read_gbuffer.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    const auto& file = fuzz::file_of(text, ".json");
    fuzz::read_or_refuse([&] {
        const scene::GBuffer frame = scene::read_frame_json(file).view;
        const scene::Border& border = frame.border;
        fuzz::require(frame.extent.width >= 1 && frame.extent.height >= 1);
        fuzz::require(border.left + border.right < frame.extent.width &&
                      border.top + border.bottom < frame.extent.height);
    });
    fuzz::read_or_refuse([&] {
        const base::FloatImage image = base::read_pfm(file);
        fuzz::require(image.texels.size() ==
                      std::size_t{image.width} * image.height * static_cast<std::size_t>(image.channels));
    });
    fuzz::read_or_refuse([&] {
        std::vector<float> numbers;
        std::vector<std::uint32_t> indices;
        scene::read_bytes(text, numbers, numbers, indices);
    });
    return 0;
}
