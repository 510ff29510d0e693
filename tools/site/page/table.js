// SPDX-License-Identifier: MIT
// A table that sorts by a click on a column's head, and shows more of a row on demand.
"use strict";

gloam.Table = class {
    // columns: {title, number?, value(row), cell?(row)}. value() gives what is sorted by; cell() gives a
    // text or an element to show in its place. more: the elements that a button in the last column shows below a row.
    constructor(columns, caption, more = null) {
        this.columns = columns;
        this.more = more;
        this.lines = [];
        this.sorted = {column: null, descending: false};
        this.body = gloam.element("tbody");
        this.heads = columns.map((column) => this.makeHead(column));
        this.root = gloam.element("table", {}, gloam.element("caption", {}, caption),
            gloam.element("thead", {}, gloam.element("tr", {}, ...this.heads)), this.body);
    }

    makeHead(column) {
        if (column.title === "") return gloam.element("td");
        const button = gloam.element("button", {type: "button"}, column.title);
        button.addEventListener("click", () => this.sort(column));
        return gloam.element("th", {scope: "col", class: column.number ? "number" : ""}, button);
    }

    add(row) {
        const line = this.makeLine(row);
        this.lines.push(line);
        this.body.append(...line.elements);
    }

    makeLine(row) {
        const cells = this.columns.map((column) => gloam.element("td", {class: column.number ? "number" : ""},
            column.cell ? column.cell(row) : String(column.value(row))));
        const line = {row, elements: [gloam.element("tr", {}, ...cells)]};
        if (this.more !== null) cells.at(-1).append(this.makeOpener(line));
        return line;
    }

    // The button that shows more of a row.
    makeOpener(line) {
        const button = gloam.element("button", {type: "button", class: "small", "aria-expanded": "false",
            "aria-label": `details of ${this.columns[0].value(line.row)}`}, "details");
        button.addEventListener("click", () => {
            const open = button.getAttribute("aria-expanded") === "false";
            button.setAttribute("aria-expanded", open);
            if (line.elements.length === 1) {
                const cell = gloam.element("td", {colspan: this.columns.length}, ...this.more(line.row));
                line.elements.push(gloam.element("tr", {class: "more"}, cell));
                line.elements[0].after(line.elements[1]);
            }
            line.elements[1].hidden = !open;
        });
        return button;
    }

    clear() {
        this.lines = [];
        this.body.replaceChildren();
    }

    // The column's order; the reverse where it is sorted by it already.
    sort(column) {
        const again = this.sorted.column === column;
        this.sorted = {column, descending: again ? !this.sorted.descending : Boolean(column.number)};
        const sign = this.sorted.descending ? -1 : 1;
        this.lines.sort((a, b) => sign * gloam.Table.compare(column.value(a.row), column.value(b.row)));
        this.body.append(...this.lines.flatMap((line) => line.elements));
        this.columns.forEach((other, i) => {
            const order = this.sorted.descending ? "descending" : "ascending";
            if (other === column) this.heads[i].setAttribute("aria-sort", order);
            else this.heads[i].removeAttribute("aria-sort");
        });
    }

    static compare(a, b) {
        if (typeof a === "number" && typeof b === "number") return a === b ? 0 : a < b ? -1 : 1;
        return String(a).localeCompare(String(b), undefined, {numeric: true});
    }
};
