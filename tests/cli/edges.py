#!/usr/bin/env python3
"""What `coif` does at the edges of what a machine gives: outputs that are inputs, streams that take nothing, limits, long names.

usage: edges.py CASE PROGRAM FOLDER
"""
import ctypes
import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import zlib
from pathlib import Path

CARD = "mtllib m.mtl\no hair\nv 0 1.7 0\nv 0.1 1.7 0\nv 0 1.5 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl hair\nf 1/1 3/3 2/2\n"
LIBRARY = "newmtl hair\nmap_Kd m.png\nmap_Ks gloss.png\n"


def png(color):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    pixels = b"".join(b"\0" + bytes(color) * 4 for _ in range(4))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4, 4, 8, 6, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(pixels))
            + chunk(b"IEND", b""))


def gltf():
    numbers = struct.pack("<9f", 0, 1.7, 0, 0.1, 1.7, 0, 0, 1.5, 0)
    return numbers, {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "hair", "mesh": 0}],
                     "meshes": [{"name": "hair", "primitives": [{"attributes": {"POSITION": 0}}]}],
                     "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 1.5, 0], "max": [0.1, 1.7, 0]}],
                     "bufferViews": [{"buffer": 0, "byteLength": len(numbers)}], "buffers": [{"uri": "b.bin", "byteLength": len(numbers)}]}


def hair(strands, points):
    """Strands that all hang from one circle, as a .hair."""
    head = struct.pack("<4sIIIIfffff", b"HAIR", strands, strands * points, 2, points - 1, 0.01, 0.0, 0.3, 0.2, 0.1).ljust(128, b"\0")
    places = [struct.pack("<3f", 0.1 + 0.0001 * s, 1.75 - 0.05 * k, 0.001 * s) for s in range(strands) for k in range(points)]
    return head + b"".join(places)


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        numbers, document = gltf()
        self.write("m.obj", CARD.encode())
        self.write("m.mtl", LIBRARY.encode())
        self.write("m.png", png((90, 60, 40, 255)))
        self.write("gloss.png", png((10, 10, 10, 255)))
        self.write("b.bin", numbers)
        self.write("e.gltf", json.dumps(document).encode())
        self.write("mask.png", png((200, 200, 200, 255)))
        self.write("r.json", json.dumps({"textures": {"mask": "mask.png"}}).encode())
        self.before = self.contents()

    def write(self, name, content):
        (self.folder / name).write_bytes(content)

    def contents(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}

    def run(self, *arguments, **more):
        more = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}
        return subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, timeout=120, **more)

    def shell(self, line):
        return subprocess.run(["bash", "-c", line.replace("coif", f"'{self.program}'", 1)], cwd=self.folder, timeout=120, stderr=subprocess.PIPE)

    def refuses(self, code, text, *arguments, **more):
        done = self.run(*arguments, **more)
        told = done.stderr.decode(errors="replace")
        assert done.returncode == code and text in told, (arguments, done.returncode, told)
        return done

    def kept_all(self):
        now = self.contents()
        assert now == self.before, sorted(name for name in now.keys() | self.before.keys() if now.get(name) != self.before.get(name))


def inputs_are_never_written_over(bench):
    os.link(bench.folder / "m.png", bench.folder / "hard.coif")
    os.symlink("m.mtl", bench.folder / "soft.coif")
    bench.before = bench.contents()
    obj = ["cook", "m.obj", "--recipe", "r.json", "--draft"]
    for name in ["m.obj", "m.mtl", "m.png", "gloss.png", "mask.png", "r.json", "hard.coif", "soft.coif"]:
        bench.refuses(1, "is also an input", *obj, "-o", name)
        for option in ["--report", "--depfile"]:
            bench.refuses(1, "is also an input", *obj, "-o", "x.coif", option, name)
    bench.refuses(1, "b.bin: is also an input", "cook", "e.gltf", "--draft", "-o", "b.bin")
    bench.refuses(1, "is also an input", "look", "m.obj", "-o", "m.png")
    bench.refuses(1, "is also an input", "cook", "m.obj", "--list", "patches", "-o", "m.png")
    bench.refuses(1, "is also an input", "cook", "m.obj", "--draft", "-o", "m.png", "--cache", "cache")
    bench.refuses(1, "is also an input", "cook", "m.obj", "--draft", "-o", "gloss.png", "--cache", "cache")  # Known from the cache now.
    bench.refuses(1, "is also an input", "grow", "--style", "short", "--body", "m.obj", "-o", "m.obj")
    bench.refuses(1, "name the same file", "cook", "m.obj", "--draft", "-o", "x.coif", "--report", "./x.coif")
    bench.write("m.json", json.dumps({"assets": [{"source": "m.obj", "output": "n.coif"}, {"source": "e.gltf", "output": "e.coif"}]}).encode())
    bench.before = bench.contents()
    bench.refuses(1, "is also an input", "cook", "--manifest", "m.json", "-o", ".", "--report", "e.gltf")
    for report in ["m.mtl", "gloss.png", "b.bin"]:
        shutil.rmtree(bench.folder / "out", ignore_errors=True)
        (bench.folder / "out").mkdir()
        bench.refuses(1, f"{report}: is also an input", "cook", "m.obj", "e.gltf", "--draft", "-o", "out", "--report", report)
    bench.write("n.json", json.dumps({"assets": [{"source": "e.gltf", "output": "m.png"}]}).encode())
    bench.before = bench.contents()
    bench.refuses(1, "m.png: is there and no cooked asset", "cook", "--manifest", "n.json", "-o", ".")
    # A body's, too, which lies elsewhere.
    (bench.folder / "body").mkdir()
    for name in ["m.obj", "m.mtl", "m.png"]:
        shutil.copy(bench.folder / name, bench.folder / "body")
    bench.write("m.hair", hair(20, 6))
    bench.before = bench.contents()
    for name in ["m.obj", "m.mtl", "m.png"]:
        bench.refuses(1, "is also an input", "cook", "m.hair", "--draft", "--body", "body/m.obj", "-o", f"body/{name}")
        assert (bench.folder / "body" / name).read_bytes() == bench.before[name]
    bench.kept_all()


def messages_change_no_result(bench):
    cook = "coif cook m.obj --draft -q -o x.coif"
    for streams in ["2>/dev/full", "2>&-", "</dev/null 2>&- ", "<&- 2>&-"]:
        (bench.folder / "x.coif").unlink(missing_ok=True)
        done = bench.shell(f"{cook} {streams}")
        assert done.returncode == 0, (streams, done)
        assert (bench.folder / "x.coif").read_bytes()[:4] != b"coif cook"[:4], streams
        assert bench.run("info", "x.coif").returncode == 0, streams
    # The reader of messages goes before the first is written.
    (bench.folder / "x.coif").unlink()
    ends = os.pipe()
    os.close(ends[0])
    done = bench.run("cook", "m.obj", "--draft", "-v", "-o", "x.coif", stderr=ends[1], preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL))
    assert done.returncode == 0 and (bench.folder / "x.coif").exists(), done
    # What was asked for on the standard output and did not get there is an error.
    for line in ["coif --help", "coif cook --help", "coif --version", "coif --man", "coif info x.coif", "coif cook --list-presets"]:
        for stream in [">/dev/full", ">&-"]:
            done = bench.shell(f"{line} {stream}")
            assert done.returncode == 2 and b"standard output: cannot write" in done.stderr, (line, stream, done)


def limits_hold_from_the_start(bench):
    bench.write("m.hair", hair(20, 6))
    bench.write("big.hair", hair(3000, 16))
    bench.write("large.json", b'{"cards": {"texels": 16777216}}')
    bench.write("small.json", b'{"textures": {"max_size": 64}, "order": {"method": "head"}}')
    bench.before = bench.contents()
    for arguments in [("cook", "big.hair", "-o", "x.coif"), ("cook", "big.hair", "--list"), ("validate", "big.hair"),
                      ("look", "big.hair", "-o", "x.png")]:
        begin = time.monotonic()
        bench.refuses(3, "big.hair: the cook exceeded 1 s, in the pass 'cards'", *arguments, "--max-seconds", 1, "--threads", 1) \
            if arguments[0] == "cook" else bench.run(*arguments, "--max-seconds", 1)
        assert time.monotonic() - begin < 20, arguments
    # Where a limit ends the program, what it has found so far is printed all the same.
    done = bench.run("validate", "m.obj", "big.hair", "--max-seconds", 1, "--format", "json")
    files = json.loads(done.stdout)["files"]
    assert done.returncode == 3 and files[-1]["path"] == "big.hair", done
    assert files[-1]["issues"][0]["code"] == "S101" and "exceeded 1 s" in files[-1]["issues"][0]["message"], files
    if "address" not in os.environ.get("COIF_SANITIZE", ""):
        bench.refuses(3, "MiB of memory", "cook", "big.hair", "--recipe", "large.json", "-o", "x.coif", "--max-memory-mb", 64, "--threads", 1)
    bench.kept_all()
    done = bench.run("cook", "m.hair", "--recipe", "small.json", "-o", "x.coif", "--draft", "--threads", 2)
    assert done.returncode == 0, done
    told = json.loads(bench.run("info", "x.coif", "--format", "json").stdout)
    assert (bench.folder / "x.coif").stat().st_size < 200_000, told


def streams_and_names_at_their_edges(bench):
    for arguments in [("cook", "m.obj", "-o", "-"), ("cook", "-", "-o", "x.coif"), ("info", "-"), ("cook", "m.obj", "-o", "x.coif", "--report", "-"),
                      ("cook", "m.obj", "-o", "x.coif", "--recipe", "-")]:
        bench.refuses(1, "-: neither reads the standard input", *arguments)
    bench.kept_all()
    limit = lambda kind, most: (lambda: resource.setrlimit(kind, (most, most)))
    bench.refuses(2, "x.coif: cannot write: File too large", "cook", "m.obj", "--draft", "-q", "-o", "x.coif", preexec_fn=limit(resource.RLIMIT_FSIZE, 100))
    bench.kept_all()
    assert bench.run("cook", "m.obj", "--draft", "-q", "-o", "x.coif", preexec_fn=limit(resource.RLIMIT_NOFILE, 8)).returncode == 0
    bench.refuses(2, "Too many open files; nothing is wrong with the file", "cook", "m.obj", "--draft", "-q", "-o", "x.coif",
                  preexec_fn=limit(resource.RLIMIT_NOFILE, 5))
    (bench.folder / "x.coif").unlink()
    name = "n" * 250 + ".coif"
    assert bench.run("cook", "m.obj", "--draft", "-q", "-o", name).returncode == 0
    assert sorted(set(bench.contents()) - set(bench.before)) == [name]
    bench.refuses(2, "cannot write: File name too long", "cook", "m.obj", "--draft", "-q", "-o", "n" + name)
    # A failure is told as JSON, too, and in the report, but over nothing else.
    for report in ["report.json", "mask.png"]:
        done = bench.refuses(2, "nope.glb: cannot open", "cook", "nope.glb", "-o", "x.coif", "--format", "json", "--report", report)
        told = json.loads(done.stdout)
        assert told["exit_code"] == 2 and told["status"] == "file access" and told["error"].startswith("nope.glb: cannot open"), told
        assert [issue["code"] for issue in told["issues"]] == ["F101"], told
    assert json.loads((bench.folder / "report.json").read_text()) == told
    assert (bench.folder / "mask.png").read_bytes() == bench.before["mask.png"]
    assert bench.run("cook", "m.obj", "--draft", "-q", "-o", "x.coif", "--report", "report.json").returncode == 0
    bench.write("lost.obj", CARD.replace("m.mtl", "lost.mtl").encode())
    bench.refuses(3, "nothing was written", "cook", "lost.obj", "--draft", "-q", "-o", "x.coif", "--report", "report.json", "--warnings-as-errors")
    told = json.loads((bench.folder / "report.json").read_text())
    assert told["exit_code"] == 3 and told["issues"] and all(issue["severity"] == "error" for issue in told["issues"]), told
    verdict = json.loads(bench.run("validate", "lost.obj", "--format", "json", "--warnings-as-errors").stdout)["files"][0]
    codes = lambda issues: sorted(issue["code"] for issue in issues if issue["severity"] != "info")
    assert codes(told["issues"]) == codes(verdict["issues"]), (told, verdict)
    # Names are shown, never obeyed.
    bench.write("esc.obj", CARD.replace("o hair", "o hair\x1b[31m\x9b").encode("latin-1"))
    done = bench.run("cook", "esc.obj", "--list")
    assert done.returncode == 0 and b"\x1b" not in done.stdout and b"hair?[31m" in done.stdout, done.stdout
    done = bench.run("cook", "esc\x1b[31m.obj", "--list")
    assert done.returncode == 2 and b"\x1b" not in done.stderr, done.stderr


def without_landlock():
    """From now on this process has a kernel that knows no Landlock (call 444)."""
    program = b"".join(struct.pack("<HBBI", *line) for line in [(0x20, 0, 0, 0), (0x15, 0, 1, 444), (0x06, 0, 0, 0x00050000 | 38), (0x06, 0, 0, 0x7FFF0000)])
    buffer = ctypes.create_string_buffer(program)

    class Filter(ctypes.Structure):
        _fields_ = [("length", ctypes.c_ushort), ("program", ctypes.c_void_p)]

    libc = ctypes.CDLL(None)
    libc.prctl(38, 1, 0, 0, 0)
    whole = Filter(len(program) // 8, ctypes.addressof(buffer))
    if libc.prctl(22, 2, ctypes.byref(whole), 0, 0) != 0:
        os._exit(99)


def strangers_recipes_stay_in_their_folder(bench):
    (bench.folder / "model").mkdir()
    bench.write("model/m.obj", CARD.encode())
    os.symlink("../mask.png", bench.folder / "model/link.png")
    for name in ["../mask.png", str(bench.folder / "mask.png"), "link.png"]:
        bench.write("model/m.recipe.json", json.dumps({"textures": {"mask": {"file": name, "channel": "r"}}}).encode())
        usual = ["model/m.obj", "--draft", "-q", "-o", "x.coif"]
        assert bench.run("cook", *usual).returncode == 0, name
        if bench.run("cook", "m.obj", "--draft", "-q", "-o", "x.coif", "--require-sandbox").returncode == 5:
            continue
        bench.refuses(3, "which lies outside of its folder, and --require-sandbox", "cook", *usual, "--require-sandbox")
        bench.refuses(3, "which lies outside of its folder", "validate", "model/m.obj", "--require-sandbox")
        for allowed in [["--root", "."], ["--recipe", "model/m.recipe.json"]]:
            done = bench.run("cook", *usual, "--require-sandbox", *allowed)
            assert done.returncode == 0, done


def machines_without_a_sandbox(bench):
    usual = bench.run("cook", "m.obj", "--draft", "-q", "-o", "x.coif", "--require-sandbox")
    if usual.returncode == 5:
        print("skipped:", usual.stderr.decode())
        return
    assert usual.returncode == 0 and b"sandbox" not in usual.stderr, usual
    bench.refuses(5, "was not read: this kernel has no Landlock", "cook", "m.obj", "--draft", "-q", "-o", "y.coif", "--require-sandbox",
                  preexec_fn=without_landlock)
    assert not (bench.folder / "y.coif").exists()
    done = bench.run("cook", "m.obj", "e.gltf", "--draft", "-q", "-o", ".", preexec_fn=without_landlock)
    assert done.returncode == 0 and done.stderr.count(b"without a full sandbox") == 1, done
    # What the kernel does not keep out is not opened all the same.
    (bench.folder / "model").mkdir()
    numbers, document = gltf()
    for uri in ["../b.bin", "link.bin", str(bench.folder / "b.bin"), "%2e%2e/b.bin"]:
        document["buffers"][0]["uri"] = uri
        bench.write("model/e.gltf", json.dumps(document).encode())
        if not (bench.folder / "model/link.bin").is_symlink():
            os.symlink("../b.bin", bench.folder / "model/link.bin")
        bench.refuses(3, "e.gltf: cannot be read", "cook", "model/e.gltf", "--draft", "-q", "-o", "y.coif", preexec_fn=without_landlock)
    document["buffers"][0]["uri"] = "link.bin"
    bench.write("model/e.gltf", json.dumps(document).encode())
    done = bench.run("cook", "model/e.gltf", "--draft", "-q", "-o", "y.coif", "--root", ".", preexec_fn=without_landlock)
    assert done.returncode == 0, done


if __name__ == "__main__":
    case, program, folder = sys.argv[1:]
    globals()[case](Bench(program, Path(folder)))
