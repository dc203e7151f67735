#!/usr/bin/python3
"""Prints the benchmark's medians, the ratios between methods, and how right each method was.

Times are processor time for one query. Ratios are of medians within this one run.
"""

import argparse
import json
import sys

# (what, query, ours, the other): how many times longer the other takes.
HEADLINES = [
    ("footprint query against Box2D", "footprint/straight/8", "ours", "box2d"),
    ("footprint query against FCL", "footprint/straight/8", "ours", "fcl"),
    ("footprint query against 0.02 s steps", "footprint/straight/8", "ours", "steps_0.02s"),
    ("footprint query against the lecture's", "footprint/straight/8", "ours", "lecture"),
    ("accelerating against Eigen's solver", "footprint/accelerating/8", "ours", "eigen"),
    ("accelerating against 0.02 s steps", "footprint/accelerating/8", "ours", "steps_0.02s"),
]
# The same queries answered by one call for many obstacles.
MANY = [
    ("one call for 10,000 against Box2D", "straight", "box2d"),
    ("one call for 10,000 against FCL", "straight", "fcl"),
    ("one call for 10,000 against 0.02 s steps", "straight", "steps_0.02s"),
    ("accelerating, one call for 10,000, Eigen", "accelerating", "eigen"),
    ("accelerating, one call for 10,000, 0.02 s", "accelerating", "steps_0.02s"),
]


def read_medians(path):
    """{query: {method: figures}} in the order of the names; ns is added, for one query."""
    with open(path) as file:
        result = json.load(file)
    queries = {}
    for run in result["benchmarks"]:
        if run.get("aggregate_name") != "median":
            continue
        query, method = run["run_name"].split("/iterations:")[0].rsplit("/", 1)
        run["ns"] = run["cpu_time"] / run["queries_per_call"]
        queries.setdefault(query, {})[method] = run
    return result["context"], queries


def spread(path):
    """The largest coefficient of variation of any method: how restless the machine was."""
    with open(path) as file:
        runs = json.load(file)["benchmarks"]
    return max((run["cpu_time"] for run in runs if run.get("aggregate_name") == "cv"), default=0)


def time_text(seconds):
    return "{:.3f} s".format(seconds) if seconds >= 1e-3 else "{:.0e} s".format(seconds)


def print_methods(query, methods):
    ours = methods["ours"]
    print("\n{}: {:.0f} questions, {:.0f} hits".format(
        query.replace("/", ", "), ours["questions"], ours["hits"]))
    print("  {:<14}{:>10}{:>9}{:>8}{:>7}{:>10}{:>14}  {}".format(
        "method", "ns/query", "x ours", "missed", "late", "invented", "worst error", "held to"))
    for name, run in sorted(methods.items(), key=lambda item: (item[0] != "ours", item[0])):
        print("  {:<14}{:>10.1f}{:>9.2f}{:>8.0f}{:>7.0f}{:>10.0f}{:>14}  {:.0e} m, {:.0e} s".format(
            name, run["ns"], run["ns"] / ours["ns"], run["misses"], run["late"], run["inventions"],
            time_text(run["worst_time_error"]), run["tolerance_m"], run["tolerance_s"]))


def print_growth(query, methods):
    sizes = sorted(methods.items(), key=lambda item: item[1]["queries_per_call"])
    least = min(run["ns"] for run in methods.values())
    print("\n{}: one call for all segments and all obstacles; first contact of each segment".format(
        query.replace("/", ", ")))
    print("  {:>10}{:>14}{:>12}{:>8}{:>7}{:>10}".format(
        "obstacles", "ns/obstacle", "x least", "missed", "late", "invented"))
    for _, run in sizes:
        print("  {:>10,.0f}{:>14.1f}{:>12.2f}{:>8.0f}{:>7.0f}{:>10.0f}".format(
            run["queries_per_call"], run["ns"], run["ns"] / least, run["misses"], run["late"],
            run["inventions"]))


def place(query):
    """Straight before accelerating, few edges before many."""
    what, motion, footprint = query.split("/")
    return what, motion != "straight", int(footprint) if footprint.isdigit() else sys.maxsize


def print_headlines(queries):
    print("Ratios of medians, 8 edges; above 1 the core is faster")
    for what, query, ours, other in HEADLINES:
        methods = queries[query]
        print("  {:<44}{:>8.2f} x".format(what, methods[other]["ns"] / methods[ours]["ns"]))
    for what, kind, other in MANY:
        many = queries["many/{}/8".format(kind)]["ours_10000"]
        single = queries["footprint/{}/8".format(kind)][other]
        print("  {:<44}{:>8.2f} x".format(what, single["ns"] / many["ns"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("json", help="what the benchmark wrote")
    parser.add_argument("--medians", metavar="FILE", help="also write the medians, as JSON")
    arguments = parser.parse_args()
    path = arguments.json
    context, queries = read_medians(path)
    if arguments.medians:
        with open(arguments.medians, "w") as file:
            json.dump({"context": context, "medians": queries}, file, indent=1, allow_nan=False)
    print("\n{}: {} processors at {} MHz, load {}, largest spread {:.0%}\n".format(
        context["date"], context["num_cpus"], context["mhz_per_cpu"],
        " ".join("{:.2f}".format(load) for load in context["load_avg"]), spread(path)))
    print_headlines(queries)
    for query, methods in sorted(queries.items(), key=lambda item: place(item[0])):
        (print_growth if query.startswith("many/") else print_methods)(query, methods)


if __name__ == "__main__":
    sys.exit(main())
