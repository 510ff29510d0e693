// SPDX-License-Identifier: MIT
// The temporal effect for any engine of WebGL2: it takes a frame's depth and normals, and gives the occlusion. It keeps
// the history of the frames before and moves it along the camera.
//
// A call leaves as WebGL begins: no program, vertex array or framebuffer bound, tests and blending off. It also leaves
// the viewport and the textures of the units that it has used.

class AmbientOcclusion {
    // effect: texts of the shaders, presets and methods, as gloam writes them. Throws an Error where the context is not
    // WebGL2 or cannot draw floats.
    constructor(gl, effect) {
        this.gl = gl;
        this.effect = effect;
        this.passes = new Passes(gl);
        this.reproject = this.passes.program("reproject", effect.reproject);
        this.images = null;
        this.restart();
    }

    // method: of effect.methods. preset: a name. radius: world units; settings that are lengths scale with it. Begins a
    // new history.
    setMethod(method, preset, radius) {
        const settings = {...method.settings[preset]};
        for (const name of this.effect.lengths) settings[name] *= radius;
        this.settings = settings;
        this.occlusion = this.passes.program("occlusion by " + method.name, method.text);
        this.restart();
    }

    // Pixels of the images that render() is given. Begins a new history.
    setSize(width, height) {
        this.deleteImages();
        const history = () => this.passes.target(width, height, this.gl.RGBA32F);
        this.images = {width, height, before: history(), moved: history(), after: history()};
        this.restart();
    }

    deleteImages() {
        if (this.images === null) return;
        for (const history of [this.images.before, this.images.moved, this.images.after])
            this.passes.deleteTarget(history);
        this.images = null;
    }

    // Forgets the history: call it where the picture is cut.
    restart() {
        this.previous = null;
        this.frames = 0;
    }

    // Renders a frame: its samples are added to the history of the frame before, which is moved where the view has.
    // depth: eye-linear depth, 0 for background. normal: in view space. projection: from view to clip space, and view:
    // from world to view space, column by column. Returns a texture whose first channel is the occlusion.
    render({depth, normal, projection, view}) {
        this.passes.begin();
        const {images} = this;
        const now = {depth, normal, view: Array.from(view), p00_p11: [projection[0], projection[5]]};
        [images.before, images.after] = [images.after, images.before];
        if (this.previous === null) this.passes.clear(images.before);
        this.drawOcclusion(now, this.hasMoved(now) ? this.moveHistory(now) : images.before);
        this.previous = {view: now.view, p00_p11: now.p00_p11};
        ++this.frames;
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
        this.gl.useProgram(null);
        return images.after.image;
    }

    hasMoved(now) {
        if (this.previous === null) return false;
        const same = (name) => now[name].every((x, i) => x === this.previous[name][i]);
        return !same("view") || !same("p00_p11");
    }

    moveHistory(now) {
        const {images, previous} = this;
        this.passes.draw(this.reproject, {depth_image: now.depth, previous_history: images.before.image,
            previous_from_current: change(previous.view, now.view), p00_p11: now.p00_p11,
            previous_p00_p11: previous.p00_p11, size: [images.width, images.height],
            tolerance: this.settings.depth_tolerance}, images.moved);
        return images.moved;
    }

    drawOcclusion(now, before) {
        const {images, settings} = this;
        this.passes.draw(this.occlusion, {...settings, depth_image: now.depth, normal_image: now.normal,
            history_before: before.image, p00_p11: now.p00_p11, size: [images.width, images.height], border: [0, 0],
            samples_asked: settings.samples, along_curve: settings.rotation === "hilbert"}, images.after);
    }

    // The history of the last frame, four floats for each pixel, row 0 first: occlusion, samples accumulated, samples
    // of the sequence used, depth.
    readHistory() {
        return this.passes.read(this.images.after);
    }

    // Deletes what this object has made in the context.
    dispose() {
        this.deleteImages();
        this.passes.dispose();
    }
}
