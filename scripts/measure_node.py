#!/usr/bin/python3
"""Measures the running node beside a bare relay of the same messages, and prints a table.

Time from an obstacles message to its warning, or to the relayed message, at a client of its own: as
separate processes (topic_tools' relay), and as nodelets in one. 16 segments, 100 messages a second to
each, in turn; ego_motion is static, so that nothing waits for odometry, unless it says otherwise.
Processor time is of one processor; memory is the most that was resident.
"""

import argparse
import json
import math
import os
import socket
import statistics
import subprocess
import sys
import time

SIZES = (10, 100, 1000, 10000)
RATE = 100  # [Hz] of the messages to each
MAX_P99 = 0.02  # [s] with all processors busy
PATIENCE = 5.0  # [s] of the predictor, so that it answers also when the machine was stuck
MAX_MEMORY = 60  # [MB]
MAX_RATIO = {1000: (1.2, 1.08), 10000: (2, None)}  # of medians: goal, moonshot
FOOTPRINT = [[0.6 * math.cos(i * math.pi / 8), 0.6 * math.sin(i * math.pi / 8)] for i in range(16)]
PACKAGE = "footprint_collision_predictor"
TICKS = os.sysconf("SC_CLK_TCK")


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class Processes:
    """Ended together, also when something fails."""

    def __init__(self):
        self.environment = dict(os.environ, ROS_MASTER_URI="http://localhost:%d" % free_port())
        self._started = []

    def start(self, *command):
        process = subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self._started.append(process)
        return process

    def start_master(self):
        self.start("rosmaster", "--core", "-p", self.environment["ROS_MASTER_URI"].split(":")[-1])
        while subprocess.run(["rosparam", "list"], env=self.environment, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, check=False).returncode != 0:
            time.sleep(0.1)

    def set_parameters(self, node, **parameters):
        subprocess.run(["rosparam", "set", node, json.dumps(parameters)], env=self.environment,
                       check=True)

    def end(self):
        for process in reversed(self._started):
            process.terminate()
            process.wait()
        self._started = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()


def processor_time(process):
    """[s]"""
    with open("/proc/%d/stat" % process.pid) as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def peak_memory(process):
    """[MB]"""
    with open("/proc/%d/status" % process.pid) as file:
        return next(int(line.split()[1]) / 1024 for line in file if line.startswith("VmHWM"))


def summary(times):
    times = sorted(times)
    return {"p50": statistics.median(times), "p99": times[int(0.99 * len(times))],
            "max": times[-1]}


class Bench:
    def __init__(self, program, processes, messages):
        self.program, self.processes, self.messages = program, processes, messages
        self.runs = []

    def measure(self, obstacles, *options, watched=None, **labels):
        """One run of the client; `watched`: the processes of relay and predictor."""
        # With odometry a message takes five times as long.
        messages = self.messages // 3 if "--odometry" in options else self.messages
        client = subprocess.Popen(
            [self.program, "--obstacles", str(obstacles), "--messages", str(messages), *options],
            env=self.processes.environment, stdout=subprocess.PIPE, text=True)
        lines = iter(client.stdout.readline, "")
        next(line for line in lines if line == "begin\n")
        before = {name: processor_time(p) for name, p in (watched or {}).items()}
        begin = time.monotonic()
        times = json.loads(next(line for line in lines if line.startswith("{")))
        passed = time.monotonic() - begin
        run = dict(labels, obstacles=obstacles, messages=messages, load=os.getloadavg())
        for name in times:
            run[name] = summary(times[name])
        for name, process in (watched or {}).items():
            run[name]["processor"] = (processor_time(process) - before[name]) / passed
            run[name]["memory"] = peak_memory(process)
        if client.wait() != 0:
            sys.exit("the client failed")
        run["ratio"] = run["predictor"]["p50"] / run["relay"]["p50"]
        self.runs.append(run)
        print_run(run)


def in_processes(bench, what, sizes, busy, ego_motion):
    processes = bench.processes
    processes.start_master()
    processes.set_parameters("/predictor_node", footprint=FOOTPRINT, ego_motion=ego_motion,
                             max_data_age=PATIENCE)
    watched = {
        "relay": processes.start("rosrun", "topic_tools", "relay", "relay/obstacles", "relay/answer"),
        "predictor": processes.start(
            "rosrun", PACKAGE, "predictor_node", "obstacles:=predictor/obstacles",
            "odom:=predictor/odom", "collision_warning:=predictor/answer")}
    options = ["--odometry"] if ego_motion == "odom" else []
    for obstacles in sizes:
        bench.measure(obstacles, *options, watched=watched, what=what, busy=busy)
    processes.end()


def in_nodelets(bench, what, sizes, busy):
    processes = bench.processes
    processes.start_master()
    processes.set_parameters("/predictor_nodelet", footprint=FOOTPRINT, ego_motion="static",
                             max_data_age=PATIENCE)
    for obstacles in sizes:
        bench.measure(obstacles, "--nodelets", what=what, busy=busy)
    processes.end()


def print_heading(text):
    print("\n%s; load %.2f %.2f %.2f" % ((text,) + os.getloadavg()))
    print("  %9s %20s %22s %7s %18s %12s" % ("", "relay", "predictor", "", "processor", ""))
    print("  %9s %10s %9s %12s %9s %7s %9s %8s %12s" %
          ("obstacles", "p50 [ms]", "p99", "p50 [ms]", "p99", "ratio", "relay", "predictor",
           "memory [MB]"))


def print_run(run):
    relay, predictor = run["relay"], run["predictor"]
    line = "  %9s %10.3f %9.3f %12.3f %9.3f %7.2f" % (
        format(run["obstacles"], ","), 1e3 * relay["p50"], 1e3 * relay["p99"],
        1e3 * predictor["p50"], 1e3 * predictor["p99"], run["ratio"])
    if "memory" in predictor:
        line += " %8.1f%% %8.1f%% %12.1f" % (100 * relay["processor"], 100 * predictor["processor"],
                                             predictor["memory"])
    print(line, flush=True)


def measure_all(bench, sizes):
    print_heading("Processes")
    in_processes(bench, "processes", sizes, False, "static")
    print_heading("Nodelets in one process")
    in_nodelets(bench, "nodelets", sizes, False)
    print_heading("Processes, ego_motion odom: 20 messages a second, which wait for odometry at 50 Hz")
    in_processes(bench, "with odometry", sizes[2:3], False, "odom")
    loops = Processes()
    with loops:
        for _ in range(os.cpu_count()):
            loops.start("sh", "-c", "while :; do :; done")
        print_heading("Processes, all processors busy with other things")
        in_processes(bench, "processes", sizes, True, "static")
        print_heading("Nodelets in one process, all processors busy with other things")
        in_nodelets(bench, "nodelets", sizes, True)


def print_goals(runs):
    print("\n  goals")
    for run in runs:
        goal = MAX_RATIO.get(run["obstacles"])
        if goal and not run["busy"] and run["what"] != "with odometry":
            print("  %-44s %8.2f of at most %g%s" % (
                "p50 over the relay, %s, %s obstacles" % (run["what"], format(run["obstacles"], ",")),
                run["ratio"], goal[0], " (moonshot %g)" % goal[1] if goal[1] else ""))
    worst = max((run for run in runs if run["busy"]), key=lambda run: run["predictor"]["p99"])
    print("  %-44s %8.1f of at most %g ms (%s, %s obstacles)" % (
        "p99 with all processors busy", 1e3 * worst["predictor"]["p99"], 1e3 * MAX_P99,
        worst["what"], format(worst["obstacles"], ",")))
    memory = max(run["predictor"].get("memory", 0) for run in runs)
    print("  %-44s %8.1f of at most %g MB" % ("largest resident memory", memory, MAX_MEMORY))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the client: node_speed_test")
    parser.add_argument("--messages", type=int, default=1000, help="to each of the two, in each run")
    parser.add_argument("--json", metavar="FILE", help="also write the figures there")
    arguments = parser.parse_args()
    print("\n".join(__doc__.splitlines()[2:]))
    with Processes() as processes:
        bench = Bench(arguments.program, processes, arguments.messages)
        measure_all(bench, SIZES)
    print_goals(bench.runs)
    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump({"rate": RATE, "segments": len(FOOTPRINT), "runs": bench.runs}, file, indent=1)


if __name__ == "__main__":
    main()
