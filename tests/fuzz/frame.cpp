// SPDX-License-Identifier: MIT
// The description of an engine's frame, fNNNN.json.
#include "fuzz/fuzz.hpp"
#include "scene/read_gbuffer.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto& file = fuzz::file_of(fuzz::text_of(data, size), ".json");
    fuzz::read_or_refuse([&] {
        const scene::FrameDescription frame = scene::read_frame_json(file);
        fuzz::require(frame.extent.width >= 1 && frame.extent.height >= 1);
        fuzz::require(2 * frame.border.width < frame.extent.width &&
                      2 * frame.border.height < frame.extent.height);
    });
    return 0;
}
