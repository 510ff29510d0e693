// SPDX-License-Identifier: MIT
// What runs in a worker of the page that checks this browser: it opens the GPU and evaluates kernels, so that a driver
// that does not return does not stop the page. Its script is all files of this folder, in the order of their names; the
// page's side is runner.js.
"use strict";

gloam.serve = (() => {
    let device = null;

    const requests = {
        // Opens the device. Returns what is reported of the GPU.
        open() {
            device = gloam.kernel.open();
            return device.facts;
        },

        // Runs a kernel on the inputs of each scenario. Returns {outputs, fault} of each.
        evaluate({check, scenarios}) {
            const program = device.compile(check.text);
            const results = scenarios.map((data) => device.run(program, check, data));
            device.drop(program);
            return results;
        }
    };

    // Answers a message {request, argument} with {value} or with {error, lost}.
    return ({data}) => {
        try {
            postMessage({value: requests[data.request](data.argument)});
        } catch (error) {
            postMessage({error: String(error.message), lost: device !== null && device.isLost()});
        }
    };
})();

addEventListener("message", gloam.serve);
