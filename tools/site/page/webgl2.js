// SPDX-License-Identifier: MIT
// Runs the passes of the page in WebGL2: those of the effect (Passes), the G-buffer of a mesh, and the canvas.
"use strict";

gloam.WebGl2 = class extends gloam.Passes {
    // Throws an Error where there is no WebGL2 or it cannot draw floats.
    static open(canvas) {
        const gl = canvas.getContext("webgl2", {antialias: false, depth: false, alpha: false,
            preserveDrawingBuffer: true, powerPreference: "high-performance"});
        if (gl === null) throw new Error("this browser has no WebGL2");
        return new gloam.WebGl2(gl);
    }

    constructor(gl) {
        super(gl);
        this.timer = new gloam.GpuTimer(gl);
        this.lost = new Promise((resolve) => gl.canvas.addEventListener("webglcontextlost", () =>
            resolve("the context was lost")));
    }

    // The canvas as what is drawn to.
    get screen() {
        const {width, height} = this.gl.canvas;
        return {framebuffer: null, width, height};
    }

    // Triangles, uploaded: {positions, normals, colors, indices}, as gloam.scene() gives them.
    mesh({positions, normals, colors, indices}) {
        const {gl} = this;
        const mesh = {vertices: gl.createVertexArray(), buffers: [], count: indices.length};
        gl.bindVertexArray(mesh.vertices);
        const filled = (target, data) => {
            const buffer = gl.createBuffer();
            gl.bindBuffer(target, buffer);
            gl.bufferData(target, data, gl.STATIC_DRAW);
            mesh.buffers.push(buffer);
        };
        const attribute = (index, data, size, type, normalized) => {
            filled(gl.ARRAY_BUFFER, data);
            gl.enableVertexAttribArray(index);
            gl.vertexAttribPointer(index, size, type, normalized, 0, 0);
        };
        attribute(0, positions, 3, gl.FLOAT, false);
        attribute(1, normals, 3, gl.FLOAT, false);
        attribute(2, colors, 4, gl.UNSIGNED_BYTE, true);
        filled(gl.ELEMENT_ARRAY_BUFFER, indices);
        gl.bindVertexArray(null);
        return mesh;
    }

    deleteMesh({vertices, buffers}) {
        for (const buffer of buffers) this.gl.deleteBuffer(buffer);
        this.gl.deleteVertexArray(vertices);
    }

    // A target that meshes can be drawn to: with a depth buffer.
    meshTarget(width, height, ...formats) {
        const {gl} = this;
        const target = this.target(width, height, ...formats);
        target.depthBuffer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, target.depthBuffer);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, target.depthBuffer);
        return target;
    }

    deleteTarget(target) {
        super.deleteTarget(target);
        this.gl.deleteRenderbuffer(target.depthBuffer ?? null);
    }

    // Clears such a target to 0 and draws a mesh to it.
    drawMesh(program, values, target, mesh) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
        target.images.forEach((_, i) => gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]));
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        this.use(program, values);
        gl.viewport(0, 0, target.width, target.height);
        gl.enable(gl.DEPTH_TEST);
        gl.bindVertexArray(mesh.vertices);
        gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(null);
        gl.disable(gl.DEPTH_TEST);
    }

    // Fills the only image of a target, of one channel, row 0 first.
    fill({image, width, height}, floats) {
        const {gl} = this;
        gl.bindTexture(gl.TEXTURE_2D, image);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RED, gl.FLOAT, floats);
    }

    // A new target with the same images.
    copyOf({framebuffer, width, height, formats}) {
        const {gl} = this;
        const copy = this.target(width, height, ...formats);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, copy.framebuffer);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
        return copy;
    }

};
