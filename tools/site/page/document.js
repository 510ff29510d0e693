// SPDX-License-Identifier: MIT
// Shows the blocks of gloam.documents (tools/site/page_data.hpp): tables sort, tables of time and error become
// charts, too, where chart.js is loaded.
"use strict";

gloam.document = (() => {
    // A text with its `code` spans.
    function inline(text) {
        return text.split("`").map((part, i) => i % 2 === 1 ? gloam.element("code", {}, part) : part);
    }

    const number = /^-?\d[\d,]*(\.\d+)?(e[-+]?\d+)?$/;

    // The value that a cell is sorted by: a number where it begins with one.
    function valueOf(cell) {
        const word = cell.replace(/`/g, "").split(" ")[0];
        return number.test(word) ? Number(word.replace(/,/g, "")) : cell;
    }

    function tableOf(block) {
        const isNumeric = (i) => block.rows.length > 0 &&
            block.rows.every((row) => /^(-|)$/.test(row[i] ?? "") || typeof valueOf(row[i]) === "number");
        const columns = block.head.map((title, i) => ({title: title.replace(/`/g, ""),
            number: isNumeric(i), value: (row) => valueOf(row[i] ?? ""),
            cell: (row) => gloam.element("span", {}, ...inline(row[i] ?? ""))}));
        const table = new gloam.Table(columns, "");
        for (const row of block.rows) table.add(row);
        return gloam.element("div", {class: "wide", tabindex: "0", role: "group", "aria-label": "Table"}, table.root);
    }

    const makers = {
        heading: (block) => [gloam.element("h" + Math.min(block.level, 6), {}, ...inline(block.text))],
        paragraph: (block) => [gloam.element("p", {}, ...inline(block.text))],
        list: (block) => [gloam.element("ul", {}, ...block.items.map((item) =>
            gloam.element("li", {}, ...inline(item))))],
        code: (block) => [gloam.element("pre", {tabindex: "0"}, block.text)],
        table: (block) => [...(gloam.chart ? gloam.chart.of(block) : []), tableOf(block)]
    };

    document.addEventListener("DOMContentLoaded", () => {
        for (const block of gloam.documents.flat())
            document.getElementById("document").append(...makers[block.kind](block));
        if (gloam.chart) gloam.chart.drawAll();
    });

    return {valueOf};
})();
