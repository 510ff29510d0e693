// SPDX-License-Identifier: MIT
// Images of an engine or of an environment: PFM.
#include "base/image_files.hpp"
#include "fuzz/fuzz.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto& file = fuzz::file_of(fuzz::text_of(data, size), ".pfm");
    fuzz::read_or_refuse([&] {
        const base::FloatImage image = base::read_pfm(file);
        fuzz::require(image.texels.size() ==
                      std::size_t{image.width} * image.height * static_cast<std::size_t>(image.channels));
    });
    return 0;
}
