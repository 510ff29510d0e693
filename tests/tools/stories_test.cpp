// SPDX-License-Identifier: MIT
// The stories of stories/*.txt: what the program says where its users run it, in a folder of its own.
//
//   == TITLE                  a story begins
//   > FILE                    a file; the lines behind it are its text, four blanks before each
//   $ WORDS => A && B         gloam with these words: status 0, no standard error, and A and B in its output
//   $1 WORDS => A && B        another status, and anything on standard error
//   %, %1 LINE => A && B      the same for a line of the shell, which has gloam in its path
//   spoil FILE : A -> B       from now on gloam is an installation of its own: in that shader B stands for A
//   only LINE                 where the shell says no to the line, the story is skipped
//   ! WORDS : ROW || ROW      each row behind the words cannot run: status 2, no folder "out". One line on
//                             standard error, without control characters, holds the text that stands in
//                             brackets or behind =>.
//   again WORDS               gloam with these words has the output of the last run
//   < FILE                    what follows is about this file, which is not empty
//   = A && B, - A && B        it holds the texts, or none of them; ~ REGEX: it matches
//
// A line that begins with four blanks goes on with the one before. {a,b} stands for a, then for b. 'a b' is
// one word. @glsl, @examples and @fixtures are folders of the repository, @here is the story's own,
// @version gloam's version, @crashing the manifest of a driver that crashes, @crashing.so the driver,
// @full_disk a disk that is full. \n is a new line, \e the escape character. Words like NAME=VALUE before the
// others are of the environment. # begins a comment.
#include "base/text.hpp"
#include "base/version.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::stories_test {

struct Story {
    std::string file;
    std::string name;
    std::vector<std::string> lines;
};

std::vector<Story> stories() {
    std::set<fs::path> files;
    for (const auto& entry : fs::directory_iterator(GLOAM_STORIES)) files.insert(entry.path());
    std::vector<Story> all;
    for (const fs::path& file : files) {
        std::istringstream lines(read_file(file));
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line.starts_with('#')) continue;
            if (line.starts_with("== ")) {
                all.push_back({.file = file.stem().string(), .name = {}, .lines = {}});
                for (std::size_t i = 3; i < line.size(); ++i)
                    if (std::isalnum(line[i]) != 0)
                        all.back().name +=
                            static_cast<char>(line[i - 1] == ' ' ? std::toupper(line[i]) : line[i]);
            } else if (std::vector<std::string>& told = all.at(all.size() - 1).lines;
                       line.starts_with("    ")) {
                told.back() += (told.back().starts_with("> ") ? "\n" : " ") + line.substr(4);
            } else {
                told.push_back(line);
            }
        }
    }
    return all;
}

std::vector<std::string> parts_of(const std::string& text, const std::string& between) {
    std::vector<std::string> parts;
    for (const auto part : std::views::split(text, between)) parts.emplace_back(part.begin(), part.end());
    return parts;
}

// The text with each choice of {a,b}.
std::vector<std::string> choices_of(const std::string& text) {
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
        const std::size_t close = std::min(text.find('}', open), text.size());
        const std::string inside = text.substr(open + 1, close - open - 1);
        if (inside.find(',') == std::string::npos) continue;
        std::vector<std::string> all;
        for (const std::string& one : parts_of(inside, ","))
            for (const std::string& choice : choices_of(text.substr(0, open) + one + text.substr(close + 1)))
                all.push_back(choice);
        return all;
    }
    return {text};
}

std::vector<std::string> quoted_words(const std::string& text) {
    std::vector<std::string> all;
    bool quoted = false;
    bool in_word = false;
    for (const char c : text) {
        const bool is_part = c != ' ' || quoted;
        if (is_part && !in_word) all.emplace_back();
        in_word = is_part;
        if (c == '\'')
            quoted = !quoted;
        else if (is_part)
            all.back() += c;
    }
    return all;
}

class Stories : public InFolder {
  public:
    explicit Stories(std::vector<std::string> lines) : lines_(std::move(lines)) {}
    void TestBody() override {
        for (const std::string& line : lines_) {
            SCOPED_TRACE(line);
            if (!IsSkipped()) take(line);
        }
    }

  private:
    [[nodiscard]] std::string replaced(std::string text) const {
        const std::pair<std::string, std::string> names[] = {{"@glsl", GLOAM_GLSL_DIR},
                                                             {"@examples", GLOAM_EXAMPLES},
                                                             {"@fixtures", GLOAM_TOOLS_FIXTURES},
                                                             {"@version", base::version()},
                                                             {"@crashing.so", GLOAM_CRASHING_LIBRARY},
                                                             {"@crashing", GLOAM_CRASHING_DRIVER},
                                                             {"@full_disk", GLOAM_FULL_DISK},
                                                             {"@here", path("").string()},
                                                             {"\\n", "\n"},
                                                             {"\\e", "\x1b"}};
        for (const auto& [name, value] : names) text = base::replaced(std::move(text), name, value);
        return text;
    }

    CommandResult run(const std::string& line, bool shell = false) {
        CommandOptions options{.working_directory = path(""), .timeout = std::chrono::seconds(300)};
        fs::path program = installation_ ? installation_->program() : GLOAM_BUILT_BINARY;
        std::vector<std::string> words{"-ec", line};
        if (shell) {
            options.environment = {"PATH=" + program.parent_path().string() + ":" + std::getenv("PATH")};
            program = "sh";
        } else {
            words = quoted_words(line);
            const auto command = std::ranges::find_if_not(words, [](const std::string& word) {
                return std::isupper(word[0]) != 0 && word.find('=') != std::string::npos;
            });
            options.environment.assign(words.begin(), command);
            words.erase(words.begin(), command);
        }
        CommandResult result = run_program(program, words, options);
        output_ = result.out + result.err;
        return result;
    }

    void expect_refused(const std::string& before, const std::string& row) {
        SCOPED_TRACE(before + row);
        const std::size_t arrow = std::min(row.find("=> "), row.size());
        std::string line = before + " " + row.substr(0, arrow);
        const std::size_t open = line.find('[');
        const std::string named =
            arrow < row.size() ? row.substr(arrow + 3) : line.substr(open + 1, line.find(']') - open - 1);
        std::erase_if(line, [](char c) { return c == '[' || c == ']'; });
        const CommandResult result = run(line);
        expect_could_not_run(result, named);
        EXPECT_THAT(result.err, Not(HasSubstr("\x1b")));
        EXPECT_LT(result.err.size(), 1000U);
        EXPECT_FALSE(fs::exists(path("out")));
    }

    // mark: "$" or "%", and the status.
    void expect_runs(const std::string& mark, const std::string& line) {
        const std::size_t arrow = std::min(line.find(" => "), line.size());
        const CommandResult result = run(line.substr(0, arrow), mark.front() == '%');
        if (mark.size() == 1) expect_success(result);
        EXPECT_EQ(result.status, std::atoi(mark.c_str() + 1)) << output_;
        if (arrow < line.size()) expect_texts(line.substr(arrow + 4), true);
    }

    void expect_texts(const std::string& texts, bool there) const {
        for (const std::string& text : parts_of(texts, " && "))
            EXPECT_EQ(output_.find(text) != std::string::npos, there) << text << "\nin " << output_;
    }

    void take(const std::string& line) {
        const std::string mark = line.substr(0, line.find(' '));
        const std::string rest = replaced(line.substr(mark.size()));
        const std::string text = rest.substr(std::min<std::size_t>(1, rest.size()));
        if (mark == ">") {
            const std::size_t end = std::min(text.find('\n'), text.size());
            write(text.substr(0, end),
                  text.substr(std::min(end + 1, text.size())) + (end < text.size() ? "\n" : ""));
        } else if (mark == "!") {
            const std::size_t colon = rest.find(" : ");
            const std::string before = colon == std::string::npos ? "" : rest.substr(0, colon);
            for (const std::string& row :
                 parts_of(colon == std::string::npos ? rest : rest.substr(colon + 3), " || "))
                for (const std::string& choice : choices_of(row)) expect_refused(before, choice);
        } else if (mark == "again") {
            const std::string before = output_;
            for (const std::string& choice : choices_of(rest)) {
                (void)run(choice);
                EXPECT_EQ(output_, before);
            }
        } else if (mark.starts_with('$') || mark.starts_with('%')) {
            for (const std::string& choice : choices_of(rest)) expect_runs(mark, choice);
        } else if (mark == "spoil") {
            if (!installation_) installation_.emplace();
            const std::size_t colon = text.find(" : ");
            const std::size_t arrow = text.find(" -> ");
            installation_->replace(text.substr(0, colon), text.substr(colon + 3, arrow - colon - 3),
                                   text.substr(arrow + 4));
        } else if (mark == "only") {
            if (run(text, true).status != 0) GTEST_SKIP() << text << "\n" << output_;
        } else {
            look(mark, text);
        }
    }

    // What a line says of files and of the last output.
    void look(const std::string& mark, const std::string& text) {
        if (mark == "<") {
            output_.clear();
            for (const std::string& file : choices_of(text)) {
                output_ += read_file(path(file));
                EXPECT_GT(fs::file_size(path(file)), 0U) << file;
            }
        } else if (mark == "=" || mark == "-") {
            expect_texts(text, mark == "=");
        } else if (mark == "~") {
            EXPECT_THAT(output_, testing::ContainsRegex(text));
        } else {
            FAIL() << "no mark: " << mark;
        }
    }

    std::vector<std::string> lines_;
    std::string output_;  // of the last run, or the file's text
    std::optional<Installation> installation_;
};

// A suite for each file.
const bool registered = [] {
    for (const Story& story : stories())
        testing::RegisterTest(("Stories_" + story.file).c_str(), story.name.c_str(), nullptr, nullptr,
                              __FILE__, __LINE__,
                              [lines = story.lines]() -> InFolder* { return new Stories(lines); });
    return true;
}();

}  // namespace gloam::test::stories_test
