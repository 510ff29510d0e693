#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# git bisect run bisect.sh MANIFEST [ARGUMENTS of gloam check], in the source folder of a driver: builds a revision with
# the command $BUILD, and checks the driver of this manifest alone. A revision that does not build, or of which nothing
# can be judged, is skipped. One that crashes or hangs is bad.
manifest=$(realpath -- "$1") && ${BUILD:-ninja -C build install} || exit 125
VK_DRIVER_FILES=$manifest VK_ICD_FILENAMES=$manifest exec gloam check --exit-code --quiet "${@:2}"
