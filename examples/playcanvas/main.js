// SPDX-License-Identifier: MIT
import {open} from "../page.js";
import {View} from "./view.js";

open(View);
