// SPDX-License-Identifier: MIT
// A scene with its occlusion: draws depth, normals and colours, gives them to AmbientOcclusion as an engine does, and
// shows the result.
"use strict";

gloam.Picture = class {
    constructor(canvas, width, height) {
        const gl = canvas.getContext("webgl2", {antialias: false, depth: false, alpha: false,
            powerPreference: "high-performance"});
        if (gl === null) throw new Error("this browser has no WebGL2");
        Object.assign(canvas, {width, height});
        this.passes = new gloam.Passes(gl);
        this.occlusion = new gloam.AmbientOcclusion(gl, gloam.effect, {depth: "linear", normals: "view"});
        this.occlusion.setSize(width, height);
        const {gbuffer_vertices, gbuffer, show} = gloam.shaders;
        this.gbuffer = this.passes.program("gbuffer", gbuffer_vertices, gbuffer);
        this.shower = this.passes.program("show", gloam.effect.whole_image, show);
        this.target = this.passes.target([width, height], ["R32F", "RGBA32F", "RGBA8"].map((format) =>
            this.passes.image(format, [width, height])));
        const depth = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
        this.meshes = new Map();
    }

    // scene: as gloam.scene() gives one. preset: a name. radius: world units. Begins a new history.
    set(scene, preset, radius) {
        if (!this.meshes.has(scene)) this.meshes.set(scene, this.uploaded(scene));
        this.scene = scene;
        this.occlusion.setPreset(preset, radius);
    }

    // The triangles of a scene. A vertex is its position and its normal, three floats each, and four bytes of colour.
    uploaded({vertices, indices}) {
        const {gl} = this.passes;
        const mesh = gl.createVertexArray();
        gl.bindVertexArray(mesh);
        for (const [target, data] of [[gl.ARRAY_BUFFER, vertices], [gl.ELEMENT_ARRAY_BUFFER, indices]]) {
            gl.bindBuffer(target, gl.createBuffer());
            gl.bufferData(target, data, gl.STATIC_DRAW);
        }
        [[3, gl.FLOAT, false], [3, gl.FLOAT, false], [4, gl.UNSIGNED_BYTE, true]].forEach((attribute, i) => {
            gl.enableVertexAttribArray(i);
            gl.vertexAttribPointer(i, ...attribute, 28, 12 * i);
        });
        gl.bindVertexArray(null);
        return mesh;
    }

    // Renders a frame. camera: as gloam.cameraAt() gives it.
    frame(camera) {
        const {width, height, images: [depth, normal]} = this.target;
        const view = gloam.viewOf(camera);
        const projection = gloam.projectionOf(this.scene, width / height);
        this.up = view.slice(4, 7);
        this.drawGbuffer({view, projection});
        this.result = this.occlusion.render({depth, normal, projection, view});
    }

    drawGbuffer(values) {
        const {passes, target} = this;
        const {gl} = passes;
        passes.begin();
        passes.use(this.gbuffer, values);
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
        gl.viewport(0, 0, target.width, target.height);
        target.images.forEach((_, i) => gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]));
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        gl.enable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.meshes.get(this.scene));
        gl.drawElements(gl.TRIANGLES, this.scene.indices.length, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(null);
    }

    // Draws the last frame to the canvas. shown: as show.frag numbers it.
    show(shown) {
        const {width, height, images: [depth_image, normal_image, albedo_image]} = this.target;
        this.passes.begin();
        this.passes.draw(this.shower, {depth_image, normal_image, albedo_image, occlusion_image: this.result,
            height, shown, up: this.up}, {framebuffer: null, width, height});
    }
};
