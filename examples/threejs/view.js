// SPDX-License-Identifier: MIT
// A scene of three.js, which the pass of ambient occlusion draws.
import {BoxGeometry, Color, DirectionalLight, HemisphereLight, Mesh, MeshStandardMaterial, PerspectiveCamera,
    PlaneGeometry, Scene, SphereGeometry, TorusKnotGeometry, WebGLRenderer} from "three";
import {EffectComposer} from "three/addons/postprocessing/EffectComposer.js";
import {OutputPass} from "three/addons/postprocessing/OutputPass.js";
import {AmbientOcclusionPass} from "gloam/three";

function placed(geometry, color, x, y, z) {
    const mesh = new Mesh(geometry, new MeshStandardMaterial({color, roughness: 0.9}));
    mesh.position.set(x, y, z);
    return mesh;
}

// A floor at y = 0, a wall at z = -2, and things on the floor.
function makeScene() {
    const scene = new Scene();
    scene.background = new Color(0xc9d4e0);
    const floor = placed(new PlaneGeometry(12, 12), 0xd8d2c8, 0, 0, 0);
    floor.rotation.x = -Math.PI / 2;
    scene.add(floor, placed(new PlaneGeometry(12, 3), 0xd2d6d0, 0, 1.5, -2));
    scene.add(placed(new BoxGeometry(1, 1.6, 1), 0xc96f4a, -1.7, 0.8, -1.3),
        placed(new BoxGeometry(1.2, 0.5, 0.8), 0x7a9cb8, -0.6, 0.25, -1.2),
        placed(new SphereGeometry(0.5, 48, 32), 0xe0c067, 0.3, 0.5, 0.1),
        placed(new TorusKnotGeometry(0.45, 0.16, 160, 24), 0x6fa287, 1.6, 0.75, -1));
    for (let i = 0; i < 5; ++i) scene.add(placed(new BoxGeometry(1.6, 0.2, 0.3), 0xb9b2a6, 3.4, 0.1 + 0.2 * i,
        -0.4 - 0.3 * i));
    const sun = new DirectionalLight(0xfff2dd, 1);
    sun.position.set(2, 4, 5);
    scene.add(new HemisphereLight(0xf4f8ff, 0xb8ada0, 2.2), sun);
    return scene;
}

export class View {
    // options: of the renderer, besides the canvas.
    constructor(canvas, options = {}) {
        this.renderer = new WebGLRenderer({canvas, antialias: false, ...options});
        this.scene = makeScene();
        this.camera = new PerspectiveCamera(40, 1, 0.1, 100);
        this.composer = new EffectComposer(this.renderer);
        this.occlusion = new AmbientOcclusionPass(this.scene, this.camera, {preset: "balanced", radius: 1});
        this.composer.addPass(this.occlusion);
        this.composer.addPass(new OutputPass());
        this.look(0);
    }

    // Pixels of the page, and pixels of the screen for each of them.
    setSize(width, height, ratio) {
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.composer.setPixelRatio(ratio);
        this.composer.setSize(width, height);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
    }

    // Turns the camera around the scene by this angle, radians.
    look(angle) {
        this.camera.position.set(7 * Math.sin(angle), 2.6, 7 * Math.cos(angle) - 0.5);
        this.camera.lookAt(0.3, 0.6, -0.6);
    }

    draw() {
        this.composer.render();
    }
}
