// SPDX-License-Identifier: MIT
// Bounds the loops of a kernel, so that one that never ends is an error of its check and not a GPU that hangs. A
// browser need not end such a kernel: Chromium over SwiftShader draws nothing more, for any page, while one runs.
"use strict";

gloam.bounded = (() => {
    // How often the loops of one invocation may go round, all of them together. The kernels of the catalogue need less
    // than 1/16 of it.
    const most = 2 ** 14;
    const isOver = `gloam_kernel_rounds > ${most}u`;
    const glslHead = "uint gloam_kernel_rounds = 0u; bool gloam_kernel_round() " +
        `{ gloam_kernel_rounds += 1u; return !(${isOver}); } `;

    // The position of the parenthesis that closes the one at `open`.
    function closing(text, open) {
        for (let at = open, depth = 0; at < text.length; ++at) {
            depth += text[at] === "(" ? 1 : text[at] === ")" ? -1 : 0;
            if (depth === 0) return at;
        }
        throw new Error("the kernel has an open parenthesis");
    }

    // The text with each header of a loop, what is between its parentheses, replaced.
    function withHeaders(text, replaced) {
        let result = "";
        let from = 0;
        for (const match of text.matchAll(/\b(for|while)\s*\(/g)) {
            const begin = match.index + match[0].length;
            const end = closing(text, begin - 1);
            result += text.slice(from, begin) + replaced(match[1], text.slice(begin, end));
            from = end;
        }
        return result + text.slice(from);
    }

    function boundedHeader(keyword, header) {
        const parts = header.split(";");
        const condition = keyword === "for" ? parts[1]?.trim() : header;
        const bounded = "gloam_kernel_round()" + (condition ? ` && (${condition})` : "");
        return keyword === "for" ? `${parts[0]}; ${bounded};${parts[2] ?? ""}` : bounded;
    }

    // Inverts the canary that the kernel writes at its end where a loop was cut.
    function withMark(text, canary, inverted) {
        const at = text.lastIndexOf(canary);
        if (at < 0) throw new Error("the kernel has no canary");
        return text.slice(0, at) + inverted + text.slice(at + canary.length);
    }

    // A kernel in GLSL ES 3.00, with its lines where they were.
    function glsl(text) {
        const marked = withMark(withHeaders(text, boundedHeader), "gloam_kernel_canary",
            `(${isOver} ? ~gloam_kernel_canary : gloam_kernel_canary)`);
        return marked.replace(/^(?!#|precision\b)/m, glslHead);
    }

    // Throws an Error where the word that a kernel has written at its end for input `i` is not the one that it had to
    // write.
    function requireEnd(word, canary, i) {
        if (word === (canary ^ i) >>> 0) return;
        throw new Error(word === (~canary ^ i) >>> 0
            ? `the kernel does not end for input ${i}: its loops went round more than ${most} times`
            : `the kernel did not finish for input ${i}`);
    }

    return {glsl, requireEnd};
})();
