// SPDX-License-Identifier: MIT
#pragma once

#include "base/image_files.hpp"
#include "tools/gloam.hpp"

namespace gloam::test {

// Tests of `gloam render`, whose output folders are in a scratch folder.
class Rendering : public InFolder {
  protected:
    [[nodiscard]] CommandResult render(const std::string& out, std::vector<std::string> arguments,
                                       std::vector<std::string> environment = {}) const {
        arguments.insert(arguments.begin(), "render");
        if (std::ranges::count(arguments, "--gbuffer") == 0)
            arguments.insert(arguments.end(), always_.begin(), always_.end());
        arguments.insert(arguments.end(), {"--out", path(out).string()});
        environment.insert(environment.end(), environment_.begin(), environment_.end());
        return run_command(arguments, {.environment = std::move(environment)});
    }

    // Those words into the folder of that name.
    template <class... Texts>
    [[nodiscard]] CommandResult render(const std::string& out, const char* line,
                                       const Texts&... arguments) const {
        return render(out, words(line, arguments...));
    }

    // One line with that text, status 2, and nothing in --out.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
        expect_could_not_run(render("out", arguments), named);
        EXPECT_FALSE(fs::exists(path("out"))) << named;
    }

    [[nodiscard]] json report(const std::string& out) const {
        return json::parse(read_file(path(out) / "render.json"));
    }

    [[nodiscard]] std::vector<float> picture(const std::string& out, const std::string& name) const {
        return base::read_pfm(path(out) / name).texels;
    }

    std::vector<std::string> always_{};       // further words of each that draws a scene
    std::vector<std::string> environment_{};  // of each command
};

}  // namespace gloam::test
