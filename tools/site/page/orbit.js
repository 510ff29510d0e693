// SPDX-License-Identifier: MIT
// A camera that a person turns around a point by mouse, touch and keys.
"use strict";

gloam.Orbit = class {
    // canvas: is given focus, and events. moved: called after each change by the person.
    constructor(canvas, moved) {
        this.canvas = canvas;
        this.moved = moved;
        this.pointers = new Map();
        this.pose = null;
        canvas.addEventListener("pointerdown", (event) => this.press(event));
        canvas.addEventListener("pointermove", (event) => this.drag(event));
        for (const name of ["pointerup", "pointercancel"])
            canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
        canvas.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
        canvas.addEventListener("keydown", (event) => this.key(event));
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    }

    static steepest = 0.49 * Math.PI;

    // What the orbit is around, and how near and far it goes.
    setScene(scene) {
        const box = gloam.boxOf(scene.positions);
        this.centre = box.low.map((low, k) => 0.5 * (low + box.high[k]));
        this.nearest = 4 * scene.near;
        this.farthest = Math.min(0.45 * scene.far, 4 * Math.hypot(...box.low.map((low, k) => box.high[k] - low)));
        this.pose = null;
    }

    // Goes on from a camera: around the point of its view ray that is nearest to the middle of the scene.
    take({rotation, eye}) {
        const ahead = [-rotation[6], -rotation[7], -rotation[8]];
        const distance = this.limited(ahead.reduce((sum, a, k) => sum + a * (this.centre[k] - eye[k]), 0));
        this.pose = {yaw: Math.atan2(-ahead[0], -ahead[2]), pitch: Math.asin(Math.max(-1, Math.min(-ahead[1], 1))),
            distance, target: ahead.map((a, k) => eye[k] + a * distance)};
    }

    limited(distance) {
        return Math.min(Math.max(distance, this.nearest), this.farthest);
    }

    // Yaw, pitch, distance and the point that is looked at; settable from elsewhere.
    get numbers() {
        const {yaw, pitch, distance, target} = this.pose;
        return [yaw, pitch, distance, ...target];
    }

    set numbers([yaw, pitch, distance, ...target]) {
        const {steepest} = gloam.Orbit;
        this.pose = {yaw, pitch: Math.min(Math.max(pitch, -steepest), steepest), distance: this.limited(distance),
            target};
    }

    // The camera as gloam.camera has it.
    get camera() {
        const {yaw, pitch, distance, target} = this.pose;
        const back = [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)];
        const right = [Math.cos(yaw), 0, -Math.sin(yaw)];
        const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
            back[0] * right[1] - back[1] * right[0]];
        return {rotation: [...right, ...up, ...back], eye: target.map((t, k) => t + distance * back[k])};
    }

    // Angles in radians; steps to the right and up as parts of the distance; a factor of the distance.
    change({yaw = 0, pitch = 0, right = 0, up = 0, zoom = 1}) {
        this.moved();
        const {rotation} = this.camera;
        const {distance, target} = this.pose;
        this.numbers = [this.pose.yaw + yaw, this.pose.pitch + pitch, distance * zoom,
            ...target.map((t, k) => t + distance * (right * rotation[k] + up * rotation[3 + k]))];
    }

    press(event) {
        this.canvas.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    }

    drag(event) {
        const before = this.pointers.get(event.pointerId);
        if (before === undefined) return;
        const now = {x: event.clientX, y: event.clientY};
        const [dx, dy] = [now.x - before.x, now.y - before.y].map((d) => d / this.canvas.clientHeight);
        const spread = this.spread();
        this.pointers.set(event.pointerId, now);
        if (this.pointers.size > 1) this.change({right: -0.5 * dx, up: 0.5 * dy, zoom: spread / this.spread()});
        else if (event.shiftKey || event.buttons > 1) this.change({right: -dx, up: dy});
        else this.change({yaw: -3 * dx, pitch: 3 * dy});
    }

    // Distance between two fingers.
    spread() {
        const [a, b] = this.pointers.values();
        return b === undefined ? 1 : Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1);
    }

    // Only once the picture has the focus: until then the wheel scrolls the page.
    wheel(event) {
        if (document.activeElement !== this.canvas) return;
        event.preventDefault();
        this.change({zoom: Math.exp(Math.max(-1, Math.min(0.0015 * event.deltaY, 1)))});
    }

    static keys = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

    key(event) {
        const [x, y] = gloam.Orbit.keys[event.key] ?? [0, 0];
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        if (["+", "="].includes(event.key)) this.change({zoom: 0.9});
        else if (["-", "_"].includes(event.key)) this.change({zoom: 1 / 0.9});
        else if (x === 0 && y === 0) return;
        else if (event.shiftKey) this.change({right: 0.05 * x, up: 0.05 * y});
        else this.change({yaw: 0.08 * x, pitch: 0.08 * y});
        event.preventDefault();
    }
};

// The least and the largest coordinates of points, three numbers each.
gloam.boxOf = (positions) => {
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let i = 0; i < positions.length; ++i) {
        low[i % 3] = Math.min(low[i % 3], positions[i]);
        high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
    return {low, high};
};
