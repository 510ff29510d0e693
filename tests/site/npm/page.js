// SPDX-License-Identifier: MIT
// What npm_test.py asks of views of the example, bundled with it.
import {Bone, BoxGeometry, BufferAttribute, DataTexture, DepthTexture, DoubleSide, FloatType, Fog, FogExp2,
    HalfFloatType, Mesh, MeshBasicMaterial, MeshStandardMaterial, Plane, PlaneGeometry, Skeleton, SkinnedMesh, Vector3,
    WebGLRenderTarget} from "three";
import {EffectComposer} from "three/addons/postprocessing/EffectComposer.js";
import {RenderPass} from "three/addons/postprocessing/RenderPass.js";
import {AmbientOcclusion, effect} from "gloam";
import {around} from "../page.js";
import "./view.js";

const size = [160, 90];

let views = [];

// A view that shows its visibility alone, until closeViews().
function made(options = {}) {
    const view = new View(document.createElement("canvas"), "gloam, balanced", null, options);
    view.occlusion.output = "visibility";
    view.setSize(...size);
    turn(view, 0);
    views.push(view);
    return view;
}

// Turns the camera around the scene. height: of an orthographic view.
function turn(view, angle, height = view.camera.isOrthographicCamera ? 2 * view.camera.top : 0) {
    view.look({...around(angle), height});
}

function closeViews() {
    for (const view of views) view.dispose();
    views = [];
}

function frames(view, count, before = () => {}) {
    for (let i = 0; i < count; ++i) {
        before(i);
        view.draw();
    }
    return view;
}

const occlusion = (view) => view.occlusion.occlusion.readShown();

// The mean difference of two images, and the largest of nine tenths of their pixels.
function apart(a, b) {
    if (a.length !== b.length) throw new Error(`${a.length} and ${b.length} pixels`);
    const all = Array.from(a, (x, i) => Math.abs(x - b[i])).sort((x, y) => x - y);
    return {mean: all.reduce((sum, x) => sum + x, 0) / all.length, most: all[Math.floor(0.9 * all.length)]};
}

// What the canvas shows, bottom row first, four bytes a pixel; and in a new frame.
function pixels({renderer}) {
    const gl = renderer.getContext();
    const bytes = new Uint8Array(4 * size[0] * size[1]);
    gl.readPixels(0, 0, ...size, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
}
const shown = (view) => pixels(frames(view, 1));

// Moves the projection by up to half a pixel.
function jitter(view, i) {
    view.camera.setViewOffset(...size, i * 0.618034 % 1 - 0.5, i * 0.7548777 % 1 - 0.5, ...size);
}

// The class gets the matrices of a left-handed view space.
const leftHanded = (view) => Object.assign(view, {left: true});

function orthographic(view) {
    turn(view, 0, 5.4);
    return view;
}

// The pass reads the depth that the RenderPass has drawn.
function withComposerDepth(view) {
    const target = new WebGLRenderTarget(...size, {type: HalfFloatType, depthTexture: new DepthTexture(...size,
        FloatType)});
    const {passes} = view.composer;
    view.composer = new EffectComposer(view.renderer, target);
    for (const pass of [new RenderPass(view.scene, view.camera), ...passes]) view.composer.addPass(pass);
    view.occlusion.source = "composer";
    return view;
}

// The pass before the RenderPass, for the ambient light alone, and lights of one kind. The materials had another pass
// before, and are given to this one twice.
function ambient(view, lights) {
    const [occlusion, output] = view.composer.passes;
    view.composer.passes = [occlusion, new RenderPass(view.scene, view.camera), output];
    occlusion.output = "ambient";
    const former = new occlusion.constructor(view.scene, view.camera);
    view.scene.traverse((object) => {
        if (object.isLight) object.visible = object.type === lights;
        if (object.isMesh) for (const pass of [former, occlusion, occlusion]) pass.darken(object.material);
    });
    return view;
}

// A black scene in white fog, which is opaque in the background.
function fogged(view, fog) {
    view.scene.background.set("white");
    return Object.assign(view.scene, {fog, overrideMaterial: new MeshBasicMaterial({color: "black"})});
}

// How far the picture is from that without occlusion, and its least byte.
function darkening(view) {
    if (view.occlusion.output === "visibility") view.occlusion.output = "shaded";
    const dark = shown(frames(view, 2));
    view.occlusion.intensity = 0;
    const plain = shown(view);
    return {most: Math.max(...plain.map((x, i) => Math.abs(x - dark[i]))), least: Math.min(...dark),
        mean: apart(dark, plain).mean};
}

// How far the visibility that is shown with these options is from its formula, at most, and its mean; both of 255.
function shownByFormula(view, {intensity = 1, distance = Infinity}) {
    view.composer.passes.pop();  // which encodes colours
    Object.assign(view.occlusion, {intensity, distance});
    const [{texels, proj_vk: p, occlusion}] = recorded(view, 1, () => {});
    const bytes = pixels(view);
    const errors = Array.from(occlusion, (one, i) => {
        const stored = texels[4 * i + 3];
        const away = p[11] === 0 ? (p[14] - stored) / p[10] : p[14] / (p[10] + stored);
        const fade = Math.min(Math.max(2 - 2 * away / distance, 0), 1);
        return Math.abs((1 - Math.min(intensity, 1) * fade * one) ** Math.max(intensity, 1) - bytes[4 * i] / 255);
    });
    return {most: 255 * Math.max(...errors), mean: bytes.reduce((sum, x) => sum + x, 0) / bytes.length};
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
    return {all, solid: apart(none, solid).mean};
}

// What a view shows before its context is lost, and after it was restored.
async function lostAndRestored() {
    const view = made();
    const before = occlusion(frames(view, 5));
    for (const [event, method] of [["lost", "forceContextLoss"], ["restored", "forceContextRestore"]]) {
        const happened = new Promise((resolve) => {
            view.renderer.domElement.addEventListener(`webglcontext${event}`, resolve, {once: true});
        });
        view.renderer[method]();
        await happened;
        await new Promise((resolve) => { setTimeout(resolve, 0); });  // no context is restored within that event
        view.draw();
    }
    return {...apart(before, occlusion(frames(view, 4))), error: view.renderer.getContext().getError()};
}

// Frames of a view and what the effect was given in each, as `gloam render --gbuffer` reads it: row 0 first, depth from
// 0 to 1. `before` may tell it to forget the history. With depths of 16 bits that are cut, as llvmpipe does it, and not
// rounded.
function recorded(view, count, before) {
    const {render} = AmbientOcclusion.prototype;
    const {prepare} = effect;
    const all = [];
    AmbientOcclusion.prototype.render = function (frame) {
        const {projection: p} = frame;
        const half = this.inputs.range === "zero-to-one" ? 0 : 0.5;
        all.push({size: this.size, view: [...frame.view], cut: this.frames === 0, texels: texelsOf(this, frame),
            proj_vk: p.map((x, i) => i % 4 === 2 ? (1 - half) * x + half * p[i + 1] : x)});
        return render.call(this, view.left ? mirrored(frame) : frame);
    };
    effect.prepare = prepare.replace(/depth = (sign_of\([^;]*);/,
        "depth = $1; if (!deep) depth = uintBitsToFloat(floatBitsToUint(depth) & ~0x1FFFu);");
    if (effect.prepare === prepare) throw new Error("prepare has no such line");
    for (let i = 0; i < count; ++i) {
        before(view, i);
        view.draw();
        all.at(-1).occlusion = occlusion(view);
    }
    Object.assign(AmbientOcclusion.prototype, {render});
    Object.assign(effect, {prepare});
    return all;
}

// The same as text.
const written = (all) => all.map((frame) =>
    ({...frame, texels: base64(frame.texels), occlusion: base64(frame.occlusion)}));

// The matrices of the same view with z turned.
const mirrored = ({projection, view, ...frame}) => ({...frame,
    projection: Array.from(projection, (x, i) => i >> 2 === 2 ? -x : x),
    view: Array.from(view, (x, i) => i % 4 === 2 ? -x : x)});

// How far a frame of the class is from that of the pass when it is given linear depth and these normals, octahedral
// ones in world space or "view". left: by a left-handed camera. Visibility is shown in a texture of one's own.
function encoded(view, normals, left, shown = "occlusion") {
    const [{size: [width, height], texels, proj_vk: p, view: matrix, occlusion: want}] = recorded(view, 1, () => {});
    const other = new AmbientOcclusion(view.renderer.getContext(), effect,
        {depth: "linear", range: "zero-to-one", normals, shown});
    const {gl} = other.passes;
    const [depth, normal] = [0, 1].map(() => ({values: new Float32Array(texels.length),
        image: other.passes.image("RGBA32F", [width, height])}));
    for (let i = 0; i < texels.length; i += 4) {
        const [stored, flat] = [texels[i + 3], p[11] === 0];
        depth.values[i] = stored === 1 ? 0 : flat ? (p[14] - stored) / p[10] : p[14] / (p[10] + stored);
        const inView = new Vector3(...texels.subarray(i, i + 3)).multiplyScalar(2).subScalar(1);
        normal.values.set([inView.x, inView.y, left ? -inView.z : inView.z], i);
        if (normals === "view") continue;
        const {x, y, z} = inView.transformDirection(view.camera.matrixWorld);
        const [u, v] = [x, y].map((one) => one / (Math.abs(x) + Math.abs(y) + Math.abs(z)));
        const folded = (one, across) => (1 - Math.abs(across)) * (one < 0 ? -1 : 1);
        normal.values.set(z < 0 ? [folded(u, v), folded(v, u)] : [u, v], i);
    }
    for (const {values, image} of [depth, normal]) {
        gl.bindTexture(gl.TEXTURE_2D, image);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.FLOAT, values);
    }
    other.setPreset("balanced", 1);
    other.setSize(width, height);
    const into = shown === "occlusion" ? null : other.passes.image("RGBA8", [width, height]);
    const frame = {depth: depth.image, normal: normal.image, into, projection: p, view: matrix};
    const drawn = other.render(left ? mirrored(frame) : frame);
    return {...apart(want, other.readShown().map((one) => into === null ? one : 1 - one)),
        into: into === null || drawn === into};
}

// Normal and depth of each pixel.
function texelsOf({passes, size}, {depth, normal}) {
    const {gl} = passes;
    const target = passes.target(size, [passes.image("RGBA32F", size)]);
    const values = new Float32Array(4 * size[0] * size[1]);
    passes.draw(passes.program("texels", effect.whole_image, `#version 300 es
        uniform highp sampler2D depth_image;
        uniform highp sampler2D normal_image;
        layout(location = 0) out highp vec4 texel;
        void main() {
            ivec2 pixel = ivec2(gl_FragCoord.xy);
            texel = vec4(texelFetch(normal_image, pixel, 0).xyz, texelFetch(depth_image, pixel, 0).x);
        }`), {depth_image: depth, normal_image: normal ?? depth}, target);
    gl.readPixels(0, 0, ...size, gl.RGBA, gl.FLOAT, values);
    passes.deleteTarget(target);
    return values;
}

const base64 = (values) =>
    btoa(Array.from(new Uint8Array(values.buffer), (byte) => String.fromCharCode(byte)).join(""));

// The message of the error that a call throws.
function refusal(call) {
    try {
        call();
    } catch (error) {
        return error.message;
    }
    return null;
}

Object.assign(window, {AmbientOcclusion, Fog, FogExp2, ambient, apart, closeViews, comparedPairs, darkening, effect,
    encoded, fogged, frames, jitter, leftHanded, lostAndRestored, made, occlusion, orthographic, recorded, refusal,
    sheet, shown, shownByFormula, turn, withComposerDepth, written});
