// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "check/lab.hpp"

namespace gloam::check::internal {

// What a kernel wrote for some of a run's inputs, one row of words for each.
struct KernelRows {
    std::span<const Word> words;
    std::size_t row = 0;    // words from one row to the next
    std::size_t count = 0;  // rows
    std::size_t first = 0;  // position of the first row's input in the whole run
    Word canary = 0;        // behind the outputs of a row, xor the row's position
};

// Adds the outputs of the rows to a result. Throws KernelError for a row whose canary is not in order.
void add_outputs(const KernelRows& rows, const KernelModule& module, const std::string& name,
                 KernelCore::Result& result);

// Adds accesses outside an image. `input`: of the first, in the whole run.
void add_faults(const KernelFaults& faults, std::size_t input, const KernelModule& module,
                const ImageSet& images, KernelCore::Result& result);

// Adds an image that the kernel stored to. `words`: of its buffer, header included. Nothing for an image that
// it only reads.
void add_stored(const ImagePrototype& image, std::span<const Word> words, const ImageSet& images,
                KernelCore::Result& result);

// A new value for each dispatch: memory of an earlier one does not hold it.
[[nodiscard]] Word new_canary();

// The result of KernelCore::run(), computed by the interpreter in float32. Images that the shader stores to
// are those of sequential invocations. Throws KernelError for a module that the interpreter cannot run.
[[nodiscard]] KernelCore::Result interpret(const std::shared_ptr<const KernelModule>& module,
                                           std::span<const Word> inputs, std::size_t count,
                                           const ImageSet& images, const std::string& name);

}  // namespace gloam::check::internal
