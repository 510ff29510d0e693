// SPDX-License-Identifier: MIT
#include "site/site.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/files.hpp"
#include "catalogue/catalogue.hpp"
#include "site/page_data.hpp"

namespace gloam::site {
namespace {

namespace fs = std::filesystem;

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

// Prepares the checks, one after another: the compiler runs in a forked copy of this process, and a copy of a
// process with several threads may inherit locks that nobody opens.
std::vector<Written> prepare_all(const check::Lab& lab, const SiteOptions& options,
                                 const catalogue::Entries& entries,
                                 const std::function<void(std::size_t, std::size_t)>& told) {
    std::vector<Written> all;
    for (const catalogue::Entry& entry : entries) {
        const check::PreparedCheck prepared =
            check::prepare(lab, entry.question, {.inputs = options.inputs, .seed = options.seed});
        all.push_back(
            {check_json(entry.description, entry.question, prepared), prepared.unsupported.empty()});
        told(all.size(), entries.size());
    }
    return all;
}

class Files {
  public:
    explicit Files(report::OutputFolder& folder) : folder_(folder) {}
    void write(const std::string& name, const std::string& text) {
        folder_.write(name, text);
        bytes_ += text.size();
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    report::OutputFolder& folder_;
    std::size_t bytes_ = 0;
};

void copy_files(const fs::path& from, std::string_view extensions, Files& files) {
    for (const fs::directory_entry& file : fs::directory_iterator(from)) {
        const fs::path& path = file.path();
        if (file.is_regular_file() && extensions.find(path.extension().string()) != std::string_view::npos)
            files.write(path.filename().string(), base::read_file(path));
    }
}

// A page of the template. Its file has what is its own in the head, then its main element.
std::string page_of(const std::string& form, const fs::path& file) {
    const std::string text = base::read_file(file);
    const std::string begin = "<main>\n";
    const std::size_t main = text.find(begin);
    const std::size_t end = text.rfind("</main>");
    const std::size_t title = text.find("<title>");
    if (main == std::string::npos || end == std::string::npos || title > main)
        throw std::runtime_error(file.string() + ": expected a title and a main element");
    std::string page = form;
    const auto put = [&page, &file](const std::string& marker, const std::string& part) {
        const std::size_t at = page.find(marker);
        if (at == std::string::npos)
            throw std::runtime_error(file.string() + ": no " + marker + " in the template");
        page.replace(at, marker.size(), part);
    };
    put("<!-- head -->\n", text.substr(title, main - title));
    put("<!-- main -->\n", text.substr(main + begin.size(), end - main - begin.size()));
    return page;
}

// The script of the worker in which the kernels run, as a text: a page of file:// cannot read a file.
std::string worker_text(const fs::path& folder) {
    std::set<fs::path> parts;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) parts.insert(file.path());
    std::string text = "const gloam = {};\n";
    for (const fs::path& part : parts) text += base::read_file(part);
    return nlohmann::ordered_json(text).dump();
}

// The pages, the libraries that they use, and the licences of these as a script.
void write_pages(const SiteOptions& options, Files& files) {
    const fs::path third_party = options.files / "third-party";
    copy_files(options.files / "page", ".js.css", files);
    const std::string form = base::read_file(options.files / "template.html");
    for (const fs::directory_entry& file : fs::directory_iterator(options.files / "page"))
        if (file.path().extension() == ".html")
            files.write(file.path().filename().string(), page_of(form, file.path()));
    files.write("worker-text.js",
                "gloam.workerText = " + worker_text(options.files / "page" / "worker") + ";\n");
    copy_files(third_party, ".js.css", files);
    nlohmann::ordered_json licences = nlohmann::ordered_json::array();
    for (const char* name : {"uplot", "img-comparison-slider"})
        licences.push_back(base::read_file(third_party / (std::string(name) + "-licence.txt")));
    files.write("licences-data.js", "gloam.licences = " + licences.dump() + ";\n");
    files.write("gallery-data.js", "gloam.gallery = " + options.gallery + ";\n");
}

// The pages of drivers and measurements, one script each. The measurements end with the pages of the user.
void write_documents(const SiteOptions& options, Files& files) {
    std::map<std::string, std::vector<fs::path>> sources;
    for (const std::string name : {"drivers", "measurements"})
        sources[name].push_back(options.documents / (name + ".md"));
    for (const fs::path& page : options.measured) sources["measurements"].push_back(page);
    for (const auto& [name, pages] : sources) {
        std::string blocks;
        for (const fs::path& page : pages)
            blocks += (blocks.empty() ? "" : ",\n") + document_json(base::read_file(page));
        files.write("document-" + name + ".js", "gloam.documents = [\n" + blocks + "\n];\n");
    }
}

// The class of the effect as a script of the pages, whose names are members of `gloam`.
std::string effect_script(const fs::path& folder) {
    return "Object.assign(gloam, (() => {\n\"use strict\";\n" + effect_classes(folder) +
           "return {AmbientOcclusion, Passes};\n})());\n";
}

// The triangles of the scenes and the shaders, as scripts. The page loads those of a scene or a method when
// it is chosen.
void write_effect(const check::Lab& lab, const SiteOptions& options, Files& files) {
    constexpr int frames = 240;
    const ShaderFolders folders{lab.options().include_roots.front(), options.files / "shaders"};
    files.write("effect-data.js", "gloam.effectData = " + effect_json(folders) + ";\n");
    files.write("ambient-occlusion.js", effect_script(options.files / "effect"));
    for (const auto& [name, json] : effect_parts(folders).methods)
        files.write("method-" + name + ".js", "gloam.addMethod(" + json + ");
");
    for (const std::string name : {"columns", "room", "knot"})
        files.write("scene-" + name + ".js",
                    "gloam.addScene(" + scene_json(scene::make_scene(name), frames) + ");\n");
}

// One script for each part of the library, and one that lists them.
void write_checks(const catalogue::Entries& entries, const std::vector<Written>& written,
                  const SiteOptions& options, Files& files) {
    std::map<std::string, std::string> parts;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        std::string& text = parts[part_of(entries[i].question.file)];
        text += (text.empty() ? "" : ",\n") + written[i].json;
    }
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const auto& [part, text] : parts) {
        const std::string name = "checks-" + part + ".js";
        files.write(name, "gloam.addChecks(\"" + part + "\", [\n" + text + "\n]);\n");
        names.push_back(name);
    }
    const nlohmann::ordered_json index{{"versions", options.versions},
                                       {"inputs", options.inputs},
                                       {"seed", options.seed},
                                       {"checks", entries.size()},
                                       {"files", names}};
    files.write("site.js", "gloam.site = " + index.dump(2) + ";\n");
}

}  // namespace

SiteSummary write_site(const check::Lab& lab, const SiteOptions& options, report::OutputFolder& folder,
                       const std::function<void(std::size_t, std::size_t)>& told) {
    const std::filesystem::path& glsl = lab.options().include_roots.front();
    catalogue::Entries entries = catalogue::select(catalogue::all_entries(glsl), options.equations);
    SiteSummary summary;
    summary.left_out = std::erase_if(entries, [](const auto& entry) { return !has_accuracy(entry); });
    summary.checks = entries.size();
    const std::vector<Written> written = prepare_all(lab, options, entries, told);
    summary.unsupported = static_cast<std::size_t>(std::ranges::count(written, false, &Written::supported));
    Files files(folder);
    write_pages(options, files);
    write_documents(options, files);
    write_effect(lab, options, files);
    write_checks(entries, written, options, files);
    summary.bytes = files.bytes();
    return summary;
}

}  // namespace gloam::site
