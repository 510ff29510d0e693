// SPDX-License-Identifier: MIT
#include "shader/internal/includer.hpp"

#include <algorithm>
#include <exception>

#include "shader/include.hpp"

namespace gloam::shader::internal {

constexpr std::size_t most_nested = 256;
constexpr std::size_t most_included = 65536;  // files that include the next one twice double their number

using Path = std::filesystem::path;
using Result = glslang::TShader::Includer::IncludeResult;

Result* Includer::includeLocal(const char* name, const char* includer, std::size_t) {
    Result* result = open(name, Path(includer).parent_path());
    if (!result->headerName.empty()) return result;
    // glslang calls includeSystem next and prints its message.
    local_failure_ = std::string(result->headerData, result->headerLength);
    return result;
}

Result* Includer::includeSystem(const char* name, const char*, std::size_t) {
    if (!local_failure_) return open(name, {});
    std::string message = std::move(*local_failure_);
    local_failure_.reset();
    return fail(std::move(message));
}

void Includer::releaseInclude(Result* result) {
    std::erase_if(open_, [result](const auto& open) { return open->result.get() == result; });
}

Result* Includer::open(const char* name, const Path& from) {
    try {
        Path path = resolved(name, from, folders_);
        const bool again =
            std::any_of(open_.begin(), open_.end(), [&](const auto& o) { return o->path == path; });
        if (again) return fail("include cycle: " + chain_to(path));
        if (open_.size() >= most_nested)
            return fail("includes are nested more than " + std::to_string(most_nested) + " deep at " +
                        path.string());
        if (++included_ > most_included)
            return fail("more than " + std::to_string(most_included) + " includes at " + path.string());
        std::string text = read_text(path);
        if (reading_) text = reading_(path, std::move(text));
        return hold(std::move(path), std::move(text));
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}

// An empty name marks the failure; the text is then the message.
Result* Includer::fail(std::string message) {
    return hold({}, std::move(message));
}

Result* Includer::hold(Path path, std::string text) {
    auto open = std::make_unique<Open>(Open{std::move(path), std::move(text), nullptr});
    open->result =
        std::make_unique<Result>(open->path.string(), open->text.c_str(), open->text.size(), nullptr);
    open_.push_back(std::move(open));
    return open_.back()->result.get();
}

std::string Includer::chain_to(const Path& path) const {
    std::string chain;
    bool inside = false;
    for (const auto& open : open_) {
        inside = inside || open->path == path;
        if (inside) chain += open->path.string() + " -> ";
    }
    return chain + path.string();
}

}  // namespace gloam::shader::internal
