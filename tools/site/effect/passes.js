// SPDX-License-Identifier: MIT
// Passes over whole images in WebGL2: programs, images, and one triangle that covers an image.

class Passes {
    // Throws an Error where the context is not WebGL2 or cannot draw floats.
    constructor(gl) {
        if (!(gl instanceof WebGL2RenderingContext)) throw new Error("the context is not one of WebGL2");
        if (gl.getExtension("EXT_color_buffer_float") === null)
            throw new Error("this GPU cannot draw to textures of floats (EXT_color_buffer_float)");
        this.gl = gl;
        this.programs = new Map();
        this.noVertices = gl.createVertexArray();
    }

    // A shader's text with these values in the place of those of its constants.
    static withConstants(name, text, constants) {
        return Object.entries(constants).reduce((all, [constant, value]) => {
            const declared = new RegExp(`(const (?:bool|int) ${constant} = )[^;]+;`);
            if (!declared.test(all)) throw new Error(`${name} has no constant ${constant}`);
            return all.replace(declared, (_, start) => `${start}${value};`);
        }, text);
    }

    // The most pixels of a side of an image.
    get mostPixels() {
        return this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE);
    }

    // A linked program with its uniforms; compiled once for each name and its constants, which are those of the
    // fragment shader.
    program(name, vertices, fragments, constants = {}) {
        const key = `${name} ${JSON.stringify(constants)}`;
        if (!this.programs.has(key))
            this.programs.set(key, this.linked(name, vertices, Passes.withConstants(name, fragments, constants)));
        return this.programs.get(key);
    }

    linked(name, vertices, fragments) {
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
        const messages = stages.map((shader) => gl.getShaderInfoLog(shader)).join(" ");
        for (const shader of stages) gl.deleteShader(shader);
        if (!gl.getProgramParameter(handle, gl.LINK_STATUS)) throw new Error(`${name} does not compile: ${messages}`);
        const uniforms = Array.from({length: gl.getProgramParameter(handle, gl.ACTIVE_UNIFORMS)}, (_, i) => {
            const {name: whole, type} = gl.getActiveUniform(handle, i);
            return {whole, type, name: whole.slice(whole.lastIndexOf(".") + 1),
                location: gl.getUniformLocation(handle, whole)};
        });
        return {handle, uniforms};
    }

    // A texture of this format, one of Passes.formats. Its nearest texel is read, clamped to the edge.
    image(format, width, height, levels = 1) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, levels, gl[Passes.formats[format]], width, height);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, levels > 1 ? gl.NEAREST_MIPMAP_NEAREST : gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        for (const edge of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
            gl.texParameteri(gl.TEXTURE_2D, edge, gl.CLAMP_TO_EDGE);
        return texture;
    }

    static formats = {r16float: "R16F", r32float: "R32F", r32uint: "R32UI", rgba32float: "RGBA32F", rgba8unorm: "RGBA8"};

    framebuffer(textures, level = 0) {
        const {gl} = this;
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        textures.forEach((texture, i) =>
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, level));
        gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        return framebuffer;
    }

    // Images of one size and what draws to all of them.
    target(width, height, ...formats) {
        const images = formats.map((format) => this.image(format, width, height));
        return {width, height, formats, images, image: images[0], framebuffer: this.framebuffer(images)};
    }

    // One image with levels, as many as its size has but at most `most`: a target for each, the largest first.
    levels(width, height, format, most) {
        const count = Math.min(most, 1 + Math.floor(Math.log2(Math.max(width, height))));
        const image = this.image(format, width, height, count);
        return Array.from({length: count}, (_, level) => ({image, images: [image],
            width: Math.max(width >> level, 1), height: Math.max(height >> level, 1),
            framebuffer: this.framebuffer([image], level)}));
    }

    deleteTarget({images, framebuffer}) {
        for (const image of images) this.gl.deleteTexture(image);
        this.gl.deleteFramebuffer(framebuffer);
    }

    clear(target) {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, target.framebuffer);
        this.gl.clearBufferfv(this.gl.COLOR, 0, [0, 0, 0, 0]);
    }

    // Sets what a pass relies on and an engine may have changed.
    begin() {
        const {gl} = this;
        for (const test of [gl.BLEND, gl.CULL_FACE, gl.DEPTH_TEST, gl.SCISSOR_TEST, gl.STENCIL_TEST,
            gl.RASTERIZER_DISCARD]) gl.disable(test);
        gl.colorMask(true, true, true, true);
    }

    // Leaves the context as WebGL begins.
    end() {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
        this.gl.useProgram(null);
    }

    // Makes a program current and sets each of its uniforms, and each member of a uniform structure, to the value of
    // its name. Numbers, arrays, and a texture for a sampler; null for a float is infinity.
    use({handle, uniforms}, values) {
        const {gl} = this;
        gl.useProgram(handle);
        let unit = 0;
        for (const {whole, name, type, location} of uniforms) {
            const value = values[name];
            if (value === undefined) throw new Error(`${whole}: there is no value of that name`);
            if (type === gl.SAMPLER_2D || type === gl.UNSIGNED_INT_SAMPLER_2D) {
                gl.activeTexture(gl.TEXTURE0 + unit);
                gl.bindTexture(gl.TEXTURE_2D, value);
                gl.uniform1i(location, unit++);
            } else {
                this.setUniform(type, location, value);
            }
        }
    }

    setUniform(type, location, value) {
        const {gl} = this;
        if (type === gl.FLOAT) gl.uniform1f(location, value ?? Infinity);
        else if (type === gl.FLOAT_VEC2) gl.uniform2fv(location, value);
        else if (type === gl.FLOAT_VEC3) gl.uniform3fv(location, value);
        else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(location, false, value);
        else if (type === gl.FLOAT_MAT3x4) gl.uniformMatrix3x4fv(location, false, value);
        else if (type === gl.FLOAT_MAT4x3) gl.uniformMatrix4x3fv(location, false, value);
        else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(location, false, value);
        else if (type === gl.INT_VEC2) gl.uniform2iv(location, value);
        else if (type === gl.UNSIGNED_INT) gl.uniform1ui(location, value);
        else gl.uniform1i(location, Number(value));
    }

    // Draws the whole of a target, or of a canvas with framebuffer null.
    draw(program, values, {framebuffer, width, height}) {
        const {gl} = this;
        this.use(program, values);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.viewport(0, 0, width, height);
        gl.bindVertexArray(this.noVertices);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindVertexArray(null);
    }

    // The first image of a target, floats of the first channels of each pixel, row 0 first.
    read({framebuffer, width, height}, channels = 4) {
        const {gl} = this;
        const texels = new Float32Array(4 * width * height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, texels);
        return channels === 4 ? texels : texels.filter((_, i) => i % 4 < channels);
    }

    // Deletes the programs.
    dispose() {
        for (const {handle} of this.programs.values()) this.gl.deleteProgram(handle);
        this.programs.clear();
        this.gl.deleteVertexArray(this.noVertices);
    }
}
