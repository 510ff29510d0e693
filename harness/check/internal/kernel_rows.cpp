// SPDX-License-Identifier: MIT
#include "check/internal/kernel_rows.hpp"

#include <fmt/format.h>

#include <random>
#include <utility>

#include "check/interpreted_kernel.hpp"

namespace gloam::check::internal {

void add_outputs(const KernelRows& rows, const KernelModule& module, const std::string& name,
                 KernelCore::Result& result) {
    for (std::size_t i = 0; i < rows.count; ++i) {
        const auto values = rows.words.subspan(i * rows.row, module.output_words);
        const Word canary = rows.words[i * rows.row + module.output_words];
        const Word expected = rows.canary ^ static_cast<Word>(i);
        if (canary != expected) {
            throw KernelError(
                fmt::format("{}: the kernel did not finish for input {} of {}: expected the canary 0x{:08x}, "
                            "found 0x{:08x}",
                            name, rows.first + i, rows.first + rows.count, expected, canary));
        }
        result.outputs.insert(result.outputs.end(), values.begin(), values.end());
    }
}

void add_faults(const KernelFaults& faults, std::size_t input, const KernelModule& module,
                const ImageSet& images, KernelCore::Result& result) {
    if (faults.count == 0) return;
    if (result.fault) {
        result.fault->count += faults.count;
        return;
    }
    const ImagePrototype& image = module.images.at(faults.image);
    result.fault = ImageFault{.image = image.name,
                              .pixel = {static_cast<int>(faults.x), static_cast<int>(faults.y)},
                              .size = images.at(image.name).size,
                              .count = faults.count,
                              .input = input};
}

void add_stored(const ImagePrototype& image, std::span<const Word> words, const ImageSet& images,
                KernelCore::Result& result) {
    if (!image.stores) return;
    const auto texels = words.subspan(image_header_words);
    Image stored = images.at(image.name);
    stored.words.assign(texels.begin(), texels.end());
    result.stored.emplace(image.name, std::move(stored));
}

Word new_canary() {
    std::random_device entropy;
    return entropy();
}

}  // namespace gloam::check::internal
