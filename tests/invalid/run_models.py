#!/usr/bin/env python3
"""Hostile and unfit SDF and URDF files: each is imported or refused with its
code, a place and what to do, within 10 s, and nothing in a file is ever run or
opened.

    run_models.py CLEVIS SOURCE_DIR [COUNT [SEED]]

Beside the cases below, COUNT (30) copies of each model are damaged at random:
each must be imported or refused with a documented exit code.
"""
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SECONDS = 10
CLEVIS, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])
COUNT = int(sys.argv[3]) if len(sys.argv) > 3 else 30
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1
MODELS = {file.name: file.read_text() for file in (SOURCE / "tests/data/models").iterdir()}
SDF, URDF = MODELS["double_pendulum.sdf"], MODELS["double_pendulum.urdf"]
REFUSED = {"S013", "S014", "S015"}
FINE = {""}
LIMIT = {"", "a limit"}  # imported, or refused by time or memory in words

LAUGHS = '<?xml version="1.0"?>\n<!DOCTYPE sdf [<!ENTITY a "ha">' + "".join(
    f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefgh", "bcdefghi")
) + "]>\n<sdf version='1.9'><model name='&i;'><link name='a'/></model></sdf>\n"
OUTSIDE = ('<!DOCTYPE sdf [<!ENTITY a SYSTEM "file:///etc/passwd">]>\n'
           "<sdf version='1.9'><model name='&a;'><link name='a'/></model></sdf>")


def cases():
    """Name, content and the codes of which one is due ("" is an import)."""
    for name in ("script.sdf", "script.urdf"):
        yield name, "#!/bin/sh\ntouch ran\n", {"S013"}
    yield "empty.sdf", "", {"S013"}
    yield "html.sdf", "<html/>", {"S013"}
    yield "xacro.urdf", '<robot name="a"><xacro:include filename="b"/></robot>', {"S013"}
    yield "large.sdf", "<sdf>" + " " * (17 << 20), {"S013"}
    yield "laughs.sdf", LAUGHS, {"S014"}
    yield "entity.sdf", OUTSIDE, {"S014"}
    yield "deep.sdf", "<sdf>" + "<model name='a'>" * 100000, {"S014"}
    yield "unclosed.urdf", "<robot name='a'>" + "<link name='b'>" * 400, {"S014"}
    for part in (10, 50, 90):
        for name, text in (("sdf", SDF), ("urdf", URDF)):
            yield f"cut_{part}.{name}", text[:len(text) * part // 100], {"S014"}
    yield "two_names.sdf", SDF.replace('link name="lower"', 'link name="upper"'), {"S014"}
    yield "no_version.sdf", SDF.replace(' version="1.9"', ""), {"S014"}
    yield "no_parent.sdf", SDF.replace("<parent>world</parent>", ""), {"S014"}
    yield "other_parent.sdf", SDF.replace("<parent>world<", "<parent>nobody<"), {"S014"}
    yield "no_parent.urdf", URDF.replace('<parent link="upper"/>', ""), {"S014"}
    yield "circle.urdf", URDF.replace('parent link="world"', 'parent link="lower"'), {"S014"}
    yield "frames.sdf", SDF.replace('<frame name="shelf"><pose>',
                                    '<frame name="shelf"><pose relative_to="upper">'), {"S014"}
    yield "no_mass.sdf", SDF.replace("<mass>2</mass>", "<mass>0</mass>"), {"S015"}
    yield "heavy.urdf", URDF.replace('mass value="2"', 'mass value="1e40"'), {"S006"}
    yield "minus.sdf", SDF.replace("<mass>2</mass>", "<mass>-2</mass>"), {"S014"}
    yield "no_mass.urdf", URDF.replace('mass value="2"', 'mass value="0"'), {"S015"}
    yield "minus.urdf", URDF.replace('mass value="2"', 'mass value="-2"'), {"S015"}
    yield "no_inertia.urdf", URDF.replace('iyy="0.009" izz="0.009"', 'iyy="0" izz="0"'), {"S015"}
    yield "flat.urdf", URDF.replace('iyy="0.009"', 'iyy="9"'), {"S006"}
    for number in ("nan", "inf", "1e999", "-nan(7)", "0x10", "1,5", ""):
        yield f"mass_{number}.sdf", SDF.replace("<mass>2<", f"<mass>{number}<"), REFUSED | FINE
        yield f"mass_{number}.urdf", URDF.replace('value="2"', f'value="{number}"'), REFUSED
        yield f"pose_{number}.sdf", SDF.replace("0.1 -0.2 1.5 0 0 0.3",
                                                f"{number} 0 0 0 0 0"), REFUSED | FINE
        yield f"pose_{number}.urdf", URDF.replace("0.4 0 0", f"{number} 0 0"), REFUSED
    for number in ("nan", "inf", "0x"):
        for key in ("damping", "friction", "spring_stiffness", "spring_reference"):
            yield f"{key}_{number}.sdf", SDF.replace(
                "</xyz>", f"</xyz><dynamics><{key}>{number}</{key}></dynamics>", 1), REFUSED | FINE
        yield f"stop_{number}.sdf", SDF.replace(
            "</xyz>", f"</xyz><limit><stiffness>{number}</stiffness></limit>", 1), REFUSED | FINE
    for place in ('mass value="2"', 'ixx="', 'lower="'):
        if place in URDF:
            yield f"word_{place[:5]}.urdf", re.sub(
                place.split('="')[0] + '="[^"]*"', place.split('="')[0] + '="two"', URDF,
                count=1), {"S014"}
    yield "limit_nan.sdf", SDF.replace(
        "</xyz>", "</xyz><limit><lower>-1</lower><upper>nan</upper></limit>", 1), {"S015"}
    yield "damping.sdf", SDF.replace(
        "</xyz>", "</xyz><dynamics><damping>nan</damping></dynamics>", 1), {"S015"}
    for version in ("1.10", "2.0", "99"):
        yield f"version_{version}.sdf", SDF.replace(
            'version="1.9"', f'version="{version}"'), {"S014"}
    yield "far.sdf", SDF.replace("0.4 0 0 0 -0.5 0", "1e9 1e9 1e9 0 -0.5 0"), {"S011"}
    yield "heavy.sdf", SDF.replace("<mass>2</mass>", "<mass>1e300</mass>"), {"S006", "S011"}
    yield "no_axis.sdf", SDF.replace("<xyz>0 1 0</xyz>", "<xyz>0 0 0</xyz>"), {"S014"}
    yield "no_axis.urdf", URDF.replace('xyz="0 1 0"', 'xyz="0 0 0"'), {"S014", "S006"}
    yield "fixed.sdf", "<sdf version='1.9'><model name='a'><static>1</static>" \
                       "<link name='b'/></model></sdf>", {"S015"}
    yield "links.sdf", "<sdf version='1.9'><model name='a'>" + "".join(
        f"<link name='{i}'/>" for i in range(100000)) + "</model></sdf>", {"S015"}
    yield "balls.sdf", "<sdf version='1.9'><model name='a'><link name='0'/>" + "".join(
        f"<link name='{i}'/><joint name='j{i}' type='ball'><parent>{i - 1}</parent>"
        f"<child>{i}</child></joint>" for i in range(1, 2000)) + "</model></sdf>", LIMIT
    yield "frames_in_a_row.sdf", (
        "<sdf version='1.9'><model name='a'><link name='b'/><frame name='0'/>" + "".join(
            f"<frame name='{i}' attached_to='{i - 1}'><pose>1e-9 0 0 0 0 0</pose></frame>"
            for i in range(1, 3990)) + "</model></sdf>"), FINE | REFUSED
    yield "chain.urdf", "<robot name='a'><link name='0'/>" + "".join(
        f"<link name='{i}'/><joint name='{i}' type='fixed'><parent link='{i - 1}'/>"
        f"<child link='{i}'/></joint>" for i in range(1, 60000)) + "</robot>", {"S015"}
    yield "shapes.sdf", SDF.replace("<sensor", "<visual name='a'/>" * 100000 + "<sensor"), FINE
    yield "nothing.sdf", "<sdf version='1.9'/>", {"S014", "S015"}
    include = "<include><uri>{}</uri></include>"
    for number, uri in enumerate(("model://sun", "https://fuel.ignitionrobotics.org/1.0/a/b",
                                  "file:///etc/passwd", "include_3.sdf")):
        # The last names itself.
        yield f"include_{number}.sdf", SDF.replace(
            "<gravity>", include.format(uri) + "<gravity>"), FINE
    yield "included_link.sdf", SDF.replace(
        "<frame", "<include merge='true'><uri>included_link.sdf</uri></include><frame").replace(
        "<child>lower<", "<child>more::lower<"), {"S014"}
    for number, title in enumerate(("$(touch ran)", "`touch ran`", "; touch ran", "a\\\"b",
                                    "'''", "a]\nb = 1\n[x", "../../ran", "ground", "\u202e\u0007",
                                    "x" * 5000, "é")):
        quoted = (title.replace("&", "&amp;").replace('"', "&quot;").replace("\n", "&#10;")
                  .replace("\u0007", "&#7;"))
        yield f"title_{number}.sdf", SDF.replace('"elbow"', f'"{quoted}"'), REFUSED | FINE
        yield f"title_{number}.urdf", URDF.replace('"lower"', f'"{quoted}"'), REFUSED | FINE


def faults(name, codes, folder):
    """What is wrong with how a file was imported or refused."""
    started = time.monotonic()
    try:
        done = subprocess.run([CLEVIS, "import", name, "--out", "scene"], cwd=folder,
                              capture_output=True, text=True, errors="replace",
                              timeout=3 * SECONDS)
    except subprocess.TimeoutExpired:
        yield "no end"
        return
    if time.monotonic() - started > SECONDS:
        yield f"{time.monotonic() - started:.1f} s"
    if list(folder.rglob("ran")):
        yield "a script in the file was run"
    if "root:" in done.stdout + done.stderr:
        yield "a file that is named in the model was read"
    head = re.search(r"^error\[(\w+)\]: (.+)", done.stderr, re.M)
    if done.returncode == 0:
        if "" not in codes:
            yield f"imported, wanted {codes}"
        return
    if head is None:
        yield f"no refusal, exit {done.returncode}: {done.stderr[-200:]!r}"
        return
    if codes == LIMIT:
        if not re.search("did not finish within 8 s|limit of 2048 MiB", head[2]):
            yield f"not the documented limit: {head[2]}"
    elif head[1] not in codes:
        yield f"{head[1]} instead of {codes}: {head[2]}"
    if done.returncode != 10:
        yield f"exit {done.returncode} with {head[1]}"
    if "scene.toml" in head[2]:
        yield f"its place is in a scene that is gone: {head[2]}"
    if (folder / "scene").exists():
        yield "a folder is left behind"
    if not re.search(r"^  help: .{8,}", done.stderr, re.M):
        yield "no help"


def damaged(text, rng):
    data = bytearray(text.encode())
    for _ in range(rng.randrange(1, 8)):
        i = rng.randrange(len(data))
        data[i:i + rng.randrange(3)] = bytes([rng.randrange(256)])
    return bytes(data)


def main():
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)

        def tried(case, content, codes):
            (folder / case).write_bytes(content)
            found = list(faults(case, codes, folder))
            (folder / case).unlink()
            shutil.rmtree(folder / "scene", ignore_errors=True)
            for text in found:
                print(f"FAILED {case}: {text}")
            return bool(found)

        for case, text, codes in cases():
            bad += tried(case, text.encode(), codes)
        rng = random.Random(SEED)
        # What is damaged may be a scene that only clevis refuses.
        codes = REFUSED | FINE | {"S004", "S006", "S011"}
        for model, text in MODELS.items():
            for i in range(COUNT):
                bad += tried(f"damaged_{SEED}_{i}_{model}", damaged(text, rng), codes)
    print(f"{bad} treated badly")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
