// SPDX-License-Identifier: MIT
// The page that shows the effect: what its controls choose, and its loop of frames.
"use strict";

gloam.effectPage = (() => {
    const at = (id) => document.getElementById(id);
    const state = {effect: null, number: 0, forward: true, times: [], failed: false, keeping: 0,
        error: null};
    const framesKept = 128;
    const legends = ["", "White is open, black is occluded.",
        "Dark blue: no history. Yellow: the mean holds as many samples as it may.",
        "Samples in the mean, on a logarithmic scale: dark blue 0, yellow 1024 or more.",
        "The normal that faces the eye, as a colour.",
        "Dark blue: as in the kept picture. Yellow: the occlusion differs by 1/8 or more."];

    function option(value, text, selected) {
        const element = gloam.element("option", {value}, text);
        element.selected = selected;
        return element;
    }

    const presetNamed = (name) => gloam.effectData.presets.find((preset) => preset.name === name);
    const methodNamed = (name) => gloam.effectData.methods.find((method) => method.name === name);

    function fillControls() {
        for (const method of gloam.effectData.methods) at("method").append(option(method.name, method.name, false));
        for (const preset of gloam.effectData.presets) at("preset").append(option(preset.name, preset.name, false));
        at("preset").value = gloam.effectData.preset;
        at("method").value = "gtao";
        at("moves").checked = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    }

    // Applies the choice of method, preset and radius, and says what they are.
    function applyMethod() {
        state.keeping = 0;
        const method = methodNamed(at("method").value);
        const radius = state.effect.scene.radius * Number(at("radius").value);
        state.effect.setMethod(method, at("preset").value, radius);
        at("radius-told").textContent = radius.toPrecision(2);
        at("method-told").textContent = `${method.name}: ${method.description}.`;
        at("preset-told").textContent = `${at("preset").value}: ${presetNamed(at("preset").value).description}.`;
    }

    async function applyScene() {
        const name = at("scene").value;
        if (!gloam.scenes.has(name)) await gloam.loadScript(`scene-${name}.js`);
        state.effect.setScene(gloam.scenes.get(name));
        state.number = 0;
        forget();
    }

    function applySize() {
        const [width, height] = at("size").value.split("x").map(Number);
        state.effect.setSize(width, height);
        tellSides(null);
        state.keeping = 0;
    }

    // Starts the frames of a converged picture: the camera stands, and the mean takes every sample.
    function beginKeeping() {
        at("moves").checked = false;
        state.effect.forget();
        applyMethod();
        Object.assign(state.effect.settings, {weight_max: 1e6, filter: "none"});
        state.keeping = framesKept;
    }

    function endKeeping() {
        state.effect.keep();
        applyMethod();
        tellSides(`${at("method").value}, kept`);
    }

    function forget() {
        state.effect.forget();
        applyMethod();
        tellSides(null);
    }

    // What the sides of the slider show; kept: null where nothing is.
    function tellSides(kept) {
        at("left").textContent = kept ?? "without";
        at("right").textContent = kept === null ? "with" : "now";
        at("forget").disabled = kept === null;
    }

    // The next frame's camera: to the end of the path and back.
    function advance() {
        if (!at("moves").checked) return;
        const last = state.effect.scene.frames - 1;
        if (state.number >= last) state.forward = false;
        if (state.number <= 0) state.forward = true;
        state.number += state.forward ? 1 : -1;
    }

    function tellTime(now) {
        state.times.push(now);
        if (state.times.length > 31) state.times.shift();
        const steps = state.times.length - 1;
        if (steps < 1) return;
        const ms = (now - state.times[0]) / steps;
        const gpu = state.effect.timer.ms;
        at("told").textContent = [`${ms.toFixed(1)} ms from frame to frame`,
            ...(gpu === null ? [] : [`${gpu.toFixed(2)} ms of the GPU for the occlusion`]),
            state.keeping > 0 ? `${state.keeping} frames until the picture is kept`
                : `${state.effect.frames} frames since the last choice`,
            ...(state.error === null ? [] : [`error ${state.error.toFixed(4)} against the kept picture (RMSE)`]),
        ].join(", ");
    }

    // Reading the images back takes long: twice a second.
    function measureError(now) {
        const asked = state.effect.kept !== null && Number(at("view").value) === 5;
        if (!asked) state.error = null;
        else if (now - (state.measured ?? -1000) > 500) {
            state.error = state.effect.error();
            state.measured = now;
        }
    }

    function draw(now) {
        if (state.failed) return;
        if (!document.hidden && state.effect.scene) {
            advance();
            state.effect.frame(state.number);
            if (state.keeping > 0 && --state.keeping === 0) endKeeping();
            else measureError(now);
            if (state.effect.frames > 0) state.effect.show(Number(at("view").value), Number(at("split").value) / 100);
            tellTime(now);
        }
        requestAnimationFrame(draw);
    }

    function fail(error) {
        state.failed = true;
        at("told").textContent = String(error.message);
        at("told").className = "bad";
    }

    const guarded = (apply) => async () => {
        try {
            await apply();
        } catch (error) {
            fail(error);
        }
    };

    async function begin() {
        fillControls();
        state.effect = new gloam.Effect(at("canvas"));
        at("canvas").addEventListener("webglcontextlost", () => fail(new Error("the context was lost")));
        applySize();
        await applyScene();
        at("scene").addEventListener("change", guarded(applyScene));
        at("size").addEventListener("change", guarded(applySize));
        for (const id of ["method", "preset", "radius"]) at(id).addEventListener("input", guarded(applyMethod));
        at("preset").addEventListener("change", guarded(() => {
            at("method").value = presetNamed(at("preset").value).method;
            applyMethod();
        }));
        at("keep").addEventListener("click", guarded(beginKeeping));
        at("forget").addEventListener("click", guarded(forget));
        at("moves").addEventListener("change", guarded(() => { if (state.effect.kept !== null) forget(); }));
        at("view").addEventListener("input", () => { at("legend").textContent = legends[Number(at("view").value)]; });
        requestAnimationFrame(draw);
    }

    document.addEventListener("DOMContentLoaded", guarded(begin));
    return {state};
})();
