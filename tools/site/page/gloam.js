// SPDX-License-Identifier: MIT
// The one global object of the site, and what all scripts use: data, text, elements.
"use strict";

const gloam = {};

// The checks of each part of the library, by its name: filled by the files checks-PART.js.
gloam.parts = new Map();

gloam.addChecks = (part, checks) => {
    gloam.parts.set(part, checks);
};

// Loads a script of the site. fetch() of a file is refused on file://, a script is not.
gloam.loadScript = (file) => new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = file;
    script.onload = () => resolve();
    script.onerror = () => reject(new Error("cannot load " + file));
    document.head.append(script);
});

// The values of a type, Float64Array for one, from their compressed bytes as base64 (page_data.hpp).
gloam.values = async (Type, text) => {
    if (text === "") return new Type();
    const packed = new Blob([Uint8Array.from(atob(text), (character) => character.charCodeAt(0))]);
    const bytes = packed.stream().pipeThrough(new DecompressionStream("deflate"));
    return new Type(await new Response(bytes).arrayBuffer());
};

// A new element with attributes and children. Texts become text nodes, never markup.
gloam.element = (tag, attributes = {}, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
};

// Marks this page in the navigation. The scripts are deferred: the page is there.
document.querySelector(`nav a[href="${location.pathname.split("/").pop() || "index.html"}"]`)
    .setAttribute("aria-current", "page");
