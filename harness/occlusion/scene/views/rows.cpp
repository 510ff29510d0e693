// SPDX-License-Identifier: MIT
#include "scene/views/generators.hpp"

namespace gloam::scene::views {
namespace {

// All views and built-in scenes, in their order: new ones are added at the end. Members: those of ViewInfo
// (what: the description); `of`: what makes it, if not the kind; the generator's own; radius:
// Scene::ao_radius; of the camera eye and target (above a terrain their heights are those above the ground),
// fovy_rad, near, far, and view_height if it is orthographic. It moves in each frame by `gliding` with its
// target, by `passing` looking at the same target, or around its target by `circling` degrees about the
// vertical axis. Or it sways: eye and target by `swaying` and `aim`, times the sine of `rate` radians a
// frame. Or it swings around the vertical axis and back, by `swinging` radians, or stands `still`.
// `shapes` are those of shapes_of(), besides what the kind makes. A mover rolls (`ball`: its radius, `rings`:
// of its sphere) or turns
// (`box`: two corners, around the origin). It is at `from`, moved by `way` times the sine and by `aside`
// times the cosine of `rate` radians a frame. A box turns about `axis` by `turn` times that sine and by
// `spin` in each frame, both from `start` on (radians).
constexpr const char* rows_text = R"json([
{"name": "study", "kind": "interior", "half": "tuning", "what": "a room with books, chairs and a table",
 "seed": 11, "radius": 0.3, "eye": [1.6, 1.6, 2.2], "target": [-0.5, 0.7, -1.0], "gliding": [-0.012, 0, -0.008]},
{"name": "workshop", "kind": "interior", "half": "unseen", "what": "a large room, crowded, seen from a corner",
 "seed": 12, "half_width": 4.0, "half_depth": 3.5, "fullness": 0.85, "radius": 0.5,
 "eye": [-3.6, 1.9, 3.1], "target": [0.5, 0.5, -1.0], "passing": [0.02, 0, 0]},
{"name": "tabletop", "kind": "interior", "half": "tuning", "what": "small things on a table, close up",
 "seed": 13, "radius": 0.12, "eye": [0.7, 1.15, 0.8], "target": [0, 0.76, 0], "circling": 0.5, "near": 0.02},
{"name": "plan", "kind": "interior", "half": "unseen", "what": "furniture from above, orthographic",
 "seed": 14, "half_width": 3.5, "half_depth": 3.0, "roofed": false, "radius": 0.4,
 "eye": [2.0, 8.0, 5.0], "target": [0, 0, 0], "gliding": [0.01, 0, 0.004], "far": 40, "view_height": 5.0},
{"name": "nave", "kind": "hall", "half": "tuning", "what": "two rows of pillars, along the middle",
 "seed": 21, "radius": 0.5, "eye": [0.2, 1.7, 1.5], "target": [0, 1.6, -10], "gliding": [0, 0, -0.03]},
{"name": "aisle", "kind": "hall", "half": "unseen", "what": "behind the pillars, looking across", "seed": 22,
 "half_width": 5.0, "radius": 0.7, "eye": [-3.6, 1.5, 1.0], "target": [2.0, 1.0, -7.0], "gliding": [0.015, 0, -0.02]},
{"name": "crypt", "kind": "hall", "half": "tuning", "what": "low, with a wide angle",
 "seed": 23, "half_width": 3.0, "height": 2.8, "pillars": 1.5, "radius": 0.4,
 "eye": [1.0, 1.0, 0.8], "target": [-0.4, 1.0, -5.0], "passing": [-0.012, 0, 0], "fovy_rad": 1.25},
{"name": "stairs", "kind": "hall", "half": "unseen", "what": "stairs with railings, close up", "seed": 24,
 "length": 9.0, "radius": 0.35, "eye": [1.6, 1.5, -2.6], "target": [-0.2, 0.8, -5.6], "passing": [-0.015, 0.004, 0]},
{"name": "meadow", "kind": "foliage", "half": "tuning", "what": "grass and bushes", "seed": 31, "bushes": 8,
 "leaves": 300, "blades": 4000, "radius": 0.2, "eye": [0, 0.9, 3.2], "target": [0, 0.2, 0], "gliding": [0.01, 0, 0]},
{"name": "grove", "kind": "foliage", "half": "unseen", "what": "trees with leaves in crowns",
 "seed": 32, "half_side": 5.0, "trees": 12, "leaves": 1200, "leaf": 0.16, "blades": 1500, "radius": 0.4,
 "eye": [0, 1.5, 6.5], "target": [0, 1.2, 0], "gliding": [0.02, 0, -0.01]},
{"name": "hedge", "kind": "foliage", "half": "tuning", "what": "bushes close up, leaf by leaf", "seed": 33,
 "half_side": 0.9, "bushes": 9, "leaves": 350, "radius": 0.15,
 "eye": [0.3, 0.7, 1.9], "target": [0, 0.3, 0], "circling": 0.4},
{"name": "lawn", "kind": "foliage", "half": "unseen", "what": "grass from above, orthographic", "seed": 34,
 "half_side": 2.5, "bushes": 3, "leaves": 300, "blades": 7000, "blade": 0.15, "radius": 0.15,
 "eye": [0.5, 5.0, 4.0], "target": [0, 0, 0], "gliding": [0.006, 0, 0], "far": 40, "view_height": 2.6},
{"name": "engine", "kind": "machine", "half": "tuning", "what": "housings, gears and pipes",
 "seed": 41, "radius": 0.25, "eye": [0.8, 1.5, 2.6], "target": [0, 0.8, -1.0], "passing": [-0.015, 0, 0]},
{"name": "pipes", "kind": "machine", "half": "unseen", "what": "pipes before a wall", "seed": 42, "parts": 3,
 "pipes": 14, "radius": 0.3, "eye": [-0.8, 1.4, 2.0], "target": [0.2, 1.1, -1.5], "gliding": [0.012, 0, 0]},
{"name": "grating", "kind": "machine", "half": "tuning", "what": "a grating over the floor",
 "seed": 43, "parts": 4, "pipes": 4, "radius": 0.3,
 "eye": [0.3, 1.3, 2.8], "target": [0, 0.2, 0.0], "gliding": [0.01, 0, -0.005], "shapes": [["cell", 4.0],
  ["each", 42, [0.12,0,0], ["box", -2.5,0.25,-0.3, -2.47,0.29,1.5]],
  ["each", 6, [0,0,0.36], ["box", -2.5,0.25,-0.3, 2.5,0.29,-0.27]]]},
{"name": "panel", "kind": "machine", "half": "unseen", "what": "machines from the front, orthographic",
 "seed": 44, "parts": 6, "pipes": 8, "radius": 0.25,
 "eye": [0.6, 2.0, 5.0], "target": [0, 1.0, -1.0], "gliding": [-0.008, 0, 0], "far": 40, "view_height": 2.6},
{"name": "hills", "kind": "terrain", "half": "tuning", "what": "hills with stones", "seed": 51, "stones": 80,
 "radius": 1.5, "eye": [0, 4.0, 18], "target": [0, 0, 0], "gliding": [0.05, 0, 0], "far": 400},
{"name": "canyon", "kind": "terrain", "half": "unseen", "what": "ridges, far away",
 "seed": 52, "half_side": 80.0, "size": 25.0, "relief": 8.0, "ridged": true, "radius": 5.0,
 "eye": [0, 14.0, 55], "target": [0, 0, 0], "gliding": [0.15, 0, 0], "far": 400},
{"name": "stones", "kind": "terrain", "half": "tuning", "what": "stones on the ground, close up",
 "seed": 53, "half_side": 8.0, "size": 5.0, "relief": 0.5, "stones": 220, "stone": 0.3, "radius": 0.35,
 "eye": [0, 1.6, 4], "target": [0, 0, 0.5], "gliding": [0.015, 0, 0], "far": 400},
{"name": "town", "kind": "terrain", "of": "town", "half": "unseen", "what": "houses along streets, from above",
 "seed": 54, "radius": 3.0, "eye": [10, 40, 45], "target": [0, 5, -40], "gliding": [0.3, 0, -0.1], "near": 1.0,
 "far": 800},
{"name": "bunny", "kind": "mesh", "half": "tuning", "what": "the bunny of glmark2-data", "file": "bunny.obj",
 "radius": 0.2, "eye": [0.4, 0.9, 1.9], "target": [0, 0.45, 0], "circling": 0.7},
{"name": "horse", "kind": "mesh", "half": "unseen", "what": "three horses of glmark2-data",
 "file": "horse.3ds", "copies": 3, "spacing": 1.4, "radius": 0.2,
 "eye": [0.5, 1.3, 3.6], "target": [0, 0.4, 0], "gliding": [0.012, 0, 0]},
{"name": "cats", "kind": "mesh", "half": "tuning", "what": "rows of cats of glmark2-data",
 "file": "cat.3ds", "up": "-z", "copies": 4, "rows": 3, "spacing": 1.6, "radius": 0.2,
 "eye": [-0.5, 1.7, 3.0], "target": [0, 0.2, -0.8], "gliding": [0.01, 0, 0]},
{"name": "asteroids", "kind": "mesh", "half": "unseen", "what": "asteroids of glmark2-data that touch",
 "file": "asteroid-high.3ds", "copies": 4, "rows": 3, "spacing": 1.05, "radius": 0.2,
 "eye": [1.2, 1.6, 2.6], "target": [0, 0.3, -0.8], "passing": [-0.015, 0, 0]},
{"name": "columns", "kind": "scene", "half": "tuning",
 "what": "a column hall, from a cable 0.1 m before the eye to 200 m away", "radius": 0.5, "fovy_rad": 1.0, "far": 250,
 "eye": [0.3, 1.75, 1.0], "target": [0, 1.9, -12.0], "swaying": [0.12, 0.02, 0], "rate": [0.05, 0.11, 0],
 "lamp": [-1.8, 4.6, -2.5], "cell": 2.0, "shapes": [
  ["plane", -7,0,-200, 0,0,203, 14,0,0], ["plane", -7,6,-200, 14,0,0, 0,0,203], ["plane", -7,0,-200, 0,6,0, 0,0,203],
  ["plane", 7,0,-200, 0,0,203, 0,6,0], ["plane", -7,0,-200, 14,0,0, 0,6,0], ["plane", -7,0,3, 0,6,0, 14,0,0],
  ["each", 40, [0,0,-5], ["box", -7,5.75,-0.3, 7,6,0.3],
   ["box", -7,0,-0.4, -6.7,5.75,0.4], ["box", -7,0,-4, -6.4,0.45,-1],
   ["box", 6.7,0,-0.4, 7,5.75,0.4], ["box", 6.4,0,-4, 7,0.45,-1],
   ["each", 2, [7,0,0], ["box", -4.25,0,-0.75, -2.75,0.25,0.75], ["box", -4.1,0.25,-0.6, -2.9,0.5,0.6],
    ["cylinder", -3.5,0.5,0, 0.45, 5.0, 40],
    ["box", -4.1,5.5,-0.6, -2.9,5.75,0.6], ["box", -4.25,5.75,-0.75, -2.75,6,0.75]]],
  ["box", 0.1,0,0.2, 2.0,1.5,0.72], ["cylinder", 0.222,0,0.89, 0.008, 6.0, 24], ["sphere", 0.75,1.65,0.4, 0.15, 24],
  ["sphere", -1.2,0.5,-5.0, 0.5, 24], ["sphere", -2.1,0.3,-5.4, 0.3, 24], ["sphere", 1.4,0.7,-14.0, 0.7, 24]]},
{"name": "corner", "kind": "scene", "what": "a floor and two walls, whose occlusion is known in closed form",
 "radius": 1.0, "eye": [3.6, 3.1, 3.9], "target": [0.6, 0.6, 0.6], "still": true, "near": 0.1, "far": 40,
 "lamp": [2.2, 3.4, 3.0], "shapes": [["plane", 0,0,0, 0,0,12, 12,0,0, 0.8,0.8,0.8],
  ["plane", 0,0,0, 12,0,0, 0,12,0, 0.15,0.7,0.15], ["plane", 0,0,0, 0,12,0, 0,0,12, 0.8,0.1,0.1]]},
{"name": "far", "kind": "scene", "half": "unseen",
 "what": "a terrace and balls 128 km from the origin, under a slow camera", "radius": 0.4, "fovy_rad": 0.8,
 "near": 0.1, "far": 60, "eye": [98305.2, 513.6, -81916.8], "target": [98303.9, 512.6, -81921.5],
 "swaying": [-0.4, 0, 0.1], "rate": [0.01, 0, 0.013], "shapes": [["plane", 98296,512,-81928, 0,0,16, 16,0,0],
  ["cell", 16.0], ["box", 98296,512,-81924, 98312,515,-81923.5],
  ["each", 5, [1.5,0,0], ["box", 98300.75,512,-81923.5, 98301.25,514.5,-81923.25]],
  ["box", 98301,512,-81921.5, 98303,512.25,-81923.25], ["box", 98301,512.25,-81921.875, 98303,512.5,-81923.25],
  ["box", 98301,512.5,-81922.25, 98303,512.75,-81923.25], ["box", 98301,512.75,-81922.625, 98303,513,-81923.25],
  ["box", 98301,513,-81923, 98303,513.25,-81923.25], ["box", 98304.5,512,-81922, 98305.5,513,-81921],
  ["box", 98304.75,513,-81921.75, 98305.25,513.5,-81921.25]], "movers": [
  {"ball": 0.5, "rings": 48, "from": [98303.6, 512.5, -81920.5]},
  {"ball": 0.25, "rings": 48, "from": [98306.0, 512.25, -81920.2], "way": [0.6, 0, 0], "start": 8.0}]},
{"name": "grass", "kind": "scene", "of": "grass", "half": "tuning",
 "what": "blades and leaves without thickness, under a moving camera", "seed": 1, "radius": 0.15, "fovy_rad": 0.8,
 "far": 60, "eye": [0, 0.42, 0.75], "target": [0, 0.1, -0.8], "swaying": [0.3, 0, 0.1], "rate": [0.02, 0, 0.013],
 "aim": [0.3, 0, 0.1]},
{"name": "knot", "kind": "scene", "half": "unseen",
 "what": "a knotted tube on the ground before a wall, under a circling camera", "radius": 0.25, "fovy_rad": 0.7,
 "near": 0.1, "far": 40, "eye": [0.9, 0.95, 2.0], "target": [0, 0.48, 0], "swinging": 0.5, "cell": 0.5, "shapes": [
  ["knot", 0.17], ["plane", -6,0,-0.45, 0,0,6.45, 12,0,0], ["plane", -6,0,-0.45, 12,0,0, 0,6,0]]},
{"name": "moving", "kind": "scene", "half": "tuning",
 "what": "a rolling ball and a turning box before steps and a wall, under a moving camera", "radius": 0.4,
 "fovy_rad": 0.8, "near": 0.1, "far": 60, "eye": [0.3, 1.3, 3.0], "target": [0, 0.5, -1.0],
 "swaying": [0.5, 0, 0.2], "rate": [0.017, 0, 0.011], "shapes": [["plane", -8,0,-3, 0,0,10, 16,0,0],
  ["plane", -8,0,-3, 16,0,0, 0,6,0], ["each", 7, [1,0,0], ["box", -3.15,0,-3, -2.85,6,-2.75]],
  ["box", -8,0,-2.75, 8,0.25,-2.25], ["box", -8,0,-2.25, 8,0.125,-1.75]], "movers": [
  {"ball": 0.35, "rings": 48, "from": [0, 0.35, -1.0], "way": [1.3, 0, 0], "rate": 0.03},
  {"box": [-0.3,0,-0.2, 0.3,0.7,0.2], "from": [0, 0, -0.1], "aside": [-0.9, 0, 0], "rate": 0.023, "spin": 0.02}]},
{"name": "relief", "kind": "scene", "what": "a carved panel in the hall of columns, close up", "radius": 0.5,
 "fovy_rad": 1.0, "far": 250, "eye": [-5.95, 1.75, -4.65], "target": [-6.7, 1.58, -5.0],
 "swaying": [0, 0.01, 0.06], "rate": [0, 0.11, 0.05], "lamp": [-5.2, 3.2, -6.0], "shapes": [
  ["all of", "columns"], ["cell", 0.5], ["each", 2, [0,0,0.66], ["box", -6.7,1.2,-5.35, -6.67,2.0,-5.31]],
  ["each", 2, [0,0.76,0], ["box", -6.7,1.2,-5.35, -6.67,1.24,-4.65]],
  ["each", 16, [0,0,0.04], ["cylinder", -6.7,1.24,-5.3, 0.013, 0.3, 24]],
  ["box", -6.7,1.54,-5.35, -6.68,1.57,-4.65], ["sphere", -6.7,1.77,-5.0, 0.05, 16],
  ["ring", 8, 0.085, ["sphere", -6.7,1.77,-5.0, 0.028, 12]],
  ["ring", 24, 0.15, ["sphere", -6.7,1.77,-5.0, 0.014, 12]]]},
{"name": "room", "kind": "scene", "half": "unseen",
 "what": "a closed room with books, boards and other small things, under a moving camera", "radius": 0.3,
 "fovy_rad": 0.95, "far": 20, "eye": [0.7, 1.5, 1.6], "target": [-0.2, 0.8, -1.6], "swaying": [0.5, 0, -0.3],
 "rate": [0.02, 0, 0.015], "lamp": [-0.6, 2.1, 0.3], "seed": 2, "shapes": [["inside", -2,0,-2.5, 2,2.6,2.5],
  ["each", 2, [0,0,4.98], ["box", -2,0,-2.5, 2,0.09,-2.48]],
  ["each", 2, [3.98,0,0], ["box", -2,0,-2.5, -1.98,0.09,2.5]],
  ["each", 2, [3.94,0,0], ["box", -2,2.54,-2.5, -1.94,2.6,2.5]], ["box", -2,2.54,-2.5, 2,2.6,-2.44],
  ["each", 25, [0.16,0,0], ["box", -1.998,0,-2.5, -1.842,0.008,2.5]], ["box", 0.4,0.9,-2.5, 1.6,0.94,-2.36],
  ["box", 0.45,0.94,-2.5, 0.49,2.1,-2.45], ["box", 0.99,0.94,-2.5, 1.03,2.1,-2.45],
  ["box", 1.51,0.94,-2.5, 1.55,2.1,-2.45], ["each", 3, [0,0.56,0], ["box", 0.45,0.94,-2.5, 1.55,0.98,-2.45]],
  ["each", 2, [1.57,0,0], ["box", -1.7,0.008,-2.5, -1.67,2.0,-2.24]],
  ["each", 5, [0,0.38,0], ["box", -1.67,0.06,-2.5, -0.13,0.085,-2.24], ["books", -1.66,0.085,-2.48, -0.2]],
  ["box", -1.67,1.96,-2.5, -0.13,1.985,-2.24], ["box", -0.6,0.72,-1.3, 0.8,0.76,-0.5],
  ["each", 2, [1.25,0,0], ["each", 2, [0,0,0.65], ["box", -0.55,0.008,-1.25, -0.5,0.72,-1.2]]],
  ["cylinder", 0.1,0.76,-0.9, 0.14, 0.012, 48], ["sphere", 0.1,0.81,-0.9, 0.05, 24],
  ["each", 2, [0.75,0,0], ["cylinder", -0.3,0.76,-0.8, 0.04, 0.1, 32], ["cylinder", -0.3,0.76,-0.8, 0.036, 0.1, 32]],
  ["each", 2, [2.4,0,0], ["box", -1.28,0.42,-1.1, -0.92,0.46,-0.74],
   ["each", 2, [0.29,0,0], ["each", 2, [0,0,0.29], ["box", -1.26,0.008,-1.08, -1.23,0.42,-1.05]]]]]},
{"name": "sky", "kind": "scene", "half": "tuning", "what": "masts, wires and a kite, mostly sky, under a moving camera",
 "radius": 0.6, "fovy_rad": 0.8, "near": 0.1, "far": 500, "eye": [0, 1.7, 0], "target": [0, 4.7, -9.0],
 "swaying": [0, 0, -0.5], "rate": [0.02, 0, 0.01], "aim": [1.5, 0, 0], "cell": 5.0, "shapes": [
  ["plane", -150,0,-300, 0,0,310, 300,0,0], ["cell", 1.0], ["each", 8, [0,0,-18], ["cylinder", -2,0,-9, 0.12, 7.0, 24],
   ["box", -2.9,6.2,-9.06, -1.1,6.35,-8.94], ["box", -2.6,5.5,-9.06, -1.4,5.65,-8.94]],
  ["each", 2, [1.7,0,0], ["box", -2.862,6.35,-135, -2.838,6.374,5]],
  ["each", 2, [1.1,0,0], ["box", -2.562,5.65,-135, -2.538,5.674,5]], ["box", 4,0,-40, 9,2.6,-34]], "movers": [
  {"box": [-0.4,-0.03,-0.3, 0.4,0.03,0.3], "from": [1.5, 5.0, -9.0], "way": [0, 1, 0], "aside": [1.2, 0, 0],
   "rate": 0.03, "start": 0.5, "spin": 0.021, "axis": [0.6, 0.8, 0]}]},
{"name": "yard", "kind": "motion", "of": "machine", "half": "tuning",
 "what": "a ball, a box and a crate move before machines", "seed": 61, "parts": 3, "pipes": 0, "radius": 0.3,
 "eye": [0.8, 1.5, 2.6], "target": [0, 0.7, -1.0], "passing": [-0.012, 0, 0], "movers": [
  {"ball": 0.3, "from": [-1.3, 0.3, 0.3], "way": [2.25, 0, 0]},
  {"box": [-0.25,-0.15,-0.2, 0.25,0.15,0.2], "from": [1.1, 0.7, 0.2], "way": [-1.0, -0.3, 0], "turn": 4.0,
   "axis": [0.6, 0.2, 0.8]},
  {"box": [-0.35,0,-0.3, 0.35,0.8,0.3], "from": [2.8, 0, -1.68], "way": [3.0, 0, 0]}]},
{"name": "gallery", "kind": "motion", "of": "hall", "half": "unseen",
 "what": "a ball, a plank and a chest move in a hall", "seed": 62, "radius": 0.5,
 "eye": [0.6, 1.6, 1.0], "target": [-1.0, 0.9, -6.0], "gliding": [0.008, 0, -0.012], "movers": [
  {"ball": 0.4, "from": [-0.9, 0.4, -4.6], "way": [0.5, 0, 2.5]},
  {"box": [-0.5,-0.06,-0.15, 0.5,0.06,0.15], "from": [0.5, 0.6, -2.6], "way": [-1.0, 0, -0.5], "turn": 3.5,
   "axis": [0.3, 0.4, 0.9]},
  {"box": [-0.3,0,-0.45, 0.3,0.6,0.45], "from": [3.15, 0, -4.7], "way": [0, 0, 5.0]}]}
])json";

}  // namespace

const Row& rows() {
    static const Row all = Row::parse(rows_text);
    return all;
}

}  // namespace gloam::scene::views
