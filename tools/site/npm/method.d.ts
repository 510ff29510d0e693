// SPDX-License-Identifier: MIT
import type {Method} from "./index.js";

/** A method for setPreset(), or for the option `method` of AmbientOcclusionPass. */
declare const method: Method;
export default method;
