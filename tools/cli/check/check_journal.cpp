// SPDX-License-Identifier: MIT
#include "cli/check/check_journal.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "base/json_bounds.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string heading_of(const CheckJournalSetup& setup) {
    return ordered_json{{"check_journal", 1},
                        {"versions", setup.versions},
                        {"inputs", setup.inputs},
                        {"seed", setup.seed},
                        {"validation", setup.validation}}
        .dump();
}

struct Kept {
    std::string device;
    check::Answer row;
};

Kept kept_from(const std::string& line) {
    base::require_bounded_json(line);
    const json object = json::parse(line, nullptr, false);
    if (!object.is_object() || !object.contains("device") || !object["device"].is_string() ||
        !object.contains("row") || !object["row"].is_string())
        throw std::runtime_error("expected an object with the texts \"device\" and \"row\"");
    return {.device = object["device"].get<std::string>(),
            .row = report::answer_from_json(object["row"].get<std::string>())};
}

}  // namespace

CheckJournal::CheckJournal(std::filesystem::path path, const CheckJournalSetup& setup, bool resume)
    : file_(std::move(path), heading_of(setup), resume) {
    std::size_t number = 1;
    for (const std::string& line : file_.lines()) {
        ++number;
        try {
            Kept kept = kept_from(line);
            Key key{kept.device, kept.row.equation, kept.row.variant};
            if (kept.row.ran()) known_[std::move(key)] = std::move(kept.row);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("{}, line {}: {}", file_.path().string(), number, error.what()));
        }
    }
}

std::optional<check::Answer> CheckJournal::known(const report::DeviceSummary& device,
                                                 const CheckTask& task) const {
    const auto found = known_.find({report::name_of(device), task.equation, task.variant});
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

bool CheckJournal::add(const report::DeviceSummary& device, const check::Answer& row) const {
    const std::string name = report::name_of(device);
    if (known_.contains({name, row.equation, row.variant})) return true;
    file_.add(json{{"device", name}, {"row", report::to_json(row)}}.dump(-1, ' ', false,
                                                                         json::error_handler_t::replace));
    return false;
}

}  // namespace gloam::cli
