#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""debian_test.py SOURCE BUILD: the packages of Debian 12 and 13, each made in its release and used in a bare chroot.

GLOAM_DEBIAN=1 runs it, in about 15 minutes. Those of this machine's release are made of BUILD. Those of the other are
made in the bare machine of tools/test-releases (GLOAM_DEBIAN_MACHINE names another folder). Wants root and debootstrap.
"""
import os
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from run import BUILD, CONSUMER, SOURCE, VERSION, run

RELEASES = ("bookworm", "trixie")
HERE = re.search(r"^VERSION_CODENAME=(\w+)", Path("/etc/os-release").read_text(encoding="utf-8"), re.M)[1]
OTHER = RELEASES[HERE == RELEASES[0]]
NAMES = {"gloam-common", "gloam-glsl", "libgloam-shader-test-dev", "gloam"}
PROGRAM = ("gloam", "gloam-glsl", "gloam-common")
FRAMEWORK = ("libgloam-shader-test-dev", "gloam-common")


def made_here(folder):
    run("ninja", "-C", BUILD, "bin/gloam")
    run("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    return folder


def made_there(folder):
    machine = Path(os.environ.get("GLOAM_DEBIAN_MACHINE", f"/var/tmp/gloam-{OTHER}"))
    run(SOURCE / "tools" / "bare-machine", OTHER, machine, "bash", "-c",
        "tools/setup && tools/build program && "
        "rm -rf build/packages && cpack -G DEB --config build/release/CPackConfig.cmake -B build/packages")
    for package in (machine / "gloam" / "build" / "packages").glob("*.deb"):
        shutil.copy(package, folder)
    return folder


class Chroot:
    """A bare Debian, made for one test and removed after it."""

    def __init__(self, release, packages):
        self.folder = Path(tempfile.mkdtemp(prefix="gloam-debian-", dir="/var/tmp"))
        run("debootstrap", "--variant=minbase", release, self.folder)
        shutil.copy("/etc/resolv.conf", self.folder / "etc" / "resolv.conf")
        run("mount", "-t", "proc", "proc", self.folder / "proc")
        shutil.copytree(packages, self.folder / "packages", ignore=shutil.ignore_patterns("_CPack_Packages"))
        self.packages = {path.name.split("_")[0]: f"/packages/{path.name}" for path in packages.glob("*.deb")}

    def run(self, command, **options):
        return run("chroot", self.folder, "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "LC_ALL=C",
                   "DEBIAN_FRONTEND=noninteractive", "sh", "-ec", command, **options)

    def install(self, *names, option="--no-install-recommends"):
        """Packages by name, ours from their files, with what they depend on; option="": and recommend."""
        self.run(f"apt-get -q -y install {option} " + " ".join(self.packages.get(name, name) for name in names))

    def remove(self):
        run("umount", self.folder / "proc")
        run("rm", "-rf", "--one-file-system", self.folder)


class Debian(unittest.TestCase):
    def use(self, release, made):
        with tempfile.TemporaryDirectory(dir="/var/tmp") as folder:
            machine = Chroot(release, made(Path(folder)))
            self.addCleanup(machine.remove)
        self.assertEqual(NAMES, set(machine.packages))
        self.program(machine)
        self.framework(machine)

    def program(self, machine):
        before = machine.run("find / -xdev -name '*gloam*' ! -path '/packages/*'")
        machine.install(*PROGRAM)
        self.assertTrue(machine.run("gloam --version").startswith(f"gloam {VERSION}, "))
        self.assertIn(" 0 failed", machine.run("gloam check TSSAO-5 HALTON --inputs 512 --device interpreter"))
        self.assertIn("gloam_remap(", machine.run("gloam pack gloam/shading/ambient.glsl"))
        machine.run("gloam pack --npm npm && test -s npm/LICENSE")
        machine.install("mesa-vulkan-drivers")
        machine.run("gloam render corner --size 32x18 --radius 1 --out corner && test -s corner/render.json")
        machine.run("gloam demo --quiet && test -s gloam-demo/live.js")
        machine.install("lintian")
        self.assertEqual("", machine.run("lintian --allow-root --fail-on none /packages/*.deb"))
        for name in PROGRAM:
            self.assertIn("MIT License", machine.run(f"cat /usr/share/doc/{name}/copyright"))
        machine.run("rm -r npm gloam-demo corner ~/.cache && apt-get -q -y purge " + " ".join(PROGRAM))
        self.assertEqual(before, machine.run("find / -xdev -name '*gloam*' ! -path '/packages/*'"))

    def framework(self, machine):
        """First without the shader library: another project tests a function of its own."""
        own = machine.folder / "own_function"
        shutil.copytree(CONSUMER, own)
        originals = {name: (own / name).read_text(encoding="utf-8") for name in ("CMakeLists.txt", "shader_test.cpp")}
        (own / "CMakeLists.txt").write_text(originals["CMakeLists.txt"].replace("shader_test glsl)", "shader_test)"),
                                            encoding="utf-8")
        (own / "shader_test.cpp").write_text(originals["shader_test.cpp"].split("TEST(Fog")[0], encoding="utf-8")
        build = "cd /own_function && cmake -G Ninja -B build && cmake --build build && ctest --test-dir build"
        machine.install(*FRAMEWORK, "ninja-build", option="")
        self.assertIn("100% tests passed, 0 tests failed out of 1", machine.run(build))
        self.assertEqual("", machine.run("find / -xdev -name 'ambient_occlusion*'"))
        for name, text in originals.items():
            (own / name).write_text(text, encoding="utf-8")
        machine.install("gloam-glsl")
        self.assertIn("100% tests passed, 0 tests failed out of 2", machine.run(build))

    def test_packages_of_this_release(self):
        self.use(HERE, made_here)

    def test_packages_of_the_other_release(self):
        self.use(OTHER, made_there)


if __name__ == "__main__":
    lacking = [what for what, there in (("GLOAM_DEBIAN=1", os.environ.get("GLOAM_DEBIAN")), ("root", os.geteuid() == 0),
                                        ("debootstrap", shutil.which("debootstrap")),
                                        ("Debian 12 or 13", HERE in RELEASES)) if not there]
    if lacking:
        print("skipped: needs " + ", ".join(lacking))
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
