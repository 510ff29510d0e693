// SPDX-License-Identifier: MIT
// The effect on the first page: what its controls and its address choose, and its loop of frames.
"use strict";

gloam.live = (() => {
    const at = (id) => document.getElementById(id);
    const state = {effect: null, orbit: null, turned: false, number: 0, forward: true, times: [], failed: false,
        keeping: 0, error: null, left: "without"};
    const framesKept = 128;
    const steps = ["480x270", "960x540", "1920x1080"];  // sizes that the page tries where none is chosen
    const smooth = 20;  // ms from frame to frame
    const controls = ["scene", "preset", "method", "radius", "view", "size", "left", "split"];
    const lists = ["scene", "preset", "method", "view", "size", "left"];
    const views = {lit: "", visibility: "White is open, black is occluded.",
        convergence: "Dark blue: no history. Yellow: the mean holds as many samples as it may.",
        samples: "Samples in the mean, on a logarithmic scale: dark blue 0, yellow 1024 or more.",
        normals: "The normal that faces the eye, as a colour.",
        difference: "Dark blue: as on the left side. Yellow: the occlusion differs by 1/8 or more."};
    const viewNumber = () => Object.keys(views).indexOf(at("view").value);

    const presetNamed = (name) => gloam.effectData.presets.find((preset) => preset.name === name);
    const methodNamed = (name) => gloam.effectData.methods.find((method) => method.name === name);

    function fillControls() {
        for (const {name} of gloam.effectData.presets) at("preset").append(gloam.element("option", {}, name));
        for (const id of ["method", "left"])
            for (const {name} of gloam.effectData.methods) at(id).append(gloam.element("option", {}, name));
        at("preset").value = gloam.effectData.preset;
        at("method").value = presetNamed(gloam.effectData.preset).method;
        at("moves").checked = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    }

    // What the address may hold.
    function kinds() {
        const {oneOf, within, list} = gloam.address;
        const missing = ["kept", ...(gloam.effectData.truths.length === 0 ? ["truth"] : [])];
        const optionsOf = (id) => [...at(id).options].map(({value}) => value).filter((one) => !missing.includes(one));
        const ofRange = (id) => within(Number(at(id).min), Number(at(id).max));
        return {...Object.fromEntries(lists.map((id) => [id, oneOf(optionsOf(id))])),
            radius: ofRange("radius"), split: ofRange("split"), camera: list(6)};
    }

    // Sets the controls to what the address holds.
    function readAddress(hash) {
        const {values, problems} = gloam.address.read(hash.slice(1), kinds());
        for (const id of controls) if (id in values) at(id).value = values[id];
        if ("preset" in values && !("method" in values)) at("method").value = presetNamed(values.preset).method;
        at("told").textContent = problems.join("; ");
        return values.camera;
    }

    function writeAddress() {
        const values = Object.fromEntries(controls.map((id) => [id, at(id).value]));
        if (values.left === "kept") delete values.left;  // nobody else has it
        if (state.turned) values.camera = state.orbit.numbers;
        const hash = "#" + gloam.address.write(values);
        if (hash !== location.hash) history.replaceState(null, "", hash);
    }

    const radiusNow = () => state.effect.scene.radius * Number(at("radius").value);

    // Applies the choice of method, preset and radius, and says what they are.
    async function applyMethod() {
        const name = at("method").value;
        const method = await gloam.method(name);
        if (name !== at("method").value) return;  // another was chosen while it was loaded
        state.keeping = 0;
        const radius = radiusNow();
        state.effect.setMethod(method, at("preset").value, radius);
        at("radius-told").textContent = radius.toPrecision(2);
        at("method-told").textContent = `${name}: ${methodNamed(name).description}.`;
        at("preset-told").textContent = `${at("preset").value}: ${presetNamed(at("preset").value).description}.`;
        if (methodNamed(at("left").value)) await applyLeft();
        await showSource();
    }

    // The source text of the method, once the person has asked for one.
    async function showSource() {
        if (at("source").open) await state.source.open(at("method").value);
    }

    async function applyScene() {
        const name = at("scene").value;
        const scene = await gloam.scene(name);
        if (name !== at("scene").value) return;
        at("truth").disabled = !gloam.effectData.truths.includes(name);  // a site without pictures has none
        const lost = at("left").value === "kept" || (at("left").value === "truth" && at("truth").disabled);
        if (lost) at("left").value = "without";
        state.effect.setScene(scene);
        state.orbit.setScene(scene);
        state.turned = false;
        state.number = 0;
        await applyMethod();
        await applyLeft();
    }

    async function applySize() {
        if (at("size").value !== "auto") return setSize(at("size").value);
        state.step = 0;
        await setSize(steps[0]);
    }

    // Where the size follows the speed: a step up while frames are short and the picture is drawn larger than it is. A
    // kept picture and truth have their own size, which stays.
    async function grow() {
        if (at("size").value !== "auto" || state.times.length < 31 || state.keeping > 0) return;
        const next = steps[state.step + 1];
        const shown = at("canvas").clientWidth * devicePixelRatio;
        const fixed = ["kept", "truth"].includes(at("left").value);
        if (next === undefined || fixed || shown < 1.2 * at("canvas").width || state.ms > smooth) return;
        ++state.step;
        await setSize(next);
    }

    async function setSize(size) {
        const [width, height] = size.split("x").map(Number);
        state.effect.setSize(width, height);
        state.times = [];
        state.keeping = 0;
        if (state.effect.scene) await applyLeft();
    }

    // Starts the frames of a converged picture: the camera stands, and the mean takes every sample.
    async function beginKeeping() {
        at("moves").checked = false;
        await applyMethod();
        Object.assign(state.effect.settings, {weight_max: 1e6, filter: "none"});
        state.keeping = framesKept;
    }

    async function endKeeping() {
        state.effect.setLeft(null);
        state.effect.keep();
        await applyMethod();
        at("kept").disabled = false;
        tellLeft("kept", `${at("method").value}, kept`);
    }

    // Applies the choice of what stands on the left: a kept picture stays, everything else is made here.
    async function applyLeft() {
        const name = at("left").value;
        const {images, scene} = state.effect;
        const method = methodNamed(name) ? await gloam.method(name) : null;
        const truth = name === "truth" ? await gloam.truth(scene.name, images) : null;
        const stale = name !== at("left").value || images !== state.effect.images || scene !== state.effect.scene;
        if (stale) return;  // another was chosen while it was loaded
        state.effect.setLeft(method, at("preset").value, radiusNow());
        if (name === "kept" && state.effect.kept !== null) return;
        state.effect.forget();
        at("kept").disabled = true;
        if (truth !== null) {
            standStill();
            state.effect.keepOcclusion(truth.occlusion);
        }
        tellLeft(name === "kept" ? "without" : name, truth === null ? name : `${truth.told}, radius ${scene.radius}`);
    }

    function tellLeft(name, told) {
        at("left").value = name;
        at("left-told").textContent = told;
        at("right-told").textContent = name === "without" ? "with" : at("method").value;
        if (name !== "without" && name !== state.left && Number(at("split").value) === 0) at("split").value = 50;
        state.left = name;
    }

    // The view that truth was traced for: the first of the path.
    function standStill() {
        at("moves").checked = false;
        state.turned = false;
        state.number = 0;
    }

    // What was made for one view no longer holds.
    async function leaveView() {
        if (!["kept", "truth"].includes(at("left").value)) return;
        at("left").value = "without";
        await applyLeft();
    }

    // The person takes the camera from its path.
    function take() {
        at("moves").checked = false;
        guarded(leaveView)();
        if (!state.turned) state.orbit.take(gloam.camera.at(state.effect.scene.cameras, state.number));
        state.turned = true;
    }

    // The camera of the next frame: where the person has turned it, or on its path, to the end and back.
    function nextCamera() {
        if (state.turned) return state.orbit.camera;
        if (at("moves").checked) {
            const last = state.effect.scene.frames - 1;
            if (state.number >= last) state.forward = false;
            if (state.number <= 0) state.forward = true;
            state.number += state.forward ? 1 : -1;
        }
        return gloam.camera.at(state.effect.scene.cameras, state.number);
    }

    function tellTime(now) {
        state.times.push(now);
        if (state.times.length > 31) state.times.shift();
        const count = state.times.length - 1;
        if (count < 1) return;
        state.ms = (now - state.times[0]) / count;
        const gpu = state.effect.passes.timer.ms;
        at("timing").textContent = [`WebGL2: ${state.ms.toFixed(1)} ms from frame to frame`,
            ...(gpu === null ? [] : [`${gpu.toFixed(2)} ms of the GPU for the occlusion`]),
            state.keeping > 0 ? `${state.keeping} frames until the picture is kept`
                : `${state.effect.frames} frames since the last choice`,
            ...(state.error === null ? []
                : [`error ${state.error.toFixed(4)} against ${at("left-told").textContent} (RMSE)`]),
        ].join(", ");
    }

    // Reading the images back takes long: twice a second.
    async function measureError(now) {
        const {effect} = state;
        const asked = effect.compared !== null && at("view").value === "difference";
        if (!asked) state.error = null;
        else if (now - (state.measured ?? -1000) > 500) {
            state.measured = now;
            state.error = await effect.error();
        }
    }

    // Browsers refuse changes of the address that follow too fast.
    function keepAddress(now) {
        if (now - (state.written ?? 0) < 500) return;
        state.written = now;
        writeAddress();
    }

    async function draw(now) {
        if (state.failed) return;
        if (!document.hidden && state.effect.settings !== null) {
            state.effect.frame(nextCamera());
            if (state.keeping > 0 && --state.keeping === 0) await endKeeping();
            else guarded(measureError)(now);
            if (state.effect.frames > 0) state.effect.show(viewNumber(), Number(at("split").value) / 100);
            tellTime(now);
            keepAddress(now);
            await grow();
        }
        requestAnimationFrame(guarded(draw));
    }

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

    function listen() {
        at("scene").addEventListener("change", guarded(applyScene));
        at("size").addEventListener("change", guarded(applySize));
        for (const id of ["method", "preset", "radius"]) at(id).addEventListener("input", guarded(applyMethod));
        at("preset").addEventListener("change", guarded(async () => {
            at("method").value = presetNamed(at("preset").value).method;
            await applyMethod();
        }));
        at("keep").addEventListener("click", guarded(beginKeeping));
        at("left").addEventListener("change", guarded(applyLeft));
        at("moves").addEventListener("change", guarded(async () => {
            if (at("moves").checked) state.turned = false;
            await leaveView();
        }));
        at("view").addEventListener("input", () => { at("legend").textContent = views[at("view").value]; });
        at("source").addEventListener("toggle", guarded(showSource));
        // The address may have been written again since the event.
        addEventListener("hashchange", guarded((event) => restore(new URL(event.newURL).hash)));
    }

    // Applies all that the address holds.
    async function restore(hash) {
        const camera = readAddress(hash);
        await applySize();
        at("legend").textContent = views[at("view").value];
        await applyScene();
        if (camera === undefined) return;
        take();
        state.orbit.numbers = camera;
    }

    async function beginPage() {
        fillControls();
        state.effect = new gloam.Effect(at("canvas"));
        state.effect.passes.lost.then((why) => fail(new Error(why)));
        state.orbit = new gloam.Orbit(at("canvas"), take);
        state.source = new gloam.Source();
        at("source").append(state.source.root);
        await restore(location.hash);
        listen();
        requestAnimationFrame(guarded(draw));
    }

    document.addEventListener("DOMContentLoaded", guarded(beginPage));
    return {state};
})();
