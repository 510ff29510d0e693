// SPDX-License-Identifier: MIT
// Ambient occlusion as a pass of three.js's EffectComposer. ExternalTexture came with version 0.180.
import {BufferGeometry, CustomBlending, DepthTexture, DoubleSide, ExternalTexture, FloatType, Group, HalfFloatType,
    Mesh, MeshNormalMaterial, NearestFilter, NoBlending, OneFactor, ShaderMaterial, SrcAlphaFactor, UniformsLib,
    UniformsUtils, WebGLRenderTarget, ZeroFactor} from "three";
import {Pass} from "three/addons/postprocessing/Pass.js";
import {AmbientOcclusion, effect} from "./index.js";

const mixVertices = `void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`;

// What is shown of the occlusion at a point so far from the camera.
const visibility = `uniform highp sampler2D gloamOcclusion;
uniform float gloamIntensity;
uniform float gloamFade;
float gloamVisibility(float away) {
    float occlusion = texelFetch(gloamOcclusion, ivec2(gl_FragCoord.xy), 0).x;
    occlusion *= clamp(2.0 - 2.0 * gloamFade * away, 0.0, 1.0);
    return pow(1.0 - min(gloamIntensity, 1.0) * occlusion, max(gloamIntensity, 1.0));
}
`;

// Fog lies between a surface and the camera: it is not darkened. The background is open, so it stays as it is.
const mixFragments = `${visibility}
uniform sampler2D color;
uniform highp sampler2D depth;
uniform vec4 lens;
uniform vec3 fog;
uniform vec3 fogColor;
uniform bool alone;
uniform bool between;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float stored = texelFetch(depth, pixel, 0).x;
    float away = min((lens.x + lens.y * stored) / (lens.z + lens.w * stored), 1e15);
    float visible = gloamVisibility(away);
    float fogged = fog.z > 0.0 ? 1.0 - exp(-fog.z * fog.z * away * away) : smoothstep(fog.x, fog.y, away);
    vec3 restored = (1.0 - visible) * fogged * fogColor;
    vec4 shaded = texelFetch(color, pixel, 0);
    gl_FragColor = alone ? vec4(vec3(visible), 1.0) : between ? vec4(restored, visible)
        : vec4(shaded.rgb * visible + restored, shaded.a);
}`;

// What is put into the shader of a material whose ambient light is darkened.
const ambientUniforms = `${visibility}uniform bool gloamBounces;
${effect.multi_bounce}`;
const ambientDarkened = `
float gloamVisible = gloamVisibility(vViewPosition.z);
reflectedLight.indirectDiffuse *= gloamBounces ? gloam_multi_bounce(1.0 - gloamVisible, diffuseColor.rgb)
    : vec3(gloamVisible);`;

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

    // Whether a material is seen through: it is not in the depth, and not darkened by what lies behind it.
    static through(material) {
        return material.transparent || material.depthWrite === false;
    }

    // That of one of the scene's materials.
    of(material) {
        if (NormalMaterials.through(material) || !material.visible) return this.hidden;
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
        const known = {preset: effect.preset, radius: 1, resolution: null, intensity: 1, distance: Infinity,
            output: "shaded", source: "scene", bounces: false, deep: false};
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
        this.uniforms = {color: {value: null}, depth: {value: null}, lens: {value: []}, fog: {value: []},
            fogColor: {value: []}, alone: {value: false}, between: {value: false},
            gloamOcclusion: {value: new ExternalTexture()}, gloamFade: {get value() { return 1 / pass.distance; }},
            gloamIntensity: {get value() { return pass.enabled && pass.occlusion ? pass.intensity : 0; }},
            gloamBounces: {get value() { return pass.bounces; }}};
        // A triangle over the whole picture: the first of a scene's transparent objects, or alone.
        this.triangle = new Mesh(new BufferGeometry(), new ShaderMaterial({vertexShader: mixVertices,
            fragmentShader: mixFragments, uniforms: this.uniforms, depthTest: false, depthWrite: false,
            transparent: true, side: DoubleSide, blendSrc: OneFactor, blendDst: SrcAlphaFactor,
            blendSrcAlpha: ZeroFactor, blendDstAlpha: OneFactor, allowOverride: false}));
        this.triangle.geometry.setDrawRange(0, 3);
        this.triangle.frustumCulled = false;
        this.triangle.layers.enableAll();
        this.mix = Object.assign(new Group().add(this.triangle), {renderOrder: -Infinity});
        this.mix.layers.enableAll();
    }

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
            for (const name of ["gloamOcclusion", "gloamIntensity", "gloamFade", "gloamBounces"])
                shader.uniforms[name] = {get value() {
                    const left = name === "gloamIntensity" && NormalMaterials.through(material);
                    return left ? 0 : darkened.get(material).uniforms[name].value;
                }};
            shader.fragmentShader = ambientUniforms + shader.fragmentShader.replace(place, place + ambientDarkened);
        };
        material.customProgramCacheKey = () => key.call(material) + " gloam";
        material.needsUpdate = true;
    }

    restart() {
        this.occlusion?.restart();
    }

    setSize(width, height) {
        this.size = [width, height].map((n) => Math.max(Math.floor(n), 1));
    }

    render(renderer, writeBuffer, readBuffer) {
        if (renderer.getContext().isContextLost()) return;
        // Of a composer the depth that the pass before has drawn.
        const inputs = this.source === "scene" ? this.drawScene(renderer)
            : {depth: readBuffer.depthTexture, normal: null};
        if (!inputs.depth) throw new Error('source "composer": expected a composer whose target has a depthTexture');
        const raw = (texture) => renderer.properties.get(texture).__webglTexture;
        this.prepare(renderer);
        const {camera, uniforms, output, source} = this;
        uniforms.gloamOcclusion.value.sourceTexture = this.occlusion.render({depth: raw(inputs.depth),
            normal: inputs.normal === null ? null : raw(inputs.normal),
            projection: camera.projectionMatrix.elements, view: camera.matrixWorldInverse.elements});
        // resetState() forgets that the depth buffer is reversed, and to what it is cleared.
        const {depth} = renderer.state.buffers;
        const reversed = depth.getReversed();
        renderer.resetState();
        depth.setReversed(reversed);
        depth.setClear(1);
        const between = output === "shaded" && source === "scene";
        this.needsSwap = output !== "ambient" && !between;
        if (output === "ambient") return;
        this.setMix({between, alone: output === "visibility", depth: inputs.depth,
            color: between ? null : readBuffer.texture}, reversed ? [1, 0] : [2, -1]);
        renderer.setRenderTarget(this.renderToScreen ? null : between ? readBuffer : writeBuffer);
        if (between) this.drawBetween(renderer);
        else renderer.render(this.mix, camera);
    }

    // scale, offset: from stored depth to clip space.
    setMix(values, [scale, offset]) {
        const [p22, p32, p23, p33] = [10, 14, 11, 15].map((i) => this.camera.projectionMatrix.elements[i]);
        const {near = 1e30, far = 2e30, density = 0, color = [0, 0, 0]} = this.scene.fog ?? {};
        Object.entries({...values, fog: [near, far, density], fogColor: color,
            lens: [offset * p33 - p32, scale * p33, offset * p23 - p22, scale * p23],
        }).forEach(([name, value]) => { this.uniforms[name].value = value; });
        this.triangle.material.blending = values.between ? CustomBlending : NoBlending;
    }

    // Draws the scene, and the occlusion behind what is opaque in it and before what is transparent.
    drawBetween(renderer) {
        const {scene, camera, mix} = this;
        renderer.clear();  // also without autoClear
        scene.children.unshift(mix);  // add() would tell the scene's listeners
        try {
            renderer.render(scene, camera);
        } finally {
            scene.children.shift();
        }
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
            this.seen = null;
        }
        const {occlusion, size, preset, radius, resolution, camera} = this;
        occlusion.choose(preset, radius, size, {resolution});
        if (this.seen !== camera) occlusion.restart();
        this.seen = camera;
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
        this.triangle.material.dispose();
        this.triangle.geometry.dispose();
    }
}
