// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "effect/internal/passes.hpp"
#include "module/reflection.hpp"

// What the push constants and the specialization constants of passes are set to, by their names.
namespace gloam::effect {

// Numbers by name: one, or the elements of a vector or of a matrix, column by column.
class Values {
  public:
    void set(const std::string& name, std::vector<double> numbers);
    void set(const std::string& name, double number) { set(name, std::vector{number}); }
    template <glm::length_t Length, class Number>
    void set(const std::string& name, const glm::vec<Length, Number>& vector) {
        std::vector<double> numbers;
        for (glm::length_t i = 0; i < Length; ++i) numbers.push_back(static_cast<double>(vector[i]));
        set(name, std::move(numbers));
    }
    template <glm::length_t Columns, glm::length_t Rows>
    void set(const std::string& name, const glm::mat<Columns, Rows, float>& matrix) {
        std::vector<double> numbers;
        for (glm::length_t i = 0; i < Columns * Rows; ++i)
            numbers.push_back(double{matrix[i / Rows][i % Rows]});
        set(name, std::move(numbers));
    }

    // What a module has of them. Each throws std::logic_error for a name without a value, or with another
    // number of elements. file: of the pass, for the message.
    [[nodiscard]] std::vector<std::byte> push_constants(const module::ModuleInterface& interface,
                                                        const std::string& file) const;
    [[nodiscard]] std::vector<backend::vulkan::SpecializationConstant> constants(
        const module::ModuleInterface& interface, const std::string& file) const;

  private:
    [[nodiscard]] const std::vector<double>& at(const std::string& name, std::size_t count,
                                                const std::string& file) const;

    std::map<std::string, std::vector<double>> values_;
};

// All that the passes of a moment name, but for what their rows add: the settings, the view, and what follows
// from both.
[[nodiscard]] Values values_of(const Moment& moment);

// The same for a view by itself.
[[nodiscard]] Values values_of(const View& view, const Settings& settings);

}  // namespace gloam::effect
