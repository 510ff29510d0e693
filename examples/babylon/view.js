// SPDX-License-Identifier: MIT
// A scene of Babylon.js with ambient occlusion: gloam's, in both kinds of coordinates, and that of the engine.
import {Camera} from "@babylonjs/core/Cameras/camera.js";
import {TargetCamera} from "@babylonjs/core/Cameras/targetCamera.js";
import {Engine} from "@babylonjs/core/Engines/engine.js";
import {DirectionalLight} from "@babylonjs/core/Lights/directionalLight.js";
import {HemisphericLight} from "@babylonjs/core/Lights/hemisphericLight.js";
import {StandardMaterial} from "@babylonjs/core/Materials/standardMaterial.js";
import {Color3, Color4} from "@babylonjs/core/Maths/math.color.js";
import {Vector3} from "@babylonjs/core/Maths/math.vector.js";
import {CreateBox} from "@babylonjs/core/Meshes/Builders/boxBuilder.js";
import {CreateCapsule} from "@babylonjs/core/Meshes/Builders/capsuleBuilder.js";
import {CreateSphere} from "@babylonjs/core/Meshes/Builders/sphereBuilder.js";
import {Mesh} from "@babylonjs/core/Meshes/mesh.js";
import {VertexData} from "@babylonjs/core/Meshes/mesh.vertexData.js";
import {SSAO2RenderingPipeline}
    from "@babylonjs/core/PostProcesses/RenderPipeline/Pipelines/ssao2RenderingPipeline.js";
import {Scene} from "@babylonjs/core/scene.js";
import {AmbientOcclusionPostProcess} from "gloam/babylon";
import {open, things} from "../page.js";

// How each adds ambient occlusion to a camera; what it returns has a restart(), or nothing of frames before.
const passes = {
    "none": () => null,
    "SSAO2RenderingPipeline, 16 samples": (camera, radius) => {
        const ssao = new SSAO2RenderingPipeline("ssao", camera.getScene(), 1, [camera]);
        Object.assign(ssao, {radius, samples: 16, totalStrength: 1.5});  // of some tried, what is nearest to the truth
        return null;
    },
    "gloam, balanced": (camera, radius) => new AmbientOcclusionPostProcess("gloam", camera, {radius}),
    "gloam, balanced, right-handed": (camera, radius) => new AmbientOcclusionPostProcess("gloam", camera, {radius}),
};

function material(name, color, scene) {
    const made = new StandardMaterial(name, scene);
    Object.assign(made, {diffuseColor: color, specularColor: Color3.Black(), backFaceCulling: false});
    return made;
}

// z of a scene, from one that points to the viewer.
const inScene = (scene, z) => scene.useRightHandedSystem ? z : -z;

// Things on a floor.
function addThings(scene) {
    const shapes = {box: CreateBox, sphere: CreateSphere, capsule: CreateCapsule};
    for (const [shape, color, [x, y, z], scale] of things) {
        const mesh = shapes[shape](shape, shape === "capsule" ? {height: 2, radius: 0.5} : {size: 1}, scene);
        mesh.position.set(x, y, inScene(scene, z));
        mesh.scaling.set(...scale);
        mesh.material = material(color, Color3.FromHexString(color), scene);
    }
    new DirectionalLight("sun", new Vector3(-2, -4, inScene(scene, -5)), scene).intensity = 0.5;
    const sky = new HemisphericLight("sky", new Vector3(0, 1, 0), scene);
    Object.assign(sky, {intensity: 0.7, groundColor: new Color3(0.8, 0.75, 0.7), specular: Color3.Black()});
}

// Triangles in white light from everywhere: the picture is the visibility.
function addModel(scene, {positions: right, indices}) {
    const positions = right.map((x, i) => i % 3 === 2 ? inScene(scene, x) : x);
    const data = Object.assign(new VertexData(), {positions, indices, normals: []});
    VertexData.ComputeNormals(positions, indices, data.normals, {useRightHandedSystem: scene.useRightHandedSystem});
    const mesh = new Mesh("model", scene);
    data.applyToMesh(mesh);
    mesh.material = material("white", Color3.White(), scene);
    new HemisphericLight("sky", new Vector3(0, 1, 0), scene).groundColor = Color3.White();
}

class View {
    static passes = Object.keys(passes);

    // model: positions and indices of triangles, right-handed, and a radius; default: a scene of its own.
    constructor(canvas, pass, model = null) {
        this.engine = new Engine(canvas, false, {preserveDrawingBuffer: true});
        this.gl = this.engine._gl;
        this.scene = new Scene(this.engine);
        this.scene.useRightHandedSystem = pass.endsWith("right-handed");
        this.scene.clearColor = Color4.FromHexString("#c9d4e0ff");
        if (model) addModel(this.scene, model);
        else addThings(this.scene);
        this.camera = new TargetCamera("camera", Vector3.Zero(), this.scene);
        this.camera.maxZ = 300;
        this.occlusion = passes[pass](this.camera, model?.radius ?? 1);
    }

    // fovy: radians. height: of an orthographic view.
    look({eye: [x, y, z], target: [u, v, w], fovy, height = 0}) {
        const {camera, scene} = this;
        camera.position.set(x, y, inScene(scene, z));
        camera.setTarget(new Vector3(u, v, inScene(scene, w)));
        camera.fov = fovy;
        camera.minZ = 0.02 * Math.hypot(x - u, y - v, z - w);
        camera.mode = height > 0 ? Camera.ORTHOGRAPHIC_CAMERA : Camera.PERSPECTIVE_CAMERA;
        const half = [-0.5, 0.5].map((side) => side * height);
        [camera.orthoBottom, camera.orthoTop] = half;
        [camera.orthoLeft, camera.orthoRight] = half.map((side) => side * this.engine.getAspectRatio(camera));
    }

    setSize(width, height) {
        this.engine.setSize(width, height);
    }

    ready() {
        return this.scene.whenReadyAsync();
    }

    restart() {
        this.occlusion?.restart();
    }

    draw() {
        this.scene.render();
    }

    dispose() {
        this.engine.dispose();
    }
}

open(View);
