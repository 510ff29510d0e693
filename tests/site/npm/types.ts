// SPDX-License-Identifier: MIT
// Uses of the package that its types allow, and one that they refuse.
import {PerspectiveCamera, Scene} from "three";
import {EffectComposer} from "three/addons/postprocessing/EffectComposer.js";
import {AmbientOcclusion, effect, type Frame} from "gloam";
import {AmbientOcclusionPass} from "gloam/three";

export function renderWith(gl: WebGL2RenderingContext, frame: Frame): WebGLTexture | null {
    const occlusion = new AmbientOcclusion(gl, effect, {depth: "buffer", range: "zero-to-one", normals: "view-unorm"});
    occlusion.setPreset("fast", 0.5);
    occlusion.setSize(640, 360);
    return occlusion.render(frame);
}

export function add(composer: EffectComposer): void {
    const pass = new AmbientOcclusionPass(new Scene(), new PerspectiveCamera(), {radius: 0.5, resolution: "tiles"});
    // @ts-expect-error there is no such output
    pass.output = "nothing";
    composer.addPass(pass);
}
