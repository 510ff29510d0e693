// SPDX-License-Identifier: MIT
// The temporal effect on the scenes of the site: G-buffer, occlusion (gloam.AmbientOcclusion), what is shown of them.
// The shaders and the settings are those of the repository, in gloam.effectData.
"use strict";

gloam.Effect = class {
    // Throws an Error where there is no WebGL2 or it cannot draw floats.
    constructor(canvas) {
        const {gbuffer_vertices, gbuffer, whole_image, show} = gloam.effectData;
        this.canvas = canvas;
        this.passes = gloam.WebGl2.open(canvas);
        this.occlusion = this.newOcclusion();
        this.gbuffer = this.passes.program("gbuffer", gbuffer_vertices, gbuffer);
        this.shower = this.passes.program("show", whole_image, show);
        this.images = null;
        this.kept = null;
        this.left = null;
        this.mesh = null;
    }

    newOcclusion() {
        return new gloam.AmbientOcclusion(this.passes, gloam.effectData, {depth: "linear", normals: "view"});
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
        if (this.mesh !== null) this.passes.deleteMesh(this.mesh);
        this.scene = scene;
        this.mesh = this.passes.mesh(scene);
        this.restart();
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
        if (this.images !== null) this.deleteImages();
        this.canvas.width = width;
        this.canvas.height = height;
        this.images = this.passes.meshTarget(width, height, "r32float", "rgba32float", "rgba8unorm");
        [this.images.depth, this.images.normal, this.images.albedo] = this.images.images;
        this.occlusion.setSize(width, height);
        this.left?.setSize(width, height);
    }

    deleteImages() {
        this.passes.deleteTarget(this.images);
        this.forget();
    }

    // Keeps occlusion from elsewhere, a float for each pixel, to compare with.
    keepOcclusion(floats) {
        this.forget();
        this.kept = this.passes.target(this.images.width, this.images.height, "r32float");
        this.passes.fill(this.kept, floats);
    }

    // Keeps a copy of the last frame's occlusion, to compare with what follows.
    keep() {
        this.forget();
        this.kept = this.passes.copyOf(this.occlusion.result);
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
    async error() {
        if (this.compared === null) return null;
        const [now, kept, depth] = await Promise.all([this.occlusion.result, this.compared, this.images]
            .map((one) => this.passes.read(one, 1)));
        let sum = 0;
        let count = 0;
        for (let i = 0; i < now.length; ++i) {
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
        this.passes.timer.measure(() => this.occlusion.render({depth, normal, projection, view}));
        this.left?.render({depth, normal, projection, view});
    }

    drawGbuffer(view, projection) {
        this.passes.begin();
        this.passes.drawMesh(this.gbuffer, {view, projection}, this.images, this.mesh);
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
            split: Math.round(split * width), up: [rotation[1], rotation[4], rotation[7]]}, this.passes.screen);
    }

    // The history of the last frame, four floats for each of its pixels, the top row first: occlusion, samples
    // accumulated, samples of the sequence used, depth.
    async read() {
        return this.occlusion.readHistory();
    }

    // The occlusion that is shown of the last frame, one float for each pixel, the top row first.
    async readOcclusion() {
        return this.occlusion.readOcclusion();
    }
};
