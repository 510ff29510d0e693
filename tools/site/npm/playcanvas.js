// SPDX-License-Identifier: MIT
// Ambient occlusion in a CameraFrame of PlayCanvas, in the place of its own.
import {ADDRESS_CLAMP_TO_EDGE, CameraFrame, FILTER_NEAREST, FramePassCameraFrame, PIXELFORMAT_R8, RenderPass,
    SSAOTYPE_LIGHTING, SSAOTYPE_NONE, Texture} from "playcanvas";
import {AmbientOcclusion, effect} from "./index.js";

// It has no target of the engine's: the passes of the effect bind their own.
class OcclusionPass extends RenderPass {
    constructor(device, {ssao, cameraComponent: {camera}}, {linearDepthTexture: depth}) {
        super(device);
        const occlusion = new AmbientOcclusion(device.gl, effect, {depth: "linear", shown: "visibility"});
        Object.assign(this, {ssao, camera, depth, occlusion});
        this.ssaoTexture = new Texture(device, {name: "gloam", width: 1, height: 1, format: PIXELFORMAT_R8,
            mipmaps: false, minFilter: FILTER_NEAREST, magFilter: FILTER_NEAREST, addressU: ADDRESS_CLAMP_TO_EDGE,
            addressV: ADDRESS_CLAMP_TO_EDGE});
    }

    execute() {
        const {device, ssao, camera, depth, occlusion, ssaoTexture} = this;
        const {width, height} = depth;
        occlusion.choose(ssao.preset, ssao.radius, [width, height]);
        if (ssaoTexture.width !== width || ssaoTexture.height !== height) ssaoTexture.resize(width, height);
        device.setTexture(ssaoTexture, 0);  // a new one gets its texture of the context only here
        const projection = Array.from(camera.projectionMatrix.data);
        for (const i of [0, 1]) projection[8 + i] += camera._jitters[i];  // as the depth was drawn with
        occlusion.render({depth: depth.impl._glTexture, into: ssaoTexture.impl._glTexture, projection,
            view: camera.viewMatrix.data});
        // What the device believes to be set, and is no more.
        device.initializeRenderState();
        device.initTextureUnits(device.maxCombinedTextures);
        Object.assign(device, {shader: null, boundVao: null, activeFramebuffer: null});
    }

    after() {
        const {device: {scope}, ssaoTexture} = this;
        scope.resolve("ssaoTexture").setValue(ssaoTexture);
        scope.resolve("ssaoTextureSizeInv").setValue([1 / ssaoTexture.width, 1 / ssaoTexture.height]);
    }

    destroy() {
        this.occlusion.dispose();
        this.ssaoTexture.destroy();
    }
}

class Passes extends FramePassCameraFrame {
    // The linear depth is drawn before the scene, whatever darkens it.
    needsInSceneDepth(options) {
        return options.ssaoType !== SSAOTYPE_NONE || super.needsInSceneDepth(options);
    }

    setupSsaoPass({ssaoType}) {
        if (ssaoType !== SSAOTYPE_NONE) this.ssaoPass = new OcclusionPass(this.device, this.cameraFrame, this.prePass);
    }
}

export class AmbientOcclusionCameraFrame extends CameraFrame {
    constructor(app, cameraComponent) {
        super(app, cameraComponent);
        Object.assign(this.ssao, {type: SSAOTYPE_LIGHTING, radius: 1, preset: effect.preset});
        this.update();
    }

    createRenderPass() {
        return new Passes(this.app, this, this.cameraComponent, this.options);
    }

    restart() {
        this.renderPassCamera?.ssaoPass?.occlusion.restart();
    }
}
