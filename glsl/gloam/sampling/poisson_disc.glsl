// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_POISSON_DISC_GLSL
#define GLOAM_SAMPLING_POISSON_DISC_GLSL

// point of a Poisson disc of 64 (POISSON-disc): `radius sqrt((i' + 1/2) / 64), i' the index with its bits reversed, at
// the emptiest of 4096 angles` [Sourimant et al. 2011 (the pattern); construction after Mitchell's best candidates].
// Poisson disc of 64 points, each prefix of which is spread evenly: squared radii (i' + 1/2) / 64, i' the index with
// its 6 bits reversed; each point at that of 4096 angles (the first at 0) where the nearest of those before it is
// farthest away. For Sourimant's directions lift them with gloam_hemisphere_lift.
// index: of the point; its lowest 6 bits count.
// Returns a point of the unit disc. No two are nearer than 0.15 to each other; 0.3 among the first 16. Error: none.
vec2 gloam_poisson_disc(uint index) {
    const vec2 points[64] = vec2[64](
        vec2(0.0883883461, 0), vec2(-0.712609649, 0), vec2(-0.311770916, 0.400763512),
        vec2(-0.312051117, -0.812672496), vec2(-0.312009633, -0.188314885), vec2(0.385711133, 0.695729434),
        vec2(0.229740798, -0.574483812), vec2(0.934622943, -0.0963971317), vec2(-0.242908403, 0.106339112),
        vec2(0.685140431, 0.317639917), vec2(0.514554143, -0.235683128), vec2(-0.1108687, 0.898899674),
        vec2(0.0855535492, 0.43358171), vec2(-0.667464852, -0.499803156), vec2(-0.601041734, 0.289933354),
        vec2(0.6969257, -0.677943289), vec2(-0.0688622892, -0.185257882), vec2(-0.0236474145, -0.733827829),
        vec2(-0.222390711, -0.489494503), vec2(-0.470620275, 0.753378451), vec2(0.341203958, 0.218271315),
        vec2(0.139316902, 0.802903056), vec2(0.64288342, 0.0276297759), vec2(0.269099116, -0.917413831),
        vec2(0.196452528, -0.250936061), vec2(-0.733029485, -0.253436923), vec2(-0.126358882, 0.579306424),
        vec2(0.834202647, -0.394548446), vec2(-0.474413574, 0.0386554971), vec2(-0.64883852, 0.552784801),
        vec2(0.480595469, -0.495570868), vec2(-0.953617692, 0.25918296), vec2(-0.0475763083, 0.145512864),
        vec2(0.524750054, 0.498071194), vec2(0.0200485289, -0.522528052), vec2(0.867411554, 0.14503333),
        vec2(0.384438038, -0.0253948253), vec2(-0.480682135, -0.646051228), vec2(-0.462465346, -0.429608315),
        vec2(-0.941593349, -0.108809456), vec2(0.150709718, 0.251443982), vec2(0.739887059, -0.19622609),
        vec2(0.306320369, 0.492042005), vec2(0.473646104, -0.782046556), vec2(-0.400650501, 0.224536568),
        vec2(-0.277958483, 0.796038032), vec2(-0.322794497, 0.597278178), vec2(0.793588459, 0.575460553),
        vec2(-0.227852762, -0.0526366793), vec2(0.638225377, -0.383869559), vec2(-0.525177896, -0.169928402),
        vec2(-0.800641656, 0.404549688), vec2(-0.13420254, 0.402090997), vec2(-0.810503244, 0.150903866),
        vec2(-0.49039638, 0.434969962), vec2(-0.11656066, -0.957131684), vec2(0.0366879702, -0.340354949),
        vec2(0.157990381, -0.769562542), vec2(0.047357738, 0.604106545), vec2(0.609334469, 0.704200983),
        vec2(0.359528571, -0.336045712), vec2(0.680785716, -0.52793777), vec2(-0.19539848, -0.673800349),
        vec2(0.342754632, 0.935257614));
    return points[index & 63u];
}

#endif
