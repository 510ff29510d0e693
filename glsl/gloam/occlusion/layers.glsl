// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_LAYERS_GLSL
#define GLOAM_OCCLUSION_LAYERS_GLSL

// Occlusion of a point by more than one depth image: layers peeled one behind another (Bavoil and Sainz 2009), or views
// of other cameras.

// depth of a layer at a tap (CS-LAYERS-depth): `d_0, |d_1|, |d_2|, |d_3|` [Bavoil and Sainz 2009].
// Layer 0 is the visible surface. Of the surfaces at a tap the one that blocks most counts, because a layer can only
// miss blockers.
// first: of the visible surface. further: of layers 1 to 3 behind it, negative where seen from behind. layer: 0 to 3.
// Eye-linear, world units.
// Returns a depth without the sign. Error: none.
float gloam_layer_depth(float first, vec3 further, int layer) {
    return layer == 0 ? first : abs(layer == 1 ? further.x : (layer == 2 ? further.y : further.z));
}

// The combined result of the layers at a sample point, added in order. With further layers a point behind a back face,
// which ends the solid in front of it, is open: no thickness has to be assumed. What is behind the last layer is
// unknown. So of three or more layers the last one ends nothing, even if it is a back face.
struct GloamLayersSeen {
    float occlusion;  // so far, [0, 1]; 0 to begin with
    float before;     // as it was before the last layer; 0 to begin with
    bool front;       // whether the last layer is a front; true to begin with
};

// what the layers at a sample point say together (CS-LAYERS-together): `the largest of the layers; a back in front of
// the point takes what it closes away` [Bavoil and Sainz 2009].
// blocked: whether it blocks the point, 0 to 1. further: signed depths of layers 1 to 3. depth: of the point,
// eye-linear, world units. layer: 0 to layers - 1. layers: 1 to 4.
// Returns what is seen with it. Error: none.
GloamLayersSeen gloam_layers_add(GloamLayersSeen seen, float blocked, vec3 further, float depth, int layer,
                                 int layers) {
    if (layer == 0) return GloamLayersSeen(blocked, 0.0, true);
    float next = layer == 1 ? further.x : (layer == 2 ? further.y : further.z);
    bool closes = seen.front && next < 0.0;
    bool known = layer + 1 < layers || layers == 2;
    float opened = closes && known && -next < depth ? seen.before : seen.occlusion;
    return GloamLayersSeen(closes ? opened : max(opened, blocked), opened, next > 0.0);
}

#endif
