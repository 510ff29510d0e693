// SPDX-License-Identifier: MIT
#include "cli/check/checker.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/variant.hpp"

namespace gloam::cli {
namespace {

constexpr std::string_view first_variant = "shipped";

std::unique_ptr<check::Lab> make_lab(const CheckerOptions& options, const shader::Variant& variant) {
    return std::make_unique<check::Lab>(check::LabOptions{.device = options.device,
                                                          .validation = options.validation,
                                                          .include_roots = {glsl_directory()},
                                                          .cache_directory = cache_directory(),
                                                          .variant = variant,
                                                          .timeout = options.timeout});
}

check::RunOptions options_of(const CheckTask& task) {
    return {.inputs = task.inputs, .seed = task.seed};
}

}  // namespace

Checker::Checker(CheckerOptions options) : options_(std::move(options)), entries_(catalogue::all_entries()) {
    lab(std::string(first_variant));
}

const check::Lab& Checker::lab(const std::string& variant) {
    if (!lab_ || variant != variant_) {
        lab_.reset();  // before the next is made: two at once may be more than a device has memory for
        lab_ = make_lab(options_, select_variants(variant).front());
        variant_ = variant;
    }
    return *lab_;
}

const catalogue::Entry& Checker::entry(const std::string& id) const {
    const auto found = std::ranges::find(entries_, id, [](const auto& e) { return e.description.id; });
    if (found == entries_.end()) throw std::invalid_argument("no equation has the ID " + id);
    return *found;
}

report::DeviceSummary Checker::device() const {
    return summary_of(lab_->device().info());
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
    const catalogue::Entry& asked = entry(task.equation);
    check::Answer row;
    try {
        row = check::run(lab(task.variant), asked.question, options_of(task));
    } catch (const std::exception& error) {
        row = row_without_result(asked, task.variant, reason_of(error), error.what());
    }
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
}

HandOver Checker::hand_over(const HandOverRequest& request) {
    try {
        const CheckTask& task = request.task;
        return make_hand_over(lab(task.variant), entry(task.equation), request, options_of(task));
    } catch (const std::exception& error) {
        return {.error = error.what()};
    }
}

check::Reason reason_of(const std::exception& error) {
    using check::Reason;
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return Reason::out_of_memory;
    // The rooms' own messages, and Vulkan's names of results.
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

check::Answer row_without_result(const catalogue::Entry& entry, const std::string& variant,
                                 check::Reason reason, const std::string& error) {
    return {.equation = entry.description.id,
            .function = entry.description.function,
            .file = entry.description.file,
            .variant = variant,
            .error = error,
            .reason = reason};
}

}  // namespace gloam::cli
