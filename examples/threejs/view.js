// SPDX-License-Identifier: MIT
// A scene of three.js with ambient occlusion: gloam's, that of the engine, and N8AO.
import {BoxGeometry, BufferGeometry, CapsuleGeometry, Color, DirectionalLight, Float32BufferAttribute, HemisphereLight,
    MathUtils, Mesh, MeshLambertMaterial, MeshStandardMaterial, OrthographicCamera, PerspectiveCamera, Scene,
    SphereGeometry, WebGLRenderer} from "three";
import {EffectComposer} from "three/addons/postprocessing/EffectComposer.js";
import {GTAOPass} from "three/addons/postprocessing/GTAOPass.js";
import {OutputPass} from "three/addons/postprocessing/OutputPass.js";
import {RenderPass} from "three/addons/postprocessing/RenderPass.js";
import {N8AOPass} from "n8ao";
import {AmbientOcclusionPass} from "gloam/three";
import {open, things} from "../page.js";

// The passes before the OutputPass. The settings of GTAOPass and N8AO are, of some tried, nearest to the truth.
const passes = {
    "none": (scene, camera) => [new RenderPass(scene, camera)],
    "GTAOPass, 16 samples": (scene, camera, radius) => {
        const gtao = new GTAOPass(scene, camera);
        gtao.updateGtaoMaterial({radius: 1.5 * radius, thickness: radius});
        return [new RenderPass(scene, camera), gtao];
    },
    "N8AO, 16 samples, neural": (scene, camera, radius) => {
        const n8ao = new N8AOPass(scene, camera);
        Object.assign(n8ao.configuration, {aoRadius: radius, intensity: 3, distanceFalloff: 1.5, neuralDenoise: true});
        return [n8ao];
    },
    "gloam, balanced": (scene, camera, radius) => [new AmbientOcclusionPass(scene, camera, {radius})],
};

// Things on a floor.
function addThings(scene) {
    const shapes = {box: new BoxGeometry(), sphere: new SphereGeometry(0.5, 48, 32),
        capsule: new CapsuleGeometry(0.5, 1, 16, 48)};
    for (const [shape, color, place, scale] of things) {
        const mesh = new Mesh(shapes[shape], new MeshStandardMaterial({color, roughness: 0.9}));
        mesh.position.set(...place);
        mesh.scale.set(...scale);
        scene.add(mesh);
    }
    const sun = new DirectionalLight("#fff2dd", 1);
    sun.position.set(2, 4, 5);
    scene.add(new HemisphereLight("#f4f8ff", "#b8ada0", 2.2), sun);
}

// Triangles in white light from everywhere: the picture is the visibility.
function addModel(scene, {positions, indices}) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    geometry.setIndex(indices);
    geometry.computeVertexNormals();
    scene.add(new Mesh(geometry, new MeshLambertMaterial()), new HemisphereLight("white", "white", Math.PI));
}

class View {
    static passes = Object.keys(passes);
    static encoded = true;  // the picture, for sRGB

    // model: positions and indices of triangles, and a radius; default: a scene of its own. options: of the renderer.
    constructor(canvas, pass, model = null, options = {}) {
        this.renderer = new WebGLRenderer({canvas, antialias: false, ...options});
        this.gl = this.renderer.getContext();
        this.scene = new Scene();
        this.scene.background = new Color("#c9d4e0");
        if (model) addModel(this.scene, model);
        else addThings(this.scene);
        this.camera = new PerspectiveCamera();
        this.composer = new EffectComposer(this.renderer);
        const added = passes[pass](this.scene, this.camera, model?.radius ?? 1);
        for (const one of [...added, new OutputPass()]) this.composer.addPass(one);
        this.occlusion = added.at(-1);
    }

    // fovy: radians. height: of an orthographic view.
    look({eye, target, fovy, height = 0}) {
        if (height > 0 === !this.camera.isOrthographicCamera) {
            this.camera = new (height > 0 ? OrthographicCamera : PerspectiveCamera)();
            for (const pass of this.composer.passes) if (pass.camera) pass.camera = this.camera;
        }
        const {camera, aspect} = this;
        camera.position.set(...eye);
        camera.lookAt(...target);
        const near = 0.02 * Math.hypot(...eye.map((x, i) => x - target[i]));
        const [top, right] = [0.5 * height, 0.5 * height * aspect];
        Object.assign(camera, {near, far: 300, fov: MathUtils.radToDeg(fovy), aspect,
            top, right, bottom: -top, left: -right});
        camera.updateProjectionMatrix();
    }

    setSize(width, height) {
        this.aspect = width / height;
        this.renderer.setSize(width, height, false);
        this.composer.setSize(width, height);
    }

    restart() {
        this.occlusion.restart?.();
    }

    draw() {
        this.composer.render();
    }

    dispose() {
        this.occlusion.dispose();
        this.renderer.dispose();
        this.renderer.forceContextLoss();
    }
}

open(View);
