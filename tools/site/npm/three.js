// SPDX-License-Identifier: MIT
// Ambient occlusion as a pass of three.js's EffectComposer.
import {DepthTexture, DoubleSide, ExternalTexture, FloatType, HalfFloatType, MeshNormalMaterial, NearestFilter,
    NoBlending, ShaderMaterial, WebGLRenderTarget} from "three";
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

// Materials that draw normals in the place of a scene's own ones, and hide what has no surface.
class NormalMaterials {
    constructor() {
        this.known = new Map();
        this.hidden = new MeshNormalMaterial({visible: false});
        this.replaced = [];
    }

    // That of one of the scene's materials: its side and its shading.
    of(material) {
        if (material.transparent || material.depthWrite === false || !material.visible) return this.hidden;
        const key = `${material.side} ${Boolean(material.flatShading)}`;
        if (!this.known.has(key)) {
            const {side, flatShading} = material;
            this.known.set(key, new MeshNormalMaterial({side, flatShading: Boolean(flatShading),
                blending: NoBlending}));
        }
        return this.known.get(key);
    }

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
        for (const material of [...this.known.values(), this.hidden]) material.dispose();
    }
}

export class AmbientOcclusionPass extends Pass {
    constructor(scene, camera, {preset = effect.preset, radius = 1, intensity = 1, output = "shaded",
        source = "scene", bounces = false} = {}) {
        super();
        for (const [name, value, expected] of [["output", output, ["shaded", "visibility", "ambient"]],
            ["source", source, ["scene", "composer"]]])
            if (!expected.includes(value))
                throw new Error(`${name} "${value}": expected ${expected.map((one) => `"${one}"`).join(" or ")}`);
        Object.assign(this, {scene, camera, preset, radius, intensity, output, source, bounces});
        this.size = [1, 1];
        this.occlusion = null;
        this.materials = new NormalMaterials();
        this.uniforms = {color: {value: null}, occlusion: {value: new ExternalTexture()}, intensity: {value: 1},
            alone: {value: false}, bounces: {value: false}};
        this.mix = new FullScreenQuad(new ShaderMaterial({vertexShader: mixVertices, fragmentShader: mixFragments,
            uniforms: this.uniforms, depthTest: false, depthWrite: false, blending: NoBlending, side: DoubleSide}));
    }

    // Lets the occlusion darken the ambient light alone of a material that three.js lights: for the output "ambient",
    // with this pass before the RenderPass.
    darken(material) {
        const compile = material.onBeforeCompile;
        const key = material.customProgramCacheKey;
        material.onBeforeCompile = (shader, renderer) => {
            compile.call(material, shader, renderer);
            const place = "#include <aomap_fragment>";
            if (!shader.fragmentShader.includes(place))
                throw new Error(`${material.type}: expected a material that three.js lights`);
            shader.uniforms.gloamOcclusion = this.uniforms.occlusion;
            shader.uniforms.gloamIntensity = this.uniforms.intensity;
            shader.uniforms.gloamBounces = this.uniforms.bounces;
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
        uniforms.intensity.value = this.intensity;
        uniforms.bounces.value = this.bounces;
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
            normals: this.source === "scene" ? "view-unorm" : "none"};
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
        const {background} = scene;
        const {autoClear} = renderer;
        const {autoUpdate} = renderer.shadowMap;
        try {
            scene.background = null;
            renderer.shadowMap.autoUpdate = false;
            renderer.autoClear = true;
            materials.replace(scene);
            renderer.setRenderTarget(this.target);
            renderer.render(scene, this.camera);
        } finally {
            materials.restore();
            Object.assign(renderer, {autoClear});
            renderer.shadowMap.autoUpdate = autoUpdate;
            scene.background = background;
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
