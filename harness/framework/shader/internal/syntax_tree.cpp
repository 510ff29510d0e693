// SPDX-License-Identifier: MIT
#include "shader/internal/syntax_tree.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace gloam::shader::internal {
namespace {

// "0:7      direct index ( temp highp float)"
struct Node {
    int line = 0;
    std::size_t depth = 0;
    std::string_view what;
};

std::optional<Node> node_of(std::string_view row) {
    Node node;
    const std::size_t colon = row.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const char* const end = row.data() + row.size();
    const auto [behind, error] = std::from_chars(row.data() + colon + 1, end, node.line);
    if (error != std::errc{}) return std::nullopt;
    const std::string_view rest(behind, static_cast<std::size_t>(end - behind));
    node.depth = std::min(rest.find_first_not_of(' '), rest.size());
    node.what = rest.substr(node.depth);
    return node;
}

std::vector<Node> nodes_of(std::string_view tree) {
    std::vector<Node> nodes;
    while (!tree.empty()) {
        const std::size_t end = std::min(tree.find('\n'), tree.size());
        if (const auto node = node_of(tree.substr(0, end))) nodes.push_back(*node);
        tree.remove_prefix(std::min(end + 1, tree.size()));
    }
    return nodes;
}

// A type without qualifiers: "float", "3-component vector of float", "structure{...}".
std::string bare_type(std::string_view text) {
    for (const std::string_view kind : {"structure{", "block{"})
        if (const std::size_t at = text.find(kind); at != std::string_view::npos)
            return std::string(text.substr(at));
    std::size_t at = text.find("-element array");
    if (at == std::string_view::npos) at = text.find("-component vector");
    if (at == std::string_view::npos) at = text.find(" matrix of ");
    const std::size_t blank = text.rfind(' ', at == std::string_view::npos ? at : at - 1);
    return std::string(blank == std::string_view::npos ? text : text.substr(blank + 1));
}

class Reader {
  public:
    explicit Reader(std::string_view tree) : nodes_(nodes_of(tree)) {}

    TokenTypes run() {
        for (std::size_t i = 0; i < nodes_.size(); ++i) read(i);
        return std::move(types_);
    }

  private:
    // The nodes directly below one.
    [[nodiscard]] std::vector<std::size_t> children(std::size_t i) const {
        std::vector<std::size_t> found;
        const std::size_t depth = nodes_[i].depth + 2;
        for (std::size_t k = i + 1; k < nodes_.size() && nodes_[k].depth >= depth; ++k)
            if (nodes_[k].depth == depth) found.push_back(k);
        return found;
    }

    [[nodiscard]] std::string type_of(std::size_t i) const {
        const std::string_view what = nodes_[i].what;
        if (what.starts_with("Constant:")) return constant_type(children(i));
        const std::size_t open = what.find(" (");
        if (open == std::string_view::npos || !what.ends_with(')')) return {};
        return bare_type(what.substr(open + 2, what.size() - open - 3));
    }

    // "2.000000" is a float, "1 (const int)" says what it is.
    [[nodiscard]] std::string constant_type(const std::vector<std::size_t>& values) const {
        if (values.empty()) return {};
        const std::string_view first = nodes_[values.front()].what;
        const std::size_t named = first.find("(const ");
        const std::string scalar = named == std::string_view::npos
                                       ? "float"
                                       : std::string(first.substr(named + 7, first.size() - named - 8));
        return values.size() == 1 ? scalar : std::to_string(values.size()) + "-component vector of " + scalar;
    }

    void read(std::size_t i) {
        const Node& node = nodes_[i];
        const std::string_view what = node.what;
        if (what.starts_with("Function ") && !what.starts_with("Function Call")) return;
        const std::vector<std::size_t> below = children(i);
        if (what.starts_with("direct index (") || what.starts_with("vector swizzle (")) {
            const std::string vector = below.empty() ? "" : type_of(below.front());
            if (vector.find("-component vector") == 1)
                types_.components[node.line] = static_cast<std::size_t>(vector.front() - '0');
        } else if (what.find(": direct index for structure (") != std::string_view::npos && !below.empty()) {
            types_.members[node.line] = others_like(what.substr(0, what.find(':')), type_of(below.front()));
        } else if (below.size() > 1 && what.ends_with(')')) {
            std::vector<std::string>& types = types_.arguments[node.line];
            types.clear();
            for (const std::size_t child : below) types.push_back(type_of(child));
        }
    }

    // Of "structure{ global float a,  global float b}".
    static std::vector<std::string> others_like(std::string_view name, std::string_view structure) {
        std::vector<std::pair<std::string, std::string>> members;
        const std::size_t open = structure.find('{');
        if (open == std::string_view::npos) return {};
        int depth = 0;
        for (std::size_t first = open + 1, k = first; k < structure.size(); ++k) {
            const char c = structure[k];
            const bool ends = depth == 0 && (c == ',' || c == '}');
            if (c == '{' || c == '(') ++depth;
            if (c == '}' || c == ')') --depth;
            if (!ends) continue;
            const std::string_view member = structure.substr(first, k - first);
            const std::size_t blank = member.rfind(' ');
            if (blank == std::string_view::npos) return {};
            members.emplace_back(member.substr(blank + 1), bare_type(member.substr(0, blank)));
            first = k + 1;
            if (depth < 0) break;
        }
        const auto own = std::ranges::find(members, name, &std::pair<std::string, std::string>::first);
        std::vector<std::string> others;
        for (const auto& [other, type] : members)
            if (own != members.end() && other != name && type == own->second) others.push_back(other);
        return others;
    }

    std::vector<Node> nodes_;
    TokenTypes types_;
};

}  // namespace

TokenTypes token_types(std::string_view tree) {
    return Reader(tree).run();
}

}  // namespace gloam::shader::internal
