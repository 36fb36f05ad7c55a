"""A Slurm cluster on one machine: a controller and a daemon for each node, without privileges of a service or a database.

    with Cluster(folder, ["n1", "n2"]) as cluster:
        subprocess.run(["sbatch", ...], env=cluster.environment)
        cluster.kill("n1")

Everything the cluster writes lies in `folder`. A node is its daemon and its jobs' processes.
"""
import os
import pathlib
import shutil
import socket
import subprocess
import time

from dying_machine import kill_all

PROGRAMS = ["slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol"]
CONFIGURATION = """ClusterName=emulated
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/none
CredType=cred/none
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={port}
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/%n.pid
SlurmdSpoolDir={folder}/spool-%n
StateSaveLocation={folder}/state
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdTimeout=5
JobRequeue=1
SchedulerParameters=sched_interval=1,batch_sched_delay=0
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def find(program):
    """Daemons lie where only root's PATH leads."""
    return shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def is_installed():
    return all(find(program) for program in PROGRAMS)


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def wait_until(condition, seconds, what):
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise TimeoutError(f"{what}: not within {seconds} s")
        time.sleep(0.02)


class CannotRun(Exception):
    """A daemon of Slurm does not run on this machine, or not for this user."""


class Cluster:
    def __init__(self, folder, nodes):
        self.folder = pathlib.Path(folder).resolve()
        self.nodes = nodes
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"))
        self.daemons = {}

    def __enter__(self):
        (self.folder / "state").mkdir(parents=True)
        port, *ports = free_ports(1 + len(self.nodes))
        host = socket.gethostname().split(".")[0]
        nodes = "\n".join(
            f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={p} CPUs=1 State=UNKNOWN"
            for node, p in zip(self.nodes, ports)
        )
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(host=host, user=user, port=port, folder=self.folder, nodes=nodes)
        )
        # Also without limits slurmd wants to know of which kind they would be, and looks for itself where none are mounted.
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        try:
            self.start("controller", [find("slurmctld"), "-D", "-i"])
            for node in self.nodes:
                self.start(node, [find("slurmd"), "-D", "-N", node])
            wait_until(self.is_ready, 60, "nodes idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for name in [*self.nodes, "controller"]:
            if name in self.daemons:
                self.kill(name)

    def is_ready(self):
        for name, daemon in self.daemons.items():
            if daemon.poll() is not None:
                lines = (self.folder / f"{name}.out").read_text().splitlines()
                raise CannotRun(f"{name}: {lines[-1] if lines else 'ended without a word'}")
        return self.ask("sinfo", "-h", "-N", "-o", "%t").split() == ["idle"] * len(self.nodes)

    def start(self, name, command):
        log = open(self.folder / f"{name}.out", "wb")
        environment = dict(self.environment, EMULATED_NODE=name)
        self.daemons[name] = subprocess.Popen(command, stdout=log, stderr=log, env=environment)

    def ask(self, *command):
        return subprocess.run(command, capture_output=True, text=True, env=self.environment).stdout

    def kill(self, name):
        """Daemons pass their environment on to what they start; jobs have their submitter's, and their node's name."""
        kill_all([f"EMULATED_NODE={name}", f"SLURMD_NODENAME={name}"])
        self.daemons.pop(name).wait()
