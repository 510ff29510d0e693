// SPDX-License-Identifier: MIT
#include "site/site.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "base/files.hpp"
#include "base/text.hpp"
#include "effect/methods.hpp"
#include "pictures/plot.hpp"
#include "report/output.hpp"
#include "report/page.hpp"
#include "site/page_data.hpp"

namespace gloam::site {
namespace {

namespace fs = std::filesystem;

// The text between two others; throws with the name of the page that lacks it.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    const std::string& page) {
    const std::size_t at = text.find(begin);
    const std::size_t to = at == std::string::npos ? at : text.find(end, at + begin.size());
    if (to == std::string::npos) throw std::runtime_error(page + ": expected " + begin + " ... " + end);
    return text.substr(at + begin.size(), to - at - begin.size());
}

// How other sites show a link to a page.
std::string preview_of(const std::string& title, const std::string& description, const std::string& page,
                       const SiteOptions& options) {
    const auto meta = [](const std::string& property, const std::string& content) {
        return "<meta property=\"" + property + "\" content=\"" + content + "\">\n";
    };
    std::string text =
        meta("og:type", "website") + meta("og:title", title) + meta("og:description", description);
    const std::string address = report::escaped_html(options.address);
    if (!address.empty()) text += meta("og:url", address + page);
    if (!options.pictures.room.empty()) text += meta("og:image", address + "room-with.png");
    return text;
}

// A page of the template with the text of its file, which has a title, a description, further elements of the
// head, then the main element. Other sites that link to it show title, description and preview. Throws
// std::runtime_error with the page's name for a text without these.
std::string page_text(const std::string& name, const std::string& text, const SiteOptions& options) {
    const std::string title = between(text, "<title>", "</title>", name);
    const std::string description = between(text, "<meta name=\"description\" content=\"", "\">", name);
    const std::size_t head = text.find("<title>");
    std::string page = base::read_file(options.files / "template.html");
    const auto put = [&page, &name](const std::string& marker, const std::string& part) {
        const std::size_t at = page.find(marker);
        if (at == std::string::npos) throw std::runtime_error(name + ": no " + marker + " in the template");
        page.replace(at, marker.size(), part);
    };
    put("<!-- head -->\n",
        preview_of(title, description, name, options) + text.substr(head, text.find("<main>\n") - head));
    put("<!-- main -->\n", between(text, "<main>\n", "</main>", name));
    return page;
}

// The part of the library that a file belongs to: "temporal" of "gloam/temporal/blend.glsl".
std::string part_of(const std::string& file) {
    return fs::path(file).parent_path().filename().string();
}

bool has_accuracy(const catalogue::Entry& entry) {
    return entry.question.reference && !entry.question.only_rules;
}

struct Written {
    std::string json;
    bool supported = true;
};

// Prepares the checks, one after another.
std::vector<Written> prepare_all(const check::Lab& lab, const SiteOptions& options,
                                 const catalogue::Entries& entries, const std::function<void(double)>& told) {
    std::vector<Written> all;
    for (const catalogue::Entry& entry : entries) {
        const check::PreparedCheck prepared =
            check::prepare(lab, entry.question, {.inputs = options.inputs, .seed = options.seed});
        all.push_back(
            {check_json(entry.description, entry.question, prepared), prepared.unsupported.empty()});
        told(static_cast<double>(all.size()) / static_cast<double>(entries.size()));
    }
    return all;
}

void copy_files(const fs::path& from, std::string_view extensions, report::OutputFolder& folder) {
    for (const fs::directory_entry& file : fs::directory_iterator(from)) {
        const fs::path& path = file.path();
        if (file.is_regular_file() && extensions.find(path.extension().string()) != std::string_view::npos)
            folder.write(path.filename().string(), base::read_file(path));
    }
}

// The script of the worker in which the kernels run, as a text: a page of file:// cannot read a file.
std::string worker_text(const fs::path& files) {
    std::set<fs::path> parts;
    for (const fs::directory_entry& file : fs::directory_iterator(files / "page/worker"))
        parts.insert(file.path());
    std::string text = "const gloam = {};\n" + base::read_file(files / "effect/passes.js");
    for (const fs::path& part : parts) text += base::read_file(part);
    return nlohmann::ordered_json(text).dump();
}

// What stands in the pages in the place of a word in capitals. The picture of a room stands only where there
// is one.
std::string filled(std::string page, const SiteOptions& options, const std::filesystem::path& library) {
    const SitePictures& pictures = options.pictures;
    if (pictures.room.empty())
        if (const std::size_t at = page.find("<figure class=\"choose\">"); at != std::string::npos)
            page.erase(at, page.find("</figure>\n", at) + 10 - at);
    page = base::replaced(page, "CAPTION", report::escaped_html(pictures.room));
    page = base::replaced(page, "PLOT\n", presets_plot());
    if (page.find("METHODS\n") == std::string::npos) return page;
    const std::string failures = base::read_file(options.documents / "methods.md");
    return base::replaced(page, "METHODS\n",
                          methods_html(options.methods, library, failures, pictures.methods));
}

void write_pages(const SiteOptions& options, const fs::path& library, report::OutputFolder& folder) {
    copy_files(options.files / "page", ".js", folder);
    for (const fs::directory_entry& file : fs::directory_iterator(options.files / "page")) {
        if (file.path().extension() != ".html") continue;
        const std::string name = file.path().filename().string();
        folder.write(name, page_text(name, filled(base::read_file(file.path()), options, library), options));
    }
    write_guides(options.documents, folder);
    folder.write("style.css",
                 std::string(report::page_style()) + base::read_file(options.files / "page/style.css"));
    folder.write("page.js", std::string(report::page_script()));
    folder.write("worker-text.js", "gloam.workerText = " + worker_text(options.files) + ";\n");
}

// The class of the effect as a script of the pages, whose names are members of `gloam`.
std::string effect_script(const fs::path& folder) {
    return "Object.assign(gloam, (() => {\n\"use strict\";\n" + effect_classes(folder) +
           "return {AmbientOcclusion, Passes};\n})());\n";
}

// The shaders and the triangles of the scenes, as scripts. The page loads a scene when it is chosen.
void write_effect(const fs::path& library, const SiteOptions& options, report::OutputFolder& folder) {
    constexpr int frames = 240;
    const ShaderFolders folders{library, options.files / "shaders"};
    folder.write("effect-data.js", "gloam.effect = " + effect_json(folders) +
                                       ";\ngloam.shaders = " + picture_json(folders) + ";\n");
    folder.write("ambient-occlusion.js", effect_script(options.files / "effect"));
    for (const std::string name : {"columns", "room", "knot"})
        folder.write("scene-" + name + ".js",
                     "gloam.addScene(" + scene_json(scene::make_scene(name), frames) + ");\n");
}

// One script for each part of the library, and one that lists them.
void write_checks(const catalogue::Entries& entries, const std::vector<Written>& written,
                  const SiteOptions& options, report::OutputFolder& folder) {
    std::map<std::string, std::string> parts;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        std::string& text = parts[part_of(entries[i].question.file)];
        text += (text.empty() ? "" : ",\n") + written[i].json;
    }
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const auto& [part, text] : parts) {
        const std::string name = "checks-" + part + ".js";
        folder.write(name, "gloam.addChecks(\"" + part + "\", [\n" + text + "\n]);\n");
        names.push_back(name);
    }
    const nlohmann::ordered_json index{{"versions", options.versions},
                                       {"inputs", options.inputs},
                                       {"seed", options.seed},
                                       {"checks", entries.size()},
                                       {"files", names}};
    folder.write("site.js", "gloam.site = " + index.dump(2) + ";\n");
}

}  // namespace

std::string presets_plot() {
    std::vector<pictures::PlotPoint> points;
    for (const effect::Preset& preset : effect::presets())
        points.push_back({preset.name, preset.time, preset.error, !preset.published});
    return "<figure>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Time and error\">\n" +
           pictures::to_plot_svg(points, "time of a frame, in that of fast (llvmpipe)", "error") +
           "</div>\n<figcaption>gloam's own presets in blue, published ones in grey; error: root mean square "
           "against ray-traced occlusion, of sequences on unseen views (gloam bench presets).</figcaption>\n"
           "</figure>\n";
}

void write_guides(const fs::path& documents, report::OutputFolder& folder) {
    for (const Guide& guide : guides)
        folder.write(guide.name + std::string(".txt"),
                     base::read_file(documents / (guide.name + std::string(".md"))));
}

SiteSummary write_site(const check::Lab& lab, const SiteOptions& options, report::OutputFolder& folder,
                       const std::function<void(double)>& told) {
    const std::filesystem::path& glsl = lab.options().include_roots.front();
    catalogue::Entries entries = options.entries;
    SiteSummary summary;
    summary.left_out = std::erase_if(entries, [](const auto& entry) { return !has_accuracy(entry); });
    summary.checks = entries.size();
    const std::vector<Written> written = prepare_all(lab, options, entries, told);
    summary.unsupported = static_cast<std::size_t>(std::ranges::count(written, false, &Written::supported));
    write_pages(options, glsl, folder);
    write_effect(glsl, options, folder);
    write_checks(entries, written, options, folder);
    return summary;
}

}  // namespace gloam::site
