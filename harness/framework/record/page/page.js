// SPDX-License-Identifier: MIT
// What a page does: tables that are sorted and filtered.
// It reads nothing but the page and writes no markup.
"use strict";
const keyOf = (row, column) => {
  const cell = row.cells[column];
  return cell.dataset.value === undefined ? cell.textContent : Number(cell.dataset.value);
};
const order = (a, b) => {
  if (typeof a === "number" && typeof b === "number") return a - b;
  if (typeof a !== typeof b) return typeof a === "number" ? 1 : -1;  // text, "-" say, before numbers
  return a < b ? -1 : a > b ? 1 : 0;
};
for (const section of document.querySelectorAll("section.table")) {
  const body = section.querySelector("tbody");
  const rows = () => Array.from(body.rows);  // a page may add some
  const heads = Array.from(section.querySelectorAll("th"));
  heads.forEach((head, column) => head.querySelector("button").addEventListener("click", () => {
    // Numbers begin with the largest, text with its beginning; a second click turns the order round.
    const numeric = head.classList.contains("number");
    const now = head.getAttribute("aria-sort");
    const up = now === null ? !numeric : now === "descending";
    heads.forEach((other) => other.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    body.append(...rows().sort((a, b) => (up ? 1 : -1) * order(keyOf(a, column), keyOf(b, column))));
  }));
  const text = section.querySelector("input[type=search]");
  const choices = Array.from(section.querySelectorAll("select"));
  const count = section.querySelector("output");
  const filter = () => {
    const words = text.value.toLowerCase().split(/\s+/);
    let shown = 0;
    for (const row of rows()) {
      const all = row.textContent.toLowerCase();
      const chosen = (choice) => choice.value === "" || row.cells[choice.dataset.column].textContent === choice.value;
      row.hidden = !(words.every((word) => all.includes(word)) && choices.every(chosen));
      if (!row.hidden) shown += 1;
    }
    count.textContent = shown + " of " + rows().length + " rows";
  };
  [text, ...choices].forEach((input) => input.addEventListener("input", filter));
  filter();
}
