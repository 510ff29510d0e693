// SPDX-License-Identifier: MIT
import type {Camera} from "@babylonjs/core/Cameras/camera.js";
import {PostProcess, type PostProcessOptions} from "@babylonjs/core/PostProcesses/postProcess.js";

export interface OcclusionOptions {
    /** "fast", "balanced" (the default), "quality" or "reference". */
    preset?: string;
    /** How far what blocks light may be, world units; default 1. */
    radius?: number;
    /** Share of the occlusion that is shown; above 1 visibility to this power; default 1. */
    intensity?: number;
}

/**
 * Ambient occlusion in a camera of Babylon.js, left- or right-handed. It draws the scene's depth itself, and darkens
 * the picture. All options may be set later, too.
 */
export class AmbientOcclusionPostProcess extends PostProcess {
    /** Also options of PostProcess, as its textureType. Throws an Error where the engine is not one of WebGL2. */
    constructor(name: string, camera: Camera, options?: OcclusionOptions & Omit<PostProcessOptions, "camera">);
    /** Forgets the history: call it where the camera jumps. */
    restart(): void;
}

export interface AmbientOcclusionPostProcess extends Required<OcclusionOptions> {}
