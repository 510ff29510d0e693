#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""engines.py GLOAM: a work list as a Kubernetes job, a Slurm task and GNU parallel would run it, here and without them.

Two machines that run the same shard at once leave one result. The parts whose packages are missing are skipped; where
none is left, the status is 77."""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import yaml
except ImportError:
    yaml = None

EXAMPLES = Path(__file__).parents[2] / "examples" / "laboratory"
SHARDS = 200  # of the manifest
LIST = ["--each", "seed=0..3", "--", "check", "HALTON-base2", "--inputs", "64", "--device", "interpreter", "--seed",
        "{seed}", "--quiet", "--json", "{result}"]


class Laboratory:
    def __init__(self, gloam, folder):
        self.folder = folder
        self.environment = dict(os.environ, PATH=f"{gloam.parent}:{os.environ['PATH']}")
        (folder / "list").write_text(self.run("gloam", "work", "list", *LIST), encoding="utf-8")

    def start(self, *command, **variables):
        return subprocess.Popen([str(word) for word in command], cwd=self.folder, env={**self.environment, **variables},
                                text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, *command, **variables):
        process = self.start(*command, **variables)
        out, err = process.communicate(timeout=120)
        assert process.returncode == 0, f"{command}: {process.returncode}\n{out}{err}"
        return out

    def missing(self):
        return self.run("gloam", "work", "missing", "list", "--results", "results").strip()


def kubernetes(laboratory):
    job = yaml.safe_load((EXAMPLES / "job.yaml").read_text(encoding="utf-8"))
    spec = job["spec"]
    assert (job["apiVersion"], job["kind"], spec["completionMode"]) == ("batch/v1", "Job", "Indexed")
    assert spec["completions"] == SHARDS >= spec["parallelism"]
    pod = spec["template"]["spec"]
    assert pod["restartPolicy"] == "Never" and "backoffLimitPerIndex" in spec, "these need each other"
    container, = pod["containers"]
    mount, = container["volumeMounts"]
    assert mount["name"] == pod["volumes"][0]["name"]
    words = container["command"] + container["args"]
    here = [word.replace(mount["mountPath"], str(laboratory.folder)) for word in words]
    laboratory.run(*here, JOB_COMPLETION_INDEX="1")


def main():
    gloam = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        laboratory = Laboratory(gloam, Path(name))
        assert laboratory.missing() == "0-3"
        both = [laboratory.start(EXAMPLES / "slurm.sh", "list", "results", SHARDS, SLURM_ARRAY_TASK_ID="0")
                for _ in range(2)]
        assert [process.wait(120) for process in both] == [0, 0]
        assert laboratory.missing() == "1-3", "two machines, one result"
        if yaml:
            kubernetes(laboratory)
            assert laboratory.missing() == "2-3"
        if shutil.which("parallel"):
            laboratory.run("parallel", "--sshlogin", ":", "--workdir", ".", "gloam", "work", "run", "list", "--results",
                           "results", "--shard", f"{{}}/{SHARDS}", ":::", *range(4))
            assert laboratory.missing() == ""
            assert len(list((laboratory.folder / "results").iterdir())) == 4
        print("with" + ("" if yaml else "out") + " the manifest,", shutil.which("parallel") or "without parallel")
        sys.exit(0 if yaml or shutil.which("parallel") else 77)


if __name__ == "__main__":
    main()
