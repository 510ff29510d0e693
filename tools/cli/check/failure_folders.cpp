// SPDX-License-Identifier: MIT
#include "cli/check/failure_folders.hpp"

#include <span>
#include <string_view>

namespace gloam::cli {
namespace {

std::string_view bytes_of(const std::vector<std::uint32_t>& words) {
    const auto bytes = std::as_bytes(std::span(words));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

FailureFolders::FailureFolders(std::filesystem::path folder) {
    if (!folder.empty()) folder_.emplace(std::move(folder));
}

std::filesystem::path FailureFolders::write(const report::DeviceSummary& device, const check::Answer& row,
                                            const HandOver& hand_over, const report::RunAgain& again) {
    const std::string name = report::slug(row.equation) + "-" + report::slug(row.variant);
    report::OutputFolder out(folder_->path() / report::slug(report::name_of(device)) / name);
    const std::string note =
        hand_over.error.empty() ? "" : "The shader and a reproduction could not be made: " + hand_over.error;
    out.write("report.txt", report::failure_text(device, row, hand_over.smallest, note, again));
    if (hand_over.error.empty() && !hand_over.shader_test.empty()) {
        out.write("shader.glsl", hand_over.glsl);
        out.write("repro.shader_test", hand_over.shader_test);
    } else if (hand_over.error.empty()) {
        out.write("shader.comp", hand_over.glsl);
        out.write("shader.spvasm", hand_over.assembly);
        out.write("shader.spv", bytes_of(hand_over.spirv));
        out.write("repro.amber", hand_over.amber);
    }
    out.keep();
    folder_->keep();
    return out.path();
}

}  // namespace gloam::cli
