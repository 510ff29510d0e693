// SPDX-License-Identifier: MIT
// The state of the page in its address, behind the #: "scene=knot&radius=2". What it cannot have there is told.
"use strict";

gloam.address = (() => {
    // Kinds of values: each gives the value of a text, or undefined where it has none.
    const oneOf = (names) => (text) => names.includes(text) ? text : undefined;

    const number = (text) => /^-?\d{1,6}(\.\d{1,9})?$/.test(text) ? Number(text) : undefined;

    const within = (least, most) => (text) => {
        const value = number(text);
        return value >= least && value <= most ? value : undefined;
    };

    const list = (count) => (text) => {
        const values = text.split(",").map(number);
        return values.length === count && !values.includes(undefined) ? values : undefined;
    };

    const longest = 400;

    // The values of a text by their names, and a line for each that is wrong. kinds: {name: kind}.
    function read(text, kinds) {
        const found = {values: {}, problems: []};
        if (text.length > longest) {
            found.problems.push(`the address has more than ${longest} characters behind the #, and is ignored`);
            return found;
        }
        for (const part of text.split("&").filter((one) => one !== "")) {
            const [name, value = ""] = part.split("=", 2);
            if (!Object.hasOwn(kinds, name)) found.problems.push(`the address names "${name}", which is unknown`);
            else if (kinds[name](value) === undefined)
                found.problems.push(`the address gives ${name} the value "${value}", which it cannot have`);
            else found.values[name] = kinds[name](value);
        }
        return found;
    }

    const textOf = (value) => [value].flat().map((one) =>
        typeof one === "number" ? String(Number(one.toFixed(5))) : one).join(",");

    const write = (values) => Object.entries(values).map(([name, value]) => `${name}=${textOf(value)}`).join("&");

    return {oneOf, within, list, read, write};
})();
