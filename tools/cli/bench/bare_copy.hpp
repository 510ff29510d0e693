// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "check/lab.hpp"
#include "check/scalars.hpp"
#include "gpu/buffer.hpp"
#include "gpu/compute.hpp"

namespace gloam::cli {

// A dispatch that does nothing but copy words from buffer to buffer: what evaluating a function costs at the
// least. `words_in` words of every input go to `words_out` words of its output, over and over where there are
// fewer.
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
