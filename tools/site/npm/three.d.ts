// SPDX-License-Identifier: MIT
import type {Camera, Material, Scene, WebGLRenderer, WebGLRenderTarget} from "three";
import {Pass} from "three/addons/postprocessing/Pass.js";

export interface PassOptions {
    /** "fast", "balanced" (the default), "quality" or "reference". */
    preset?: string;
    /** How far what blocks light may be, world units; default 1. */
    radius?: number;
    /** Which pixels are swept (Preset.resolution); null (the default): those of the preset. */
    resolution?: "full" | "tiles" | "half" | null;
    /** Share of the occlusion that is shown; above 1 visibility to this power; default 1. */
    intensity?: number;
    /** Where none is shown any more, world units: it fades out from half of it on. Default Infinity. */
    distance?: number;
    /**
     * "shaded" (the default): the picture, darkened. "visibility": 1 where open, 0 where blocked. "ambient": no picture;
     * the materials given to darken() read the occlusion.
     */
    output?: "shaded" | "visibility" | "ambient";
    /**
     * "scene" (the default): the pass draws the scene: depth and normals, and for "shaded", in the place of a
     * RenderPass, the picture: what is opaque is darkened before transparent surfaces are drawn over it. "composer": it
     * darkens the picture of the passes before it, and reads the depthTexture of the composer's target, which the pass
     * right before it has drawn; it makes normals from that.
     */
    source?: "scene" | "composer";
    /** The camera may zoom to a view of less than 30 degrees (Inputs.deep); default false. */
    deep?: boolean;
    /** With "ambient": light that surfaces of one colour send each other brightens corners; default false. */
    bounces?: boolean;
}

/**
 * Ambient occlusion in an EffectComposer, in the place of its RenderPass; before it with the output "ambient", behind
 * it with the output "visibility" or the source "composer". All options may be set later, too.
 */
export class AmbientOcclusionPass extends Pass {
    /** Throws an Error for another option, or a value that none of these is. */
    constructor(scene: Scene, camera: Camera, options?: PassOptions);
    scene: Scene;
    /** Another camera begins a new history. */
    camera: Camera;
    /** Forgets the history: call it where the camera jumps. */
    restart(): void;
    /**
     * Lets the occlusion darken the ambient light alone of a material that three.js lights: for the output "ambient",
     * with this pass before the RenderPass. Of several passes, a material reads the one that it was given to last.
     */
    darken(material: Material): void;
    setSize(width: number, height: number): void;
    /** Throws an Error for a logarithmic depth buffer. Does nothing while the context is lost. */
    render(renderer: WebGLRenderer, writeBuffer: WebGLRenderTarget, readBuffer: WebGLRenderTarget): void;
    dispose(): void;
}

export interface AmbientOcclusionPass extends Required<PassOptions> {}
