// SPDX-License-Identifier: MIT
// A scene of PlayCanvas whose ambient light ambient occlusion darkens: gloam's, and that of the engine.
import * as pc from "playcanvas";
import {AmbientOcclusionCameraFrame} from "gloam/playcanvas";
import {open, things} from "../page.js";

// How each makes the CameraFrame of a camera.
const passes = {
    "none": (app, camera) => new pc.CameraFrame(app, camera),
    "CameraFrame, 12 samples": (app, camera, radius) => {
        const frame = new pc.CameraFrame(app, camera);
        // Of some tried, what is nearest to the truth.
        Object.assign(frame.ssao, {type: pc.SSAOTYPE_LIGHTING, radius: 3 * radius, power: 1});
        return frame;
    },
    "gloam, balanced": (app, camera, radius) => {
        const frame = new AmbientOcclusionCameraFrame(app, camera);
        frame.ssao.radius = radius;
        return frame;
    },
};

function material(color) {
    const made = new pc.StandardMaterial();
    Object.assign(made, {diffuse: new pc.Color().fromString(color), cull: pc.CULLFACE_NONE});
    made.update();
    return made;
}

// Things on a floor.
function addThings(app) {
    for (const [type, color, place, scale] of things) {
        const entity = new pc.Entity();
        entity.addComponent("render", {type, material: material(color)});
        entity.setPosition(...place);
        entity.setLocalScale(...scale);
        app.root.addChild(entity);
    }
    const sun = new pc.Entity();
    sun.addComponent("light", {type: "directional", intensity: 1});
    sun.setEulerAngles(50, 20, 0);
    app.root.addChild(sun);
    app.scene.ambientLight = new pc.Color(0.6, 0.6, 0.6);
}

// Triangles in white light from everywhere: the picture is the visibility.
function addModel(app, {positions, indices}) {
    const mesh = new pc.Mesh(app.graphicsDevice);
    mesh.setPositions(positions);
    mesh.setNormals(pc.calculateNormals(positions, indices));
    mesh.setIndices(indices);
    mesh.update();
    const entity = new pc.Entity();
    entity.addComponent("render", {meshInstances: [new pc.MeshInstance(mesh, material("#ffffff"))]});
    app.root.addChild(entity);
    app.scene.ambientLight = pc.Color.WHITE;
}

class View {
    static passes = Object.keys(passes);
    static encoded = true;  // the picture, for sRGB

    // model: positions and indices of triangles, and a radius; default: a scene of its own.
    constructor(canvas, pass, model = null) {
        this.app = new pc.Application(canvas, {graphicsDeviceOptions: {antialias: false, preserveDrawingBuffer: true}});
        this.gl = this.app.graphicsDevice.gl;
        if (model) addModel(this.app, model);
        else addThings(this.app);
        this.entity = new pc.Entity();
        this.entity.addComponent("camera", {clearColor: new pc.Color().fromString("#c9d4e0"), farClip: 300});
        this.app.root.addChild(this.entity);
        this.frame = passes[pass](this.app, this.entity.camera, model?.radius ?? 1);
        this.frame.update();
    }

    // fovy: radians. height: of an orthographic view.
    look({eye, target, fovy, height = 0}) {
        const {camera} = this.entity;
        this.entity.setPosition(...eye);
        this.entity.lookAt(...target);
        camera.nearClip = 0.02 * Math.hypot(...eye.map((x, i) => x - target[i]));
        camera.fov = fovy * 180 / Math.PI;
        camera.projection = height > 0 ? pc.PROJECTION_ORTHOGRAPHIC : pc.PROJECTION_PERSPECTIVE;
        camera.orthoHeight = 0.5 * height;
    }

    setSize(width, height) {
        this.app.setCanvasResolution(pc.RESOLUTION_FIXED, width, height);
    }

    restart() {
        this.frame.restart?.();
    }

    draw() {
        this.app.update(0);
        this.app.render();
    }

    dispose() {
        this.frame.destroy();
        this.app.destroy();
    }
}

open(View);
