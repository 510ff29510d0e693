// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "effect/internal/passes.hpp"
#include "shader/reflection.hpp"

// What the push constants and the specialization constants of passes are set to, by their names.
namespace gloam::effect {

// Push constants, and which of them are the view's.
struct PushConstants {
    std::vector<std::byte> bytes;
    std::vector<bool> of_view;  // for each byte
};

// Numbers by name: one, or the elements of a vector or of a matrix, column by column.
class Values {
  public:
    // of_view: it depends on the view or the frame; else on the settings alone.
    void set(const std::string& name, std::vector<double> numbers, bool of_view = false);
    void set(const std::string& name, double number, bool of_view = false) {
        set(name, std::vector{number}, of_view);
    }
    template <glm::length_t Length, class Number>
    void set(const std::string& name, const glm::vec<Length, Number>& vector, bool of_view = false) {
        std::vector<double> numbers;
        for (glm::length_t i = 0; i < Length; ++i) numbers.push_back(static_cast<double>(vector[i]));
        set(name, std::move(numbers), of_view);
    }
    template <glm::length_t Columns, glm::length_t Rows>
    void set(const std::string& name, const glm::mat<Columns, Rows, float>& matrix, bool of_view = false) {
        std::vector<double> numbers;
        for (glm::length_t i = 0; i < Columns * Rows; ++i)
            numbers.push_back(double{matrix[i / Rows][i % Rows]});
        set(name, std::move(numbers), of_view);
    }

    // What a module has of them. Each throws std::logic_error for a name without a value, or with another
    // number of elements. file: of the pass, for the message.
    [[nodiscard]] PushConstants push_constants(const shader::ModuleInterface& interface,
                                               const std::string& file) const;
    [[nodiscard]] std::vector<gpu::SpecializationConstant> constants(const shader::ModuleInterface& interface,
                                                                     const std::string& file) const;

  private:
    struct Value {
        std::vector<double> numbers;
        bool of_view = false;
    };
    [[nodiscard]] const Value& at(const std::string& name, std::size_t count, const std::string& file) const;

    std::map<std::string, Value> values_;
};

// All that the passes of a moment name: the settings, and what follows from them, the view and the step.
[[nodiscard]] Values values_of(const Moment& moment);

// The same for a view by itself.
[[nodiscard]] Values values_of(const View& view, const Settings& settings);

}  // namespace gloam::effect
