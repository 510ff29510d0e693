// SPDX-License-Identifier: MIT
// The page: a camera that moves around the scene, and controls of the pass.
import {View} from "./view.js";

const at = (id) => document.getElementById(id);
const view = new View(at("canvas"));

function fit() {
    view.setSize(window.innerWidth, window.innerHeight, window.devicePixelRatio);
}

window.addEventListener("resize", fit);
fit();
view.renderer.setAnimationLoop((milliseconds) => {
    view.occlusion.enabled = at("on").checked;
    view.occlusion.output = at("alone").checked ? "visibility" : "shaded";
    view.occlusion.radius = Number(at("radius").value);
    view.look(0.4 * Math.sin(milliseconds / 3000));
    view.draw();
});
