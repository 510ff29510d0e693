// SPDX-License-Identifier: MIT
// The page that checks this browser: runs the kernels of all parts, judges them, shows and saves the results.
"use strict";

gloam.checkPage = (() => {
    const at = (id) => document.getElementById(id);
    const state = {running: false, stop: false, rows: [], runner: null, table: gloam.checkTable.made(), toldAt: 0};
    at("results").append(state.table);  // page.js, which sorts it, comes later

    // What a check gave: {tally, fault, error, reason, seconds} for gloam.results.row(), null where it was stopped.
    async function runOf(check) {
        const begin = performance.now();
        const run = {tally: gloam.judge.newTally(), fault: "", error: check.unsupported, reason: ""};
        if (run.error !== "") return {...run, reason: "unsupported", seconds: 0};
        try {
            const scenarios = await Promise.all(check.scenarios.map(gloam.judge.decode));
            if (state.stop) return null;  // meanwhile, and the runner has ended
            const results = await state.runner.evaluate(check, scenarios);
            results.forEach(({outputs, fault}, i) => {
                gloam.judge.addScenario(run.tally, check, scenarios[i], outputs);
                run.fault ||= fault;
            });
            if (run.fault !== "") run.reason = "fault";
        } catch (error) {
            if (error.reason === "stopped") return null;
            if (error.reason === undefined) throw error;
            Object.assign(run, {error: error.message, reason: error.reason});
        }
        return {...run, seconds: (performance.now() - begin) / 1000};
    }

    // The table is given a check without its inputs: they take most of the memory.
    function add({scenarios, ...check}, run) {
        const row = gloam.results.row(check, run);
        state.rows.push(row);
        state.table.tBodies[0].append(gloam.checkTable.rowOf({check, row, worst: run.tally.worst, kernel: check.kernel},
            at("details")));
        at("progress").value = state.rows.length;
        if (performance.now() - state.toldAt > 1000) tellProgress();  // a screen reader reads each
    }

    function tellProgress() {
        state.toldAt = performance.now();
        const count = (outcome) => state.rows.filter((row) => row.outcome === outcome).length;
        const end = state.running ? "" : state.rows.length < gloam.site.checks ? " (stopped)" : " (finished)";
        at("told").textContent = `${state.rows.length} of ${gloam.site.checks} checks: ${count("ok")} ok, ` +
            `${count("failed")} failed, ${count("not judged")} not judged${end}`;
        at("told").className = count("failed") > 0 ? "bad" : "";
        document.querySelector("input[type=search]").dispatchEvent(new Event("input"));  // the rows are filtered again
    }

    // The checks of a file of the site, by the name of their part.
    async function checksOf(file) {
        await gloam.loadScript(file);
        const [[part, checks]] = gloam.parts;
        gloam.parts.delete(part);  // frees the memory of its data
        return checks;
    }

    // Runs the checks of a file. A lost GPU opens again before the next check. Where it does not, the run ends.
    async function runFile(file) {
        for (const check of await checksOf(file)) {
            if (state.stop) return;
            await state.runner.open();
            const run = await runOf(check);
            if (run !== null) add(check, run);
        }
    }

    async function runAll() {
        Object.assign(state, {running: true, stop: false, rows: []});
        state.table.tBodies[0].replaceChildren();
        Object.assign(at("progress"), {value: 0, max: gloam.site.checks});
        const focused = document.activeElement;
        setButtons();
        if (focused === at("run")) at("stop").focus();
        try {
            tellProgress();
            for (const file of gloam.site.files) if (!state.stop) await runFile(file);
            state.running = false;
            tellProgress();
        } catch (error) {
            state.running = false;
            if (error.reason === "stopped") tellProgress();
            else fail(error, ". The results so far can be saved.");
        }
        const stopped = document.activeElement === at("stop");
        setButtons();
        if (stopped) at("run").focus();
    }

    function setButtons() {
        at("run").disabled = state.running;
        at("stop").disabled = !state.running;
        at("save").disabled = state.running || state.rows.length === 0;
        at("run").textContent = state.rows.length === 0 ? "Run the checks" : "Run all again";
    }

    function stop() {
        state.stop = true;
        state.runner.end();
    }

    function save() {
        const blob = new Blob([gloam.results.file(state.runner.facts, state.rows)], {type: "application/json"});
        const link = gloam.element("a", {href: URL.createObjectURL(blob), download: "gloam-webgl2.json"});
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    }

    function fail(error, more = "") {
        at("told").textContent = error.message + more;
        at("told").className = "bad";
    }

    async function begin() {
        at("agent").textContent = navigator.userAgent;
        at("versions").textContent = gloam.site.versions;
        at("run").addEventListener("click", runAll);
        at("stop").addEventListener("click", stop);
        at("save").addEventListener("click", save);
        state.runner = new gloam.runner.Runner();
        await state.runner.open();
        at("gpu").textContent = `${state.runner.facts.renderer} (${state.runner.facts.version})`;
        setButtons();
    }

    document.addEventListener("DOMContentLoaded", () => begin().catch(fail));
    return {state};
})();
