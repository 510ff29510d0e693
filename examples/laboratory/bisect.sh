#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# git bisect run bisect.sh MANIFEST [ARGUMENTS of gloam check], in the source folder of a driver: builds a revision with
# the command $BUILD, and checks the driver of this manifest alone. A revision that does not build, or of which nothing
# can be judged, is skipped. One that crashes or hangs is bad. Without a manifest, or its library, the search ends.
bash -c "${BUILD:-ninja -C build install}" || exit 125
gloam devices --driver "$1" >/dev/null || exit 255
exec gloam check --exit-code --quiet --driver "$1" "${@:2}"
