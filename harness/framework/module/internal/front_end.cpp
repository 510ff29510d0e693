// SPDX-License-Identifier: MIT
#include "module/internal/front_end.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "base/text.hpp"
#include "module/include.hpp"

namespace gloam::module::internal {
namespace {

// The text behind the mark of an error; nullopt for another line.
std::optional<std::string> error_of(const std::string& line) {
    for (const std::string_view mark : {"ERROR: ", "INTERNAL ERROR: ", "UNIMPLEMENTED: "})
        if (line.starts_with(mark)) return line.substr(mark.size());
    return std::nullopt;
}

// Whether the message only counts the errors.
bool is_summary(const std::string& message) {
    return message.find("No code generated.") != std::string::npos ||
           message.find("compilation terminated") != std::string::npos;
}

// Replaces "'#include' : reason for header name: x" by its reason.
std::string without_include_token(std::string message) {
    constexpr std::string_view token = "'#include' : ";
    const auto begin = message.find(token);
    const auto end = message.rfind(" for header name: ");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return message;
    return message.erase(end).erase(begin, token.size());
}

// Replaces the compiler's key of an overload, "f(vi2;f1;" or "g(", by "f()".
std::string without_keys(std::string message) {
    constexpr std::string_view key_letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-[];";
    for (auto at = message.find('('); at != std::string::npos; at = message.find('(', at + 1)) {
        const auto end = std::min(message.find_first_not_of(key_letters, at + 1), message.size());
        const bool closes = end < message.size() && message[end] == ')';
        if (!closes && (end == at + 1 || message[end - 1] == ';'))
            message.erase(at + 1, end - at - 1).insert(at + 1, 1, ')');
    }
    return message;
}

std::string tidied(const std::string& message) {
    std::string text = without_include_token(message);
    if (text.find("Linking ") != std::string::npos) text = without_keys(text);
    const auto two_blanks = [](char a, char b) { return a == ' ' && b == ' '; };
    text.erase(std::unique(text.begin(), text.end(), two_blanks), text.end());
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

// Has the ":line: " that follows a file.
bool has_place(std::string_view message) {
    for (auto at = message.find(':'); at != std::string_view::npos; at = message.find(':', at + 1)) {
        const auto end = message.find_first_not_of("0123456789", at + 1);
        if (end != std::string_view::npos && end > at + 1 && message.substr(end, 2) == ": ") return true;
    }
    return false;
}

constexpr const char* preamble = "#extension GL_GOOGLE_include_directive : enable\n";
constexpr int version_when_missing = 110;

// glslang's process-wide tables, from the first use to the end of the program.
class Process {
  public:
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
};

// Called before a shader is constructed, so that Process exists before any shader.
EShLanguage language_of(source::Stage stage) {
    static const Process process;
    if (stage == source::Stage::vertex) return EShLangVertex;
    return stage == source::Stage::fragment ? EShLangFragment : EShLangCompute;
}

// With this flag glslang does not add a spurious syntax error after the first real one.
EShMessages messages_of(Client client) {
    unsigned rules = EShMsgCascadingErrors;
    if (client != Client::none) rules |= unsigned{EShMsgSpvRules} | unsigned{EShMsgVulkanRules};
    return static_cast<EShMessages>(rules);
}

// The errors of glslang's log as "file:line: message" lines. `file`: for messages without a place.
std::string error_lines(const std::string& log, const std::string& file) {
    std::vector<std::string> errors;
    bool in_error = false;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        if (const auto error = error_of(line)) {
            in_error = !is_summary(*error);
            if (in_error) errors.push_back(*error);
        } else if (in_error && line.starts_with(' ')) {
            errors.back() += line;  // the rest of a message of several lines
        } else {
            in_error = false;
        }
    }
    if (errors.empty()) return file + ": the compiler gave no reason";
    std::string text;
    for (const std::string& error : errors) {
        if (!text.empty()) text += "\n";
        if (!has_place(error)) text.append(file).append(": ");
        text += tidied(error);
    }
    return base::for_terminal(text);  // it quotes the shader
}

constexpr std::size_t most_nested = 256;
constexpr std::size_t most_included = 65536;  // files that include the next one twice double their number

// Serves #include from files. An include's name is its path, which error messages then contain.
// glslang is built without exceptions, so nothing may be thrown through it: failures become messages.
class Includer final : public glslang::TShader::Includer {
    using Path = std::filesystem::path;

  public:
    Includer(IncludeFolders folders, Reading reading)
        : folders_(std::move(folders)), reading_(std::move(reading)) {}

    IncludeResult* includeLocal(const char* name, const char* includer, std::size_t) override {
        IncludeResult* result = open(name, Path(includer).parent_path());
        if (!result->headerName.empty()) return result;
        // glslang calls includeSystem next and prints its message.
        local_failure_ = std::string(result->headerData, result->headerLength);
        return result;
    }

    IncludeResult* includeSystem(const char* name, const char*, std::size_t) override {
        if (!local_failure_) return open(name, {});
        return fail(*std::exchange(local_failure_, std::nullopt));
    }

    void releaseInclude(IncludeResult* result) override {
        std::erase_if(open_, [result](const auto& open) { return open->result.get() == result; });
    }

  private:
    struct Open {
        Path path;
        std::string text;
        std::unique_ptr<IncludeResult> result;
    };

    IncludeResult* open(const char* name, const Path& from) {
        try {
            Path path = resolved(name, from, folders_);
            const auto again =
                std::ranges::find(open_, path, [](const auto& open) -> const Path& { return open->path; });
            if (again != open_.end()) {
                std::string chain;
                for (auto open = again; open != open_.end(); ++open) chain += (*open)->path.string() + " -> ";
                return fail("include cycle: " + chain + path.string());
            }
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
    IncludeResult* fail(std::string message) { return hold({}, std::move(message)); }

    IncludeResult* hold(Path path, std::string text) {
        Open& open =
            *open_.emplace_back(std::make_unique<Open>(Open{std::move(path), std::move(text), nullptr}));
        open.result =
            std::make_unique<IncludeResult>(open.path.string(), open.text.c_str(), open.text.size(), nullptr);
        return open.result.get();
    }

    IncludeFolders folders_;
    Reading reading_;
    std::vector<std::unique_ptr<Open>> open_;
    std::size_t included_ = 0;  // files so far
    std::optional<std::string> local_failure_;
};

// A shader of pieces that are read as one text, each with its own name and lines. They must outlive it.
class Shader {
  public:
    Shader(source::Stage stage, Client client, const std::vector<source::Source>& pieces)
        : language_(language_of(stage)), messages_(messages_of(client)), shader_(language_) {
        for (const source::Source& piece : pieces) {
            texts_.push_back(piece.text.c_str());
            lengths_.push_back(static_cast<int>(piece.text.size()));
            shown_.push_back(base::one_line(piece.name));  // a message ends with its line
        }
        for (const std::string& name : shown_) names_.push_back(name.c_str());
        shader_.setStringsWithLengthsAndNames(texts_.data(), lengths_.data(), names_.data(),
                                              static_cast<int>(texts_.size()));
        shader_.setPreamble(preamble);
        if (client == Client::none) return;
        shader_.setEnvInput(glslang::EShSourceGlsl, language_, glslang::EShClientVulkan, 100);
        shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
        shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    }

    // `name`: for messages without a place. Throws CompileError.
    void parse(const std::string& name, Includer includer) {
        if (!shader_.parse(GetDefaultResources(), version_when_missing, false, messages_, includer))
            throw source::CompileError(error_lines(shader_.getInfoLog(), name));
    }

    // Of what has been parsed: drops unreached functions if `unreached` says so.
    const glslang::TIntermediate& link(const std::string& name, Unreached unreached) {
        program_.addShader(&shader_);
        const EShMessages more = unreached == Unreached::kept ? EShMsgKeepUncalled : EShMsgDefault;
        if (!program_.link(static_cast<EShMessages>(messages_ | more)))
            throw source::CompileError(error_lines(program_.getInfoLog(), name));
        return *program_.getIntermediate(language_);
    }

    std::string preprocess(const std::string& name, Includer includer) {
        std::string result;
        if (!shader_.preprocess(GetDefaultResources(), version_when_missing, ENoProfile, false, false,
                                messages_, &result, includer))
            throw source::CompileError(error_lines(shader_.getInfoLog(), name));
        // The preprocessor also prints the preamble, before the line that must be the first.
        return result.substr(std::min(result.find("#version"), result.size()));
    }

  private:
    EShLanguage language_;
    EShMessages messages_;
    std::vector<const char*> texts_;
    std::vector<int> lengths_;
    std::vector<std::string> shown_;
    std::vector<const char*> names_;
    glslang::TShader shader_;
    glslang::TProgram program_;  // after the shader: must be destroyed first
};

}  // namespace

void check(source::Stage stage, Client client, const std::string& name,
           const std::vector<source::Source>& pieces, const std::vector<std::filesystem::path>& roots,
           Check what) {
    Shader shader(stage, client, pieces);
    shader.parse(name, {include_folders(roots, pieces), {}});
    if (what == Check::program) (void)shader.link(name, Unreached::dropped);
}

std::string preprocessed(const std::vector<source::Source>& pieces, source::Stage stage, Client client,
                         const IncludeFolders& folders, const Reading& reading) {
    return Shader(stage, client, pieces).preprocess(pieces.front().name, {folders, reading});
}

Spirv to_spirv(const source::Source& source, source::Stage stage,
               const std::vector<std::filesystem::path>& roots, Unreached unreached, bool lines) {
    const std::vector pieces{source};
    Shader shader(stage, Client::vulkan, pieces);
    shader.parse(source.name, {include_folders(roots, pieces), {}});
    Spirv module;
    spv::SpvBuildLogger logger;
    glslang::SpvOptions options;
    options.generateDebugInfo = lines;
    options.disableOptimizer = true;  // ours runs after it, with the passes that the caller chose
    glslang::GlslangToSpv(shader.link(source.name, unreached), module, &logger, &options);
    const std::string messages = logger.getAllMessages();
    for (const char* failure : {"error: ", "Missing functionality: "})
        if (messages.find(failure) != std::string::npos)
            throw source::CompileError(source.name + ": " + messages);
    return module;
}

}  // namespace gloam::module::internal
