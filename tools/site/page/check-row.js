// SPDX-License-Identifier: MIT
// What the table of checks shows of a check: its verdict, its worst input, the text of its kernel.
"use strict";

gloam.checkRow = (() => {
    const asNumber = (value) => value === "inf" ? Infinity : value === "nan" ? NaN : value;
    const short = (value) => Number.isFinite(value) ? String(Number(value.toPrecision(3))) : "infinite";
    const tones = {ok: "good", failed: "bad", "not judged": "soft"};

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

    // The lines of a kernel that the message of a compiler names: "ERROR: 0:12: ...".
    function namedLines(message) {
        return new Set([...message.matchAll(/\b0:(\d+)\b/g)].map(([, line]) => Number(line)));
    }

    // The lines of a text, indented by its braces: kernels are stored without indentation.
    function indentedLines(text) {
        const count = (line, brace) => line.split(brace).length - 1;
        let depth = 0;
        return text.trimEnd().split("\n").map((line) => {
            const indented = "    ".repeat(Math.max(depth - (line.startsWith("}") ? 1 : 0), 0)) + line;
            depth += count(line, "{") - count(line, "}");
            return indented + "\n";
        });
    }

    // The text of a kernel with the numbers of its lines.
    function kernelText({check, row, kernel}) {
        const named = namedLines(row.error);
        return gloam.element("pre", {class: "code", tabindex: "0", role: "region",
            "aria-label": `kernel of ${check.equation}`}, ...indentedLines(kernel).map((line, i) =>
            gloam.element("span", {class: named.has(i + 1) ? "line bad" : "line"}, line)));
    }

    // What is shown below a row.
    const more = (shown) => [factsOf(shown), ...shown.kernel === "" ? [] : [kernelText(shown)]];

    // The columns of the table. A row of it: {check, row, worst, kernel}.
    const columns = [
        {title: "equation", value: ({row}) => row.equation},
        {title: "function", value: ({row}) => row.function},
        {title: "verdict", value: ({row}) => verdictOf(row), cell: ({row}) => gloam.element("span",
            {class: tones[row.outcome]}, verdictOf(row))},
        {title: "of allowed", number: true, value: ({row}) => asNumber(row.budget_fraction),
            cell: ({row}) => short(asNumber(row.budget_fraction))},
        {title: "worst ulp", number: true, value: ({row}) => asNumber(row.max_ulp),
            cell: ({row}) => short(asNumber(row.max_ulp))},
        {title: "worst absolute", number: true, value: ({row}) => asNumber(row.max_abs),
            cell: ({row}) => short(asNumber(row.max_abs))},
        {title: "inputs", number: true, value: ({row}) => row.inputs},
        {title: "judged", number: true, value: ({row}) => row.judged},
        {title: "ms", number: true, value: ({row}) => Math.round(row.seconds * 1000)},
        {title: "details", value: ({row}) => row.error || row.fault || row.not_judged_because,
            cell: ({row}) => gloam.element("span", {class: "reason"},
                row.error || row.fault || row.not_judged_because)}
    ];

    return {columns, more};
})();
