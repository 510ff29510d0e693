// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FURTHER_LAYERS_GLSL
#define GLOAM_OCCLUSION_FURTHER_LAYERS_GLSL

// Depth layers behind the one that the eye sees (CS-E, CS-LAYERS; Bavoil and Sainz 2009), for the loops of all methods. Of the surfaces at a
// tap the one that blocks most counts: each layer can only miss what the others show.
//
// To have them, define GLOAM_LAYERS, before the method is included, as the number of layers, the first among them: a constant expression or a
// specialization constant, of which 1 costs nothing. And define what this prototype asks for. Without GLOAM_LAYERS there is one layer.
#ifndef GLOAM_LAYERS
#define GLOAM_LAYERS 1
#define GLOAM_FURTHER_LAYER(pixel, layer) 0.0
#else
// Defined by the user: eye-linear depth of a further layer at a pixel inside the image, in world units; negative where the surface is
// seen from behind, 0 or not finite where there is none.
// layer: 1 is the next behind what the eye sees, up to GLOAM_LAYERS - 1.
float gloam_fetch_layer(ivec2 pixel, int layer);
#define GLOAM_FURTHER_LAYER(pixel, layer) gloam_fetch_layer(pixel, layer)
#endif

#endif
