// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <deque>
#include <span>
#include <type_traits>
#include <vector>

#include "interpreter/machine.hpp"
#include "numeric/interval.hpp"
#include "subject/images.hpp"
#include "subject/kernel_code.hpp"

namespace gloam::subject {

// A kernel that the interpreter runs, one input at a time, on one number type (interpreter/number.hpp). Not
// thread-safe.
template <class Number>
class InterpretedKernel {
  public:
    // `module` and `images` (image_words()) must outlive this object.
    InterpretedKernel(const interpreter::Program& program, const KernelModule& module,
                      std::span<const std::vector<Word>> images)
        : machine_(program),
          team_(module.team),
          subgroup_size_(team_.kind == backend::Team::Kind::quad ? team_.count() : module.subgroup_size),
          row_(module.output_words + 1),
          run_{static_cast<Word>(std::max<std::size_t>(module.fixed_inputs, 1)),
               team_.kind == backend::Team::Kind::alone ? kernel_group_size : 1, 0},
          outputs_(row_ * run_.front()) {
        machine_.bind(0, KernelBinding::outputs, outputs_);
        machine_.bind(0, KernelBinding::faults, faults_);
        machine_.bind_push_constants(run_);
        for (std::size_t i = 0; i < images.size(); ++i) {
            const auto binding = KernelBinding::first_image + static_cast<unsigned>(i);
            if (!module.images[i].layered.empty()) {
                bind_layers(binding, module.images[i].layered);
            } else if (module.images[i].sampled) {
                machine_.bind(0, binding, interpreter::sampled_view_of(images[i], module.samplers));
            } else {
                machine_.bind(0, binding, images[i]);
            }
        }
    }

    InterpretedKernel(const InterpretedKernel&) = delete;  // the machine is bound to its buffers
    InterpretedKernel& operator=(const InterpretedKernel&) = delete;

    // `index`: of the input, if the module has its inputs as constants. Throws interpreter::Error.
    void run(std::span<const Word> inputs, std::size_t index = 0) {
        begin(inputs, index);
        machine_.run();
    }
    // The same, and adds to the coverage, or reports every instruction with a result.
    template <class Observer>
        requires(!std::integral<std::remove_cvref_t<Observer>>)
    void run(std::span<const Word> inputs, Observer&& observer) {
        begin(inputs, 0);
        machine_.run(observer);
    }

    [[nodiscard]] interpreter::Value<Number> output(std::size_t word) const {
        return machine_.read(0, KernelBinding::outputs, first_ + word);
    }

    [[nodiscard]] std::size_t output_words() const { return row_ - 1; }

    // Accesses outside an image in the last run.
    [[nodiscard]] KernelFaults faults() const {
        const auto word = [this](std::size_t k) { return machine_.read(0, KernelBinding::faults, k).bits(); };
        return {.count = word(0), .image = word(1), .x = word(2), .y = word(3), .input = word(4)};
    }

    [[nodiscard]] interpreter::Machine<Number>& machine() { return machine_; }

    // In which order the invocations of a team run.
    void set_order(interpreter::Order order) { order_ = order; }

  private:
    // Texels that the kernel has not filled yet; a channel that the format lacks is 0, the last one 1.
    void bind_layers(std::uint32_t binding, const std::string& format) {
        std::vector<Word>& texels = layers_.emplace_back();
        const Word one = format.ends_with('f') ? to_word(1.0F) : 1U;
        const std::size_t count = std::size_t{image_sides[0]} * image_sides[1] * run_.front();
        for (std::size_t i = 0; i < count; ++i) texels.insert(texels.end(), {0U, 0U, 0U, one});
        machine_.bind(
            0, binding,
            interpreter::ImageView{.size = {image_sides[0], image_sides[1], run_.front()}, .texels = texels});
    }

    void begin(std::span<const Word> inputs, std::size_t index) {
        first_ = index * row_;
        machine_.bind(0, KernelBinding::inputs, inputs);
        if (team_.kind == backend::Team::Kind::alone)
            machine_.set_invocation({.group = {static_cast<std::uint32_t>(index), 0, 0}});
        else
            machine_.set_group({.group_size = team_.size, .subgroup_size = subgroup_size_}, order_);
    }

    interpreter::Machine<Number> machine_;
    backend::Team team_;
    std::uint32_t subgroup_size_;
    interpreter::Order order_ = interpreter::Order::forward;
    std::size_t row_;
    std::array<Word, 3> run_;  // those of KernelRun
    std::vector<Word> outputs_;
    std::array<Word, sizeof(KernelFaults) / sizeof(Word)> faults_{};
    std::deque<std::vector<Word>> layers_;  // of each image that the function loads or stores
    std::size_t first_ = 0;
};

}  // namespace gloam::subject
