// SPDX-License-Identifier: MIT

export interface Preset {
    readonly name: string;
    readonly description: string;
    /** Of each pixel that is swept; and the taps on each side of one. */
    readonly slices: number;
    readonly steps: number;
    /** Which pixels are swept: each, every second one in both directions, or these and each of some tiles of 8 x 8. */
    readonly resolution: "full" | "half" | "tiles";
    /** Of tiles: the deviation of the occlusion in one from which on each of its pixels is swept. */
    readonly mark: number;
    /** How far a mean of frames may be from that of the last ones; and how much less of a new frame it filters. */
    readonly range: number;
    readonly sharpness: number;
}

/** The presets, and the shaders in GLSL ES 3.00. */
export interface Effect {
    /** The default preset. */
    readonly preset: string;
    readonly presets: readonly Preset[];
    /** Of the first sweep, with tiles. */
    readonly steps_before_tiles: number;
    readonly whole_image: string;
    readonly tiles: string;
    readonly prepare: string;
    readonly sweep: string;
    readonly sweep_from_depth: string;
    readonly mark: string;
    readonly refine: string;
    readonly refine_from_depth: string;
    readonly halve: string;
    readonly filter: string;
    readonly filter_of_tiles: string;
    readonly join: string;
    readonly join_of_tiles: string;
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
    /**
     * The camera may zoom to a view of less than 30 degrees: depth then takes twice the memory. Orthographic cameras,
     * and those that begin so narrow, have that without it. Default false.
     */
    deep?: boolean;
    /** What render() gives: "occlusion" (the default), 1 where blocked, or "visibility", 1 where open. */
    shown?: "occlusion" | "visibility";
}

/** Textures of the size of the view, stored as the constructor was told; matrices as the vertices were drawn with. */
export interface Frame {
    depth: WebGLTexture;
    normal?: WebGLTexture | null;
    /** From view to clip space, 16 numbers, column by column. It may be off its centre, and of a left-handed view. */
    projection: ArrayLike<number>;
    /** From world to view space, likewise. */
    view: ArrayLike<number>;
    /** What is drawn, of the size of the view, R8 or RGBA8; default: a texture of the object's own. */
    into?: WebGLTexture | null;
}

/** The frame in sequences for any engine of WebGL2. */
export class AmbientOcclusion {
    /** Throws an Error for other inputs, and where the context is not WebGL2 or cannot draw floats. */
    constructor(gl: WebGL2RenderingContext, effect: Effect, inputs?: Inputs);
    /** Frames since the history began. */
    readonly frames: number;
    /**
     * radius: of influence, world units. resolution: in the place of the preset's. Begins a new history. Throws an Error
     * for another preset, radius or resolution.
     */
    setPreset(preset: string, radius: number, options?: {resolution?: Preset["resolution"] | null}): void;
    /** Pixels of the images that render() gets. Begins a new history. */
    setSize(width: number, height: number): void;
    /** Forgets the history: call it where the picture is cut. */
    restart(): void;
    /**
     * Renders a frame: it is added to the history, which is moved where the view has. Returns the texture that it has
     * drawn, whose first channel is what is shown, 8 bits; null where the context is lost. One of the object's own is
     * valid until the next call.
     * Leaves no program, vertex array or framebuffer bound, tests and blending off, and its viewport and textures.
     */
    render(frame: Frame): WebGLTexture | null;
    /** What the last frame has shown, one float a pixel, row 0 first. Waits for the GPU. */
    readShown(): Float32Array;
    /** Deletes what this object has made in the context. */
    dispose(): void;
}
