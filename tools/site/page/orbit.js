// SPDX-License-Identifier: MIT
// A camera that a person turns around the point it looks at, by mouse, finger and keys.
"use strict";

gloam.Orbit = class {
    // canvas: is given focus, and events. begin: gives the camera to go on from, at the person's first change.
    constructor(canvas, begin) {
        this.begin = begin;
        this.pose = null;
        let last = [0, 0];
        canvas.addEventListener("pointerdown", (event) => {
            canvas.setPointerCapture(event.pointerId);
            last = [event.clientX, event.clientY];
        });
        canvas.addEventListener("pointermove", ({buttons, isPrimary, clientX, clientY}) => {
            if (buttons === 0 || !isPrimary) return;
            const [right, down] = [clientX - last[0], clientY - last[1]].map((d) => 3 * d / canvas.clientHeight);
            last = [clientX, clientY];
            this.change(-right, down);
        });
        // Only once the picture has the focus: until then the wheel scrolls the page.
        canvas.addEventListener("wheel", (event) => {
            if (document.activeElement !== canvas) return;
            event.preventDefault();
            this.change(0, 0, Math.exp(Math.max(-1, Math.min(0.0015 * event.deltaY, 1))));
        }, {passive: false});
        canvas.addEventListener("keydown", (event) => {
            const step = gloam.Orbit.keys[event.key];
            if (!step || event.ctrlKey || event.altKey || event.metaKey) return;
            event.preventDefault();
            this.change(...step);
        });
    }

    static keys = {ArrowLeft: [-0.08, 0], ArrowRight: [0.08, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08],
        "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1 / 0.9]};

    // Angles in radians, and a factor of the distance.
    change(yaw, pitch, zoom = 1) {
        this.pose ??= gloam.Orbit.poseOf(this.begin());
        const {pose} = this;
        pose.yaw += yaw;
        pose.pitch = Math.max(-1.5, Math.min(pose.pitch + pitch, 1.5));
        pose.distance = Math.max(pose.nearest, Math.min(pose.distance * zoom, pose.farthest));
    }

    static poseOf({eye, target}) {
        const back = eye.map((x, k) => x - target[k]);
        const distance = Math.hypot(...back);
        return {target, distance, nearest: 0.2 * distance, farthest: 4 * distance,
            yaw: Math.atan2(back[0], back[2]), pitch: Math.asin(back[1] / distance)};
    }

    get camera() {
        const {yaw, pitch, distance, target} = this.pose;
        const back = [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)];
        return {eye: target.map((x, k) => x + distance * back[k]), target};
    }
};
