// SPDX-License-Identifier: MIT
// The table of all methods, from gloam.methodPages.
"use strict";

document.addEventListener("DOMContentLoaded", () => {
    const best = ({presets}) => presets.toSorted((a, b) => a.error - b.error)[0];
    const measured = (title, name, digits) => ({title, number: true,
        value: (method) => best(method)?.[name] ?? Infinity,
        cell: (method) => best(method)?.[name].toFixed(digits) ?? ""});
    const link = (method) => gloam.element("a", {href: `method-${method.name}.html`}, method.name);
    const table = new gloam.Table([
        {title: "method", value: (method) => method.name, cell: link},
        {title: "estimates", value: (method) => method.measure},
        measured("error", "error", 4), measured("time", "time", 2),
        {title: "preset", value: (method) => best(method)?.name ?? ""},
        {title: "what it is", value: (method) => method.description}], "");
    for (const method of gloam.methodPages) table.add(method);
    document.getElementById("methods").append(table.root);
});
