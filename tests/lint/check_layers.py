#!/usr/bin/env python3
"""Fail if src/ is not what architecture.py says (CI, first step): an include
that LAYERS or the order of ROOMS does not allow, a header of another module
that is not public, an include circle between stems (x.h and x.cc are one), a
folder that is no room, a room that docs/architecture.md does not explain."""
import re
import sys
from pathlib import Path

from architecture import LAYERS, MOST_FILES_OF_A_ROOM, PUBLIC, ROOMS

LIBRARIES = r"(Eigen|deal\.II|gmsh|petsc|nlohmann|fmt|toml|CLI|udunits2)"


def read(src):
    """{path in src: [(line number, line, included path or None)]}"""
    files = {}
    for path in sorted(src.rglob("*.[hc]*")):
        lines = enumerate(path.read_text().splitlines(), 1)
        files[path.relative_to(src).as_posix()] = [
            (number, line.strip(), (re.match(r'\s*#\s*include\s*"([^"]+)"', line)
                                    or [None, None])[1])
            for number, line in lines if re.match(r"\s*#\s*include", line)]
    return files


def module(path):
    return path.split("/")[0]


def room(path):
    """The room's rank and name; files beside the rooms stand above all."""
    rooms = list(ROOMS.get(module(path), ()))
    parts = path.split("/")
    if len(parts) == 2:
        return len(rooms), ""
    return (rooms.index(parts[1]), parts[1]) if parts[1] in rooms else (-1, parts[1])


def layer_faults(files):
    for path, includes in files.items():
        here = module(path)
        if here not in LAYERS:
            yield f"{path}: module {here} has no row in LAYERS"
            continue
        ours, theirs = (set(names.split()) for names in LAYERS[here])
        for number, line, target in includes:
            other = re.match(rf"#\s*include\s*[<\"]{LIBRARIES}", line)
            mine = target and module(target) != here
            if (mine and module(target) not in ours) or (other and other[1] not in theirs):
                yield f"{path}:{number}: {here} may not have {line}"
            elif mine and module(target) in PUBLIC and (
                    target.split("/", 1)[1].removesuffix(".h")
                    not in PUBLIC[module(target)].split()):
                yield f"{path}:{number}: {target} is not public"


def room_faults(files):
    count = {}
    for path, includes in files.items():
        if module(path) not in ROOMS:
            continue
        rank, name = room(path)
        if rank < 0:
            yield f"{path}: {name} is no room of {module(path)}"
            continue
        count[module(path), name] = count.get((module(path), name), 0) + 1
        for number, line, target in includes:
            if target and module(target) == module(path) and room(target)[0] > rank:
                yield f"{path}:{number}: {name} stands below what it includes: {line}"
    for (here, name), files_of_it in count.items():
        if files_of_it > MOST_FILES_OF_A_ROOM:
            yield f"{here}/{name}: {files_of_it} files; at most {MOST_FILES_OF_A_ROOM}"


def public_faults(files):
    used = {target for path, includes in files.items()
            for _, _, target in includes if target and module(target) != module(path)}
    for here, headers in PUBLIC.items():
        for header in headers.split():
            if f"{here}/{header}.h" not in used:
                yield f"{here}/{header}.h is public but no other module includes it"


def circles(files):
    """Strongly connected stems (Tarjan)."""
    stem = lambda path: path.rsplit(".", 1)[0]
    next_of = {}
    for path, includes in files.items():
        next_of.setdefault(stem(path), set()).update(
            stem(t) for _, _, t in includes if t in files and stem(t) != stem(path))
    index, low, stack, found = {}, {}, [], []

    def visit(v):
        index[v] = low[v] = len(index)
        stack.append(v)
        for w in sorted(next_of.get(v, ())):
            if w not in index:
                visit(w)
                low[v] = min(low[v], low[w])
            elif w in stack:
                low[v] = min(low[v], index[w])
        if low[v] == index[v]:
            at = stack.index(v)
            if len(stack) - at > 1:
                found.append(sorted(stack[at:]))
            del stack[at:]

    for v in sorted(next_of):
        if v not in index:
            visit(v)
    return found


def document_faults(root):
    text = (root / "docs/architecture.md").read_text()
    for here, rooms in ROOMS.items():
        for name, purpose in rooms.items():
            if f"| `{name}` | {purpose} |" not in text:
                yield f"docs/architecture.md: no row of {here}: | `{name}` | {purpose} |"


def check(root):
    files = read(root / "src")
    faults = [*layer_faults(files), *room_faults(files), *public_faults(files),
              *(f"include circle: {', '.join(c)}" for c in circles(files)),
              *document_faults(root)]
    print("\n".join(faults))
    return len(faults)


if __name__ == "__main__":
    sys.exit(check(Path(sys.argv[1] if len(sys.argv) > 1 else ".")) > 0)
