// SPDX-License-Identifier: MIT
// The texts of the licences, from gloam.licences.
"use strict";

document.addEventListener("DOMContentLoaded", () => {
    for (const text of gloam.licences)
        document.getElementById("licences").append(gloam.element("pre", {}, text));
});
