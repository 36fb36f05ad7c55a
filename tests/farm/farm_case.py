"""What the tests of the farm share: a manifest of small assets that differ, and what must hold when all is done."""
import json
import pathlib

MODEL = pathlib.Path(__file__).resolve().parents[2] / "sample_assets/bob/bob.glb"
RECIPE = {"order": {"method": "head"}, "textures": {"max_size": 64}}


def write_manifest(folder, count):
    """`count` cooks of the sample, each by a recipe of its own. Returns the manifest's path."""
    folder.mkdir(parents=True)
    assets = []
    for i in range(count):
        recipe = folder / f"{i}.recipe.json"
        recipe.write_text(json.dumps(dict(RECIPE, dynamics={"damping_ratio": 1 + i / 100})))
        assets.append({"source": str(MODEL), "recipe": recipe.name, "output": f"{i // 10}/{i}.coif"})
    manifest = folder / "hair.json"
    manifest.write_text(json.dumps({"assets": assets}))
    return manifest


def outputs_of(manifest, folder):
    return [folder / asset["output"] for asset in json.loads(manifest.read_text())["assets"]]


class Faults:
    """Says what does not hold, and goes on."""

    def __init__(self):
        self.count = 0

    def unless(self, condition, what):
        if not condition:
            self.count += 1
            print(f"fault: {what}")
