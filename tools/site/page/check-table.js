// SPDX-License-Identifier: MIT
// The table of checks (page.js sorts it): the row of a check, and its details, with the text of its kernel.
"use strict";

gloam.checkTable = (() => {
    const asNumber = (value) => value === "inf" ? Infinity : value === "nan" ? NaN : value;
    const tones = {ok: "good", failed: "bad", "not judged": "soft"};
    const titles = ["verdict", "equation", "function", "of allowed", "worst ulp", "worst absolute", "inputs", "judged",
        "ms", "details"];
    const isNumber = (column) => column > 2 && column < 9;

    // An empty table.
    function made() {
        const heads = titles.map((title, i) => gloam.element("th", {scope: "col", class: isNumber(i) ? "number" : ""},
            gloam.element("button", {type: "button"}, title)));
        return gloam.element("table", {}, gloam.element("caption", {}, "One line for each equation"),
            gloam.element("thead", {}, gloam.element("tr", {}, ...heads)), gloam.element("tbody"));
    }

    function verdictOf(row) {
        return row.outcome === "failed" && row.reason !== "" ? row.reason : row.outcome;
    }

    // What is allowed, the classes of inputs of which the browser promises nothing, and the worst input.
    function factsOf({check, row, worst}) {
        const facts = [["allowed", check.budget.text]];
        const free = Object.entries(row.classes).filter(([, counts]) => counts.recorded === counts.inputs);
        if (free.length > 0) facts.push(["not promised", free.map(([name]) => name).join(", ")]);
        if (worst !== null)
            facts.push(["worst input", `${worst.index} (${worst.inputClass})`],
                ["values", gloam.results.inputText(check, worst.inputs)],
                ["got", gloam.results.outputText(check, worst.got)], ["exact", worst.want.join(", ")]);
        return gloam.element("dl", {}, ...facts.flatMap(([name, text]) =>
            [gloam.element("dt", {}, name), gloam.element("dd", {}, text)]));
    }

    // The text of a kernel with the numbers of its lines, indented by its braces; bad: the lines that the message of a
    // compiler names ("ERROR: 0:12: ...").
    function kernelText({check, row, kernel}) {
        const named = new Set([...row.error.matchAll(/\b0:(\d+)\b/g)].map(([, line]) => Number(line)));
        const count = (line, brace) => line.split(brace).length - 1;
        let depth = 0;
        const lines = kernel.trimEnd().split("\n").map((line, i) => {
            const indented = "    ".repeat(Math.max(depth - (line.startsWith("}") ? 1 : 0), 0)) + line;
            depth += count(line, "{") - count(line, "}");
            return gloam.element("span", {class: named.has(i + 1) ? "line bad" : "line"}, indented + "\n");
        });
        return gloam.element("pre", {class: "code", tabindex: "0", role: "region",
            "aria-label": `kernel of ${check.equation}`}, ...lines);
    }

    function showDetails(dialog, shown) {
        const close = gloam.element("form", {method: "dialog"}, gloam.element("button", {}, "Close"));
        dialog.replaceChildren(gloam.element("h2", {}, shown.row.equation), factsOf(shown),
            ...shown.kernel === "" ? [] : [kernelText(shown)], close);
        dialog.showModal();
    }

    // shown: {check, row, worst, kernel}. The button of the row shows details in a dialog.
    function rowOf(shown, dialog) {
        const {row} = shown;
        const details = gloam.element("button", {type: "button", class: "small",
            "aria-label": `details of ${row.equation}`}, "details");
        details.addEventListener("click", () => showDetails(dialog, shown));
        const numbers = [row.budget_fraction, row.max_ulp, row.max_abs, row.inputs, row.judged,
            Math.round(row.seconds * 1000)].map(asNumber);
        const cell = (...children) => gloam.element("td", {}, ...children);
        return gloam.element("tr", {}, cell(gloam.element("span", {class: tones[row.outcome]}, verdictOf(row))),
            cell(row.equation), cell(row.function),
            ...numbers.map((value) => gloam.element("td", {class: "number", "data-value": value},
                Number.isFinite(value) ? String(Number(value.toPrecision(3))) : "infinite")),
            cell(gloam.element("span", {class: "reason"}, row.error || row.fault || row.not_judged_because), details));
    }

    return {made, rowOf};
})();
