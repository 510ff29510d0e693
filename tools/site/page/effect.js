// SPDX-License-Identifier: MIT
// The temporal effect in WebGL2: G-buffer, history moved along the camera, one method's samples, what is shown of them.
// The shaders and the settings are those of the repository, in gloam.effectData.
"use strict";

gloam.scenes = new Map();

gloam.Effect = class {
    // Throws an Error where there is no WebGL2 or it cannot draw floats.
    constructor(canvas) {
        this.gl = canvas.getContext("webgl2", {antialias: false, depth: false, alpha: false,
            preserveDrawingBuffer: true, powerPreference: "high-performance"});
        if (this.gl === null) throw new Error("this browser has no WebGL2");
        if (this.gl.getExtension("EXT_color_buffer_float") === null)
            throw new Error("this GPU cannot draw to textures of floats (EXT_color_buffer_float)");
        this.canvas = canvas;
        this.data = gloam.effectData;
        this.programs = new Map();
        this.gbuffer = this.program("gbuffer", this.data.gbuffer_vertices, this.data.gbuffer);
        this.reproject = this.program("reproject", gloam.Effect.wholeImage, this.data.reproject);
        this.shower = this.program("show", gloam.Effect.wholeImage, this.data.show);
        this.timer = new gloam.GpuTimer(this.gl);
        this.images = null;
        this.kept = null;
        this.restart();
    }

    static wholeImage = `#version 300 es
void main() {
    gl_Position = vec4(vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0), 0.0, 1.0);
}`;

    // A linked program with its uniforms' locations by name; compiled once.
    program(name, vertices, fragments) {
        if (this.programs.has(name)) return this.programs.get(name);
        const {gl} = this;
        const handle = gl.createProgram();
        const stages = [[gl.VERTEX_SHADER, vertices], [gl.FRAGMENT_SHADER, fragments]].map(([stage, text]) => {
            const shader = gl.createShader(stage);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(handle, shader);
            return shader;
        });
        gl.linkProgram(handle);
        if (!gl.getProgramParameter(handle, gl.LINK_STATUS))
            throw new Error(`${name} does not compile: ${stages.map((s) => gl.getShaderInfoLog(s)).join(" ")}`);
        const count = gl.getProgramParameter(handle, gl.ACTIVE_UNIFORMS);
        const uniforms = Array.from({length: count}, (_, i) => gl.getActiveUniform(handle, i));
        const program = {handle, uniforms, at: (uniform) => gl.getUniformLocation(handle, uniform)};
        this.programs.set(name, program);
        return program;
    }

    // Uploads a scene of gloam.scenes.
    setScene(scene) {
        const {gl} = this;
        this.scene = {...scene, cameras: gloam.doubles(scene.cameras), count: 3 * scene.triangles};
        this.mesh = gl.createVertexArray();
        gl.bindVertexArray(this.mesh);
        const attribute = (index, text, size, type, normalized) => {
            gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ARRAY_BUFFER, gloam.bytes(text), gl.STATIC_DRAW);
            gl.enableVertexAttribArray(index);
            gl.vertexAttribPointer(index, size, type, normalized, 0, 0);
        };
        attribute(0, scene.positions, 3, gl.FLOAT, false);
        attribute(1, scene.normals, 3, gl.FLOAT, false);
        attribute(2, scene.colors, 4, gl.UNSIGNED_BYTE, true);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, gloam.bytes(scene.indices), gl.STATIC_DRAW);
        gl.bindVertexArray(null);
        this.restart();
    }

    // method: of effectData.methods. preset: a name. radius: world units; settings that are lengths scale with it.
    setMethod(method, preset, radius) {
        const settings = {...method.settings[preset]};
        for (const name of this.data.lengths) settings[name] *= radius;
        this.settings = settings;
        this.occlusion = this.program("occlusion by " + method.name, gloam.Effect.wholeImage, method.text);
        this.restart();
    }

    image(internal, width, height) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
            gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        return texture;
    }

    framebuffer(...textures) {
        const {gl} = this;
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        textures.forEach((texture, i) =>
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0));
        gl.drawBuffers(textures.map((texture, i) => gl.COLOR_ATTACHMENT0 + i));
        return framebuffer;
    }

    // A history: its image and what draws to it.
    history(width, height) {
        const image = this.image(this.gl.RGBA32F, width, height);
        return {image, framebuffer: this.framebuffer(image)};
    }

    setSize(width, height) {
        const {gl} = this;
        if (this.images !== null) this.deleteImages();
        this.canvas.width = width;
        this.canvas.height = height;
        const depth = this.image(gl.R32F, width, height);
        const normal = this.image(gl.RGBA32F, width, height);
        const albedo = this.image(gl.RGBA8, width, height);
        const framebuffer = this.framebuffer(depth, normal, albedo);
        const buffer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, buffer);
        this.images = {width, height, depth, normal, albedo, framebuffer, buffer,
            before: this.history(width, height), moved: this.history(width, height),
            after: this.history(width, height)};
        this.restart();
    }

    deleteImages() {
        const {gl, images} = this;
        for (const texture of [images.depth, images.normal, images.albedo]) gl.deleteTexture(texture);
        for (const history of [images.before, images.moved, images.after]) {
            gl.deleteTexture(history.image);
            gl.deleteFramebuffer(history.framebuffer);
        }
        gl.deleteRenderbuffer(images.buffer);
        gl.deleteFramebuffer(images.framebuffer);
        this.forget();
    }

    // Keeps a copy of the last frame's history, to compare with what follows.
    keep() {
        const {gl, images} = this;
        const {width, height} = images;
        this.kept ??= this.history(width, height);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, images.after.framebuffer);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.kept.framebuffer);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }

    forget() {
        if (this.kept === null) return;
        this.gl.deleteTexture(this.kept.image);
        this.gl.deleteFramebuffer(this.kept.framebuffer);
        this.kept = null;
    }

    // The root of the mean squared difference between the occlusion of the last frame and the kept one, over the pixels
    // that show geometry; null where nothing is kept.
    error() {
        if (this.kept === null) return null;
        const now = this.read();
        const kept = this.read(this.kept);
        let sum = 0;
        let count = 0;
        for (let i = 0; i < now.length; i += 4) {
            if (!Number.isFinite(now[i + 3])) continue;
            sum += (now[i] - kept[i]) ** 2;
            ++count;
        }
        return Math.sqrt(sum / Math.max(count, 1));
    }

    // Forgets the history.
    restart() {
        this.previous = null;
        this.frames = 0;
    }

    projection() {
        const {fovy, near, far} = this.scene;
        return gloam.camera.projection(fovy, this.images.width / this.images.height, near, far);
    }

    // Renders a frame: the samples are added to the history of the frame before, which is moved where the camera has.
    frame(number) {
        const camera = gloam.camera.at(this.scene.cameras, number);
        this.gl.disable(this.gl.BLEND);
        this.gl.viewport(0, 0, this.images.width, this.images.height);
        this.drawGbuffer(camera);
        const {images} = this;
        [images.before, images.after] = [images.after, images.before];
        let {before} = images;
        if (this.previous === null) this.clear(before);
        else if (this.previous.number !== number) before = this.moveHistory(camera);
        this.timer.measure(() => this.drawOcclusion(before));
        this.previous = {number, camera};
        ++this.frames;
    }

    clear(history) {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, history.framebuffer);
        this.gl.clearBufferfv(this.gl.COLOR, 0, [0, 0, 0, 0]);
    }

    drawGbuffer(camera) {
        const {gl, gbuffer} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.images.framebuffer);
        for (let i = 0; i < 3; ++i) gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        gl.useProgram(gbuffer.handle);
        gl.uniformMatrix4fv(gbuffer.at("view"), false, gloam.camera.view(camera));
        gl.uniformMatrix4fv(gbuffer.at("projection"), false, this.projection());
        gl.enable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.mesh);
        gl.drawElements(gl.TRIANGLES, this.scene.count, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(null);
        gl.disable(gl.DEPTH_TEST);
    }

    // Binds images to the samplers of a program and makes it current.
    use(program, images) {
        const {gl} = this;
        gl.useProgram(program.handle);
        Object.entries(images).forEach(([name, image], unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, image);
            gl.uniform1i(program.at(name), unit);
        });
    }

    setFrame(program) {
        const projection = this.projection();
        this.gl.uniform2f(program.at("parameters.p00_p11"), projection[0], projection[5]);
        this.gl.uniform2i(program.at("parameters.size"), this.images.width, this.images.height);
    }

    drawTo(framebuffer) {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, framebuffer);
        this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
    }

    moveHistory(camera) {
        const {gl, reproject, images} = this;
        this.use(reproject, {depth_image: images.depth, previous_history: images.before.image});
        this.setFrame(reproject);
        gl.uniformMatrix4fv(reproject.at("parameters.previous_from_current"), false,
            gloam.camera.change(this.previous.camera, camera));
        gl.uniform1f(reproject.at("parameters.tolerance"), this.settings.depth_tolerance ?? Infinity);
        this.drawTo(images.moved.framebuffer);
        return images.moved;
    }

    static floats = ["radius", "bias", "c_spatial", "weight_max", "c_rot", "least_radius", "samples_distance",
        "samples_radius", "radius_cap", "smoothing", "bias_depth"];

    // Sets the members of method_values that the shader reads. Each is the setting of the same name.
    setMethodValues() {
        const {gl, occlusion, settings} = this;
        for (const {name, type} of occlusion.uniforms) {
            const [block, member] = name.split(".");
            if (block !== "method_values") continue;
            if (!(member in settings)) throw new Error(`${name}: there is no setting of that name`);
            if (type === gl.FLOAT) gl.uniform1f(occlusion.at(name), settings[member] ?? Infinity);
            else gl.uniform1ui(occlusion.at(name), settings[member]);
        }
    }

    drawOcclusion(before) {
        const {gl, occlusion, images, settings} = this;
        this.use(occlusion, {depth_image: images.depth, normal_image: images.normal, history_before: before.image});
        this.setFrame(occlusion);
        gl.uniform2i(occlusion.at("parameters.border"), 0, 0);
        for (const name of gloam.Effect.floats) gl.uniform1f(occlusion.at("parameters." + name), settings[name]);
        this.setMethodValues();
        gl.uniform1ui(occlusion.at("parameters.samples_least"), settings.samples_least);
        gl.uniform1ui(occlusion.at("samples_asked"), settings.samples);
        gl.uniform1ui(occlusion.at("samples_converged"), settings.samples_converged);
        gl.uniform1ui(occlusion.at("samples_unit"), settings.samples_unit);
        gl.uniform1ui(occlusion.at("table_size"), settings.table_size);
        gl.uniform1i(occlusion.at("rounds_up"), Number(settings.rounds_up));
        gl.uniform1i(occlusion.at("reject_taps"), Number(settings.reject_taps));
        gl.uniform1i(occlusion.at("along_curve"), Number(settings.rotation === "hilbert"));
        this.drawTo(images.after.framebuffer);
    }

    // Draws the last frame to the canvas. view: as show.frag numbers them. split: part of the width, from the left,
    // with the kept occlusion, or without any where none is kept.
    show(view, split) {
        const {gl, shower, images} = this;
        this.use(shower, {depth_image: images.depth, normal_image: images.normal, albedo_image: images.albedo,
            history_image: images.after.image, kept_image: (this.kept ?? images.after).image});
        gl.uniform1i(shower.at("has_kept"), Number(this.kept !== null));
        const {rotation} = this.previous.camera;
        gl.uniform2i(shower.at("size"), images.width, images.height);
        gl.uniform1i(shower.at("shown"), view);
        gl.uniform1f(shower.at("weight_max"), this.settings.weight_max);
        gl.uniform1i(shower.at("split"), Math.round(split * images.width));
        gl.uniform3f(shower.at("up"), rotation[1], rotation[4], rotation[7]);
        this.drawTo(null);
    }

    // The history of the last frame, four floats for each pixel, the top row first: occlusion, samples accumulated,
    // samples of the sequence used, depth. Or another history of that size.
    read(history = this.images.after) {
        const {gl, images} = this;
        const texels = new Float32Array(4 * images.width * images.height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, history.framebuffer);
        gl.readPixels(0, 0, images.width, images.height, gl.RGBA, gl.FLOAT, texels);
        return texels;
    }
};
