// SPDX-License-Identifier: MIT
// What npm_test.py asks of views of the example, bundled with it.
import {Bone, BoxGeometry, BufferAttribute, DataTexture, DepthTexture, DoubleSide, FloatType, HalfFloatType, Mesh,
    MeshStandardMaterial, OrthographicCamera, Plane, PlaneGeometry, Skeleton, SkinnedMesh, Vector3, WebGLRenderTarget}
    from "three";
import {EffectComposer} from "three/addons/postprocessing/EffectComposer.js";
import {AmbientOcclusion, effect} from "gloam";
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

function measured(view) {
    const values = occlusion(view);
    return {edge: values[pixelOf(view, edge)], floor: values[pixelOf(view, floor)], sky: values.at(-1),
        frames: view.occlusion.occlusion.frames, error: view.renderer.getContext().getError()};
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

// The pass before the RenderPass, for the ambient light alone, and lights of one kind. The materials had another pass
// before, and are given to this one twice.
function ambient(view, lights) {
    const [render, occlusion, output] = view.composer.passes;
    view.composer.passes = [occlusion, render, output];
    occlusion.output = "ambient";
    const former = new occlusion.constructor(view.scene, view.camera);
    view.scene.traverse((object) => {
        if (object.isLight) object.visible = object.type === lights;
        if (object.isMesh) for (const pass of [former, occlusion, occlusion]) pass.darken(object.material);
    });
    return view;
}

// An upright sheet in the scene, of this width, whose left edge is so far from -1.
const sheet = (options = {}, width = 2, left = 0) => {
    const mesh = new Mesh(new PlaneGeometry(width, 2), new MeshStandardMaterial({side: DoubleSide, ...options}));
    mesh.position.set(left - 1 + width / 2, 1, 1);
    return mesh;
};

const texels = (...values) => {
    const texture = new DataTexture(new Uint8Array(values.flatMap((x) => [x, x, x, 255])), values.length, 1);
    texture.needsUpdate = true;
    return texture;
};

// A box, bent as a whole by its one bone or turned by itself.
function bent(skinned) {
    const geometry = new BoxGeometry(0.5, 2, 0.5);
    const count = geometry.attributes.position.count;
    geometry.setAttribute("skinIndex", new BufferAttribute(new Uint16Array(4 * count), 4));
    geometry.setAttribute("skinWeight", new BufferAttribute(Float32Array.from({length: 4 * count},
        (_, i) => i % 4 === 0 ? 1 : 0), 4));
    const mesh = new (skinned ? SkinnedMesh : Mesh)(geometry, new MeshStandardMaterial());
    const turned = skinned ? new Bone() : mesh;
    if (skinned) {
        mesh.add(turned);
        mesh.bind(new Skeleton([turned]));
    }
    mesh.position.set(0, 1, 1);
    turned.rotation.z = 0.7;
    return mesh;
}

// Pairs of meshes whose surfaces are the same; null is none.
const pairs = () => [["alphaTest", sheet({alphaTest: 0.5, alphaMap: texels(0, 255)}), sheet({}, 1, 1)],
    ["alphaTest of colours", sheet({alphaTest: 0.5, map: texels(255, 255)}), sheet()],
    ["clipping planes", sheet({clippingPlanes: [new Plane(new Vector3(1, 0, 0), 0)]}), sheet({}, 1, 1)],
    ["displacement", sheet({displacementMap: texels(255), displacementScale: 0.5}), sheet().translateZ(0.5)],
    ["skeleton", bent(true), bent(false)], ["glass", sheet({transparent: true, opacity: 0.3}), null],
    ["no depth", sheet({depthWrite: false}), null], ["wireframe", sheet({wireframe: true}), null]];

// How far the first frames of each pair are apart, and that of the first one from that without it.
function comparedPairs() {
    const view = made();
    view.renderer.localClippingEnabled = true;
    const first = (mesh) => {
        if (mesh) view.scene.add(mesh);
        view.occlusion.restart();
        view.draw();
        if (mesh) view.scene.remove(mesh);
        return occlusion(view);
    };
    const [none, solid] = [first(null), first(sheet())];
    const all = pairs().map(([name, one, other]) => {
        const shown = first(one);
        return {name, apart: apart(shown, first(other)).mean, visible: apart(shown, none).mean};
    });
    closed(view);
    return {all, solid: apart(none, solid).mean};
}

// What a view shows before its context is lost, and after it was restored.
async function lostAndRestored() {
    const view = made();
    const happens = (name) => new Promise((resolve) => {
        view.renderer.domElement.addEventListener(`webglcontext${name}`, resolve, {once: true});
    });
    const before = occlusion(frames(view, 5));
    const [lost, restored] = [happens("lost"), happens("restored")];
    view.renderer.forceContextLoss();
    await lost;
    await new Promise((resolve) => { setTimeout(resolve, 0); });  // no context is restored within that event
    view.draw();
    view.renderer.forceContextRestore();
    await restored;
    const after = occlusion(frames(view, 5));
    const got = {...apart(before, after), ...measured(view)};
    closed(view);
    return got;
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

window.page = {AmbientOcclusion, ambient, apart, closed, comparedPairs, effect, frames, jitter,
    lostAndRestored, made, measured, occlusion, orthographic, refusal, shown, withComposerDepth};
