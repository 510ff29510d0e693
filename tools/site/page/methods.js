// SPDX-License-Identifier: MIT
// The table of all methods, from gloam.methodList; the details of one stand below its row.
"use strict";

gloam.methodRow = (() => {
    const paragraph = (...words) => gloam.element("p", {}, ...words);

    function tableOf(label, columns, rows) {
        const table = new gloam.Table(columns, "");
        for (const row of rows) table.add(row);
        return gloam.element("div", {class: "wide equations", tabindex: "0", role: "region", "aria-label": label},
            table.root);
    }

    const equations = (method) => tableOf("Equations", [{title: "equation", value: (one) => one.name},
        {title: "what it is", value: (one) => one.title},
        {title: "formula", value: (one) => one.formula, cell: ({formula}) => gloam.element("code", {}, formula)},
        {title: "source", value: (one) => one.source}], method.equations);

    const presets = (method) => method.presets.length === 0 ? [] : [tableOf("Presets", [
        {title: "preset", value: (preset) => preset.name},
        {title: "error", number: true, value: (preset) => preset.error, cell: ({error}) => error.toFixed(4)},
        {title: "time", number: true, value: (preset) => preset.time, cell: ({time}) => time.toFixed(2)},
        {title: "what it is", value: (preset) => preset.description}], method.presets)];

    const picture = (method) => method.caption === "" ? [] : [gloam.element("figure", {},
        gloam.element("img", {src: `method-${method.name}.png`, alt: "its occlusion in a room"}),
        gloam.element("figcaption", {}, method.caption))];

    const failures = (method) => method.fails === "" ? []
        : [paragraph(`Where it fails: ${method.fails}. Error, by gloam bench methods: ${method.number}.`)];

    const copied = ({file, name}) => paragraph("Copy it by ", gloam.element("code", {},
        `gloam pack ${file} --function gloam_${name}`), ".");

    const more = (method) => [copied(method), paragraph(`Falloff with the distance: ${method.falloff}.`),
        equations(method), ...presets(method), ...failures(method), ...picture(method)];

    return {more};
})();

document.addEventListener("DOMContentLoaded", () => {
    const best = ({presets}) => presets.toSorted((a, b) => a.error - b.error)[0];
    const measured = (title, name, digits) => ({title, number: true,
        value: (method) => best(method)?.[name] ?? Infinity,
        cell: (method) => best(method)?.[name].toFixed(digits) ?? ""});
    const table = new gloam.Table([
        {title: "method", value: (method) => method.name},
        {title: "estimates", value: (method) => method.measure},
        measured("error", "error", 4), measured("time", "time", 2),
        {title: "preset", value: (method) => best(method)?.name ?? ""},
        {title: "what it is", value: (method) => method.description},
        {title: "", value: () => "", cell: () => ""}], "", gloam.methodRow.more);
    for (const method of gloam.methodList) table.add(method);
    document.getElementById("methods").append(table.root);
});
