// SPDX-License-Identifier: MIT
// Ambient occlusion as a pass of three.js's EffectComposer.
import {DepthTexture, DoubleSide, ExternalTexture, FloatType, HalfFloatType, MeshNormalMaterial, NearestFilter,
    NoBlending, ShaderMaterial, UniformsLib, UniformsUtils, WebGLRenderTarget} from "three";
import {FullScreenQuad, Pass} from "three/addons/postprocessing/Pass.js";
import {AmbientOcclusion, effect} from "./index.js";

const mixVertices = `varying vec2 at;
void main() {
    at = uv;
    gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

// The background is open, so it stays as it is.
const mixFragments = `uniform sampler2D color;
uniform sampler2D occlusion;
uniform float intensity;
uniform bool alone;
varying vec2 at;
void main() {
    float visibility = 1.0 - intensity * texelFetch(occlusion, ivec2(gl_FragCoord.xy), 0).x;
    vec4 shaded = texture2D(color, at);
    gl_FragColor = alone ? vec4(vec3(visibility), 1.0) : vec4(shaded.rgb * visibility, shaded.a);
}`;

// What is put into the shader of a material whose ambient light is darkened.
const ambientUniforms = `uniform highp sampler2D gloamOcclusion;
uniform float gloamIntensity;
uniform bool gloamBounces;
${effect.multi_bounce}`;
const ambientDarkened = `
float gloamShown = gloamIntensity * texelFetch(gloamOcclusion, ivec2(gl_FragCoord.xy), 0).x;
reflectedLight.indirectDiffuse *= gloamBounces ? gloam_multi_bounce(gloamShown, diffuseColor.rgb)
    : vec3(1.0 - gloamShown);`;

// Materials that were given to darken(), and the pass whose occlusion they read.
const darkened = new WeakMap();

// Lets the shader of a MeshNormalMaterial leave out what alphaTest leaves out.
function cutOut(shader) {
    Object.assign(shader.uniforms, UniformsUtils.clone(UniformsLib.common));
    const parts = ["map", "alphamap", "alphatest"];
    for (const [place, ending] of [["#include <uv_pars_fragment>", "_pars_fragment"],
        ["#include <logdepthbuf_fragment>", "_fragment"]])
        shader.fragmentShader = shader.fragmentShader.replace(place,
            [place, ...parts.map((part) => `#include <${part}${ending}>`)].join("\n"));
}

// Materials that draw normals in the place of a scene's own ones, and hide what has no surface.
class NormalMaterials {
    constructor() {
        this.known = new Map();
        this.hidden = new MeshNormalMaterial({visible: false});
        this.replaced = [];
        this.forget = ({target}) => {
            this.known.get(target).dispose();
            this.known.delete(target);
            target.removeEventListener("dispose", this.forget);
        };
    }

    // That of one of the scene's materials.
    of(material) {
        if (material.transparent || material.depthWrite === false || !material.visible) return this.hidden;
        if (!this.known.has(material)) {
            this.known.set(material, Object.assign(new MeshNormalMaterial({blending: NoBlending}),
                {onBeforeCompile: cutOut}));
            material.addEventListener("dispose", this.forget);
        }
        const normals = this.known.get(material);
        for (const name of NormalMaterials.shared) if (name in material) normals[name] = material[name];
        for (const name of ["map", "alphaMap"]) normals[name] = material.alphaTest > 0 ? material[name] : null;
        normals.version = material.version;
        return normals;
    }

    static shared = ["side", "flatShading", "wireframe", "opacity", "alphaTest", "clippingPlanes", "clipIntersection",
        "displacementMap", "displacementScale", "displacementBias"];

    replace(scene) {
        scene.traverse((object) => {
            const {material} = object;
            if (!material) return;
            this.replaced.push([object, material]);
            if (!object.isMesh) object.material = this.hidden;  // points, lines, sprites
            else object.material = Array.isArray(material) ? material.map((one) => this.of(one)) : this.of(material);
        });
    }

    restore() {
        for (const [object, material] of this.replaced) object.material = material;
        this.replaced = [];
    }

    dispose() {
        for (const material of this.known.keys()) this.forget({target: material});
        this.hidden.dispose();
    }
}

export class AmbientOcclusionPass extends Pass {
    constructor(scene, camera, options = {}) {
        super();
        for (const [name, object, kind] of [["scene", scene, "isObject3D"], ["camera", camera, "isCamera"]])
            if (!object?.[kind]) throw new Error(`${name}: expected one of three.js, got ${object}`);
        const known = {preset: effect.preset, radius: 1, intensity: 1, output: "shaded", source: "scene",
            bounces: false, deep: false};
        for (const name of Object.keys(options))
            if (!(name in known)) throw new Error(`option "${name}": expected ${Object.keys(known).join(", ")}`);
        const {output, source} = Object.assign(known, options);
        for (const [name, value, expected] of [["output", output, ["shaded", "visibility", "ambient"]],
            ["source", source, ["scene", "composer"]]])
            if (!expected.includes(value))
                throw new Error(`${name} "${value}": expected ${expected.map((one) => `"${one}"`).join(" or ")}`);
        Object.assign(this, {scene, camera, ...known});
        this.size = [1, 1];
        this.occlusion = null;
        this.materials = new NormalMaterials();
        const pass = this;
        this.uniforms = {color: {value: null}, occlusion: {value: new ExternalTexture()}, alone: {value: false},
            intensity: {get value() { return pass.enabled && pass.occlusion ? pass.intensity : 0; }},
            bounces: {get value() { return pass.bounces; }}};
        this.mix = new FullScreenQuad(new ShaderMaterial({vertexShader: mixVertices, fragmentShader: mixFragments,
            uniforms: this.uniforms, depthTest: false, depthWrite: false, blending: NoBlending, side: DoubleSide}));
    }

    // Lets the occlusion darken the ambient light alone of a material that three.js lights: for the output "ambient",
    // with this pass before the RenderPass.
    darken(material) {
        const known = darkened.has(material);
        darkened.set(material, this);
        if (known) return;
        const compile = material.onBeforeCompile;
        const key = material.customProgramCacheKey;
        material.onBeforeCompile = (shader, renderer) => {
            compile.call(material, shader, renderer);
            const place = "#include <aomap_fragment>";
            if (!shader.fragmentShader.includes(place))
                throw new Error(`${material.type}: expected a material that three.js lights`);
            for (const name of ["Occlusion", "Intensity", "Bounces"])
                shader.uniforms[`gloam${name}`] = {get value() {
                    return darkened.get(material).uniforms[name.toLowerCase()].value;
                }};
            shader.fragmentShader = ambientUniforms + shader.fragmentShader.replace(place, place + ambientDarkened);
        };
        material.customProgramCacheKey = () => key.call(material) + " gloam";
        material.needsUpdate = true;
    }

    // Forgets the history: call it where the camera jumps.
    restart() {
        this.occlusion?.restart();
    }

    setSize(width, height) {
        this.size = [width, height].map((n) => Math.max(Math.floor(n), 1));
    }

    render(renderer, writeBuffer, readBuffer) {
        if (renderer.getContext().isContextLost()) return;
        const inputs = this.source === "scene" ? this.drawScene(renderer) : AmbientOcclusionPass.drawn(readBuffer);
        const raw = (texture) => renderer.properties.get(texture).__webglTexture;
        this.prepare(renderer);
        const {camera} = this;
        const {uniforms} = this;
        uniforms.occlusion.value.sourceTexture = this.occlusion.render({depth: raw(inputs.depth),
            normal: inputs.normal === null ? null : raw(inputs.normal),
            projection: camera.projectionMatrix.elements, view: camera.matrixWorldInverse.elements});
        // resetState() forgets that the depth buffer is reversed, and to what it is cleared.
        const {depth} = renderer.state.buffers;
        const reversed = depth.getReversed();
        renderer.resetState();
        depth.setReversed(reversed);
        depth.setClear(1);
        this.needsSwap = this.output !== "ambient";
        if (!this.needsSwap) return;
        uniforms.color.value = readBuffer.texture;
        uniforms.alone.value = this.output === "visibility";
        renderer.setRenderTarget(this.renderToScreen ? null : writeBuffer);
        this.mix.render(renderer);
    }

    // Brings the effect to the options that are set now.
    prepare(renderer) {
        const reversed = renderer.state.buffers.depth.getReversed();
        const inputs = {depth: "buffer", range: reversed ? "zero-to-one" : "negative-one-to-one",
            normals: this.source === "scene" ? "view-unorm" : "none", deep: this.deep};
        const made = JSON.stringify(inputs);
        if (this.made !== made) {
            if (renderer.capabilities.logarithmicDepthBuffer)
                throw new Error("logarithmicDepthBuffer: expected a linear or a reversed depth buffer");
            this.occlusion?.dispose();
            this.occlusion = new AmbientOcclusion(renderer.getContext(), effect, inputs);
            this.made = made;
            this.chosen = this.sized = this.seen = null;
        }
        const {occlusion, size, preset, radius, camera} = this;
        if (this.chosen?.some((one, i) => one !== [preset, radius][i]) ?? true)
            occlusion.setPreset(preset, radius);
        this.chosen = [preset, radius];
        if (this.sized !== String(size)) occlusion.setSize(...size);
        this.sized = String(size);
        if (this.seen !== camera) occlusion.restart();
        this.seen = camera;
    }

    // The depth that the pass before has drawn.
    static drawn({depthTexture}) {
        if (!depthTexture) throw new Error('source "composer": expected a composer whose target has a depthTexture');
        return {depth: depthTexture, normal: null};
    }

    // Draws depth and normals of the scene.
    drawScene(renderer) {
        const [width, height] = this.size;
        this.target ??= new WebGLRenderTarget(width, height, {type: HalfFloatType, minFilter: NearestFilter,
            magFilter: NearestFilter, depthTexture: new DepthTexture(width, height, FloatType)});
        this.target.setSize(width, height);
        const {scene, materials} = this;
        const {background, overrideMaterial} = scene;
        const {autoClear} = renderer;
        const {autoUpdate} = renderer.shadowMap;
        try {
            Object.assign(scene, {background: null, overrideMaterial: null});
            renderer.shadowMap.autoUpdate = false;
            renderer.autoClear = true;
            materials.replace(scene);
            renderer.setRenderTarget(this.target);
            renderer.render(scene, this.camera);
        } finally {
            materials.restore();
            Object.assign(renderer, {autoClear});
            renderer.shadowMap.autoUpdate = autoUpdate;
            Object.assign(scene, {background, overrideMaterial});
        }
        return {depth: this.target.depthTexture, normal: this.target.texture};
    }

    dispose() {
        this.occlusion?.dispose();
        this.occlusion = null;
        this.made = null;
        this.target?.depthTexture.dispose();
        this.target?.dispose();
        this.target = undefined;
        this.materials.dispose();
        this.mix.material.dispose();
        this.mix.dispose();
    }
}
