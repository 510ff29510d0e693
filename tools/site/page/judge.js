// SPDX-License-Identifier: MIT
// Judges outputs of a kernel by the documented accuracy, as harness/framework/check/judge.cpp does for a device that
// does not preserve NaN, infinity and -0. Says what the check is worth, as harness/framework/check/answer.cpp does. It
// needs neither a page nor a GPU.
"use strict";

gloam.judge = (() => {
    const classNames = ["ordinary", "branch", "zero", "subnormal", "huge", "infinite", "nan"];
    // How an input is judged: the values of check::Criterion.
    const criterion = {recorded: 0, codomain: 1, budget: 2, edge: 3};
    const leastJudgedShare = 0.25;  // of a check's inputs: check::least_judged_share
    const largestFloat = 3.4028234663852886e38;
    const smallestNormal = 2 ** -126;
    const view = new DataView(new ArrayBuffer(8));

    // One unit in the last place of a 32-bit float at a finite x; at a power of two the smaller gap.
    function ulpSize(x) {
        const magnitude = Math.abs(x);
        view.setFloat64(0, magnitude);
        const high = view.getUint32(0);
        let exponent = (high >>> 20) - 1023;
        if ((high & 0xfffff) === 0 && view.getUint32(4) === 0) exponent -= 1;
        return 2 ** (Math.min(Math.max(exponent, -126), 127) - 23);
    }

    // The value of a word: f float, i int, otherwise unsigned.
    function valueOf(letter, word) {
        if (letter === "u" || letter === "b") return word;
        view.setUint32(0, word);
        return letter === "f" ? view.getFloat32(0) : view.getInt32(0);
    }

    // 0 or infinity where the error is not a matter of distance, else -1.
    function settledError(got, want) {
        if (Number.isNaN(got) || Number.isNaN(want)) return Number.isNaN(got) && Number.isNaN(want) ? 0 : Infinity;
        if (Math.abs(want) > largestFloat) {
            const sameSide = Math.sign(got) === Math.sign(want);
            const isLarge = Math.abs(got) === Infinity ||
                (Math.abs(want) !== Infinity && Math.abs(got) >= largestFloat);
            return sameSide && isLarge ? 0 : Infinity;
        }
        if (Math.abs(got) === Infinity) return Infinity;
        return Math.abs(want) < smallestNormal && got === 0 ? 0 : -1;
    }

    function fractionOf(error, allowed) {
        if (error === 0) return 0;
        return allowed > 0 ? error / allowed : Infinity;
    }

    // The error of one float. `unit`: ULP of the largest component of its value, or 0.
    function floatError(budget, got, want, unit) {
        const settled = settledError(got, want);
        const absolute = settled >= 0 ? settled : Math.abs(got - want);
        let ulp = settled >= 0 ? settled : absolute / ulpSize(want);
        if (unit > 0 && Number.isFinite(absolute)) ulp = absolute / unit;
        return {ulp, absolute, fraction: Math.min(fractionOf(ulp, budget.ulp), fractionOf(absolute, budget.abs))};
    }

    function unitOf(budget, want, first, words) {
        let unit = 0;
        for (let i = first; budget.of_largest_component && i < first + words; ++i)
            if (Number.isFinite(want[i])) unit = Math.max(unit, ulpSize(want[i]));
        return unit;
    }

    // The largest error of the outputs of one input against one exact result.
    function errorAgainst(check, got, want) {
        const error = {ulp: 0, absolute: 0, fraction: 0};
        let first = 0;
        for (const words of check.values) {
            const unit = unitOf(check.budget, want, first, words);
            for (let i = first; i < first + words; ++i) addError(error, check, got[i], want[i], i, unit);
            first += words;
        }
        return error;
    }

    function addError(error, check, got, want, i, unit) {
        if (check.outputs[i] !== "f") {
            if (got !== want) error.ulp = error.absolute = error.fraction = Infinity;
            return;
        }
        const here = floatError(check.budget, got, want, unit);
        if (here.absolute > check.budget.abs) error.ulp = Math.max(error.ulp, here.ulp);
        error.absolute = Math.max(error.absolute, here.absolute);
        error.fraction = Math.max(error.fraction, here.fraction);
    }

    // The error against the first exact result that allows the outputs, otherwise the least error.
    function bestError(check, got, wants) {
        let best = null;
        for (const want of wants) {
            const error = errorAgainst(check, got, want);
            if (best === null || error.fraction < best.fraction) best = error;
            if (best.fraction <= 1) break;
        }
        return best;
    }

    // Whether some result is outside the codomain.
    function hasCodomain(check) {
        return check.codomain.some((end) => end !== null) && /[^b]/.test(check.outputs);
    }

    function insideCodomain(check, got) {
        const low = check.codomain[0] ?? -Infinity;
        const high = check.codomain[1] ?? Infinity;
        return got.every((value, i) => check.outputs[i] === "b" || (value >= low && value <= high));
    }

    // Whether a value is near the documented result of an edge: within 1/256 of the largest component, or the budget.
    function nearEdge(check, got, want, first, words) {
        let largest = 0.01;
        for (let i = first; i < first + words; ++i)
            if (Number.isFinite(want[i])) largest = Math.max(largest, Math.abs(want[i]));
        const allowed = Math.max(largest / 256, check.budget.abs, smallestNormal);
        for (let i = first; i < first + words; ++i)
            if (!sameNumber(got[i], want[i], check.outputs[i] === "f" ? allowed : 0)) return false;
        return true;
    }

    function sameNumber(got, want, allowed) {
        if (Number.isNaN(want)) return Number.isNaN(got);
        if (Number.isFinite(want) && Math.abs(want) > 1e30) return true;
        return got === want || Math.abs(got - want) <= allowed;
    }

    function holdsAtEdge(check, got, wants) {
        return wants.some((want) => {
            let first = 0;
            return check.values.every((words) => {
                const near = nearEdge(check, got, want, first, words);
                first += words;
                return near;
            });
        });
    }

    // The errors of one input, and its fraction of what is allowed: above 1 it fails.
    function judgeInput(check, how, got, wants) {
        const none = {ulp: 0, absolute: 0, fraction: 0};
        if (!insideCodomain(check, got)) {
            const outside = {ulp: Infinity, absolute: Infinity, fraction: Infinity};
            return {error: outside, fraction: Infinity};
        }
        if (how === criterion.budget) {
            const error = bestError(check, got, wants);
            return {error, fraction: error.fraction};
        }
        const fails = how === criterion.edge && !holdsAtEdge(check, got, wants);
        return {error: none, fraction: fails ? Infinity : 0};
    }

    // An empty tally of a check: counts for each class, and for false and true if all results are boolean; the largest
    // errors, the worst input.
    function newTally() {
        return {classes: classNames.map(() => ({inputs: 0, outside: 0, recorded: 0, open: 0})),
            predicate: [{inputs: 0, judged: 0}, {inputs: 0, judged: 0}], maxUlp: 0, maxAbsolute: 0,
            budgetFraction: 0, worst: null};
    }

    // The data of a scenario, decoded.
    async function decode({name, count, images, inputs, classes, criteria, wants, counts}) {
        return {name, count, images: await Promise.all(images.map((image) => gloam.values(Uint32Array, image))),
            inputs: await gloam.values(Uint32Array, inputs), classes: await gloam.values(Uint8Array, classes),
            criteria: await gloam.values(Uint8Array, criteria), wants: await gloam.values(Float64Array, wants),
            counts: await gloam.values(Uint16Array, counts)};
    }

    function addInput(tally, inputClass, result, sample) {
        const counts = tally.classes[inputClass];
        ++counts.inputs;
        tally.maxUlp = Math.max(tally.maxUlp, result.error.ulp);
        tally.maxAbsolute = Math.max(tally.maxAbsolute, result.error.absolute);
        tally.budgetFraction = Math.max(tally.budgetFraction, result.error.fraction);
        if (result.fraction > 1) ++counts.outside;
        if (result.fraction > 0 && (tally.worst === null || result.fraction > tally.worst.fraction))
            tally.worst = {...sample(), ...result.error, fraction: result.fraction};
    }

    // Counts an input of a function whose results are all boolean: check::Answer::add_predicate().
    function addPredicate(tally, check, want, wasJudged) {
        if (/[^b]/.test(check.outputs)) return;
        tally.predicate.forEach((counts, i) => {
            if (!want.includes(i)) return;
            ++counts.inputs;
            if (wasJudged) ++counts.judged;
        });
    }

    // Adds the outputs of a decoded scenario to a tally. `outputs`: words, one input after another.
    function addScenario(tally, check, data, outputs) {
        const width = check.outputs.length;
        for (let i = 0, at = 0; i < data.count; ++i) {
            const words = outputs.subarray(i * width, (i + 1) * width);
            const wants = [];
            for (let k = 0; k < data.counts[i]; ++k, at += width) wants.push(data.wants.subarray(at, at + width));
            if (data.criteria[i] === criterion.recorded) {
                ++tally.classes[data.classes[i]].inputs;
                ++tally.classes[data.classes[i]].recorded;
                addPredicate(tally, check, wants[0], false);
                continue;
            }
            const got = Array.from(words, (word, k) => valueOf(check.outputs[k], word));
            const result = judgeInput(check, data.criteria[i], got, wants);
            const open = data.criteria[i] === criterion.codomain && !hasCodomain(check);
            if (open) ++tally.classes[data.classes[i]].open;
            addPredicate(tally, check, wants[0], !open);
            addInput(tally, data.classes[i], result, () => ({index: i, inputClass: classNames[data.classes[i]],
                scenario: data.name, inputs: Array.from(inputRow(check, data, i)), got: Array.from(words),
                want: Array.from(wants[0])}));
        }
    }

    function inputRow(check, data, i) {
        return data.inputs.subarray(i * check.inputs.length, (i + 1) * check.inputs.length);
    }

    const sum = (tally, member) => tally.classes.reduce((total, counts) => total + counts[member], 0);

    // Inputs for which some result would have failed.
    const judged = (tally) => sum(tally, "inputs") - sum(tally, "recorded") - sum(tally, "open");

    // Why no verdict follows from a tally without failures; empty where one does.
    function notJudgedBecause(tally) {
        const inputs = sum(tally, "inputs");
        if (inputs === 0) return "there are no inputs";
        if (sum(tally, "recorded") === inputs) return "the device promises nothing for any of its inputs";
        if (judged(tally) === 0) return "every result would pass";
        if (judged(tally) < leastJudgedShare * inputs)
            return `${judged(tally)} of ${inputs} inputs could be judged, ` +
                `expected ${100 * leastJudgedShare} % at least`;
        const open = tally.classes.findIndex((counts) => counts.open > 0 &&
            counts.open + counts.recorded === counts.inputs);
        if (open >= 0) return `every result would pass for its ${classNames[open]} inputs`;
        const unjudged = tally.predicate.findIndex((counts) => counts.inputs > 0 && counts.judged === 0);
        return unjudged < 0 ? "" : `no input could be judged whose result is ${unjudged === 1}: ` +
            `a function that is always ${unjudged === 0} would pass`;
    }

    // {outcome: "ok", "failed" or "not judged", because}. `because`: why it is not judged. `run`: {tally, fault, error,
    // reason}, of which `reason` is "unsupported" where there was no kernel to run.
    function outcomeOf({tally, fault, error, reason}) {
        if (reason === "unsupported") return {outcome: "not judged", because: error};
        if (error !== "" || fault !== "" || sum(tally, "outside") > 0) return {outcome: "failed", because: ""};
        const because = notJudgedBecause(tally);
        return {outcome: because === "" ? "ok" : "not judged", because};
    }

    return {classNames, newTally, decode, addScenario, valueOf, sum, judged, outcomeOf};
})();
