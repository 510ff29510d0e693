// SPDX-License-Identifier: MIT
#include <algorithm>
#include <regex>

#include "shader/internal/declarations.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/lines.hpp"
#include "shader/pack.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader {
namespace {

std::string trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return std::string(line.substr(first, line.find_last_not_of(" \t\r\n") - first + 1));
}

// Reads the comments of a packed text: above declarations, and behind members and variables.
class Comments {
  public:
    explicit Comments(const std::string& text) {
        std::size_t at = 0;
        while (at < text.size()) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            line(text.substr(at, end - at));
            at = end + 1;
        }
        finish_member();
    }

    std::map<std::string, std::string> above;
    std::string head;

  private:
    void line(const std::string& text) {
        const std::string code = trimmed(text);
        const bool inside = !text.empty() && text.front() == ' ';
        if (code.starts_with("//")) {
            (inside ? of_member_ : open_) += code + "\n";
            return;
        }
        finish_member();
        if (!inside) declaration(code);
        if (code.empty() || inside) {
            if (inside) member(code);
            if (!any_code_ && !open_.empty()) head += open_ + "\n";
            open_.clear();
            return;
        }
        if (!code.starts_with("#version")) any_code_ = true;
        open_.clear();
    }

    // A line at file scope.
    void declaration(const std::string& code) {
        static const std::regex function(R"(^(?:precise )?[\w]+ (\w+)\()");
        static const std::regex structure(R"((?:^struct|uniform|buffer) (\w+) \{)");
        static const std::regex variable(R"((\w+)(?:\[[^\]]*\])?(?: = [^;]*)?;\s*(//.*)?$)");
        std::smatch found;
        if (code == "}" || code.starts_with("}")) {
            structure_.clear();
        } else if (std::regex_search(code, found, structure)) {
            structure_ = found[1];
            add(structure_, open_);
        } else if (std::regex_search(code, found, function)) {
            add(found[1], open_);
        } else if (std::regex_search(code, found, variable)) {
            member_ = found[1];
            of_member_ = found[2].matched ? found[2].str() + "\n" : "";
            add(member_, open_);
        }
    }

    // A line inside a structure.
    void member(const std::string& code) {
        static const std::regex pattern(R"((\w+)(?:\[[^\]]*\])?;\s*(//.*)?$)");
        std::smatch found;
        if (structure_.empty() || !std::regex_search(code, found, pattern)) return;
        member_ = structure_ + "." + found[1].str();
        of_member_ = found[2].matched ? found[2].str() + "\n" : "";
    }

    void finish_member() {
        if (!member_.empty()) add(member_, of_member_);
        member_.clear();
        of_member_.clear();
    }

    void add(const std::string& name, const std::string& comment) {
        if (!comment.empty()) above[name] += comment;
    }

    std::string open_;       // the comment that the next declaration may follow
    std::string structure_;  // whose members the lines are
    std::string member_;
    std::string of_member_;
    bool any_code_ = false;
};

// The functions alone.
std::string module_of_functions(const Source& packed, WgslOptions options) {
    const std::string text = internal::preprocessed(packed, Stage::compute, {});
    const std::vector<internal::Declaration> declared = internal::declarations(text);
    const Source whole{packed.name, internal::completed(text, declared)};
    options.entry_point = false;
    return to_wgsl(internal::to_spirv(whole, Stage::compute, {}, {.unreached = internal::Unreached::kept}),
                   options);
}

}  // namespace

std::string pack_wgsl(const std::vector<std::filesystem::path>& files, PackRequest request,
                      const std::vector<std::filesystem::path>& roots) {
    request.language = Language::vulkan450;
    const std::string name = files.empty() ? "nothing" : files.back().string();
    const Source packed{name + " as packed", pack(files, request, roots)};
    const CompileOptions compiled{.stage = request.stage.value_or(Stage::compute)};
    const Comments comments(packed.text);
    const WgslOptions options{
        .functions = functions(packed, compiled), .comments = comments.above, .head = comments.head};
    const bool has_main =
        std::ranges::any_of(options.functions, [](const Function& f) { return f.name == "main"; });
    try {
        return has_main ? to_wgsl(compile(packed, compiled), options) : module_of_functions(packed, options);
    } catch (const WgslError& error) {
        throw WgslError(name + ": WGSL cannot express " + error.what());
    }
}

}  // namespace gloam::shader
