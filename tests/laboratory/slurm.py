#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""slurm.py GLOAM: a work list on Slurm, a controller and two node daemons on this machine, of which one is killed.

The results must be those of one machine: nothing is lost, nothing counts twice. Wants root, and what
tools/packages-laboratory.txt names; without these the status is 77."""
import contextlib
import os
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SHARDS = 8
LIST = ["--each", "seed=1..6", "--each", "part=0..3", "--", "check", "HALTON-*", "gloam_radical_*", "--inputs", "4096",
        "--device", "interpreter", "--seed", "{seed}", "--shard", "{part}/4", "--quiet", "--json", "{result}"]
SCRIPT = Path(__file__).parents[2] / "examples" / "laboratory" / "slurm.sh"
CONFIGURATION = """
ClusterName=gloam
SlurmctldHost=localhost
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmctldPort={ports[0]}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmdSpoolDir={folder}/spool-%n
StateSaveLocation={folder}/state
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=10
MessageTimeout=10
SchedulerParameters=sched_interval=1,requeue_delay=1
NodeName=node1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1
NodeName=node2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], text=True, capture_output=True, timeout=300, check=False,
                          **options)
    assert done.returncode == 0, f"{command}: {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def wait_for(what, condition, seconds=90):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"{what}: not within {seconds} s"
        time.sleep(0.2)


class Cluster:
    """The daemons, in the foreground: each is a child of this process, and ends with it."""

    def __init__(self, folder):
        self.folder = folder
        (folder / "state").mkdir()
        configuration = folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(folder=folder, ports=free_ports(3)), encoding="utf-8")
        self.environment = dict(os.environ, SLURM_CONF=str(configuration))
        self.daemons = {}

    def start(self, name, *command):
        log = open(self.folder / f"{name}.log", "w", encoding="utf-8")
        self.daemons[name] = subprocess.Popen([str(word) for word in command], env=self.environment, stdout=log,
                                              stderr=log, stdin=subprocess.DEVNULL, start_new_session=True)

    def __enter__(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self.start("munged", "munged", "--foreground", "--force", f"--key-file={key}",
                   f"--socket={self.folder}/munge.socket", f"--log-file={self.folder}/munged.log",
                   f"--pid-file={self.folder}/munged.pid", f"--seed-file={self.folder}/munged.seed")
        wait_for("munged", (self.folder / "munge.socket").exists)
        self.start("slurmctld", "slurmctld", "-D", "-c")
        for node in ("node1", "node2"):
            self.start(node, "slurmd", "-D", "-c", "-N", node)
        wait_for("two idle nodes", lambda: self.states().count("idle") == 2)
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons.values()):
            daemon.terminate()
        for daemon in self.daemons.values():
            with contextlib.suppress(subprocess.TimeoutExpired):
                daemon.wait(10)
            daemon.kill()

    def states(self):
        done = subprocess.run(["sinfo", "-h", "-N", "-o", "%T"], env=self.environment, text=True, capture_output=True,
                              check=False)
        return done.stdout.split()

    def tasks(self):
        """The tasks of the job array that wait or run."""
        return run("squeue", "-h", "-r", "-o", "%K", env=self.environment).split()

    def processes(self, node):
        """The daemon of a node and all that it runs."""
        victims = {self.daemons[node].pid}
        for process in Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if f"SLURMD_NODENAME={node}\0".encode() in (process / "environ").read_bytes():
                    victims.add(int(process.name))
                    parent = int((process / "stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[1])
                    if b"slurmstepd" in Path(f"/proc/{parent}/cmdline").read_bytes():
                        victims.add(parent)
        return victims

    def kill(self, node):
        """What a power failure does to a node: its daemon and all that it runs are gone."""
        victims = self.processes(node)
        for victim in victims:
            with contextlib.suppress(ProcessLookupError):
                os.kill(victim, signal.SIGKILL)
        return len(victims)


def rows_of(gloam, database, *results):
    run(gloam, "report", "--summary", "--sqlite", database, *results)
    with contextlib.closing(sqlite3.connect(database)) as connection:
        return sorted(connection.execute("SELECT * FROM result").fetchall())


def run_array(gloam, folder, work, results):
    environment = {"PATH": f"{gloam.parent}:{os.environ['PATH']}"}
    with Cluster(folder) as cluster:
        environment = {**cluster.environment, **environment}
        begin = time.monotonic()
        run("sbatch", f"--array=0-{SHARDS - 1}", SCRIPT, work, results, SHARDS, env=environment, cwd=folder)
        wait_for("a task that works on node2, and some results", lambda: list(results.glob(".*")) and
                 len(list(results.glob("*.json"))) >= 3 and len(cluster.processes("node2")) >= 3)
        victims = cluster.kill("node2")
        print(f"killed node2: {victims} processes, after {len(list(results.glob('*.json')))} results", flush=True)
        assert victims >= 3, "the daemon, the step and gloam"
        wait_for("the end of the array", lambda: not cluster.tasks(), 240)
        jobs = run("scontrol", "show", "job", env=environment)
        assert "Restarts=1" in jobs, "no task was queued again:\n" + jobs
        print(f"{SHARDS} tasks on two nodes, one of them killed: {time.monotonic() - begin:.1f} s")


def main():
    gloam = Path(sys.argv[1]).resolve()
    lacks = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name)]
    if os.geteuid() != 0 or lacks:
        print(f"skipped: {'without ' + ', '.join(lacks) if lacks else 'not root'} (tools/setup laboratory)")
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="gloam-slurm-", dir="/tmp") as name:
        folder = Path(name)
        work, whole, results = folder / "list", folder / "whole", folder / "results"
        work.write_text(run(gloam, "work", "list", *LIST), encoding="utf-8")
        begin = time.monotonic()
        print(run(gloam, "work", "run", work, "--results", whole), end="")
        print(f"on one machine without Slurm: {time.monotonic() - begin:.1f} s", flush=True)
        results.mkdir()
        run_array(gloam, folder, work, results)
        missing = run(gloam, "work", "missing", work, "--results", results)
        assert missing == "", f"lost: {missing}"
        expected = rows_of(gloam, folder / "whole.sqlite", whole)
        assert rows_of(gloam, folder / "lab.sqlite", results) == expected, "other results than on one machine"
        assert rows_of(gloam, folder / "lab.sqlite", results, whole) == expected, "an answer counts twice"
        print(f"{len(expected)} results, each once")


if __name__ == "__main__":
    main()
