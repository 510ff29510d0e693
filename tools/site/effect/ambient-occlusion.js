// SPDX-License-Identifier: MIT
// The temporal effect for any engine of WebGL2: it takes a frame's depth and normals, and gives the occlusion. It keeps
// the history of the frames before and moves it along the camera.
//
// A call leaves as WebGL begins: no program, vertex array or framebuffer bound, tests and blending off. It also leaves
// the viewport and the textures of the units that it has used.

class AmbientOcclusion {
    // effect: texts of the shaders, presets and methods, as gloam writes them. inputs: how the engine stores what
    // render() gets:
    //   depth    "linear": eye-linear depth, 0 for background; "buffer": a depth buffer, standard or reversed
    //   range    of the projection's depth: "negative-one-to-one", or "zero-to-one"
    //   normals  "none": they are made from depth; "view" or "world" space, and behind it "-octahedral", "-unorm" or
    //            both, as `gloam pack --normals` has them
    // Throws an Error for other inputs, and where the context is not WebGL2 or cannot draw floats.
    constructor(gl, effect, {depth = "buffer", range = "negative-one-to-one", normals = "none"} = {}) {
        this.inputs = AmbientOcclusion.checkedInputs(depth, range, normals);
        this.effect = effect;
        this.passes = new Passes(gl);
        this.targets = new Map();
        this.size = null;
        this.settings = null;
        this.orthographic = false;  // the camera of the last frame
        this.restart();
    }

    static checkedInputs(depth, range, normals) {
        const check = (name, value, pattern, expected) => {
            if (!pattern.test(value)) throw new Error(`${name} "${value}": expected ${expected}`);
        };
        check("depth", depth, /^(linear|buffer)$/, '"linear" or "buffer"');
        check("range", range, /^(negative-one|zero)-to-one$/, '"negative-one-to-one" or "zero-to-one"');
        check("normals", normals, /^(none|(view|world)(-octahedral)?(-unorm)?)$/,
            '"none", or "view" or "world" and "-octahedral", "-unorm" or both behind it');
        return {depth, range, normals};
    }

    // preset: a name. radius: world units; settings that are lengths scale with it. Begins a new history. Throws an
    // Error for another preset or radius.
    setPreset(preset, radius) {
        const {presets, methods, lengths} = this.effect;
        const found = presets.find(({name}) => name === preset);
        if (!found) throw new Error(`preset "${preset}": expected ${presets.map(({name}) => name).join(", ")}`);
        if (!(radius > 0 && radius <= 1e18)) throw new Error(`radius ${radius}: expected a number above 0`);
        this.method = methods.find(({name}) => name === found.method);
        this.settings = {...found.settings};
        for (const name of lengths) this.settings[name] *= radius;
        this.deleteImages();
    }

    // Pixels of the images that render() gets. Begins a new history.
    setSize(width, height) {
        const most = this.passes.mostPixels;
        for (const side of [width, height])
            if (!Number.isInteger(side) || side < 1 || side > most)
                throw new Error(`size ${width}x${height}: expected whole numbers from 1 to ${most}`);
        this.size = [width, height];
        this.deleteImages();
    }

    deleteImages() {
        for (const target of this.targets.values()) this.passes.deleteTarget(target);
        this.targets.clear();
        this.result = null;
        this.restart();
    }

    // Forgets the history: call it where the picture is cut.
    restart() {
        this.previous = null;
        this.frames = 0;
    }

    // Renders a frame: its samples are added to the history of the frame before, which is moved where the view has.
    // depth, normal: textures of the size of the view, stored as the constructor was told. projection: from view to
    // clip space, and view: from world to view space, column by column, as the engine's vertices were drawn with.
    // Returns a texture whose first channel is the occlusion: 0 open, 1 blocked.
    render({depth, normal = null, projection, view}) {
        if (this.size === null || this.settings === null)
            throw new Error("no size or no preset: setSize() and setPreset() must come before render()");
        const given = viewOf(projection, view, this.size);
        this.passes.begin();
        const full = this.taken(given, depth, normal);
        const now = this.settings.resolution === "half" ? this.halved(full) : full;
        if (this.orthographic !== now.orthographic) this.restart();
        this.orthographic = now.orthographic;
        const [name, last] = this.frames % 2 === 0 ? ["even", "odd"] : ["odd", "even"];
        this.history = this.target(name, now.size, "rgba32float");
        this.drawOcclusion(now, this.historyBefore(now, last));
        this.result = this.shown(full, now);
        this.previous = now;
        ++this.frames;
        this.passes.end();
        return this.result.image;
    }

    // Images of this size and these formats; made when they are first asked for.
    target(name, [width, height], ...formats) {
        if (!this.targets.has(name)) this.targets.set(name, this.passes.target(width, height, ...formats));
        return this.targets.get(name);
    }

    draw(name, constants, values, target) {
        this.passes.draw(this.passes.program(name, this.effect.whole_image, this.effect[name], constants), values,
            target);
        return target;
    }

    // The view with what the passes read: eye-linear depth and normals in view space.
    taken(view, depth, normal) {
        const {depth: stored, range, normals} = this.inputs;
        if (!depth) throw new Error("depth: expected a texture");
        if (normals !== "none" && !normal) throw new Error("normal: expected a texture");
        let images = [depth, normal];
        if (stored === "buffer" || (normals !== "none" && normals !== "view")) {
            const m = view.view;
            images = this.draw("take_inputs", {orthographic: view.orthographic, depth_buffer: stored === "buffer",
                zero_to_one: range === "zero-to-one", has_normals: normals !== "none",
                world_normals: normals.startsWith("world"), octahedral_normals: normals.includes("octahedral"),
                unorm_normals: normals.includes("unorm")}, {stored_depth_image: depth, stored_normal_image: normal,
                p22_p32: view.p22_p32, view_from_world: [...m.slice(0, 3), ...m.slice(4, 7), ...m.slice(8, 11)]},
            this.target("taken", view.size, "r32float", "rgba32float")).images;
        }
        const taken = {...view, depth: images[0], normal: images[1]};
        if (normals !== "none") return taken;
        return {...taken, normal: this.draw("normals_from_depth", {orthographic: view.orthographic},
            {...view, depth_image: taken.depth}, this.target("normals", view.size, "rgba32float")).image};
    }

    halved(full) {
        const [depth, normal] = this.draw("halve_inputs", {orthographic: full.orthographic},
            {depth_image: full.depth, normal_image: full.normal, view_size: full.size, view_p00_p11: full.p00_p11},
            this.target("halved", halfView(full).size, "r32float", "rgba32float")).images;
        return {...halfView(full), depth, normal};
    }

    // The history of the frame before, at the pixels of this one. last: the name of its target.
    historyBefore(now, last) {
        const {previous} = this;
        const history = this.target(last, now.size, "rgba32float");
        if (previous === null) {
            this.passes.clear(history);
            return history;
        }
        const same = (name) => now[name].every((x, i) => x === previous[name][i]);
        if (same("view") && same("p00_p11")) return history;
        return this.draw("reproject", {orthographic: now.orthographic}, {depth_image: now.depth,
            previous_history: history.image, previous_from_current: change(previous, now), p00_p11: now.p00_p11,
            previous_p00_p11: previous.p00_p11, size: now.size, tolerance: this.settings.depth_tolerance},
        this.target("moved", now.size, "rgba32float"));
    }

    drawOcclusion(now, before) {
        const {settings, method} = this;
        const program = this.passes.program("occlusion by " + method.name, this.effect.whole_image, method.text,
            {orthographic: this.orthographic});
        this.passes.draw(program, {...settings, ...now, depth_image: now.depth,
            normal_image: now.normal, history_before: before.image, border: [0, 0], samples_asked: settings.samples,
            on_lattice: settings.rotation === "lattice"}, this.history);
    }

    // What is shown of the history, at the size of the view.
    shown(full, now) {
        const {settings} = this;
        const source = settings.filter === "none" ? this.history : this.filtered(now);
        if (settings.resolution !== "half") return source;
        return this.draw("upsample", {orthographic: full.orthographic}, {depth_image: full.depth,
            half_depth_image: now.depth, source_image: source.image, view_size: full.size},
        this.target("upsampled", full.size, "r32float"));
    }

    filtered(now) {
        const {settings, history} = this;
        const values = {...now, history_image: history.image, c_adaptive: settings.c_adaptive,
            weight_max: settings.weight_max, cap: settings.filter_cap,
            sigma_pixels: settings.filter_sigma * (2 * settings.filter_half_width + 1)};
        const constants = {orthographic: now.orthographic, HALF_WIDTH: settings.filter_half_width};
        const along = (along_y, along_x_image, name) => this.draw("spatial_filter", {...constants, along_y},
            {...values, along_x_image}, this.target(name, now.size, "r32float"));
        return along(true, along(false, null, "filtered along x").image, "filtered");
    }

    // The history of the last frame, four floats for each of its pixels, row 0 first: occlusion, samples accumulated,
    // samples of the sequence used, depth.
    readHistory() {
        return this.passes.read(this.history);
    }

    // The occlusion that the last frame has given, one float a pixel, row 0 first.
    readOcclusion() {
        return this.passes.read(this.result, 1);
    }

    // Deletes what this object has made in the context.
    dispose() {
        this.deleteImages();
        this.passes.dispose();
    }
}
