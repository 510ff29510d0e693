// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "check/lab.hpp"
#include "check/signature.hpp"
#include "gpu/commands.hpp"
#include "gpu/resources.hpp"

namespace gloam::cli {

// A dispatch that only copies words from buffer to buffer: the minimal cost of evaluating a function. Each
// invocation copies the `words_in` words of its input to `words_out` words of output, repeating them if there
// are fewer.
class BareCopy {
  public:
    // Throws like gpu::Buffer and gpu::ComputePipeline.
    BareCopy(const check::Lab& lab, std::size_t count, std::size_t words_in, std::size_t words_out);

    // Uploads the inputs, copies, downloads the outputs. Throws like gpu::Commands::submit().
    void run(std::span<const check::Word> inputs);

  private:
    const gpu::Device* device_;
    std::size_t count_;
    gpu::ComputePipeline pipeline_;
    gpu::Buffer inputs_;
    gpu::Buffer outputs_;
    std::vector<check::Word> received_;
};

}  // namespace gloam::cli
