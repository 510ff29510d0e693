// SPDX-License-Identifier: MIT
// The temporal effect on the scenes of the site: G-buffer, occlusion (gloam.AmbientOcclusion), what is shown of them.
// The shaders and the settings are those of the repository, in gloam.effectData.
"use strict";

gloam.Effect = class {
    // Throws an Error where there is no WebGL2 or it cannot draw floats.
    constructor(canvas) {
        this.gl = canvas.getContext("webgl2", {antialias: false, depth: false, alpha: false,
            preserveDrawingBuffer: true, powerPreference: "high-performance"});
        if (this.gl === null) throw new Error("this browser has no WebGL2");
        this.canvas = canvas;
        this.data = gloam.effectData;
        this.occlusion = this.newOcclusion();
        this.passes = this.occlusion.passes;
        this.gbuffer = this.passes.program("gbuffer", this.data.gbuffer, {}, this.data.gbuffer_vertices);
        this.shower = this.passes.program("show", this.data.show);
        this.timer = new gloam.GpuTimer(this.gl);
        this.images = null;
        this.kept = null;
        this.left = null;
        this.mesh = null;
        this.buffers = [];
    }

    newOcclusion() {
        return new gloam.AmbientOcclusion(this.gl, this.data, {depth: "linear", normals: "view"});
    }

    // Settings of the method, in use until setMethod() is called again.
    get settings() {
        return this.occlusion.settings;
    }

    // Frames since the history began.
    get frames() {
        return this.occlusion.frames;
    }

    // Uploads a scene: {positions, normals, colors, indices, ...}, as gloam.scene() gives one.
    setScene(scene) {
        const {gl} = this;
        this.deleteScene();
        this.scene = scene;
        this.mesh = gl.createVertexArray();
        gl.bindVertexArray(this.mesh);
        const filled = (target, data) => {
            const buffer = gl.createBuffer();
            gl.bindBuffer(target, buffer);
            gl.bufferData(target, data, gl.STATIC_DRAW);
            this.buffers.push(buffer);
        };
        const attribute = (index, data, size, type, normalized) => {
            filled(gl.ARRAY_BUFFER, data);
            gl.enableVertexAttribArray(index);
            gl.vertexAttribPointer(index, size, type, normalized, 0, 0);
        };
        attribute(0, scene.positions, 3, gl.FLOAT, false);
        attribute(1, scene.normals, 3, gl.FLOAT, false);
        attribute(2, scene.colors, 4, gl.UNSIGNED_BYTE, true);
        filled(gl.ELEMENT_ARRAY_BUFFER, scene.indices);
        gl.bindVertexArray(null);
        this.restart();
    }

    deleteScene() {
        for (const buffer of this.buffers) this.gl.deleteBuffer(buffer);
        this.gl.deleteVertexArray(this.mesh);
        this.buffers = [];
    }

    // method: as gloam.method() gives one. preset: a name. radius: world units.
    setMethod(method, preset, radius) {
        this.occlusion.setMethod(method, preset, radius);
    }

    // Another method on the left side, with a history of its own; null: none. The rest as for setMethod().
    setLeft(method, preset, radius) {
        if (method === null) {
            this.left?.dispose();
            this.left = null;
            return;
        }
        if (this.left === null) {
            this.left = this.newOcclusion();
            this.left.setSize(this.images.width, this.images.height);
        }
        this.left.setMethod(method, preset, radius);
    }

    setSize(width, height) {
        const {gl} = this;
        if (this.images !== null) this.deleteImages();
        this.canvas.width = width;
        this.canvas.height = height;
        this.images = this.passes.target(width, height, gl.R32F, gl.RGBA32F, gl.RGBA8);
        [this.images.depth, this.images.normal, this.images.albedo] = this.images.images;
        const buffer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, buffer);
        this.images.buffer = buffer;
        this.occlusion.setSize(width, height);
        this.left?.setSize(width, height);
    }

    deleteImages() {
        this.gl.deleteRenderbuffer(this.images.buffer);
        this.passes.deleteTarget(this.images);
        this.forget();
    }

    // The image to keep in.
    keeping() {
        this.kept ??= this.passes.target(this.images.width, this.images.height, this.gl.R32F);
        return this.kept;
    }

    // Keeps occlusion from elsewhere, a float for each pixel, to compare with.
    keepOcclusion(floats) {
        const {gl} = this;
        const {width, height} = this.images;
        gl.bindTexture(gl.TEXTURE_2D, this.keeping().image);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RED, gl.FLOAT, floats);
    }

    // Keeps a copy of the last frame's occlusion, to compare with what follows.
    keep() {
        const {gl} = this;
        const {width, height} = this.keeping();
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.occlusion.result.framebuffer);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.kept.framebuffer);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }

    forget() {
        if (this.kept === null) return;
        this.passes.deleteTarget(this.kept);
        this.kept = null;
    }

    // What stands on the left side: the occlusion of its method, or the kept image; null: no occlusion.
    get compared() {
        return this.left?.result ?? this.kept;
    }

    // The root of the mean squared difference between the occlusion of the last frame and that of the left side, over
    // the pixels that show geometry; null where the left side has none.
    error() {
        if (this.compared === null) return null;
        const [now, kept, depth] = [this.occlusion.result, this.compared, this.images]
            .map((one) => this.passes.read(one));
        let sum = 0;
        let count = 0;
        for (let i = 0; i < now.length; i += 4) {
            if (!(depth[i] > 0)) continue;
            sum += (now[i] - kept[i]) ** 2;
            ++count;
        }
        return Math.sqrt(sum / Math.max(count, 1));
    }

    // Forgets the history.
    restart() {
        this.occlusion.restart();
        this.left?.restart();
    }

    projection() {
        const {fovy, near, far} = this.scene;
        return gloam.camera.projection(fovy, this.images.width / this.images.height, near, far);
    }

    // Renders a frame: the samples are added to the history of the frame before, which is moved where the camera has.
    // camera: as gloam.camera.at() gives it.
    frame(camera) {
        this.camera = camera;
        const view = gloam.camera.view(camera);
        const projection = this.projection();
        this.drawGbuffer(view, projection);
        const {depth, normal} = this.images;
        this.timer.measure(() => this.occlusion.render({depth, normal, projection, view}));
        this.left?.render({depth, normal, projection, view});
    }

    drawGbuffer(view, projection) {
        const {gl, images, passes} = this;
        passes.begin();
        gl.bindFramebuffer(gl.FRAMEBUFFER, images.framebuffer);
        for (let i = 0; i < 3; ++i) gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        passes.use(this.gbuffer, {view, projection});
        gl.viewport(0, 0, images.width, images.height);
        gl.enable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.mesh);
        gl.drawElements(gl.TRIANGLES, this.scene.indices.length, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(null);
    }

    // Draws the last frame to the canvas. view: as show.frag numbers them. split: part of the width, from the left,
    // with what stands on the left side.
    show(view, split) {
        const {images} = this;
        const {width, height} = images;
        const {rotation} = this.camera;
        const {history, result} = this.occlusion;
        this.passes.begin();
        this.passes.draw(this.shower, {depth_image: images.depth, normal_image: images.normal,
            albedo_image: images.albedo, occlusion_image: result.image, history_image: history.image,
            kept_image: (this.compared ?? result).image, has_kept: this.compared !== null, size: [width, height],
            shown: view, weight_max: this.settings.weight_max,
            split: Math.round(split * width), up: [rotation[1], rotation[4], rotation[7]]},
        {framebuffer: null, width, height});
    }

    // The history of the last frame, four floats for each of its pixels, the top row first: occlusion, samples
    // accumulated, samples of the sequence used, depth.
    read() {
        return this.occlusion.readHistory();
    }

    // The occlusion that is shown of the last frame, one float for each pixel, the top row first.
    readOcclusion() {
        return this.occlusion.readOcclusion();
    }
};
