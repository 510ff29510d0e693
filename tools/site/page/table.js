// SPDX-License-Identifier: MIT
// A table that sorts by a click on a column's head, and shows only the rows with a given text.
"use strict";

gloam.Table = class {
    // columns: {title, number?, value(row), cell?(row)}. value() gives what is sorted by and searched; cell() gives a
    // text or an element to show in its place.
    constructor(columns, caption) {
        this.columns = columns;
        this.rows = [];
        this.needle = "";
        this.sorted = {column: null, descending: false};
        this.body = gloam.element("tbody");
        this.heads = columns.map((column) => this.makeHead(column));
        this.root = gloam.element("table", {}, gloam.element("caption", {}, caption),
            gloam.element("thead", {}, gloam.element("tr", {}, ...this.heads)), this.body);
    }

    makeHead(column) {
        const button = gloam.element("button", {type: "button"}, column.title);
        button.addEventListener("click", () => this.sort(column));
        return gloam.element("th", {scope: "col", class: column.number ? "number" : ""}, button);
    }

    add(row) {
        const cells = this.columns.map((column) => gloam.element("td", {class: column.number ? "number" : ""},
            column.cell ? column.cell(row) : String(column.value(row))));
        const line = {row, element: gloam.element("tr", {}, ...cells)};
        this.rows.push(line);
        line.element.hidden = !this.matches(line);
        this.body.append(line.element);
    }

    clear() {
        this.rows = [];
        this.body.replaceChildren();
    }

    // The column's order; the reverse where it is sorted by it already.
    sort(column) {
        const again = this.sorted.column === column;
        this.sorted = {column, descending: again ? !this.sorted.descending : Boolean(column.number)};
        const sign = this.sorted.descending ? -1 : 1;
        this.rows.sort((a, b) => sign * gloam.Table.compare(column.value(a.row), column.value(b.row)));
        this.body.append(...this.rows.map((line) => line.element));
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

    filter(needle) {
        this.needle = needle.toLowerCase();
        for (const line of this.rows) line.element.hidden = !this.matches(line);
    }

    matches(line) {
        return this.needle === "" ||
            this.columns.some((column) => String(column.value(line.row)).toLowerCase().includes(this.needle));
    }
};
