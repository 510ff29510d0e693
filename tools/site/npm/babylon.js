// SPDX-License-Identifier: MIT
// Ambient occlusion as a post-process of Babylon.js.
import {Effect} from "@babylonjs/core/Materials/effect.js";
import {RenderTargetTexture} from "@babylonjs/core/Materials/Textures/renderTargetTexture.js";
import {Texture} from "@babylonjs/core/Materials/Textures/texture.js";
import {Constants} from "@babylonjs/core/Engines/constants.js";
import {PostProcess} from "@babylonjs/core/PostProcesses/postProcess.js";
import {DepthRenderer} from "@babylonjs/core/Rendering/depthRenderer.js";
import "@babylonjs/core/Rendering/depthRendererSceneComponent.js";  // what a DepthRenderer before 9 needs
import {AmbientOcclusion, effect} from "./index.js";

Effect.ShadersStore.gloamFragmentShader = `varying vec2 vUV;
uniform sampler2D textureSampler;
uniform sampler2D visibility;
uniform float intensity;
void main() {
    vec4 color = texture2D(textureSampler, vUV);
    float seen = mix(1.0, texture2D(visibility, vUV).x, min(intensity, 1.0));
    gl_FragColor = vec4(color.rgb * pow(seen, max(intensity, 1.0)), color.a);
}`;

export class AmbientOcclusionPostProcess extends PostProcess {
    constructor(name, camera, {preset = effect.preset, radius = 1, intensity = 1, ...options} = {}) {
        const scene = camera.getScene();
        const engine = scene.getEngine();
        const occlusion = new AmbientOcclusion(engine._gl, effect, {depth: "buffer", shown: "visibility",
            range: engine.isNDCHalfZRange ? "zero-to-one" : "negative-one-to-one"});
        super(name, "gloam", {...options, camera, uniforms: ["intensity"], samplers: ["visibility"]});
        Object.assign(this, {preset, radius, intensity, occlusion});
        this.depth = new DepthRenderer(scene, Constants.TEXTURETYPE_FLOAT, camera, true, Texture.NEAREST_SAMPLINGMODE);
        if (engine.useReverseDepthBuffer) this.depth.clearColor.r = 0;
        const map = this.depth.getDepthMap();
        this.visibility = new RenderTargetTexture(`${name} visibility`, map.getSize(), scene, {generateMipMaps: false,
            generateDepthBuffer: false, samplingMode: Texture.NEAREST_SAMPLINGMODE, format: Constants.TEXTUREFORMAT_R});
        camera.customRenderTargets.push(map);
        map.onBeforeBindObservable.add(() => this.fit(map, engine.getRenderWidth(), engine.getRenderHeight()));
        map.onAfterUnbindObservable.add(() => this.draw(map, camera, engine));
        this.onApplyObservable.add((shader) => {
            shader.setTexture("visibility", this.visibility);
            shader.setFloat("intensity", this.intensity);
        });
    }

    // The depth renderer keeps the size that it has begun with.
    fit(map, width, height) {
        const size = map.getSize();
        if (size.width !== width || size.height !== height)
            for (const image of [map, this.visibility]) image.resize({width, height});
    }

    draw(map, camera, engine) {
        const {occlusion, preset, radius} = this;
        const {width, height} = map.getSize();
        const raw = (texture) => texture.getInternalTexture()._hardwareTexture.underlyingResource;
        occlusion.choose(preset, radius, [width, height]);
        occlusion.render({depth: raw(map), into: raw(this.visibility), view: camera.getViewMatrix().asArray(),
            projection: camera.getProjectionMatrix().asArray()});
        engine.wipeCaches(true);
    }

    restart() {
        this.occlusion.restart();
    }

    dispose(camera = this.getCamera()) {
        const targets = camera.customRenderTargets;
        const at = targets.indexOf(this.depth.getDepthMap());
        if (at >= 0) targets.splice(at, 1);
        this.depth.dispose();
        this.visibility.dispose();
        this.occlusion.dispose();
        super.dispose(camera);
    }
}
