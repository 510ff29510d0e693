// SPDX-License-Identifier: MIT
#include "cost/cost.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "backend/vulkan/radv.hpp"
#include "base/process.hpp"
#include "module/reflection.hpp"

namespace gloam::cost {

namespace {

std::string_view first_word(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    return line.substr(0, line.find_first_of(" \t"));
}

bool begins(std::string_view word, std::initializer_list<std::string_view> with) {
    return std::ranges::any_of(with, [&](std::string_view one) { return word.starts_with(one); });
}

// An instruction's name has the unit that executes it in front.
bool is_instruction(std::string_view word) {
    const auto is_of_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    return word.size() > 2 && std::ranges::all_of(word, is_of_name) && word != "s_code_end" &&
           begins(word, {"s_", "v_", "ds_", "image_", "buffer_", "global_", "flat_", "scratch_", "exp_"});
}

void count(std::string_view instruction, Cost& cost) {
    ++cost.instructions;
    if (begins(instruction, {"v_"})) ++cost.valu;
    if (begins(instruction, {"image_store", "image_atomic", "buffer_store", "buffer_atomic", "global_store",
                             "global_atomic"}))
        ++cost.stores;
    else if (begins(instruction, {"image_", "buffer_load", "global_load"}))
        ++cost.loads;
}

// A label of the form BB12, which a line begins with or a branch ends with; empty: there is none.
std::string label_in(std::string_view text) {
    const std::size_t at = text.find("BB");
    if (at == std::string_view::npos) return {};
    const std::size_t end = std::min(text.find_first_not_of("0123456789", at + 2), text.size());
    return end > at + 2 ? std::string(text.substr(at, end - at)) : std::string();
}

// The names of a chip in RADV, the newest last.
std::vector<std::string> chips_of(const std::string& family) {
    if (family == "NAVI31") return {"GFX1100", family};
    return {family};
}

backend::vulkan::DescriptorKind kind_of(module::BindingType type) {
    using enum backend::vulkan::DescriptorKind;
    static constexpr std::array kinds{storage_image, sampled_image,  texture,
                                      sampler,       storage_buffer, uniform_buffer};  // as BindingType
    return kinds.at(static_cast<std::size_t>(type));
}

backend::vulkan::RadvProgram program_of(const module::Spirv& module, const CostOptions& options) {
    const module::ModuleInterface interface = module::reflect(module);
    backend::vulkan::RadvProgram program{.spirv = module, .descriptors = {}, .constants = options.constants};
    for (const module::Binding& one : interface.bindings)
        program.descriptors.push_back(
            {.set = one.set, .number = one.number, .count = one.count, .kind = kind_of(one.type)});
    if (interface.push_constants)
        program.push_constant_bytes = static_cast<std::uint32_t>(interface.push_constants->size);
    return program;
}

Cost cost_from(const backend::vulkan::RadvReport& report) {
    if (!report.messages.empty())
        throw std::runtime_error(fmt::format("Vulkan validation: {}", fmt::join(report.messages, " | ")));
    Cost cost = counted(report.assembly);
    for (const auto& [name, value] :
         {std::pair("instructions", &Cost::instructions), std::pair("vgprs", &Cost::registers),
          std::pair("subgroups per simd", &Cost::waves), std::pair("spilled vgprs", &Cost::spilled)}) {
        const auto found = report.statistics.find(name);
        if (found == report.statistics.end())
            throw std::runtime_error(fmt::format("RADV does not say its number of {}", name));
        cost.*value = found->second;
    }
    return cost;
}

// The work of a process of its own. Nothing that the driver prints is for the user.
std::string compiled(std::span<const module::Spirv> modules, const CostOptions& options,
                     const std::string& chip) {
    if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
        dup2(nowhere, STDERR_FILENO);
    const auto validation =
        options.validation ? backend::vulkan::Validation::on : backend::vulkan::Validation::off;
    std::vector<backend::vulkan::RadvProgram> programs;
    for (const module::Spirv& module : modules) programs.push_back(program_of(module, options));
    nlohmann::json numbers;
    for (const backend::vulkan::RadvReport& report :
         backend::vulkan::compiled_by_radv(programs, chip, validation)) {
        const Cost cost = cost_from(report);
        for (const CostField& field : cost_fields) numbers.push_back(cost.*field.value);
    }
    return numbers.dump();
}

}  // namespace

Cost counted(std::string_view assembly) {
    Cost cost;
    std::map<std::string, std::size_t> labels;  // and the number of instructions before them
    std::map<std::size_t, std::size_t> loops;   // begin and end, by such numbers
    while (!assembly.empty()) {
        const std::string_view line = assembly.substr(0, assembly.find('\n'));
        assembly.remove_prefix(std::min(line.size() + 1, assembly.size()));
        const std::string_view word = first_word(line.substr(0, line.find(';')));
        if (word.starts_with("BB")) labels.emplace(label_in(word), cost.instructions);
        if (!is_instruction(word)) continue;
        count(word, cost);
        if (!begins(word, {"s_branch", "s_cbranch"})) continue;
        const auto back = labels.find(label_in(line.substr(0, line.find(';'))));
        if (back == labels.end()) continue;
        std::size_t& end = loops[back->second];
        end = std::max<std::size_t>(end, cost.instructions);
    }
    cost.loops = loops.size();
    std::size_t behind = 0;  // loops may stand in each other
    for (const auto& [begin, end] : loops) {
        cost.in_loops += end > behind ? end - std::max(begin, behind) : 0;
        behind = std::max(behind, end);
    }
    return cost;
}

Cost cost_of(const module::Spirv& module, const CostOptions& options) {
    return costs_of({&module, 1}, options).front();
}

std::vector<Cost> costs_of(std::span<const module::Spirv> modules, const CostOptions& options) {
    if (std::ranges::find(families, options.family) == families.end())
        throw std::invalid_argument(
            fmt::format("unknown family \"{}\": expected {}", options.family, fmt::join(families, ", ")));
    const std::vector<std::string> chips = chips_of(options.family);
    for (std::size_t i = 0;; ++i) {
        try {
            const auto numbers = nlohmann::json::parse(
                base::run_apart([&] { return compiled(modules, options, chips[i]); }, base::compiler_limits));
            std::vector<Cost> costs(modules.size());
            std::size_t n = 0;
            for (Cost& cost : costs)
                for (const CostField& field : cost_fields) numbers.at(n++).get_to(cost.*field.value);
            return costs;
        } catch (const base::LimitError& error) {  // RADV ends the process where it does not know the name
            if (i + 1 == chips.size())
                throw base::LimitError(std::string("the compiler of the GPU ") + error.what());
        }
    }
}

}  // namespace gloam::cost
