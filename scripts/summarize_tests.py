#!/usr/bin/python3
"""Counts the results of a test run from its JUnit XML files.

Names skipped and failed tests, the latter with their message, and closes with the line
"N passed, N failed". A file that cannot be read is a failure, and so is a run without any test.
"""

import argparse
import pathlib
import sys
import xml.etree.ElementTree as ElementTree


class Totals:
    def __init__(self):
        self.passed = 0
        self.failed = []  # (name, message)
        self.skipped = []  # (name, reason)


def text_of(element):
    """The message of a failure: gtest and unittest put it in the attribute, the text, or both."""
    message = (element.get("message") or "").strip()
    text = (element.text or "").strip()
    if message and message not in text:
        text = message + ("\n" + text if text else "")
    return text or message or "no message"


def is_skipped(case):
    return case.get("status") == "notrun" or case.get("result") == "skipped"


def is_wrapper(case):
    """rostest's own entry for a program whose cases have a file of their own."""
    return (case.get("classname") or "").startswith("rostest.runner.")


def count_case(case, suite, totals):
    name = "{}.{}".format(case.get("classname") or suite, case.get("name") or "?")
    wrong = case.findall("failure") + case.findall("error")
    skipped = case.find("skipped")
    if wrong:
        totals.failed.append((name, "\n".join(text_of(w) for w in wrong)))
    elif skipped is not None or is_skipped(case):
        totals.skipped.append((name, "" if skipped is None else text_of(skipped)))
    elif not is_wrapper(case):
        totals.passed += 1


def count_suite(suite, path, totals):
    """A suite may say that it has errors without having a case for them (a crash)."""
    cases = suite.findall("testcase")
    for case in cases:
        count_case(case, suite.get("name") or path.stem, totals)
    for nested in suite.findall("testsuite"):
        count_suite(nested, path, totals)
    claimed = int(suite.get("failures") or 0) + int(suite.get("errors") or 0)
    if claimed and not any(case.find("failure") is not None or case.find("error") is not None
                           for case in suite.iter("testcase")):
        totals.failed.append((path.stem, "its file claims {} failures but has no case for them; "
                                         "did it crash?".format(claimed)))


def count_file(path, totals):
    try:
        tree = ElementTree.parse(str(path))
    except (ElementTree.ParseError, OSError) as error:
        totals.failed.append((path.stem, "{} cannot be read ({}): did the test crash while "
                                         "writing it?".format(path, error)))
        return
    count_suite(tree.getroot(), path, totals)


def indented(text):
    return "\n".join("    " + line for line in text.splitlines())


def report(totals):
    for name, reason in totals.skipped:
        print("SKIPPED {}{}".format(name, ": " + " ".join(reason.split()) if reason else ""))
    for name, message in totals.failed:
        print("FAILED  {}\n{}".format(name, indented(message)))
    line = "{} passed, {} failed".format(totals.passed, len(totals.failed))
    if totals.skipped:
        line += ", {} skipped".format(len(totals.skipped))
    print(line)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="where the XML files are")
    parser.add_argument("--run-status", type=int, default=0, help="exit status of the test run")
    parser.add_argument("--log", help="what the test run said, named when it failed")
    arguments = parser.parse_args()

    totals = Totals()
    for path in sorted(arguments.folder.glob("**/*.xml")):
        count_file(path, totals)
    where = "; see {}".format(arguments.log) if arguments.log else ""
    if arguments.run_status != 0 and not totals.failed:
        totals.failed.append(("run_tests", "ended with exit status {}{}".format(
            arguments.run_status, where)))
    if totals.passed + len(totals.failed) == 0:
        totals.failed.append(("run_tests", "no test ran" + where))
    report(totals)
    return 1 if totals.failed else 0


if __name__ == "__main__":
    sys.exit(main())
