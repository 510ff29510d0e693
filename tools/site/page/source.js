// SPDX-License-Identifier: MIT
// The source text of a method in each language, with a button that copies it.
"use strict";

// The texts of the methods that were loaded, by their names: {language: text}.
gloam.sources = new Map();

gloam.addSource = (name, texts) => gloam.sources.set(name, texts);

gloam.Source = class {
    constructor() {
        this.language = gloam.element("select", {"aria-label": "Language"});
        this.copy = gloam.element("button", {type: "button"}, "Copy");
        this.told = gloam.element("span", {role: "status", class: "soft"});
        this.text = gloam.element("pre", {class: "source", tabindex: "0", role: "region", "aria-label": "Source text"});
        const controls = gloam.element("p", {class: "controls"}, this.language, this.copy, this.told);
        this.root = gloam.element("div", {}, controls, this.text);
        this.language.addEventListener("change", () => this.show());
        this.copy.addEventListener("click", () => this.copyText());
    }

    // Loads the texts of a method and shows the one in the chosen language.
    async open(name) {
        this.wanted = name;
        if (!gloam.sources.has(name)) await gloam.loadScript(`source-${name}.js`);
        if (this.wanted !== name) return;  // another was opened meanwhile
        this.texts = gloam.sources.get(name);
        const chosen = this.language.value;
        this.language.replaceChildren(...Object.keys(this.texts).map((language) =>
            gloam.element("option", {}, language)));
        if (chosen in this.texts) this.language.value = chosen;
        this.show();
    }

    show() {
        this.text.textContent = this.texts[this.language.value];
        this.told.textContent = `${this.text.textContent.split("\n").length - 1} lines`;
    }

    async copyText() {
        try {
            await navigator.clipboard.writeText(this.text.textContent);
            this.told.textContent = "copied";
        } catch {
            getSelection().selectAllChildren(this.text);
            this.told.textContent = "The browser does not let a page copy: the text is selected.";
        }
    }
};
