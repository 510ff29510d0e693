// SPDX-License-Identifier: MIT
// The APIs in which the effect of the first page runs. What one of them needs is loaded when it is first used.
"use strict";

gloam.api = (() => {
    const titles = {webgl2: "WebGL2", webgpu: "WebGPU"};
    const scripts = {webgl2: ["gpu-timer.js", "webgl2.js"], webgpu: ["webgpu.js"]};
    const openers = {webgl2: (canvas) => gloam.WebGl2.open(canvas), webgpu: (canvas) => gloam.WebGpu.open(canvas)};
    const loaded = new Map();

    // WebGPU, where there is one.
    async function best() {
        return await navigator.gpu?.requestAdapter() ? "webgpu" : "webgl2";
    }

    function load(script) {
        if (!loaded.has(script)) loaded.set(script, gloam.loadScript(script));
        return loaded.get(script);
    }

    // The effect on a canvas that has had no context. Throws an Error where the browser does not have the API.
    async function effect(api, canvas) {
        await Promise.all([...scripts[api], `passes-${api}.js`].map(load));
        return new gloam.Effect(canvas, await openers[api](canvas), gloam.passes.get(api));
    }

    return {titles, best, effect};
})();
