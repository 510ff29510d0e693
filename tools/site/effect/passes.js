// SPDX-License-Identifier: MIT
// Passes over whole images in WebGL2: programs, images, and one triangle that covers an image.

class Passes {
    // Throws an Error where the context is not WebGL2 or cannot draw floats.
    constructor(gl) {
        if (!(gl instanceof WebGL2RenderingContext)) throw new Error("the context is not one of WebGL2");
        if (gl.getExtension("EXT_color_buffer_float") === null)
            throw new Error("this GPU cannot draw to textures of floats (EXT_color_buffer_float)");
        this.gl = gl;
        // Of a side of an image, and of a viewport of whole tiles.
        this.mostPixels = Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), ...gl.getParameter(gl.MAX_VIEWPORT_DIMS)) & ~7;
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

    // A texture of a sized format, "R32F" for example. Its nearest texel is read, or of four the mean; both clamped to
    // the edge.
    image(format, [width, height], {levels = 1, linear = false} = {}) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, levels, gl[format], width, height);
        const filter = linear ? gl.LINEAR : gl.NEAREST;
        for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, levels > 1 ? gl.NEAREST_MIPMAP_NEAREST : filter],
            [gl.TEXTURE_MAG_FILTER, filter], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
            [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) gl.texParameteri(gl.TEXTURE_2D, name, value);
        return texture;
    }

    // What draws to all of these images, of this size.
    target([width, height], images, level = 0) {
        const {gl} = this;
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        images.forEach((image, i) =>
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, image, level));
        gl.drawBuffers(images.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        return {width, height, images, image: images[0], framebuffer};
    }

    // A target for each level of one image, the largest first.
    levels([width, height], format, most) {
        const levels = Math.min(most, 1 + Math.floor(Math.log2(Math.max(width, height))));
        const image = this.image(format, [width, height], {levels});
        return Array.from({length: levels}, (_, level) =>
            this.target([width, height].map((n) => Math.max(n >> level, 1)), [image], level));
    }

    deleteTarget({images, framebuffer}) {
        for (const image of images) this.gl.deleteTexture(image);
        this.gl.deleteFramebuffer(framebuffer);
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
    // its name: a number, an array, a texture for a sampler.
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
        if (type === gl.FLOAT) gl.uniform1f(location, value);
        else if (type === gl.UNSIGNED_INT) gl.uniform1ui(location, value);
        else if (type === gl.FLOAT_VEC2) gl.uniform2fv(location, value);
        else if (type === gl.FLOAT_VEC3) gl.uniform3fv(location, value);
        else if (type === gl.FLOAT_MAT3x4) gl.uniformMatrix3x4fv(location, false, value);
        else if (type === gl.FLOAT_MAT4x3) gl.uniformMatrix4x3fv(location, false, value);
        else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(location, false, value);
        else gl.uniform1i(location, value);
    }

    // Draws the whole of a target, or of a canvas with framebuffer null. tiles: how many there are of what side, of
    // which the program draws some; those at the edges stand out.
    draw(program, values, {framebuffer, width, height}, tiles = null) {
        const {gl} = this;
        this.use(program, values);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.viewport(0, 0, tiles ? tiles.side * tiles.width : width, tiles ? tiles.side * tiles.height : height);
        gl.bindVertexArray(this.noVertices);
        gl.drawArrays(gl.TRIANGLES, 0, tiles ? 6 * tiles.width * tiles.height : 3);
        gl.bindVertexArray(null);
    }

    // Deletes the programs.
    dispose() {
        for (const {handle} of this.programs.values()) this.gl.deleteProgram(handle);
        this.programs.clear();
        this.gl.deleteVertexArray(this.noVertices);
    }
}
