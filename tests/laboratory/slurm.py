#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""slurm.py GLOAM: examples/laboratory/slurm.sh on Slurm: a controller and two nodes here, of which one is killed.
The shards' results are those of one run. GLOAM_SLURM=1 runs it. Wants root and Debian's slurm-wlm and munge."""
import contextlib
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CHECK = ["HALTON-*", "gloam_radical_*", "--variant", "all", "--device", "interpreter", "--inputs", "500000", "--jobs", "1"]
SCRIPT = Path(__file__).parents[2] / "examples/laboratory/slurm.sh"
DAEMONS = ["munged --foreground --force --key-file={0}/munge.key --socket={0}/munge.socket --log-file={0}/munge.log "
           "--pid-file={0}/munge.pid --seed-file={0}/munge.seed", "slurmctld -D -c", "slurmd -DcN node1", "slurmd -DcN node2"]
CONFIGURATION = """
ClusterName=gloam
SlurmctldHost=localhost
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmctldPort={ports[0]}
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmdSpoolDir={folder}/spool-%n
StateSaveLocation={folder}/state
ProctrackType=proctrack/pgid
SlurmdParameters=config_overrides
SlurmdTimeout=10
SchedulerParameters=requeue_delay=1
NodeName=node1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1
NodeName=node2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1
PartitionName=all Nodes=node1,node2 Default=YES
"""


def run(*command, check=True, **options):
    return subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE, timeout=300, check=check,
                          **options).stdout


def wait_for(what, condition):
    end = time.monotonic() + 240
    while not condition():
        assert time.monotonic() < end, f"{what}: not within 240 s"
        time.sleep(0.2)


def kill_node(name):
    """What a power failure does: the daemon of a node and all that it runs are gone, and none of them reports it."""
    victims = set()
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if f"-DcN\0{name}\0".encode() in (process / "cmdline").read_bytes():
                victims.add(int(process.name))
            if f"SLURMD_NODENAME={name}\0".encode() in (process / "environ").read_bytes():
                victims |= {int(process.name), int((process / "stat").read_text().rsplit(")", 1)[1].split()[1])}
    for victim in sorted(victims):  # a parent, slurmstepd say, before its child
        os.kill(victim, signal.SIGKILL)


def run_array(folder, results, environment, daemons):
    (folder / "state").mkdir()
    ports = [socket.create_server(("127.0.0.1", 0)).getsockname()[1] for _ in range(3)]
    (folder / "munge.key").write_bytes(os.urandom(128))
    (folder / "slurm.conf").write_text(CONFIGURATION.format(folder=folder, ports=ports))
    for line in DAEMONS:
        daemon = daemons.enter_context(subprocess.Popen(line.format(folder).split(), env=environment))
        daemons.callback(daemon.kill)
        wait_for("munged", (folder / "munge.socket").exists)
    wait_for("two nodes", lambda: run("sinfo", "-hNo%T", check=False, env=environment).split() == ["idle", "idle"])
    run("sbatch", "--array=0-7", SCRIPT, 8, results, *CHECK, cwd=folder, env=environment)
    wait_for("results", lambda: len([*results.glob("*.json")]) > 1 and run("squeue", "-htR", "-wnode2", env=environment))
    kill_node("node2")
    wait_for("the end of the array", lambda: not run("squeue", "-h", env=environment))
    assert "Restarts=1" in run("scontrol", "show", "job", env=environment), "no task was queued again"


def main():
    gloam = Path(sys.argv[1]).resolve()
    if not os.environ.get("GLOAM_SLURM") or os.geteuid() != 0 or not shutil.which("slurmctld"):
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="gloam-slurm-", dir="/tmp") as name, contextlib.ExitStack() as daemons:
        folder, results, whole = Path(name), Path(name) / "results", Path(name) / "whole.json"
        environment = {"PATH": f"{gloam.parent}:{os.environ['PATH']}", "SLURM_CONF": f"{name}/slurm.conf"}
        run_array(folder, results, {**os.environ, **environment}, daemons)
        run(gloam, "check", *CHECK, "--quiet", "--json", whole)

        def rows(*files):
            run(gloam, "report", "--json", folder / "merged", *files)
            return [{**row, "seconds": 0} for row in json.loads((folder / "merged").read_text())["results"]]

        shards = [*results.glob("*.json")]
        assert rows(*shards) == rows(*reversed(shards), whole) == rows(whole), "other results than of one run"


if __name__ == "__main__":
    main()
