// SPDX-License-Identifier: MIT
#include "cli/check/checker.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "cli/check/own_file.hpp"
#include "cli/environment.hpp"
#include "cli/variant.hpp"
#include "gl/errors.hpp"
#include "shader/include.hpp"

namespace gloam::cli {
namespace {

constexpr std::string_view first_variant = "shipped";

std::unique_ptr<check::Lab> make_lab(const CheckerOptions& options, const shader::Variant& variant,
                                     const std::vector<std::filesystem::path>& roots,
                                     const std::filesystem::path& file) {
    std::vector<shader::Excerpt> excerpts;
    if (!file.empty()) excerpts = shader::excerpts({file.string(), shader::read_text(file)}, roots).functions;
    return std::make_unique<check::Lab>(check::LabOptions{.device = options.device,
                                                          .validation = options.validation,
                                                          .include_roots = roots,
                                                          .cache_directory = cache_directory(),
                                                          .variant = variant,
                                                          .excerpts = std::move(excerpts),
                                                          .timeout = options.timeout});
}

check::RunOptions options_of(const CheckTask& task) {
    return {.inputs = task.inputs, .seed = task.seed, .coverage = task.coverage};
}

}  // namespace

Checker::Checker(CheckerOptions options)
    : options_(std::move(options)), entries_(catalogue::all_entries(glsl_directory())) {
    lab(std::string(first_variant), {glsl_directory()}, {});
}

const check::Lab& Checker::lab(const std::string& variant, const std::vector<std::filesystem::path>& roots,
                               const std::filesystem::path& file) {
    if (!lab_ || variant != variant_ || roots != roots_ || file != file_) {
        lab_.reset();  // destroyed before the next is made: a device may lack memory for two
        lab_ = make_lab(options_, select_variants(variant).front(), roots, file);
        variant_ = variant;
        roots_ = roots;
        file_ = file;
    }
    return *lab_;
}

const check::Lab& Checker::lab(const CheckTask& task) {
    if (task.file.empty()) return lab(task.variant, {glsl_directory()}, {});
    return lab(task.variant, include_roots_of(task.file, task.includes), task.file);
}

check::Question Checker::question_of(const CheckTask& task) {
    if (!task.file.empty()) return own_question(lab(task), task);
    const auto found =
        std::ranges::find(entries_, task.equation, [](const auto& e) { return e.description.id; });
    if (found == entries_.end()) throw std::invalid_argument("no equation has the ID " + task.equation);
    return found->question;
}

report::DeviceSummary Checker::device() const {
    return summary_of(lab_->info());
}

report::DeviceSummary summary_of(const gpu::DeviceInfo& info) {
    return {.name = base::one_line(info.name),
            .driver = base::one_line(info.driver),
            .type = info.type,
            .api_version = info.api_version,
            .preserves_signed_zero_inf_nan = info.float32.preserves_signed_zero_inf_nan,
            .preserves_denormals = info.float32.preserves_denormals,
            .flushes_denormals = info.float32.flushes_denormals,
            .rounds_to_even = info.float32.rounds_to_even};
}

check::Answer Checker::run(const CheckTask& task) {
    const auto begin = std::chrono::steady_clock::now();
    check::Answer answer;
    try {
        answer = check::run(lab(task), question_of(task), options_of(task));
    } catch (const std::exception& error) {
        answer = answer_without_result(task, entries_, reason_of(error), error.what());
    }
    answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return answer;
}

HandOver Checker::hand_over(const HandOverRequest& request) {
    try {
        const CheckTask& task = request.task;
        return make_hand_over(lab(task), question_of(task), request, options_of(task));
    } catch (const std::exception& error) {
        return {.error = error.what()};
    }
}

check::Reason reason_of(const std::exception& error) {
    using check::Reason;
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return Reason::out_of_memory;
    if (dynamic_cast<const gl::OutOfMemory*>(&error) != nullptr) return Reason::out_of_memory;
    if (dynamic_cast<const check::Unsupported*>(&error) != nullptr) return Reason::unsupported;
    // Message texts of the rooms, and Vulkan's names of results, with their reasons.
    constexpr std::array<std::pair<std::string_view, Reason>, 10> signs{{
        {"was lost while", Reason::device_lost},
        {"ErrorDeviceLost", Reason::device_lost},
        {"VK_ERROR_DEVICE_LOST", Reason::device_lost},
        {"did not finish a submission within", Reason::hang},
        {"still runs an earlier submission", Reason::hang},
        {"has not enough memory", Reason::out_of_memory},
        {"ErrorOutOfHostMemory", Reason::out_of_memory},
        {"ErrorOutOfDeviceMemory", Reason::out_of_memory},
        {"VK_ERROR_OUT_OF_HOST_MEMORY", Reason::out_of_memory},
        {"VK_ERROR_OUT_OF_DEVICE_MEMORY", Reason::out_of_memory},
    }};
    const std::string_view message = error.what();
    for (const auto& [sign, reason] : signs) {
        if (message.find(sign) != std::string_view::npos) return reason;
    }
    return Reason::error;
}

check::Answer answer_without_result(const CheckTask& task, const catalogue::Entries& entries,
                                    check::Reason reason, const std::string& error) {
    check::Answer answer{.equation = task.equation,
                         .function = task.equation.substr(0, task.equation.find('(')),
                         .file = std::filesystem::path(task.file).filename().string(),
                         .variant = task.variant,
                         .error = error,
                         .reason = reason};
    const auto entry =
        std::ranges::find(entries, task.equation, [](const auto& e) { return e.description.id; });
    if (!task.file.empty() || entry == entries.end()) return answer;
    answer.function = entry->description.function;
    answer.file = entry->description.file;
    return answer;
}

}  // namespace gloam::cli
