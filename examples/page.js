// SPDX-License-Identifier: MIT
// The page of an example: a camera that moves before a scene, and the choice of the pass.

// On a floor: shape, color, place, and scale. A capsule is twice as high as wide.
export const things = [
    ["box", "#d8d2c8", [0, -0.05, 0], [12, 0.1, 12]],
    ["box", "#d2d6d0", [0, 1.5, -2], [12, 3, 0.1]],
    ["box", "#c96f4a", [-1.7, 0.8, -1.3], [1, 1.6, 1]],
    ["box", "#7a9cb8", [-0.6, 0.25, -1.2], [1.2, 0.5, 0.8]],
    ["sphere", "#e0c067", [0.3, 0.5, 0.1], [1, 1, 1]],
    ["capsule", "#6fa287", [1.6, 1, -1], [1, 1, 1]],
    ...[0, 1, 2, 3, 4].map((i) => ["box", "#b9b2a6", [3.4, 0.1 + 0.2 * i, -0.4 - 0.3 * i], [1.6, 0.2, 0.3]]),
];

// Where the camera is, turned around them by an angle in radians.
export const around = (angle) =>
    ({eye: [7 * Math.sin(angle), 2.6, 7 * Math.cos(angle) - 0.5], target: [0.3, 0.6, -0.6], fovy: 0.7});

// View: a class of a scene with the static member passes; compare.py uses it, too.
export function open(View) {
    window.View = View;
    const canvas = document.getElementById("canvas");
    const select = document.getElementById("pass");
    let view = null;
    const fit = () => view.setSize(window.innerWidth, window.innerHeight);
    const choose = () => {
        view?.dispose();
        const fresh = canvas.cloneNode();  // with a context of its own
        document.getElementById("canvas").replaceWith(fresh);
        view = new View(fresh, select.value);
        fit();
    };
    const draw = (milliseconds) => {
        view.look(around(0.4 * Math.sin(milliseconds / 3000)));
        view.draw();
        requestAnimationFrame(draw);
    };
    select.append(...View.passes.map((pass) => new Option(pass)));
    select.value = View.passes.find((pass) => pass.startsWith("gloam"));
    if (location.hash === "#compare") return;
    select.addEventListener("change", choose);
    window.addEventListener("resize", fit);
    choose();
    requestAnimationFrame(draw);
}
