#!/usr/bin/env python3
"""`coif view` of a source, as a page and a shell meet it.

usage: live_view.py CASE PROGRAM SOURCE FOLDER
"""
import http.client
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

# The marks of the page that the build for the web makes.
PAGE = ('<html lang="en"><style></style><script></script><script id="asset" data-name="@NAME@">@ASSET@</script>'
        '<script type="module"></script></html>')
PATIENCE = 60  # seconds


class View:
    """A running `coif view`, whose temporary files would lie in FOLDER/tmp."""

    def __init__(self, program, folder, *words):
        self.tmp = folder / "tmp"
        self.tmp.mkdir()
        (folder / "page.html").write_text(PAGE)
        self.errors = open(folder / "errors.txt", "w+")
        self.process = subprocess.Popen([program, "view", *words, "--page", "page.html", "--format", "json"], cwd=folder, text=True,
                                        stdout=subprocess.PIPE, stderr=self.errors, env={**os.environ, "TMPDIR": str(self.tmp)})
        text = ""
        while not text.endswith("}\n"):
            line = self.process.stdout.readline()
            assert line, f"it ended: {self.said()}"
            text += line
        self.address = json.loads(text)["address"]
        self.host, self.path = self.address.removeprefix("http://").split("/", 1)
        self.path = "/" + self.path

    def said(self):
        self.errors.flush()
        return Path(self.errors.name).read_text()

    def connect(self):
        return http.client.HTTPConnection(self.host, timeout=PATIENCE)

    def ask(self, method, route, body=None):
        connection = self.connect()
        connection.request(method, self.path + route, body, {"Content-Type": "application/octet-stream"})
        answer = connection.getresponse()
        return answer.status, answer.read()

    def post(self, route, body):
        status, text = self.ask("POST", route, body)
        return status, json.loads(text)

    def states(self):
        """What the server tells, as it tells it."""
        connection = self.connect()
        connection.request("GET", self.path + "events")
        answer = connection.getresponse()
        assert answer.status == 200, answer.status
        for line in answer:
            if line.startswith(b"data: "):
                yield json.loads(line[6:])

    def wait(self, wanted):
        end = time.monotonic() + PATIENCE
        for state in self.states():
            if wanted(state):
                return state
            assert time.monotonic() < end, f"never came: {state}"
        raise AssertionError("the events ended")

    def cooked(self, request=1):
        return self.wait(lambda s: s["request"] >= request and not s["cooking"])

    def end(self, number=signal.SIGTERM):
        self.process.send_signal(number)
        code = self.process.wait(timeout=PATIENCE)
        self.process.stdout.close()
        return code

    def left_behind(self):
        end = time.monotonic() + 10
        while list(self.tmp.iterdir()) and time.monotonic() < end:
            time.sleep(0.01)
        return [str(path) for path in self.tmp.rglob("*")]


def copy(source, folder):
    recipe = source.with_suffix(".recipe.json")
    shutil.copy(source, folder / "bob.glb")
    shutil.copy(recipe, folder / "bob.recipe.json")


def later(path):
    """Clocks of file systems are coarse."""
    facts = path.stat()
    os.utime(path, ns=(facts.st_atime_ns, facts.st_mtime_ns + 10**9))


def sliders_cook_at_once(program, folder):
    view = View(program, folder, "bob.glb")
    first = view.cooked()
    assert (first["problem"], first["revision"], first["quality"]) == ("", 1, "draft"), first
    assert first["recipe_file"]["material"]["primary_shift"] == 0.7, first
    status, page = view.ask("GET", "")
    assert status == 200 and b"data-live" in page and b"@" not in page, page
    status, asset = view.ask("GET", "asset")
    assert status == 200
    (folder / "live.coif").write_bytes(asset)
    subprocess.run([program, "cook", "bob.glb", "--draft", "-o", "cooked.coif", "--quiet"], cwd=folder, check=True)
    assert asset == (folder / "cooked.coif").read_bytes(), "not what coif cook --draft makes"

    times = []
    states = view.states()
    next(states)
    for shift in (1.0, 1.25, 1.5):
        begin = time.monotonic()
        status, answer = view.post("recipe", json.dumps({"material": {"primary_shift": shift}}))
        assert status == 202, answer
        state = next(s for s in states if s["request"] == answer["request"])
        times.append(time.monotonic() - begin)
        assert state["changes"]["material"]["primary_shift"] == shift and state["problem"] == "", state
    print("from a slider's change to the event:", ", ".join(f"{t:.2f} s" for t in times))
    assert min(times) < 3, "a slider is slow"  # under one second on an idle machine
    (folder / "tuned.coif").write_bytes(view.ask("GET", "asset")[1])
    told = subprocess.run([program, "info", "tuned.coif", "--format", "json"], cwd=folder, check=True, capture_output=True, text=True)
    assert json.loads(told.stdout), told
    assert (folder / "tuned.coif").read_bytes() != asset

    code = view.end(signal.SIGINT)
    assert code == 0, f"exit code {code}: {view.said()}"
    assert view.left_behind() == []


def files_are_watched(program, folder):
    view = View(program, folder, "bob.recipe.json")  # its source lies beside it
    view.cooked()
    recipe = folder / "bob.recipe.json"
    text = recipe.read_text()
    recipe.write_text(text.replace('"primary_shift": 0.7', '"primary_shift": 0.9'))
    later(recipe)
    state = view.wait(lambda s: s["revision"] == 2)
    assert state["recipe_file"]["material"]["primary_shift"] == 0.9

    recipe.write_text(text.replace("primary_shift", "primary_shft"))
    later(recipe)
    state = view.wait(lambda s: s["problem"])
    told = subprocess.run([program, "cook", "bob.glb", "-o", "x.coif", "--recipe", "bob.recipe.json"], cwd=folder, capture_output=True, text=True)
    assert told.stderr == f"coif cook: error: {state['problem']}\n", (told.stderr, state["problem"])
    assert f"coif view: error: {state['problem']}\n" in view.said()
    assert state["revision"] == 2 and view.ask("GET", "asset")[0] == 200, "the last good hair is lost"

    recipe.write_text(text)
    later(recipe)
    state = view.wait(lambda s: s["revision"] == 3)
    assert state["problem"] == ""

    source = folder / "bob.glb"
    whole = source.read_bytes()
    source.write_bytes(whole[:5000])
    state = view.wait(lambda s: s["problem"])
    source.write_bytes(whole)
    state = view.wait(lambda s: s["revision"] == 4)
    assert state["problem"] == ""
    assert view.end() == 0
    assert view.left_behind() == []


def a_recipe_grows_hair(program, folder):
    recipe = folder / "grown.recipe.json"
    text = json.dumps({"grow": {"style": "short", "strands": 300}, "cards": {"triangles": 400, "rounds": 1, "texels": 65536}})
    recipe.write_text(text)
    view = View(program, folder, "grown.recipe.json")
    first = view.cooked()
    assert (first["problem"], first["revision"]) == ("", 1), first
    recipe.write_text(text.replace("short", "bob"))
    later(recipe)
    state = view.wait(lambda s: s["revision"] == 2)
    assert state["recipe_file"]["grow"]["style"] == "bob" and state["problem"] == "", state
    assert view.end() == 0
    assert view.left_behind() == []


def killed_in_mid_cook_leaves_nothing(program, folder):
    view = View(program, folder, "bob.glb", "--quality", "full")
    status, answer = view.post("model?format=glb&name=my%20hair.glb", (folder / "bob.glb").read_bytes())
    assert status == 202, answer
    state = view.wait(lambda s: s["cooking"])
    assert state["revision"] == 0, "this cook was to take longer"
    assert [p.name for p in view.tmp.rglob("*.glb")] == ["model_1.glb"]
    time.sleep(0.3)
    children = Path(f"/proc/{view.process.pid}/task/{view.process.pid}/children").read_text().split()
    view.end(signal.SIGKILL)
    assert view.left_behind() == []
    end = time.monotonic() + 10
    while any(Path(f"/proc/{child}").exists() for child in children) and time.monotonic() < end:
        time.sleep(0.01)
    assert not [child for child in children if Path(f"/proc/{child}").exists()], "a process is left"
    names = sorted(p.name for p in folder.iterdir())
    assert names == ["bob.glb", "bob.recipe.json", "errors.txt", "page.html", "tmp"], names


def ends_soon_in_mid_cook(program, folder):
    view = View(program, folder, "bob.glb", "--quality", "full")
    view.wait(lambda s: s["cooking"])
    time.sleep(0.5)
    begin = time.monotonic()
    assert view.end() == 0
    took = time.monotonic() - begin
    assert took < 5, f"{took:.1f} s"
    assert view.left_behind() == []
    assert "error" not in view.said(), view.said()


def processes_of(view, job):
    """Numbers of the view's children that do this job."""
    found = []
    for task in Path(f"/proc/{view.process.pid}/task").iterdir():
        for child in (task / "children").read_text().split():
            words = Path(f"/proc/{child}/cmdline").read_bytes().split(b"\0")
            if words[1:3] == [b"--run-job", job.encode()]:
                found.append(int(child))
    return found


def outlives_its_cooks(program, folder):
    """What exceeds its limits or crashes is a problem that the page tells, and no more."""
    view = View(program, folder, "bob.glb", "--quality", "full", "--max-seconds", "1")
    state = view.cooked()
    assert "bob.glb: the cook exceeded 1 s, in the pass '" in state["problem"], state
    assert view.ask("GET", "")[0] == 200 and view.ask("GET", "asset")[0] == 404
    states = view.states()
    next(states)
    _, answer = view.post("recipe", json.dumps({"material": {"primary_shift": 1.25}}))
    assert next(s for s in states if s["cooking"]), "it cooks no more"
    end = time.monotonic() + 10
    while not processes_of(view, "cook") and time.monotonic() < end:
        time.sleep(0.002)
    for process in processes_of(view, "cook"):
        os.kill(process, signal.SIGSEGV)
    state = next(s for s in states if s["request"] == answer["request"])
    assert f"bob.glb: the cook crashed (signal {int(signal.SIGSEGV)}), in the pass '" in state["problem"], state
    assert view.end() == 0
    assert view.left_behind() == []
    assert processes_of_nobody(folder) == []


def processes_of_nobody(folder):
    """Processes that still work in the folder."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if (process / "cwd").resolve() == folder.resolve():
                found.append(process.name)
        except OSError:
            pass  # it has just ended, or is somebody else's
    return found


CASES = {f.__name__: f for f in (sliders_cook_at_once, files_are_watched, a_recipe_grows_hair, killed_in_mid_cook_leaves_nothing, ends_soon_in_mid_cook,
                                outlives_its_cooks)}


def main(case, program, source, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    copy(Path(source), folder)
    CASES[case](program, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
