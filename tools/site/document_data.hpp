// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace gloam::site {

// A page of the documents as JSON for page/document.js: an array of blocks in order. Each has a "kind":
// "heading" with "level" and "text", "paragraph" with "text", "list" with "items", "code" with "text",
// "table" with "head" and "rows". Texts keep `code` spans; links are reduced to their words. Pictures are
// left out. markdown: what the pages of docs use: ATX headings, lists with "-" or numbers, fenced or indented
// code, tables.
[[nodiscard]] std::string document_json(std::string_view markdown);

}  // namespace gloam::site
