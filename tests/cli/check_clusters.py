"""A study by worker processes, by the ranks of mpirun and by Slurm: the same bytes, and nothing lost or double when
workers, ranks, tasks or all of it are killed at twenty moments.

Usage: check_clusters.py HAWSER SOURCE jobs|mpi|slurm
Returns 77 with a message where the engine is not to be had.
"""
import fcntl
import glob
import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

HAWSER, SOURCE, ENGINE = sys.argv[1:4]
SAMPLES, KILLS, PATIENCE = 3000, 20, 120
RESULTS = ["samples.csv", "summary.json", "study.h5", "study.html"]
SKIPPED = 77


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


# ------------------------------------------------------------------------------------------------------ the engines

def mpirun(ranks):
    return ["mpirun", "--oversubscribe", "-n", str(ranks), HAWSER, "study", "--mpi"]


def check_mpi():
    if not shutil.which("mpirun"):
        skip("there is no mpirun here (Debian: openmpi-bin)")
    if not glob.glob(os.path.dirname(HAWSER) + "/../lib*/**/hawser/mpi.so", recursive=True):
        skip("hawser was built without MPI (Debian: libopenmpi-dev)")
    os.environ |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def up_loopback():
    """Brings lo up in a network of our own, where nobody else's ports are, with an address that is not of loopback:
    names are looked up for kinds of addresses that are there."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
        fcntl.ioctl(s, 0x8914, struct.pack("16sh14x", b"lo", 0x1 | 0x40))  # SIOCSIFFLAGS: up, running
        address = struct.pack("16sHH4s8x", b"lo:1", socket.AF_INET, 0, socket.inet_aton("192.0.2.1"))
        fcntl.ioctl(s, 0x8916, address)  # SIOCSIFADDR


def slurm_start(folder):
    """A Slurm of one node; its two daemons."""
    host = socket.gethostname()
    for name in ("state", "spool"):
        os.makedirs(f"{folder}/{name}")
    lines = f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmUser=root
SlurmdUser=root
MpiDefault=none
MailProg=/bin/true
SchedulerParameters=batch_sched_delay=0,sched_interval=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""
    for name, text in (("slurm.conf", lines), ("cgroup.conf", "CgroupPlugin=cgroup/v1\n")):
        with open(f"{folder}/{name}", "w") as f:
            f.write(text)
    os.environ["SLURM_CONF"] = f"{folder}/slurm.conf"
    daemons = []
    for name in ("slurmctld", "slurmd"):
        with open(f"{folder}/{name}.log", "w") as log:
            daemons.append(subprocess.Popen([name, "-D", "-c"], stdout=log, stderr=log))
    end = time.monotonic() + 20
    while time.monotonic() < end:
        if "idle" in subprocess.run(["sinfo", "-h", "-o", "%t"], capture_output=True, text=True).stdout:
            return daemons
        time.sleep(0.2)
    tail = "".join(open(f"{folder}/{n}.log").read()[-400:] for n in ("slurmctld", "slurmd"))
    slurm_end(daemons)
    skip(f"Slurm does not start here: {tail}")


def slurm_end(daemons):
    for d in reversed(daemons):
        d.terminate()
    for d in daemons:
        d.wait()


def check_slurm():
    if not all(shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin") for name in ("slurmctld", "slurmd", "sbatch")):
        skip("there is no Slurm here (Debian: slurmctld, slurmd, slurm-client; scripts/setup.sh --clusters)")
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    if os.geteuid():
        skip("Slurm's daemons need root")
    if "HAWSER_OWN_NET" in os.environ:
        up_loopback()
        return
    own = subprocess.run(["unshare", "--net", "true"], capture_output=True)
    if own.returncode:
        skip("no network namespace can be had for Slurm's ports")
    os.environ["HAWSER_OWN_NET"] = "1"
    os.execvp("unshare", ["unshare", "--net", sys.executable, "-B", *sys.argv])


# ------------------------------------------------------------------------------------------------------- what is seen

def rows(folder):
    """The numbers of the samples in the workers' files, whole rows only."""
    found = []
    for path in sorted(glob.glob(f"{folder}/workers/*.rows")):
        with open(path, "rb") as f:
            data = f.read()
        found += [struct.unpack_from("<q", data, at)[0] for at in range(0, len(data) - RECORD + 1, RECORD)]
    return found


def children(pid):
    """All processes below one."""
    try:
        with open(f"/proc/{pid}/task/{pid}/children") as f:
            direct = [int(word) for word in f.read().split()]
    except OSError:
        return []
    return direct + [below for child in direct for below in children(child)]


def words(pid):
    try:
        with open(f"/proc/{pid}/cmdline", "rb") as f:
            return f.read().split(b"\0")
    except OSError:
        return []


def members(folder, root):
    """Of the study in a folder: the processes that steer (ranks, tasks), and their workers."""
    mine = [p for p in map(int, filter(str.isdigit, os.listdir("/proc")))
            if words(p)[:2] == [HAWSER.encode(), b"study"] and folder.encode() in words(p) and p != root]
    parent = {}
    for p in mine:
        try:
            with open(f"/proc/{p}/stat") as f:
                parent[p] = int(f.read().rsplit(")", 1)[1].split()[1])
        except OSError:
            pass
    both = set(mine) | ({root} if words(root)[:1] == [HAWSER.encode()] else set())  # not mpirun
    steer = [p for p in mine if parent.get(p) not in both]
    return steer, [p for p in mine if parent.get(p) in both]


def same(one, other):
    for name in RESULTS:
        with open(f"{one}/{name}", "rb") as a, open(f"{other}/{name}", "rb") as b:
            assert a.read() == b.read(), f"{one}/{name} and {other}/{name} differ"


def once(folder):
    found = rows(folder)
    assert sorted(found) == list(range(SAMPLES)), f"{folder}: {len(found)} rows, {len(set(found))} samples"


# ---------------------------------------------------------------------------------------------------------- the tests

def study(command, folder, **more):
    return [*command, STUDY, "--output", folder, "--quiet"]


def whole(command, folder):
    subprocess.run(study(command, folder), check=True, timeout=PATIENCE)


def end(process):
    process.send_signal(signal.SIGKILL)
    process.wait()


def killed(command, folder, choose):
    """Starts the study until it gets to its end; each start is hit once a share of the samples is there."""
    for k in range(KILLS):
        before = len(set(rows(folder)))
        goal = max(before + 1, SAMPLES * (k + 1) // (KILLS + 2))
        process = subprocess.Popen(study(command, folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   start_new_session=True)
        deadline = time.monotonic() + PATIENCE
        while len(rows(folder)) < goal and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.002)
        time.sleep(0.0013 * (k % 7))
        assert process.poll() is None, f"the study ended before it was hit for the {k + 1}th time"
        assert len(rows(folder)) < SAMPLES, f"the study was over before it was hit for the {k + 1}th time"
        choose(process, folder, k)
        while ENGINE != "slurm" and any(members(folder, process.pid)) and time.monotonic() < deadline:
            time.sleep(0.01)  # ranks and workers end with it, in a moment
        assert len(set(rows(folder))) >= before, "rows were thrown away"
    whole(command, folder)
    once(folder)


def end_all(process, folder):
    """Ranks too: left alone they notice after a moment that mpirun is gone, and might be at their end by then."""
    steer, _ = members(folder, process.pid)
    for pid in steer:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    end(process)


def hit_whole(process, folder, k):
    end_all(process, folder)


def hit_rank(process, folder, k):
    """One rank, then the rest; the last time mpirun is left to end the others, which takes it seconds."""
    steer, _ = members(folder, process.pid)
    os.kill(steer[k % len(steer)], signal.SIGKILL)
    if k == KILLS - 1:
        assert process.wait(PATIENCE) != 0, "mpirun does not say that a rank died"
        return
    time.sleep(0.03)
    end_all(process, folder)


def hit_task(process, folder, k):
    """In turn a task of the array, and who waits for it: the array goes on."""
    steer, _ = members(folder, process.pid)
    if k % 2 == 0 and steer:
        os.kill(steer[k % len(steer)], signal.SIGKILL)
    if k % 2:
        end(process)
    elif process.poll() is None:
        time.sleep(0.1)
        end(process)


def workers_killed(command, folder, reference):
    """Workers die at twenty moments of one start: each takes at most its sample along."""
    process = subprocess.Popen(study(command, folder), stdout=subprocess.DEVNULL)
    hit = 0
    while process.poll() is None and hit < KILLS:
        time.sleep(0.02)
        if len(rows(folder)) < SAMPLES * (hit + 1) // (KILLS + 2):
            continue
        _, workers = members(folder, process.pid)
        if workers:
            try:
                os.kill(workers[hit % len(workers)], signal.SIGKILL)
                hit += 1
            except ProcessLookupError:
                pass
    assert process.wait(PATIENCE) == 0
    assert hit > KILLS // 2, f"only {hit} workers could be hit"
    once(folder)
    with open(f"{folder}/samples.csv") as a, open(f"{reference}/samples.csv") as b:
        other = [x for x, y in zip(a.readlines(), b.readlines(), strict=True) if x != y]
    assert len(other) <= hit and all("signal 9" in line for line in other), other[:3]
    print(f"{hit} workers killed: {len(other)} samples went with them, {SAMPLES} rows once each")


def main():
    {"jobs": lambda: None, "mpi": check_mpi, "slurm": check_slurm}[ENGINE]()
    work = tempfile.mkdtemp(prefix="hawser-clusters-")
    daemons = []
    try:
        global STUDY, RECORD
        STUDY = f"{work}/study.yaml"
        with open(f"{SOURCE}/cases/studies/friction.yaml") as f, open(STUDY, "w") as out:
            out.write(f.read().replace("../huangjiahu", f"{SOURCE}/cases/huangjiahu").replace("1024", str(SAMPLES)))
        reference = f"{work}/reference"
        whole([HAWSER, "study", "--jobs", "1"], reference)
        RECORD = os.path.getsize(f"{reference}/workers/worker-0.rows") // SAMPLES
        if ENGINE == "slurm":
            daemons = slurm_start(f"{work}/slurm")
        commands = {"jobs": [[HAWSER, "study", "--jobs", "2"], [HAWSER, "study", "--jobs", "4"]],
                    "mpi": [mpirun(2), mpirun(4)],
                    "slurm": [[HAWSER, "study", "--slurm", "--tasks", "4"],
                              [HAWSER, "study", "--slurm", "--tasks", "3", "--jobs", "2"]]}[ENGINE]
        for k, command in enumerate(commands):
            whole(command, f"{work}/whole-{k}")
            same(reference, f"{work}/whole-{k}")
            once(f"{work}/whole-{k}")
        print("the same bytes by", *(" ".join(c).replace(HAWSER, "hawser") for c in commands), sep="\n  ")
        for k, hit in enumerate({"jobs": [hit_whole], "mpi": [hit_whole, hit_rank], "slurm": [hit_task]}[ENGINE]):
            killed(commands[0], f"{work}/killed-{k}", hit)
            same(reference, f"{work}/killed-{k}")
            print(f"{KILLS} times {hit.__name__}: the same bytes, {SAMPLES} rows once each")
        if ENGINE != "slurm":
            workers_killed(commands[0], f"{work}/workers", reference)
    finally:
        slurm_end(daemons)
        shutil.rmtree(work, ignore_errors=True)


main()
