// SPDX-License-Identifier: MIT
// Results as the file that `gloam check --json` writes (harness/framework/report/check_report.cpp). `gloam report`
// merges both.
"use strict";

gloam.results = (() => {
    // A float with its bits: "0.1 (0x3dcccccd)".
    function floatText(value, word) {
        let text = String(value);
        for (let digits = 1; digits <= 9 && Number.isFinite(value); ++digits) {
            const shorter = Number(value.toPrecision(digits));
            if (Math.fround(shorter) !== value) continue;
            text = String(shorter);
            break;
        }
        return `${Object.is(value, -0) ? "-0" : text} (0x${word.toString(16).padStart(8, "0")})`;
    }

    function wordText(letter, word) {
        const value = gloam.judge.valueOf(letter, word);
        if (letter === "f") return floatText(value, word);
        if (letter === "b") return String(value !== 0);
        return letter === "u" ? `${value} (0x${word.toString(16).padStart(8, "0")})` : String(value);
    }

    const outputText = (check, words) => words.map((word, i) => wordText(check.outputs[i], word)).join(", ");

    // The inputs by parameters: "vec2 (0 (0x00000000), 1 (0x3f800000)), float 2 (0x40000000)".
    function inputText(check, words) {
        let at = 0;
        return check.parameters.map(([type, count]) => {
            const texts = words.slice(at, at + count).map((word, i) => wordText(check.inputs[at + i], word));
            at += count;
            return count > 1 ? `${type} (${texts.join(", ")})` : `${type} ${texts[0]}`;
        }).join(", ");
    }

    // JSON has no infinity and no NaN.
    function number(value) {
        if (Number.isNaN(value)) return "nan";
        if (Number.isFinite(value)) return value;
        return value > 0 ? "inf" : "-inf";
    }

    function sampleJson(check, worst) {
        if (worst === null) return null;
        return {input: worst.index, class: worst.inputClass, images: worst.scenario,
            values: inputText(check, worst.inputs), input_words: worst.inputs, got_words: worst.got,
            want: worst.want.map(number), allowed: [], ulp: number(worst.ulp), abs: number(worst.absolute)};
    }

    function classesJson(tally) {
        const json = {};
        tally.classes.forEach((counts, i) => {
            if (counts.inputs > 0) json[gloam.judge.classNames[i]] = counts;
        });
        return json;
    }

    function predicateJson({predicate}) {
        const json = {};
        predicate.forEach((counts, i) => {
            if (counts.inputs > 0) json[i === 1] = counts;
        });
        return json;
    }

    const {sum} = gloam.judge;

    // The story of a failure: the worst input.
    function storyOf(check, tally) {
        const outside = sum(tally, "outside");
        if (outside === 0 || tally.worst === null) return "";
        return `${check.function} (${check.file}): ${outside} of ${sum(tally, "inputs")} inputs outside ` +
            `${check.budget.text}\n  worst input ${tally.worst.index}: ${inputText(check, tally.worst.inputs)}\n` +
            `    got  ${outputText(check, tally.worst.got)}\n    want ${tally.worst.want.join(", ")}\n`;
    }

    // The row of one check. `run`: {tally, fault, error, reason, seconds}.
    function row(check, run) {
        const {tally} = run;
        const {outcome, because} = gloam.judge.outcomeOf(run);
        return {equation: check.equation, function: check.function, file: check.file, variant: "shipped",
            verdict: "budget", outcome, not_judged_because: because, inputs: sum(tally, "inputs"),
            judged: gloam.judge.judged(tally), outside: sum(tally, "outside"), recorded: sum(tally, "recorded"),
            by_rules: 0, forbidden: 0, bounded: 0, unbounded: 0, undefined: 0, undefined_at: "", differs: 0,
            max_ulp: number(tally.maxUlp), max_abs: number(tally.maxAbsolute), width_fraction: null,
            budget_fraction: number(tally.budgetFraction), guarantee: null, unbounded_at: "", budget: check.budget,
            classes: classesJson(tally), predicate: predicateJson(tally),
            worst: sampleJson(check, tally.worst), coverage: null, fault: run.fault,
            error: run.error, reason: run.reason, seconds: run.seconds, story: storyOf(check, tally)};
    }

    // One line of at most 400 characters, as the readers of these files demand.
    const name = (text) => String(text).replace(/[\u0000-\u001f\u007f]+/g, " ").trim().slice(0, 400);

    // The file. `device`: what is reported of the GPU.
    function file(device, rows) {
        const float_controls = {signed_zero_inf_nan_preserve: false, denorm_preserve: false,
            denorm_flush_to_zero: false, rounding_mode_rte: false};
        return JSON.stringify({
            device: {name: name(device.name), driver: name(navigator.userAgent), type: device.type,
                api_version: name(device.version), float_controls},
            versions: gloam.site.versions,
            results: rows}, null, 2) + "\n";
    }

    return {row, file, inputText, outputText};
})();
