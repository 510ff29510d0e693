// SPDX-License-Identifier: MIT
import {CameraFrame, type AppBase, type CameraComponent} from "playcanvas";

/**
 * A CameraFrame of PlayCanvas whose ambient occlusion is gloam's: `ssao.type` says what it darkens, the ambient light
 * alone (SSAOTYPE_LIGHTING, the default) or the picture (SSAOTYPE_COMBINE).
 */
export class AmbientOcclusionCameraFrame extends CameraFrame {
    /** Throws an Error where the device is not one of WebGL2. */
    constructor(app: AppBase, cameraComponent: CameraComponent);
    /**
     * radius: how far what blocks light may be, world units; default 1. preset: "fast", "balanced" (the default),
     * "quality" or "reference". Of the others, type counts alone.
     */
    ssao: CameraFrame["ssao"] & {preset: string};
    /** Forgets the history: call it where the camera jumps. */
    restart(): void;
}
