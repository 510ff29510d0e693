// SPDX-License-Identifier: MIT

/** The value of a setting; null is infinity. */
export type Setting = number | boolean | string | null;

/** A method: its pass in GLSL ES 3.00. */
export interface Method {
    readonly name: string;
    readonly description: string;
    readonly text: string;
}

export interface Preset {
    readonly name: string;
    readonly description: string;
    /** Name of its method. */
    readonly method: string;
    /** For a radius of 1. */
    readonly settings: Readonly<Record<string, Setting>>;
}

/** The shaders in GLSL ES 3.00, the presets, and the methods that these use. */
export interface Effect {
    /** The default preset. */
    readonly preset: string;
    readonly presets: readonly Preset[];
    readonly methods: readonly Method[];
    /** Names of the settings that are lengths and scale with the radius. */
    readonly lengths: readonly string[];
    readonly whole_image: string;
    readonly take_inputs: string;
    readonly normals_from_depth: string;
    readonly halve_inputs: string;
    readonly reproject: string;
    readonly spatial_filter: string;
    readonly upsample: string;
    /** `vec3 gloam_multi_bounce(float occlusion, vec3 albedo)`: factor of the ambient light, with what surfaces reflect. */
    readonly multi_bounce: string;
}
export const effect: Effect;

/** How the engine stores what render() gets. */
export interface Inputs {
    /** "buffer" (the default): a depth buffer, standard or reversed. "linear": eye-linear depth, 0 for background. */
    depth?: "buffer" | "linear";
    /** Depth range of the projection; "negative-one-to-one" is the default, that of OpenGL. */
    range?: "negative-one-to-one" | "zero-to-one";
    /**
     * "none" (the default): they are made from depth. "view" or "world" space, and behind it "-octahedral" for two
     * coordinates, "-unorm" where 0 to 1 stands for -1 to 1, or both.
     */
    normals?: string;
}

export interface Frame {
    depth: WebGLTexture;
    normal?: WebGLTexture | null;
    /** From view to clip space, 16 numbers, column by column. A jitter of up to a pixel is left out. */
    projection: ArrayLike<number>;
    /** From world to view space, likewise. */
    view: ArrayLike<number>;
}

/** The temporal effect for any engine of WebGL2. */
export class AmbientOcclusion {
    /** Throws an Error for other inputs, and where the context is not WebGL2 or cannot draw floats. */
    constructor(gl: WebGL2RenderingContext, effect: Effect, inputs?: Inputs);
    /** Frames since the history began. */
    readonly frames: number;
    /** The settings in use; a change holds until a preset is set. */
    readonly settings: Record<string, Setting>;
    /** radius: world units. Begins a new history. */
    setPreset(preset: string, radius: number): void;
    /** Pixels of the images that render() gets. Begins a new history. */
    setSize(width: number, height: number): void;
    /** Forgets the history: call it where the picture is cut. */
    restart(): void;
    /**
     * Renders a frame. Returns a texture of the size of the view whose first channel is the occlusion: 0 open, 1
     * blocked. It is valid until the next call; read it with texelFetch(), it may be a format without filtering.
     * Leaves no program, vertex array or framebuffer bound, tests and blending off, and its viewport and textures.
     */
    render(frame: Frame): WebGLTexture;
    /** Occlusion of the last frame, one float a pixel, row 0 first. Waits for the GPU. */
    readOcclusion(): Float32Array;
    /** History of the last frame, four floats a pixel: occlusion, samples, samples of the sequence used, depth. */
    readHistory(): Float32Array;
    /** Deletes what this object has made in the context. */
    dispose(): void;
}
