/* SPDX-License-Identifier: MIT
 * Ambient occlusion in a few passes: what an engine makes for them, and what it gives them each frame. C99 and C++.
 *
 * image        format          size                   written by       read by
 * depth        the engine's    view                   the engine       prepare; in place of normal (nearest)
 * normal       the engine's    view                   the engine       sweep, refine (nearest)
 * levels[2]    R16F            view, 5 mipmaps        prepare          sweep, refine, join; prepare, filter and join of
 *                                                                      the next frame (nearest texel, nearest level)
 * texels       R32UI           view; half of it, up,  sweep; refine    filter (full), join, mark (nearest)
 *                              for half and tiles
 * history[2]   RGB10_A2        view                   filter, join     the same of the next frame (linear)
 * shown        R8              view                   filter, join     the engine: 1 where blocked, 0 where open;
 *                                                                      with constant 10 the other way round
 * Deep, for orthographic cameras and those that zoom to less than 30 degrees: R32F for R16F, RG32UI for R32UI.
 * With tiles, where each pixel is swept in those of 8 x 8 pixels in which half size does not suffice:
 * marks        R8              view / 8, rounded up   mark             fragment refine, halve, join, filter (nearest)
 * full texels  as texels       view                   refine, join     filter (nearest)
 * With bent normals:
 * bends        RGBA8           as texels              sweep; refine    join or filter (nearest)
 * full bends   RGBA8           view                   refine, join     filter (nearest), with tiles
 * bent[2]      RGB10_A2        view                   filter, join     the engine; the same of the next frame (linear)
 *
 * pass         bindings of set 0, in their order                              a group makes
 * prepare      depth, levels (0, 1, 2, 3, 4), levels before; lists            32 x 16 pixels of the view
 * sweep        levels, normal (depth for normals from depth), texels          16 x 8 texels
 * mark         texels, marks, lists                                           8 x 8 marks
 * refine       levels, normal or depth, full texels; texels; lists            as work[1] says
 * join (half)  texels, levels, shown, history before, levels before, history  32 x 16 pixels of the view
 *   (tiles)    these; full texels; lists                                      as work[3] says
 * filter (full)  texels, shown, history before, levels before, history        32 x 8 pixels of the view
 *   (tiles)    the same, but full texels for texels; lists                    as work[2] says
 * They run in this order: prepare, sweep and filter (full) or join (half); with tiles prepare, sweep, mark, refine,
 * join and filter, and lists alone then. With bent normals, at the first semicolon or else at the end: bends in sweep;
 * full bends in refine; bends (with tiles full bends in filter), bent, bent before in filter and join; and behind
 * texels in refine bends, behind full texels in join full bends. normalize(normal + 2 bent - 1), all in view space, is
 * the mean of the open directions by the cosine.
 *
 * "before" is that of the last frame: the two of levels, history and bent change places. Images begin with zeros;
 * samplers clamp to the edge. A cut needs no image cleared.
 * Lists: a storage buffer of 68 bytes and 8 for each mark, which prepare empties and mark fills. It begins with work[0]
 * to work[3], of 16 bytes each: the groups (x, y, 1) of an indirect dispatch, and a count.
 * Vulkan: structures are push constants, images are in layout GENERAL, and before each pass there is a memory barrier
 * from COMPUTE_SHADER, SHADER_WRITE to COMPUTE_SHADER, SHADER_READ | SHADER_WRITE. With tiles both stages are
 * COMPUTE_SHADER | DRAW_INDIRECT, the second access is INDIRECT_COMMAND_READ, too, and the buffer has the usages
 * STORAGE and INDIRECT. The device needs the feature shaderStorageImageExtendedFormats. Specialization constants:
 * 1 orthographic; 2, 3, 4 normals in world space, octahedral, from 0 to 1; 5 slices; 6 steps; 8 frames follow one
 * another; 9 deep, for which what writes levels or texels is packed with the other formats; 10 what is shown is
 * visibility, of filter and join.
 * OpenGL: structures are the uniform block 0 (Parameters), in a buffer of 128 bytes, or members of a uniform structure
 * `parameters`, if packed so, and behind each compute pass there
 * is a glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT), with tiles also
 * GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT.
 * As fragment shaders (330, 300es) a pass draws a triangle over all that it writes, prepare one for each `level`. Their
 * samplers: depth is stored_image; normal, normal_image; levels, depth_image; levels before, depth_before_image;
 * texels, texel_image; marks, mark_image; history before, before_image. There are no lists and no bent normals. With
 * tiles, refine draws to full texels alone; behind it halve, which has no structure, draws from full texels
 * (texel_image) and marks to texels; join draws to shown, history and full texels (outputs 0, 1, 2); filter reads full
 * texels as texel_image. These four keep what the images hold in tiles that are not theirs, and so must the engine. It
 * is soonest where tiles.vert draws them, whose comment says how. */
#ifndef GLOAM_FRAME_H
#define GLOAM_FRAME_H
#include <math.h>
#include <string.h>

/* What the sweep takes: each pixel, every second one in both directions, or these and each pixel of some tiles. */
typedef enum { gloam_full, gloam_half, gloam_tiles } gloam_resolution;
/* mark: of tiles. range, sharpness: of the history. orthographic: cameras that the passes are made for, as constant 1
 * says. deep: likewise, as constant 9; some images have other formats. */
typedef struct { gloam_resolution resolution; float mark, range, sharpness; int orthographic, deep; } gloam_preset;
typedef struct { /* another one begins a sequence */
    gloam_preset preset;
    int size[2];      /* of the view, pixels */
    float radius;     /* of influence, world units */
    int depth_buffer; /* depth is that of the projection, 0 to 1; otherwise eye-linear, world units */
} gloam_settings;
/* Both column by column. projection: to clip space with z from 0 to 1; row 0 of images is at y = -1 of it. view: from
 * world space. Right- or left-handed, as the projection is: one of perspective where w is -z or z; an orthographic one
 * where the middle of its depths lies at z <= 0 or z > 0. */
typedef struct { float projection[16], view[16]; } gloam_camera;

/* What gloam_next() returns: 0, or why this frame cannot be drawn. */
typedef enum {
    gloam_fine,
    gloam_projection_by_rows, /* written row by row, expected column by column */
    gloam_view_by_rows,
    gloam_previous_by_rows, /* previous_from_current */
    gloam_other_projection  /* orthographic, and by the preset the passes are for perspective; or the reverse */
} gloam_error;

/* What the passes are given. depth: numerator and divisor. */
typedef struct { float before[4][4], depth[4], inverse_size[2], usual[2], far_value; } gloam_prepare;
typedef struct {
    float view_from_world[3][4]; /* the last of each: usual; 2 for left-handed cameras */
    float inverse_span[2], first[2], span[2], ray_span[2], first_ray[2], reach[2], noise[2];
    float depth[4], far_value; /* for normals from depth */
} gloam_sweep;
typedef struct { float inverse_texels[2], least; } gloam_mark;
typedef struct { /* filter or join. albedo: of what blocks, with multi-bounce; set in filter before gloam_next() */
    float before[4][4], most, range, narrowing, sharpness, dither, albedo, inverse_texels[2], inverse_size[2], usual[2];
} gloam_last;

typedef struct { /* begins with zeros */
    gloam_settings settings;
    gloam_camera now, before;        /* without a jitter, which moves no history */
    float previous_from_current[16]; /* view space of this frame to that of the frame before */
    int frames, still;               /* frames before this one in the sequence; the camera is that of the last one */
    gloam_prepare prepare;
    gloam_sweep sweep; /* of refine, too */
    gloam_mark mark;
    gloam_last filter, join;
} gloam_frame;

/* How pixels look into the view, lengths in radii: (column, row, 1, 1 / depth) to view space over depth; orthographic
 * (column, row, 1, depth) to view space. Depth buffers of orthographic cameras are lifted to 1 at their near plane. */
typedef struct { double step[2], first[2], lift; int flat; } gloam_lens;
static inline gloam_lens gloam_lens_of(const gloam_settings* settings, const float* p) {
    gloam_lens lens = {{0, 0}, {0, 0}, 0, p[11] == 0};
    for (int i = 0; i < 2; ++i) {
        const double scale = p[5 * i] * (lens.flat ? (double)settings->radius : 1);
        lens.step[i] = 2 / (settings->size[i] * scale);
        lens.first[i] = ((lens.flat ? -p[12 + i] : p[8 + i]) - 1.0) / scale + 0.5 * lens.step[i];
    }
    if (settings->depth_buffer && lens.flat)
        lens.lift = 1 - (p[14] - (p[10] > 0 ? 1.0 : 0.0)) / p[10] / (double)settings->radius;
    return lens;
}

/* Columns that take a pixel as above to (u, v, depth) of its point in the frame before, over depth. */
static inline void gloam_fill_before(const gloam_frame* frame, float before[4][4]) {
    const gloam_lens now = gloam_lens_of(&frame->settings, frame->now.projection);
    const gloam_lens then = gloam_lens_of(&frame->settings, frame->before.projection);
    const double flat = now.flat, deep = 1 - flat;
    const double look[4][4] = {{now.step[0], 0, 0, 0}, {0, now.step[1], 0, 0},
                               {now.first[0], now.first[1], now.lift - deep, flat}, {0, 0, -flat, deep}};
    for (int column = 0; column < 4; ++column) {
        double to[3] = {0, 0, 0};
        for (int i = 0; i < 12; ++i)
            to[i % 3] += frame->previous_from_current[i / 3 * 4 + i % 3] * look[column][i / 3] /
                         (i < 9 ? 1 : (double)frame->settings.radius);
        const double one = now.flat ? look[column][3] : -to[2];
        for (int i = 0; i < 2; ++i)
            before[column][i] =
                (float)(((to[i] - then.first[i] * one) / then.step[i] + 0.5 * one) / frame->settings.size[i]);
        before[column][2] = (float)(now.flat ? then.lift * one - to[2] : one);
    }
}

/* Of deep passes: the depth, or part of depth, of a camera of 60 degrees that sees as much, and the least part for each
 * unit of depth: by what is rounded where it is stored, to 24 bits. */
static inline void gloam_fill_usual(const gloam_settings* settings, const float* p, gloam_lens lens, float usual[2]) {
    const double least = 1.0 / 8192, radius = settings->radius, buffer = settings->depth_buffer ? least : 0;
    const double across = fmax(fabs(lens.step[0] * settings->size[0]), fabs(lens.step[1] * settings->size[1])) / 1.1547;
    usual[0] = (float)(lens.flat ? fmax(across, fabs(buffer / (p[10] * radius))) : fmax(fmin(across, 1), 2 * least));
    usual[1] = (float)(lens.flat ? 2 * least : p[14] < 0 ? -buffer * radius / p[14] : 0);
}

static inline float gloam_part(double value) { return (float)(value - floor(value)); }

/* The parameters, from what stands above them. p: the projection with its jitter. */
static inline void gloam_fill(gloam_frame* frame, const float* p) {
    const gloam_settings* settings = &frame->settings;
    const gloam_lens lens = gloam_lens_of(settings, p);
    const double radius = settings->radius, scale = lens.flat ? p[10] * radius : radius;
    const int buffer = settings->depth_buffer, deep = buffer && !lens.flat;
    const float depth[4] = {buffer ? (float)(p[14] / scale + lens.lift) : 0,
                            deep ? 0 : (float)(buffer ? -1 / scale : 1 / radius), deep ? p[10] : 1, deep ? 1.0f : 0};
    const float far_value = !buffer ? INFINITY : (lens.flat ? p[10] : p[14]) > 0 ? 0.0f : 1.0f; /* 0: reversed */
    float moved[4][4] = {{0}, {0}, {0, 0, -1, 0}, {0}}; /* a depth below 0: all has moved, whatever the images hold */
    gloam_last* last = &frame->filter;
    gloam_fill_before(frame, last->before);
    memcpy(frame->prepare.before, frame->frames > 0 ? last->before : moved, sizeof moved);
    for (int i = 0; i < 4; ++i) frame->prepare.depth[i] = frame->sweep.depth[i] = depth[i];
    memcpy(frame->sweep.view_from_world, frame->now.view, sizeof frame->sweep.view_from_world);
    gloam_fill_usual(settings, p, lens, last->usual);
    frame->prepare.far_value = frame->sweep.far_value = far_value;
    for (int i = 0; i < 2; ++i) {
        frame->sweep.view_from_world[i][3] = frame->prepare.usual[i] = last->usual[i];
        const int size = settings->size[i];
        const double span = size > 1 ? size - 1 : 1;
        frame->prepare.inverse_size[i] = last->inverse_size[i] = last->inverse_texels[i] = 1.0f / (float)size;
        frame->mark.inverse_texels[i] = 1.0f / (float)((size + 1) / 2);
        frame->sweep.inverse_span[i] = (float)(1 / span);
        frame->sweep.first[i] = 0.5f / (float)size;
        frame->sweep.span[i] = (float)(span / size);
        frame->sweep.ray_span[i] = (float)(lens.step[i] * span);
        frame->sweep.first_ray[i] = (float)lens.first[i];
        frame->sweep.reach[i] = (float)(1 / lens.step[i]);
        frame->sweep.noise[i] = gloam_part(frame->frames * (i == 0 ? 0.6180340 : 0.7548777));
    }
    last->most = frame->frames == 0 ? 0 : (frame->still ? 63.0f : 7.0f) / 1023.0f;
    last->range = frame->still ? 1 : settings->preset.range;
    last->narrowing = last->range - 0.01f;
    last->sharpness = frame->still ? 0 : settings->preset.sharpness;
    last->dither = gloam_part(frame->frames * 0.4142136);
    frame->join = *last;
    memcpy(frame->join.inverse_texels, frame->mark.inverse_texels, sizeof frame->mark.inverse_texels);
    frame->mark.least = settings->preset.mark;
}

/* The next frame begins a sequence. */
static inline void gloam_cut(gloam_frame* frame) { memset(&frame->settings, 0, sizeof frame->settings); }

/* Whether a matrix has (0, 0, 0, 1) in its last column, and not in its last row; a perspective (0, 0, 1 or -1, 0). */
static inline int gloam_is_last(const float* m, int step, int projects) {
    const float z = m[2 * step], w = m[3 * step], slack = projects ? 0 : 1e-6f;
    if (projects && w == 0) return m[0] == 0 && m[step] == 0 && (z == 1 || z == -1);
    return fabsf(m[0]) <= slack && fabsf(m[step]) <= slack && fabsf(z) <= slack && fabsf(w - 1) <= slack;
}
static inline int gloam_by_rows(const float* m, int projects) {
    /* An infinite far plane, reversed, and 1 as the near one: the middle of depth is behind the eye. */
    const int behind = projects && m[15] == 0 && m[14] * m[11] * (m[10] - 0.5f * m[11]) > 0;
    return gloam_is_last(m + 12, 1, projects) && (behind || !gloam_is_last(m + 3, 4, projects));
}

/* Left-handed cameras are taken by the mirror z = -z, behind a matrix (rows), before it (columns), or both. */
static inline int gloam_is_left(const float* projection) {
    const float* p = projection;
    return p[11] == 0 ? (1 - 2 * p[14]) / p[10] > 0 : p[11] > 0;
}
static inline void gloam_mirror(float* m, int rows, int columns) {
    for (int i = 0; i < 16; ++i)
        if ((rows && i % 4 == 2) != (columns && i / 4 == 2)) m[i] = -m[i];
}

/* The next frame. A projection that is aside of the last one's by up to a pixel has a jitter, for antialiasing.
 * previous_from_current: the view matrix of the last frame times the inverse of this one's, multiplied in double,
 * without a jitter; NULL begins a sequence where the camera moves. After an error nothing is to be drawn, and the next
 * frame begins a sequence. */
static inline gloam_error gloam_next(gloam_frame* frame, gloam_settings settings, gloam_camera camera,
                                     const float* previous_from_current) {
    const float *p = camera.projection, *change = previous_from_current;
    const int flat = p[11] == 0, left = gloam_is_left(p);
    const float turned = left ? 2 : 0;
    const gloam_error error = gloam_by_rows(p, 1)                      ? gloam_projection_by_rows
                              : gloam_by_rows(camera.view, 0)          ? gloam_view_by_rows
                              : change && gloam_by_rows(change, 0)     ? gloam_previous_by_rows
                              : flat != !!settings.preset.orthographic ? gloam_other_projection
                                                                       : gloam_fine;
    if (error != gloam_fine) {
        gloam_cut(frame);
        return error;
    }
    gloam_mirror(camera.projection, 0, left);
    gloam_mirror(camera.view, left, 0);
    const int alike = turned == frame->sweep.view_from_world[2][3];
    const int same = alike && memcmp(&settings, &frame->settings, sizeof settings) == 0;
    gloam_camera held = camera;
    for (int i = flat ? 12 : 8, k = 0; same && k < 2; ++i, ++k)
        if (fabsf(camera.projection[i] - frame->now.projection[i]) * (float)settings.size[k] <= 2)
            held.projection[i] = frame->now.projection[i];
    frame->still = same && memcmp(&held, &frame->now, sizeof held) == 0;
    /* Floats of a view are coarse in a large world. */
    for (int i = 12; change && i < 15; ++i) frame->still &= fabsf(change[i]) <= 1e-5f * settings.radius;
    const int follows = same && (frame->still || change);
    if (!follows) held = camera;
    frame->frames = follows ? frame->frames + 1 : 0;
    frame->settings = settings;
    frame->before = follows ? frame->now : held;
    frame->now = held;
    for (int i = 0; i < 16; ++i)
        frame->previous_from_current[i] = follows && !frame->still ? change[i] : i % 5 == 0;
    gloam_mirror(frame->previous_from_current, left, left);
    gloam_fill(frame, camera.projection);
    frame->sweep.view_from_world[2][3] = turned;
    return gloam_fine;
}
#endif
