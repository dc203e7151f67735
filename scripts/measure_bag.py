#!/usr/bin/python3
"""Runs the reader and analyze_bag in turn and prints medians, ratios and memory.

usage: measure_bag.py MESSAGES "READ COMMAND" "ANALYZE COMMAND" LAST_ARGUMENT
"""

import os
import statistics
import sys
import time

RATE = 10  # [Hz] of the obstacles messages
RUNS = 7
LARGEST_RATIO = 2  # of analyze_bag to reading
SLOWEST = 2000  # x real time
MOST_MEMORY = 200  # [MB]


def run(command):
    """Wall time [s], processor time [s] and the largest resident memory [MB] of one run."""
    begin = time.monotonic()
    child = os.fork()
    if child == 0:
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, 1)
        os.execv(command[0], command)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit("failed: " + " ".join(command))
    return time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    messages = int(sys.argv[1])
    read = sys.argv[2].split()
    analyze = sys.argv[3].split() + [sys.argv[4]]
    run(read)  # so that the file is in memory for all
    results = {"read": [], "analyze": []}
    for _ in range(RUNS):
        results["read"].append(run(read))
        results["analyze"].append(run(analyze))
    driven = messages / RATE
    print("%.0f s of driving, %d obstacles messages; medians of %d runs, in turn" %
          (driven, messages, RUNS))
    for name, what in (("read", "reading and deserialising"), ("analyze", "analyze_bag -o")):
        wall, cpu, memory = (statistics.median(column) for column in zip(*results[name]))
        print("  %-27s %7.3f s  (processor %7.3f s)  %8.0f x real time  %6.1f MB" %
              (what, wall, cpu, driven / wall, memory))
    for index, what in ((0, "wall"), (1, "processor")):  # the latter even when others are busy, too
        ratio = [a[index] / r[index] for a, r in zip(results["analyze"], results["read"])]
        print("  analyze_bag / reading, %s time: %.2f" % (what, statistics.median(ratio)))
    print("  goals: a ratio of at most %g, %g x real time or more, at most %g MB" %
          (LARGEST_RATIO, SLOWEST, MOST_MEMORY))


if __name__ == "__main__":
    main()
