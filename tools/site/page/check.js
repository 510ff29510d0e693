// SPDX-License-Identifier: MIT
// The page that checks this browser: runs the kernels of all parts, judges them, shows and saves the results.
"use strict";

gloam.checkPage = (() => {
    const at = (id) => document.getElementById(id);
    const state = {running: false, stop: false, rows: [], device: null, table: null};

    const asNumber = (value) => value === "inf" ? Infinity : value === "nan" ? NaN : value;
    const short = (value) => Number.isFinite(value) ? String(Number(value.toPrecision(3))) : "infinite";

    function verdictOf(row) {
        if (row.reason === "unsupported") return "unsupported";
        if (row.error !== "" || row.fault !== "") return row.reason;
        if (row.outside > 0) return "failed";
        return row.recorded === row.inputs ? "not judged" : "passed";
    }

    // The worst input, or why there is no result.
    function detailOf({check, row, worst}) {
        if (row.error !== "" || row.fault !== "") return row.error || row.fault;
        if (worst === null) return "";
        const line = (name, text) => [gloam.element("dt", {}, name), gloam.element("dd", {}, text)];
        return gloam.element("details", {}, gloam.element("summary", {}, "input " + worst.index),
            gloam.element("dl", {}, ...line("input", gloam.results.inputText(check, worst.inputs)),
                ...line("got", gloam.results.outputText(check, worst.got)),
                ...line("exact", worst.want.join(", ")), ...line("class", worst.inputClass),
                ...line("allowed", check.budget.text)));
    }

    const columns = [
        {title: "equation", value: ({row}) => row.equation},
        {title: "function", value: ({row}) => row.function},
        {title: "verdict", value: ({row}) => verdictOf(row), cell: ({row}) => gloam.element("span",
            {class: gloam.results.passed(row) ? "good" : "bad"}, verdictOf(row))},
        {title: "of allowed", number: true, value: ({row}) => asNumber(row.budget_fraction),
            cell: ({row}) => short(asNumber(row.budget_fraction))},
        {title: "worst ulp", number: true, value: ({row}) => asNumber(row.max_ulp),
            cell: ({row}) => short(asNumber(row.max_ulp))},
        {title: "worst absolute", number: true, value: ({row}) => asNumber(row.max_abs),
            cell: ({row}) => short(asNumber(row.max_abs))},
        {title: "inputs", number: true, value: ({row}) => row.inputs},
        {title: "not judged", number: true, value: ({row}) => row.recorded},
        {title: "ms", number: true, value: ({row}) => Math.round(row.seconds * 1000)},
        {title: "worst input", value: ({row}) => row.worst === null ? row.error : row.worst.values, cell: detailOf}
    ];

    // The outcome of one check. `started`: its program, whose compilation has begun.
    async function outcomeOf(device, check, started) {
        const begin = performance.now();
        const outcome = {tally: gloam.judge.newTally(), fault: "", error: "", reason: ""};
        try {
            const program = await device.link(started);
            for (const scenario of check.scenarios) {
                const data = gloam.judge.decode(scenario);
                const {outputs, fault} = await device.run(program, check, data);
                gloam.judge.addScenario(outcome.tally, check, data, outputs);
                outcome.fault = outcome.fault || fault;
            }
            device.drop(program);
            if (outcome.fault !== "") outcome.reason = "fault";
        } catch (error) {
            outcome.tally = gloam.judge.newTally();
            outcome.error = String(error.message);
            outcome.reason = device.isLost() ? "device lost" : "error";
        }
        outcome.seconds = (performance.now() - begin) / 1000;
        return outcome;
    }

    const unsupported = (check) => ({tally: gloam.judge.newTally(), fault: "", error: state.device.unsupported(check),
        reason: "unsupported", seconds: 0});

    function addResult(check, outcome) {
        const row = gloam.results.row(check, outcome);
        state.rows.push(row);
        state.table.add({check, row, worst: outcome.tally.worst});
        at("progress").value = state.rows.length;
        tellProgress();
    }

    function tellProgress() {
        const failed = state.rows.filter((row) => !gloam.results.passed(row)).length;
        const ends = state.running ? "" : state.rows.length < gloam.site.checks ? " (stopped)" : " (finished)";
        at("told").textContent =
            `${state.rows.length} of ${gloam.site.checks} checks, ${failed} failed${ends}`;
        at("told").className = failed > 0 ? "bad" : "";
    }

    // Runs the checks of one part. The next program compiles while one runs.
    async function runPart(checks) {
        const start = (check) =>
            check && state.device.unsupported(check) === "" ? state.device.begin(check) : null;
        let started = start(checks[0]);
        for (let i = 0; i < checks.length && !state.stop; ++i) {
            const next = start(checks[i + 1]);
            addResult(checks[i], started === null ? unsupported(checks[i])
                : await outcomeOf(state.device, checks[i], started));
            started = next;
            await gloam.pause();
            if (!state.device.isLost()) continue;
            state.device = await state.device.reopen();  // the checks that follow get a new context
            started = start(checks[i + 1]);
        }
    }

    async function run() {
        Object.assign(state, {running: true, stop: false, rows: []});
        state.table.clear();
        at("progress").max = gloam.site.checks;
        at("run").disabled = at("save").disabled = at("api").disabled = true;
        at("stop").disabled = false;
        for (const file of gloam.site.files) {
            if (state.stop) break;
            await gloam.loadScript(file);
            const [[part, checks]] = gloam.parts;
            await runPart(checks);
            gloam.parts.delete(part);  // frees the memory of its data
        }
        state.running = false;
        at("run").disabled = at("save").disabled = at("api").disabled = false;
        at("stop").disabled = true;
        tellProgress();
    }

    function save() {
        const blob = new Blob([gloam.results.file(state.device, state.rows)], {type: "application/json"});
        const link = gloam.element("a", {href: URL.createObjectURL(blob), download: `gloam-${at("api").value}.json`});
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    }

    function fail(error) {
        at("told").textContent = String(error.message);
        at("told").className = "bad";
        at("run").disabled = true;
    }

    // Opens the device of the chosen interface. Results of another one are no longer shown.
    async function choose() {
        at("run").disabled = at("save").disabled = true;
        state.rows = [];
        state.table.clear();
        at("told").textContent = "No check has run.";
        at("told").className = "";
        state.device = await (at("api").value === "webgpu" ? gloam.webgpu : gloam.kernel).open();
        at("gpu").textContent = `${state.device.renderer} (${state.device.version})`;
        at("run").disabled = false;
    }

    async function begin() {
        at("agent").textContent = navigator.userAgent;
        at("versions").textContent = gloam.site.versions;
        state.table = new gloam.Table(columns, "One line for each equation");
        at("results").append(state.table.root);
        at("run").addEventListener("click", () => run().catch(fail));
        at("stop").addEventListener("click", () => { state.stop = true; });
        at("save").addEventListener("click", save);
        at("filter").addEventListener("input", () => state.table.filter(at("filter").value));
        at("api").addEventListener("change", () => choose().catch(fail));
        const [webgpu] = [...at("api").options].filter((option) => option.value === "webgpu");
        gloam.webgpu.available().then((there) => { webgpu.disabled = !there; }, () => {});
        await choose();
    }

    document.addEventListener("DOMContentLoaded", () => begin().catch(fail));
    return {state};
})();
