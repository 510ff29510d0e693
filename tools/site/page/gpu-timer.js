// SPDX-License-Identifier: MIT
// Times of the GPU, where the browser gives them (EXT_disjoint_timer_query_webgl2).
"use strict";

gloam.GpuTimer = class {
    constructor(gl) {
        this.gl = gl;
        this.extension = gl.getExtension("EXT_disjoint_timer_query_webgl2");
        this.asked = [];
        this.ms = null;  // of the last work whose time is known
    }

    // Runs work and asks for its time, which is known some frames later.
    measure(work) {
        const {gl, extension} = this;
        if (extension === null) {
            work();
            return;
        }
        const query = gl.createQuery();
        gl.beginQuery(extension.TIME_ELAPSED_EXT, query);
        work();
        gl.endQuery(extension.TIME_ELAPSED_EXT);
        this.asked.push(query);
        this.collect();
    }

    collect() {
        const {gl, extension} = this;
        while (this.asked.length > 0 && gl.getQueryParameter(this.asked[0], gl.QUERY_RESULT_AVAILABLE)) {
            const query = this.asked.shift();
            // Something else has disturbed the clock: the time says nothing.
            const disturbed = gl.getParameter(extension.GPU_DISJOINT_EXT);
            if (!disturbed) this.ms = gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6;
            gl.deleteQuery(query);
        }
    }
};
