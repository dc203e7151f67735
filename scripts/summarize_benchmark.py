#!/usr/bin/python3
"""Prints the benchmark's medians, the ratios between methods, and how right each method was.

Times are processor time for one query: the footprint and one obstacle. Ratios are of medians within
this one run. In the mixed scenes about one obstacle in ten hits, and something touches at once. In
the late ones nothing touches before nine tenths of the horizon are over, and few do then: nobody
can narrow the horizon to an early hit and be done.
"""

import argparse
import json
import sys

FEW = "_10000"  # obstacles, where a headline does not say how many

# (what, motion, ours, the other, at least, moonshot): how many times longer the other takes. Ours
# is one query, or one call for 10,000 obstacles; the other is always one query.
HEADLINES = [
    ("scalar query / Box2D", "straight", "ours", "box2d", 15, 25),
    ("batch, baseline / Box2D", "straight", "batch_baseline", "box2d", 25, 40),
    ("batch, AVX2 / Box2D", "straight", "batch_avx2", "box2d", 70, 110),
    ("batch, AVX-512 / Box2D", "straight", "batch_avx512", "box2d", None, None),
    ("lean, AVX2 / Box2D", "straight", "lean_avx2", "box2d", 200, 350),
    ("lean, AVX-512 / Box2D", "straight", "lean_avx512", "box2d", None, None),
    ("batch, AVX2 / FCL", "straight", "batch_avx2", "fcl", 400, 1500),
    ("batch, AVX2 / 0.02 s steps", "straight", "batch_avx2", "steps_0.02s", 400, 1500),
    ("scalar query / Eigen's solver", "accelerating", "ours", "eigen", 350, 700),
    ("scalar query / 0.02 s steps", "accelerating", "ours", "steps_0.02s", 35, 75),
    ("batch, AVX2 / Eigen's solver", "accelerating", "batch_avx2", "eigen", 350, 700),
    ("batch, AVX2 / 0.02 s steps", "accelerating", "batch_avx2", "steps_0.02s", 35, 75),
    ("scalar query / 0.02 s steps", "turning", "ours", "steps_0.02s", 60, 150),
    ("batch, AVX2 / 0.02 s steps", "turning", "batch_avx2", "steps_0.02s", 60, 150),
]
SCENES = ("mixed", "late")
MEMORY_GOAL = 100  # bytes an obstacle


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
    """Coefficients of variation, the usual and the largest: how restless the machine was."""
    with open(path) as file:
        runs = json.load(file)["benchmarks"]
    spreads = sorted(run["cpu_time"] for run in runs if run.get("aggregate_name") == "cv")
    return (spreads[len(spreads) // 2], spreads[-1]) if spreads else (0, 0)


def time_text(seconds):
    return "{:.3f} s".format(seconds) if seconds >= 1e-3 else "{:.0e} s".format(seconds)


def ratio(queries, scene, motion, ours, other):
    """None where this processor has not the instructions."""
    place = "{}/{}/8".format(scene, motion)
    one = queries["footprint/" + place]
    ours = one.get(ours) or queries["many/" + place].get(ours + FEW)
    return one[other]["ns"] / ours["ns"] if ours else None


def growth(queries, query, method):
    """How much more one of the most obstacles costs than one of 1,000, and how many those are."""
    sizes = {size(name): run["ns"] for name, run in queries[query].items() if kind(name) == method}
    return (sizes[max(sizes)] / sizes[1000], max(sizes)) if sizes else None


def number(value, form="{:.0f}"):
    return "-" if value is None else form.format(value)


def print_headlines(context, queries):
    print("Ratios of medians, 8 edges; above 1 the core is faster. One call for 10,000 obstacles"
          "\nwhere it says batch (each segment's earliest contact) or lean (the footprint's)\n")
    form = "  {:<13}{:<32}{:>9}{:>10}{:>10}{:>10}"
    print(form.format("", "", "at least", "moonshot", *SCENES))
    for what, motion, ours, other, least, moonshot in HEADLINES:
        reached = [number(ratio(queries, scene, motion, ours, other), "{:.1f}") for scene in SCENES]
        print(form.format(motion, what, number(least), number(moonshot), *reached))
    print_growth(queries)
    print("\n  memory of a batch: {:.0f} bytes for a disc (at most {}), {:.0f} for a line".format(
        float(context["bytes_per_disc"]), MEMORY_GOAL, float(context["bytes_per_line"])))
    for name in sorted(context):
        if name.startswith("without_"):
            print("  this processor has no {}: left out".format(name[len("without_"):]))


def print_growth(queries):
    print("\n  time for an obstacle among the most, relative to 1,000: 1 is linear\n")
    for motion in ("straight", "accelerating", "turning"):
        for method in ("batch_baseline", "lean_baseline", "batch_avx2", "lean_avx2"):
            found = [growth(queries, "many/{}/{}/8".format(scene, motion), method)
                     for scene in SCENES]
            if all(found):
                print("  {:<13}{:<32}{:>29}{:>10}".format(
                    motion, "{}, {:,} obstacles".format(method, found[0][1]),
                    *("{:.2f}".format(more) for more, _ in found)))


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


def kind(method):
    return method.rsplit("_", 1)[0]


def size(method):
    return int(method.rsplit("_", 1)[1])


def print_many(query, methods):
    kinds = list(dict.fromkeys(kind(name) for name in sorted(methods)))
    runs = list(methods.values())
    print("\n{}: one call for all obstacles; ns for each of them".format(query.replace("/", ", ")))
    print("  {:>10}".format("obstacles") + "".join("{:>16}".format(name) for name in kinds))
    for count in sorted({size(name) for name in methods}):
        print("  {:>10,}".format(count) + "".join(
            "{:>16.1f}".format(methods["{}_{}".format(name, count)]["ns"]) for name in kinds))
    wrong = [sum(run[what] for run in runs) for what in ("misses", "late", "inventions")]
    print("  {:,.0f} questions: {:.0f} missed, {:.0f} late, {:.0f} invented; worst error {}".format(
        sum(run["questions"] for run in runs), *wrong,
        time_text(max(run["worst_time_error"] for run in runs))))


def place(query):
    """Mixed before late, straight first, few edges before many."""
    what, scene, motion, footprint = query.split("/")
    motions = ["straight", "accelerating", "turning", "growing", "walls"]
    edges = int(footprint) if footprint.isdigit() else sys.maxsize
    return what, motions.index(motion), SCENES.index(scene), edges


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
    print("\n{}: {} processors at {} MHz, load {}; spread {:.0%}, at most {:.0%}\n".format(
        context["date"], context["num_cpus"], context["mhz_per_cpu"],
        " ".join("{:.2f}".format(load) for load in context["load_avg"]), *spread(path)))
    print("\n".join(__doc__.splitlines()[2:]) + "\n")
    print_headlines(context, queries)
    for query, methods in sorted(queries.items(), key=lambda item: place(item[0])):
        (print_many if query.startswith("many/") else print_methods)(query, methods)


if __name__ == "__main__":
    sys.exit(main())
