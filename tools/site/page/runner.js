// SPDX-License-Identifier: MIT
// Runs kernels in a worker (worker/worker.js), each within a time. A worker that does not answer is ended and replaced.
"use strict";

gloam.runner = (() => {
    // Seconds that the worker has for one request. The slowest check takes 1/50 of it over SwiftShader.
    const limits = {open: 30, evaluate: 20};

    // Why there is no result. reason: "hang", "device lost", "stopped" or "error".
    class RunError extends Error {
        constructor(message, reason) {
            super(message);
            this.reason = reason;
        }
    }

    // A page of file:// may start a worker from its own memory only.
    const startWorker = () =>
        new Worker(URL.createObjectURL(new Blob([gloam.workerText], {type: "text/javascript"})));

    // The GPU.
    class Runner {
        constructor() {
            this.worker = null;
            this.stopRequest = null;  // while the worker has one
        }

        // Opens the GPU unless it is open. `facts` holds what is reported of it. Throws a RunError.
        async open() {
            if (this.worker !== null) return;
            this.worker = startWorker();
            try {
                this.facts = await this.ask("open");
            } catch (error) {
                this.end();
                throw error;
            }
        }

        // Runs the kernel of a check on its decoded scenarios: {outputs, fault} of each. The GPU is open. Throws a
        // RunError; where its reason is not "error", the GPU is no longer open.
        async evaluate(check, scenarios) {
            const {row, targets, outputs} = check;
            const inputs = scenarios.map((data) => ({count: data.count, inputs: data.inputs, images: data.images}));
            try {
                return await this.ask("evaluate",
                    {check: {text: check.kernel, row, targets, outputs}, scenarios: inputs});
            } catch (error) {
                if (error.reason !== "error") this.end();
                throw error;
            }
        }

        // Ends the worker, and what it does.
        end() {
            this.stopRequest?.(new RunError("stopped", "stopped"));
            this.worker?.terminate();
            this.worker = null;
        }

        ask(request, argument) {
            return new Promise((resolve, reject) => {
                const seconds = limits[request];
                const timer = setTimeout(() => this.stopRequest(
                    new RunError(`the browser did not answer within ${seconds} s`, "hang")), seconds * 1000);
                const settle = (done) => (value) => {
                    clearTimeout(timer);
                    this.stopRequest = null;
                    done(value);
                };
                this.stopRequest = settle(reject);
                const answer = ({data}) => "value" in data ? settle(resolve)(data.value)
                    : this.stopRequest(new RunError(data.error, data.lost ? "device lost" : "error"));
                this.worker.onmessage = answer;
                this.worker.onerror = (event) =>
                    answer({data: {error: event.message || "the worker did not start", lost: true}});
                this.worker.postMessage({request, argument});
            });
        }
    }

    return {limits, Runner};
})();
