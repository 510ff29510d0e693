// SPDX-License-Identifier: MIT
// The pictures of gloam.gallery: {device, scenes: [{title, before, after, occlusion, caption}]}, names of files.
"use strict";

gloam.addPictures = (scene) => {
    const picture = (file, text, attributes = {}) => gloam.element("img", {src: file, alt: text, ...attributes});
    const slider = gloam.element("img-comparison-slider", {"aria-label": "without and with ambient occlusion"},
        picture(scene.before, "without ambient occlusion", {slot: "first"}),
        picture(scene.after, "with ambient occlusion", {slot: "second"}));
    const occlusion = gloam.element("figure", {}, picture(scene.occlusion, "the occlusion alone", {loading: "lazy"}),
        gloam.element("figcaption", {}, "The occlusion alone: white is open."));
    document.getElementById("gallery").append(gloam.element("h2", {}, scene.title),
        gloam.element("figure", {}, slider, gloam.element("figcaption", {}, scene.caption)), occlusion);
};

document.addEventListener("DOMContentLoaded", () => {
    document.getElementById("device").textContent = gloam.gallery.device;
    gloam.gallery.scenes.forEach(gloam.addPictures);
});
