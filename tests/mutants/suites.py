"""The project's tests in groups that run as one process each, and which of them come through the place of a mistake."""
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import time

# No suite of ours needs more; a mistake may.
MEMORY = 12 << 30


class Suite:
    """Cases of a program that run in one process, or one test of ctest's."""

    def __init__(self, name, command, folder, limit, is_fixture):
        self.name, self.command, self.folder, self.limit, self.is_fixture = name, command, folder, limit, is_fixture
        self.seconds, self.reached = 0, set()

    def run(self, environment, limit):
        def bound():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        before = time.monotonic()
        process = subprocess.Popen(self.command, cwd=self.folder, env={**os.environ, **environment}, preexec_fn=bound,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   start_new_session=True)
        try:
            passed = process.wait(limit) == 0
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.wait()
            passed = False
        self.seconds = self.seconds or time.monotonic() - before
        return passed


def list_suites(work, wanted, unwanted):
    build_folder = work / "build"
    listed = subprocess.run(["ctest", "--test-dir", build_folder, "--show-only=json-v1"], check=True, capture_output=True, text=True)
    cases = collections.defaultdict(list)
    suites = []
    for test in json.loads(listed.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test["properties"]}
        name, command = test["name"], test["command"]
        chosen = [a for a in command if a.startswith("--gtest_filter=")]
        if chosen:
            case = chosen[0].split("=", 1)[1]
            cases[command[0], case.split(".")[0].split("/")[-1]].append(case)
        else:
            suites.append(Suite(name, ["ctest", "--test-dir", str(build_folder), "-R", f"^{re.escape(name)}$", "-FA", ".*"], work, 300,
                                "FIXTURES_SETUP" in properties))
    for (program, name), filters in cases.items():
        command = [program, "--gtest_brief=1", "--gtest_fail_fast", "--gtest_filter=" + ":".join(filters)]
        suites.append(Suite(f"{pathlib.Path(program).name}:{name}", command, build_folder / "tests", 900, False))
    return [s for s in suites if re.search(wanted, s.name) and not re.search(unwanted, s.name)]


def learn_reach(suites, work, is_known, longest):
    """Runs each suite without a mistake, or recalls what that said of the same programs; returns the names of those that fail."""
    memory = work / "reach.json"
    before = json.loads(memory.read_text()) if memory.exists() else {}
    known = before if is_known else {name: told for name, told in before.items() if told[0] > longest}

    def learn(suite):
        if suite.name in known:
            suite.seconds, reached = known[suite.name]
            suite.reached = set(reached)
            return True
        file = work / "seen" / str(suites.index(suite))
        passed = suite.run({"COIF_MUTANTS_SEEN": str(file)}, 900)
        suite.reached = {number for number, seen in enumerate(file.read_bytes()) if seen} if file.exists() else set()
        return passed
    shutil.rmtree(work / "seen", ignore_errors=True)
    (work / "seen").mkdir()
    # What others need comes first.
    suites.sort(key=lambda s: not s.is_fixture)
    failed = [suite.name for suite in suites if suite.is_fixture and not learn(suite)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        others = [suite for suite in suites if not suite.is_fixture]
        failed += [suite.name for suite, passed in zip(others, pool.map(learn, others)) if not passed]
    suites.sort(key=lambda s: (not s.is_fixture, s.seconds))
    memory.write_text(json.dumps({s.name: [s.seconds, sorted(s.reached)] for s in suites if s.name not in failed}))
    return failed


def find_test(suites, number):
    """The name of a suite that fails with that mistake, or None."""
    environment = {"COIF_MUTANT": str(number)}
    reaching = [suite for suite in suites if number in suite.reached]
    stop = []

    def attempt(suite):
        if stop:
            return
        if not suite.run(environment, 20 + 10 * suite.seconds):
            stop.append(suite.name)
    for suite in reaching:
        if suite.is_fixture:
            attempt(suite)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(attempt, [suite for suite in reaching if not suite.is_fixture]))
    return stop[0] if stop else None
