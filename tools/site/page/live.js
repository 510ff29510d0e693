// SPDX-License-Identifier: MIT
// The live effect: its controls, and its loop of frames.
"use strict";

gloam.live = (() => {
    const at = (id) => document.getElementById(id);
    const state = {picture: null, orbit: null, scene: null, number: 0, step: 1, times: [], fence: null, failed: false,
        stopped: false, changed: false};  // changed: the picture that stands since Stop is no longer that of the controls
    const mostWidth = 960;  // pixels of the picture

    async function applyScene() {
        const name = at("scene").value;
        const scene = await gloam.scene(name);
        if (name !== at("scene").value) return;  // another was chosen while it was loaded
        Object.assign(state, {scene, number: 0});
        state.orbit.pose = null;
        applySettings();
    }

    function applySettings() {
        const preset = gloam.effect.presets.find(({name}) => name === at("preset").value);
        const radius = state.scene.radius * Number(at("radius").value);
        state.picture.set(state.scene, preset.name, radius);
        at("radius-told").textContent = radius.toPrecision(2);
        at("preset-told").textContent = `${preset.name}: ${preset.description}.`;
    }

    // The camera where the path has it. The person takes it from there.
    function onPath() {
        at("moves").checked = false;
        return gloam.cameraAt(state.scene, state.number);
    }

    // The camera of the next frame: where the person has turned it, or on its path, to the end and back.
    function nextCamera() {
        if (at("moves").checked && !state.stopped) {
            state.orbit.pose = null;
            if (state.number + state.step < 0 || state.number + state.step >= state.scene.frames) state.step *= -1;
            state.number += state.step;
        }
        return state.orbit.pose === null ? gloam.cameraAt(state.scene, state.number) : state.orbit.camera;
    }

    function tellTime(now) {
        state.times = [...state.times.slice(-30), now];
        const ms = (now - state.times[0]) / Math.max(state.times.length - 1, 1);
        at("timing").textContent = `WebGL2: ${ms.toFixed(1)} ms from frame to frame, ` +
            `frame ${state.picture.occlusion.frames} since the last choice`;
    }

    // Whether the GPU still draws the last frame. A queue of frames on a slow one would stop the whole page.
    const isBusy = (gl) => state.fence !== null && gl.clientWaitSync(state.fence, 0, 0) === gl.TIMEOUT_EXPIRED;

    function draw(now) {
        if (state.failed) return;
        const {gl} = state.picture.passes;
        if (!document.hidden && !isBusy(gl) && (!state.stopped || state.changed)) {
            state.changed = false;
            state.picture.frame(nextCamera());
            state.picture.show(at("show").selectedIndex);
            gl.deleteSync(state.fence);
            state.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
            gl.flush();
            if (!state.stopped) tellTime(now);
        }
        requestAnimationFrame(guarded(draw));
    }

    // Stops the frames, or goes on. While they stand, a change of a control or of the view draws one.
    function toggle() {
        Object.assign(state, {stopped: !state.stopped, times: []});
        at("stop").textContent = state.stopped ? "Go on" : "Stop";
    }

    const change = () => { state.changed = true; };

    function fail(error) {
        state.failed = true;
        at("told").textContent = String(error.message);
        at("told").className = "bad";
    }

    const guarded = (apply) => async (argument) => {
        try {
            await apply(argument);
        } catch (error) {
            fail(error);
        }
    };

    async function beginPage() {
        at("scene").append(...gloam.sceneNames.map((name) => new Option(name)));
        at("preset").append(...gloam.effect.presets.map(({name}) => new Option(name)));
        at("preset").value = gloam.effect.preset;
        at("moves").checked = !matchMedia("(prefers-reduced-motion: reduce)").matches;
        const width = Math.min(at("canvas").clientWidth, mostWidth);
        state.picture = new gloam.Picture(at("canvas"), width, Math.round(width * 9 / 16));
        at("canvas").addEventListener("webglcontextlost", () => fail(new Error("the context was lost")));
        state.orbit = new gloam.Orbit(at("canvas"), onPath);
        await applyScene();
        at("told").textContent = "";
        at("scene").addEventListener("change", guarded(applyScene));
        for (const id of ["preset", "radius"]) at(id).addEventListener("input", guarded(applySettings));
        at("stop").addEventListener("click", toggle);
        at("controls").addEventListener("input", change);
        for (const event of ["pointermove", "wheel", "keydown"]) at("canvas").addEventListener(event, change);
        requestAnimationFrame(guarded(draw));
    }

    document.addEventListener("DOMContentLoaded", guarded(beginPage));
    return {state};
})();
