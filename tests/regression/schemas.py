"""Real outputs of every command hold to docs/*.schema.json.

    schemas.py CLEVIS SOURCE_DIR [RESULT_DIR...]

Scenes of tests/data and geometry are simulated, a link is checked, its modes found,
variants planned and results compared; RESULT_DIR are folders of checks made before. A document with a key
too many or too few must be seen. Every key has a description.
"""
import copy
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from support import Checks

KNOWN = {"$schema", "title", "description", "type", "const", "enum", "properties", "required",
         "additionalProperties", "items", "minItems", "maxItems", "minimum", "maximum",
         "exclusiveMinimum", "$ref", "$defs", "anyOf", "oneOf", "minLength", "pattern"}
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
LINK = """schema = 1
name = "a link, two sizes"

[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"

[[part]]
name = "link"
geometry = "link.geo"
length_unit = "mm"
thickness = "10 mm"
material = "steel"
limits = { safety_factor = 2 }

[[part.case]]
name = "pull"
pins = { bore_B = ["5 kN", "0 N", "0 N"] }
held_by_pin = ["bore_A"]

[[part.case]]
name = "clamped"
fixed = { bore_A = ["x", "y"] }
pins = { bore_B = ["0 N", "-200 N", "0 N"] }

[vary]
design = "grid"

[[vary.quantity]]
path = "part.link.thickness"
values = ["8 mm", "10 mm"]
"""
# Every joint, drive law and kind of force, and what only some results have.
SIMULATED = ["tests/data/scenes/every_joint", "tests/data/scenes/helical_gears",
             "tests/data/scenes/motors",
             "tests/data/scenes/bushing", "tests/data/scenes/journal",
             "geometry/landing_gear/scene", "geometry/landing_gear/change_point",
             "geometry/landing_gear/bearings", "geometry/gas_cylinder/scene",
             "geometry/wheel/drop", "geometry/wall/impact", "geometry/bennett/scene"]


def is_type(value, name):
    if name in ("number", "integer"):
        return (isinstance(value, (int, float)) and not isinstance(value, bool)
                and (name == "number" or float(value).is_integer()))
    return isinstance(value, TYPES[name])


def errors(value, schema, root, at="$"):
    """What a document breaks of a schema. Keywords that nobody checks are errors."""
    if "$ref" in schema:
        yield from errors(value, root["$defs"][schema["$ref"].split("/")[-1]], root, at)
    for word in set(schema) - KNOWN:
        yield f"{at}: keyword {word} is not checked"
    names = schema.get("type", [])
    names = [names] if isinstance(names, str) else names
    if names and not any(is_type(value, name) for name in names):
        yield f"{at}: {json.dumps(value)[:40]} is no {'/'.join(names)}"
        return
    if "const" in schema and value != schema["const"]:
        yield f"{at}: {value!r} is not {schema['const']!r}"
    if "enum" in schema and value not in schema["enum"]:
        yield f"{at}: {value!r} is none of {schema['enum']}"
    for word in ("anyOf", "oneOf"):
        if word in schema and all(any(errors(value, s, root, at)) for s in schema[word]):
            yield f"{at}: fits no {word}"
    if is_type(value, "number"):
        if value < schema.get("minimum", value) or value > schema.get("maximum", value):
            yield f"{at}: {value} is out of range"
        if "exclusiveMinimum" in schema and value <= schema["exclusiveMinimum"]:
            yield f"{at}: {value} is out of range"
    if isinstance(value, list):
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            yield f"{at}: {len(value)} items"
        if "items" in schema:
            for k, item in enumerate(value):
                yield from errors(item, schema["items"], root, f"{at}[{k}]")
    if isinstance(value, dict):
        known, more = schema.get("properties", {}), schema.get("additionalProperties", True)
        for key in schema.get("required", []):
            if key not in value:
                yield f"{at}: lacks {key}"
        for key, item in value.items():
            if key in known:
                yield from errors(item, known[key], root, f"{at}.{key}")
            elif more is False:
                yield f"{at}: has the unknown key {key}"
            elif isinstance(more, dict):
                yield from errors(item, more, root, f"{at}.{key}")


def undescribed(schema, root, at="$"):
    """Keys without a description of their own or of the definition that they refer to."""
    for word in ("properties", "$defs"):
        for key, child in schema.get(word, {}).items():
            target = root["$defs"][child["$ref"].split("/")[-1]] if "$ref" in child else {}
            if word == "properties" and not (child.get("description")
                                             or target.get("description")):
                yield f"{at}.{key}"
            yield from undescribed(child, root, f"{at}.{key}")
    for word in ("items", "additionalProperties", "anyOf", "oneOf"):
        below = schema.get(word)
        for child in below if isinstance(below, list) else [below]:
            if isinstance(child, dict):
                yield from undescribed(child, root, at)


class Documents(Checks):
    def __init__(self, clevis, root, folder):
        super().__init__()
        self.clevis, self.root, self.folder = clevis, root, folder
        self.schemas = {p.name.split(".")[0]: json.loads(p.read_text())
                        for p in (root / "docs").glob("*.schema.json")}
        # scene: an input, a unit test holds it to the reader; study: regression.study.contract
        self.seen = {"scene", "study"}

    def keys_are_described(self):
        for name, schema in self.schemas.items():
            found = list(undescribed(schema, schema))
            self.expect(not found, f"{name}.schema.json describes every key {found[:5]}")

    def silence_is_seen(self, name, definition, key):
        schema = copy.deepcopy(self.schemas[name])
        del schema["$defs"][definition]["properties"][key]["description"]
        self.expect(list(undescribed(schema, schema)) == [f"$.{definition}.{key}"],
                    f"{name}: {key} without a description is seen")

    def run(self, *arguments, codes=(0,), cwd=None):
        done = subprocess.run([self.clevis, *map(str, arguments)], cwd=cwd or self.root,
                              capture_output=True, text=True)
        self.expect(done.returncode in codes, f"clevis {' '.join(map(str, arguments))}: "
                    f"exit {done.returncode} {done.stderr[:300] if done.returncode else ''}")
        return done.stdout

    def holds_to(self, name, text, what):
        schema, document = self.schemas[name], json.loads(text)
        found = list(errors(document, schema, schema))
        self.expect(not found, f"{what} holds to {name}.schema.json {found[:5]}")
        self.seen.add(name)
        return document

    def files(self, out, *pairs):
        for name, pattern in pairs:
            found = sorted(out.glob(pattern))
            self.expect(found, f"{out.name} has {pattern}")
            for file in found:
                self.holds_to(name, file.read_text(), f"{out.name}/{file.name}")

    def faults_are_seen(self, name, text):
        schema, document = self.schemas[name], json.loads(text)
        wrong = copy.deepcopy(document)
        wrong["nobody"] = 1
        self.expect(any(errors(wrong, schema, schema)), f"{name}: an unknown key is seen")
        for key in schema["required"]:
            wrong = {k: v for k, v in document.items() if k != key}
            self.expect(any(errors(wrong, schema, schema)), f"{name}: a missing {key} is seen")


def main():
    clevis, root = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        d = Documents(clevis, root, folder)
        d.keys_are_described()
        d.silence_is_seen("simulate", "bearing", "static_load_N")
        for scene in SIMULATED:
            out = folder / scene.replace("/", "_")
            d.run("simulate", f"{scene}.toml", "--report", "--out", out)
            d.files(out, ("simulate", "simulate.json"), ("view_motion", "view/simulation.json"))
        d.run("transmission", "geometry/transmission/example.toml", "--out", folder / "train")
        d.files(folder / "train", ("transmission", "transmission.json"))
        d.run("impact", "geometry/ejector/beam_theory.toml", "--out", folder / "ejector")
        d.files(folder / "ejector", ("impact", "impact.json"))
        d.holds_to("error", d.run("simulate", "nothing.toml", "--json", codes=(22,)), "error")

        d.holds_to("faces", d.run("faces", "geometry/step/fork.toml", "--json"), "faces")

        d.run("init", "link", "--template", "part", cwd=folder)
        (folder / "link/grid.toml").write_text(LINK)
        d.run("plan", "link/grid.toml", "--out", "plan", cwd=folder)
        d.files(folder / "plan", ("plan", "plan.json"))
        d.run("mesh", "link/grid.toml", cwd=folder)
        for thickness in ("8 mm", "10 mm"):
            d.run("check", "link/grid.toml", "--tolerance", "10%", "--set",
                  f"part.link.thickness={thickness}", "--out", thickness[0], cwd=folder)
            d.files(folder / thickness[0], ("result", "result.json"),
                    ("view_motion", "view/motion.json"), ("view_part", "view/part_*.json"))
        d.holds_to("compare", d.run("compare", "8", "1/result.json", "--json", codes=(3,),
                                    cwd=folder), "compare")
        d.run("modes", "link/grid.toml", "--modes", "2", "--tolerance", "20%", "--out", "modes",
              cwd=folder)
        d.files(folder / "modes", ("modes", "modes.json"))
        for out in map(Path, sys.argv[3:]):
            d.files(out, ("result", "result.json"), ("view_motion", "view/motion.json"),
                    ("view_part", "view/part_*.json"))
        d.faults_are_seen("simulate", (folder / "geometry_bennett_scene/simulate.json").read_text())
        d.faults_are_seen("view_part", next((folder / "8/view").glob("part_*")).read_text())
        d.expect(d.seen == set(d.schemas), f"every schema was tried {set(d.schemas) - d.seen}")
    return d.exit_code()


if __name__ == "__main__":
    sys.exit(main())
