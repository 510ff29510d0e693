// SPDX-License-Identifier: MIT
// The page of one method, from gloam.methodPages.
"use strict";

gloam.methodPage = (() => {
    const paragraph = (...words) => gloam.element("p", {}, ...words);
    const section = (title, ...content) => [gloam.element("h2", {}, title), ...content];

    function equations(method) {
        const table = new gloam.Table([{title: "equation", value: (one) => one.name},
            {title: "what it is", value: (one) => one.title},
            {title: "formula", value: (one) => one.formula, cell: ({formula}) => gloam.element("code", {}, formula)},
            {title: "source", value: (one) => one.source}], "");
        for (const one of method.equations) table.add(one);
        return section("Equations", paragraph(`It estimates: ${method.measure}. Falloff with the distance: `,
            `${method.falloff}.`), gloam.element("div", {class: "wide equations", tabindex: "0", role: "region",
            "aria-label": "Equations"}, table.root));
    }

    function picture(method) {
        if (method.picture === "") return [];
        return [gloam.element("figure", {}, gloam.element("img", {src: method.picture, alt: "its occlusion in a room"}),
            gloam.element("figcaption", {}, method.caption))];
    }

    function measured(method) {
        if (method.presets.length === 0)
            return section("Error and time", paragraph("No preset runs this method, so none was measured."));
        const table = new gloam.Table([{title: "preset", value: (preset) => preset.name},
            {title: "error", number: true, value: (preset) => preset.error, cell: ({error}) => error.toFixed(4)},
            {title: "time", number: true, value: (preset) => preset.time, cell: ({time}) => time.toFixed(2)},
            {title: "what it is", value: (preset) => preset.description}],
        "gloam bench presets, llvmpipe: RMSE against ray-traced truth, time in that of the preset fast");
        for (const preset of method.presets) table.add(preset);
        return section("Error and time", gloam.element("div", {class: "wide", tabindex: "0", role: "region",
            "aria-label": "Presets"}, table.root));
    }

    function failures(method) {
        if (method.fails === "") return [];
        return section("Where it fails", paragraph(`${method.fails[0].toUpperCase()}${method.fails.slice(1)}.`),
            paragraph(gloam.element("span", {class: "soft"}, `Error, by gloam bench methods: ${method.number}.`)));
    }

    function links(method) {
        const live = gloam.element("a", {href: `index.html#method=${method.name}`}, "See it live");
        return paragraph(...(method.live ? [live, ". "] : []), "Copy it by ", gloam.element("code", {},
            `gloam pack ${method.file} --function gloam_${method.name}`));
    }

    document.addEventListener("DOMContentLoaded", async () => {
        const place = document.getElementById("method");
        const method = gloam.methodPages.find(({name}) => name === place.dataset.name);
        const source = new gloam.Source();
        place.append(links(method), ...picture(method), ...equations(method), ...measured(method), ...failures(method),
            ...section("Source text", source.root));
        await source.open(method.name);
    });
})();
