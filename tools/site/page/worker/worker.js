// SPDX-License-Identifier: MIT
// What runs in a worker of the page that checks this browser: it opens the GPU and evaluates kernels, so that a driver
// that does not return does not stop the page. Its script is all files of this folder, in the order of their names; the
// page's side is runner.js.
"use strict";

gloam.serve = (() => {
    let device = null;

    const requests = {
        // Opens the device of an interface, "webgl2" or "webgpu". Returns what is reported of the GPU.
        async open(name) {
            device = await (name === "webgpu" ? gloam.webgpu : gloam.kernel).open();
            return device.facts;
        },

        // Runs a kernel on the inputs of each scenario. Returns {outputs, fault} of each.
        async evaluate({check, scenarios}) {
            const program = await device.compile(check.text);
            const results = [];
            for (const data of scenarios) results.push(await device.run(program, check, data));
            device.drop(program);
            return results;
        }
    };

    // Answers a message {request, argument} with {value} or with {error, lost}.
    return async ({data}) => {
        try {
            postMessage({value: await requests[data.request](data.argument)});
        } catch (error) {
            // A lost device of WebGPU says so after the error.
            await new Promise((resolve) => setTimeout(resolve, 100));
            postMessage({error: String(error.message), lost: device !== null && device.isLost()});
        }
    };
})();

addEventListener("message", gloam.serve);
