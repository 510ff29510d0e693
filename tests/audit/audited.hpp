// SPDX-License-Identifier: MIT
#pragma once

#include "audit/audit.hpp"
#include "support/lab.hpp"

namespace gloam::audit {

using namespace subject;

// The functions of a text, for the interpreter.
class Audited {
  public:
    explicit Audited(const std::string& text, const std::string& name = "audit.glsl") {
        const std::filesystem::path folder(FIXTURES);
        options_ = {.device = std::string(interpreter_name),
                    .file = std::make_shared<const OwnFile>(folder / name, text,
                                                            std::vector<std::filesystem::path>{folder})};
        lab_ = std::make_unique<const Lab>(options_);
    }

    [[nodiscard]] OwnFunction function(const std::string& function) const {
        return own_functions(options_, {function}).found.at(0);
    }

    [[nodiscard]] Audit audit(const std::string& name, const Ranges& ranges = {},
                              std::size_t inputs = 2048) const {
        return audit::audit(*lab_, function(name), ranges, {.inputs = inputs});
    }

    [[nodiscard]] std::vector<OrdinaryValues> values(const std::string& name,
                                                     const Ranges& ranges = {}) const {
        return ordinary_values(function(name), ranges);
    }

  private:
    LabOptions options_;
    std::unique_ptr<const Lab> lab_;
};

inline const AuditFinding* find(const Audit& audit, Concern concern) {
    const auto found = std::ranges::find(audit.findings, concern, &AuditFinding::concern);
    return found == audit.findings.end() ? nullptr : &*found;
}

inline const Audited& fixture() {
    static const Audited audited(module::read_text(std::filesystem::path(FIXTURES) / "audit.glsl"));
    return audited;
}

}  // namespace gloam::audit
