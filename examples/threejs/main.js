// SPDX-License-Identifier: MIT
// The page: a camera that moves around the scene, and controls of the pass. For pictures: with #with or #without behind
// the page's address the camera stands still and there are no controls.
import {View} from "./view.js";

const at = (id) => document.getElementById(id);
const still = ["#with", "#without"].includes(location.hash);
const view = new View(at("canvas"));

function draw(milliseconds) {
    view.occlusion.intensity = at("on").checked ? 1 : 0;
    view.occlusion.output = at("alone").checked ? "visibility" : "shaded";
    view.occlusion.radius = Number(at("radius").value);
    view.look(0.4 * Math.sin(milliseconds / 3000));
    view.draw();
}

function fit() {
    view.setSize(window.innerWidth, window.innerHeight, window.devicePixelRatio);
    for (let i = 0; still && i < 64; ++i) draw(0);
}

at("controls").hidden = still;
at("on").checked = location.hash !== "#without";
window.addEventListener("resize", fit);
fit();
if (!still) view.renderer.setAnimationLoop(draw);
