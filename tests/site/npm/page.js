// SPDX-License-Identifier: MIT
// What npm_test.py asks of views of the example, bundled with it.
import {OrthographicCamera, Vector3, WebGLRenderTarget, DepthTexture, FloatType, HalfFloatType} from "three";
import {EffectComposer} from "three/addons/postprocessing/EffectComposer.js";
import {AmbientOcclusion, effect} from "gloam";
import {encodings} from "./encodings.js";
import {View} from "./view.js";

const size = [160, 90];

// A view that shows its visibility alone.
function made(options = {}, [width, height] = size) {
    const view = new View(document.createElement("canvas"), options);
    view.occlusion.output = "visibility";
    view.setSize(width, height, 1);
    return view;
}

function closed(view) {
    view.occlusion.dispose();
    view.renderer.dispose();
    view.renderer.forceContextLoss();
}

function frames(view, count, before = () => {}) {
    for (let i = 0; i < count; ++i) {
        before(i);
        view.draw();
    }
    return view;
}

const occlusion = (view) => view.occlusion.occlusion.readOcclusion();

// The mean difference of two images, and the largest of nine tenths of their pixels.
function apart(a, b) {
    if (a.length !== b.length) throw new Error(`${a.length} and ${b.length} pixels`);
    const all = Array.from(a, (x, i) => Math.abs(x - b[i])).sort((x, y) => x - y);
    return {mean: all.reduce((sum, x) => sum + x, 0) / all.length, most: all[Math.floor(0.9 * all.length)]};
}

// The pixel that shows a point of the world, from the bottom left corner.
function pixelOf(view, point, [width, height] = size) {
    const at = new Vector3(...point).project(view.camera);
    return Math.floor((at.y + 1) / 2 * height) * width + Math.floor((at.x + 1) / 2 * width);
}

// What the canvas shows, bottom row first, four bytes a pixel.
function shown(view, [width, height] = size) {
    const gl = view.renderer.getContext();
    const bytes = new Uint8Array(4 * width * height);
    view.draw();
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
}

const edge = [-3.5, 0.02, -1.99];
const floor = [-1, 0, 1.8];
const top = [-1.7, 1.6, -1.1];

// Errors of the eye-linear depth at points of the scene, relative; they say whether depth is read as it was stored.
function depthErrors(view) {
    const history = view.occlusion.occlusion.readHistory();
    return [floor, top, [3, 2, -2]].map((point) => {
        const truth = -new Vector3(...point).applyMatrix4(view.camera.matrixWorldInverse).z;
        return Math.abs(history[4 * pixelOf(view, point) + 3] / truth - 1);
    });
}

function measured(view) {
    const values = occlusion(view);
    return {edge: values[pixelOf(view, edge)], floor: values[pixelOf(view, floor)], sky: values.at(-1),
        depth: Math.max(...depthErrors(view)), frames: view.occlusion.occlusion.frames,
        error: view.renderer.getContext().getError()};
}

const halton = (index, base) => {
    let sum = 0;
    for (let place = 1 / base; index > 0; index = Math.floor(index / base), place /= base) sum += index % base * place;
    return sum;
};

// A new frame of the same view with the projection moved by up to half a pixel.
function jitter(view, i) {
    view.camera.setViewOffset(...size, halton(i + 1, 2) - 0.5, halton(i + 1, 3) - 0.5, ...size);
}

function orthographic(view) {
    const camera = new OrthographicCamera(-4.8, 4.8, 2.7, -2.7, 0.1, 100);
    camera.position.copy(view.camera.position);
    camera.quaternion.copy(view.camera.quaternion);
    camera.updateProjectionMatrix();
    view.camera = view.occlusion.camera = view.composer.passes[0].camera = camera;
    return view;
}

// The pass reads the depth that the RenderPass has drawn.
function withComposerDepth(view) {
    const target = new WebGLRenderTarget(...size, {type: HalfFloatType, depthTexture: new DepthTexture(...size,
        FloatType)});
    const {passes} = view.composer;
    view.composer = new EffectComposer(view.renderer, target);
    for (const pass of passes) view.composer.addPass(pass);
    view.occlusion.source = "composer";
    return view;
}

// The pass before the RenderPass, for the ambient light alone, and lights of one kind.
function ambient(view, lights) {
    const [render, occlusion, output] = view.composer.passes;
    view.composer.passes = [occlusion, render, output];
    occlusion.output = "ambient";
    view.scene.traverse((object) => {
        if (object.isLight) object.visible = object.type === lights;
        if (object.isMesh) occlusion.darken(object.material);
    });
    return view;
}

// The message of the error that a call throws.
function refusal(call) {
    try {
        call();
    } catch (error) {
        return error.message;
    }
    return null;
}

window.page = {AmbientOcclusion, ambient, apart, closed, effect, encodings, frames, jitter, made, measured,
    occlusion, orthographic, refusal, shown, withComposerDepth};
