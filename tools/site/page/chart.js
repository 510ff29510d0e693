// SPDX-License-Identifier: MIT
// Charts of error against time with uPlot, from tables of configurations.
"use strict";

gloam.chart = (() => {
    const waiting = [];  // charts that have a place in the page but are not drawn
    const modes = ["single", "temporal"];

    const column = (head, wanted) => head.findIndex((title) => wanted.test(title));

    // The points of a table with a column of time and one of error: [{name, time, error}], by time. Otherwise none.
    function pointsOf(block) {
        const [time, error] = [column(block.head, /^(ms|time)$/), column(block.head, /RMSE/)];
        if (time < 0 || error < 0 || block.rows.length < 3) return [];
        const points = block.rows.map((row) => ({name: row[0].replace(/`/g, ""), time: Number(row[time]),
            error: Number(row[error])}));
        return points.filter((point) => point.time > 0 && point.error > 0).sort((a, b) => a.time - b.time);
    }

    // An element for the chart of a table, and a line that names the point under the pointer.
    function of(block) {
        const points = pointsOf(block);
        if (points.length === 0) return [];
        const place = gloam.element("div", {class: "chart", role: "img",
            "aria-label": "Error against time; the table below has the same numbers"});
        const told = gloam.element("p", {class: "soft"}, "Point at the chart: its configurations are named here.");
        waiting.push({points, place, told});
        return [place, told];
    }

    function optionsOf({points, place, told}) {
        const style = getComputedStyle(document.documentElement);
        const ink = style.getPropertyValue("--ink");
        const line = style.getPropertyValue("--line");
        const colors = [style.getPropertyValue("--bad"), style.getPropertyValue("--mark")];
        const axis = (label) => ({label, stroke: ink, grid: {stroke: line}, ticks: {stroke: line}});
        const series = modes.map((mode, i) => ({label: mode, stroke: colors[i], paths: () => null,
            points: {show: true, size: 7, fill: colors[i]}}));
        const name = (u) => {
            const point = points[u.cursor.idx];
            if (point) told.textContent = `${point.name}: time ${point.time}, error ${point.error}`;
        };
        return {width: place.clientWidth, height: 320, scales: {x: {time: false, distr: 3}}, series: [{}, ...series],
            axes: [axis("time"), axis("error (RMSE)")], legend: {live: false},
            hooks: {setCursor: [name]}};
    }

    function draw(chart) {
        const {points, place} = chart;
        const isMode = (mode, point) => point.name.includes("/") ? point.name.endsWith("/" + mode) : mode === modes[1];
        const data = [points.map((point) => point.time), ...modes.map((mode) =>
            points.map((point) => isMode(mode, point) ? point.error : null))];
        const plot = new uPlot(optionsOf(chart), data, place);
        new ResizeObserver(() => plot.setSize({width: place.clientWidth, height: 320})).observe(place);
    }

    return {of, drawAll: () => waiting.splice(0).forEach(draw), pointsOf};
})();
