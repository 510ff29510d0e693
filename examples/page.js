// SPDX-License-Identifier: MIT
// The page of an example: a camera that moves before a scene, and the choice of the pass.

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
        const angle = 0.4 * Math.sin(milliseconds / 3000);
        view.look({eye: [7 * Math.sin(angle), 2.6, 7 * Math.cos(angle) - 0.5], target: [0.3, 0.6, -0.6], fovy: 0.7});
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
