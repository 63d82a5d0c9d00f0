"""peers.md and its plots from the rows of peers.csv."""
from pathlib import Path

import mechanisms
import parts
from figures import plot

HERE = Path(__file__).resolve().parent
# Allowed errors of the comparison.
PART_GOALS = [(0.05, "5 %"), (0.01, "1 %"), (0.003, "0.3 %")]
MECHANISM_GOALS = [1e-3, 1e-6, 1e-8]
OURS = ("clevis check", mechanisms.COMMAND)
LIBRARY = mechanisms.PROGRAMS["work_precision"][0]


def number(text):
    return float(text) if text else None


def seconds(value):
    if value is None:
        return ""
    return f"{value:.2f}" if value >= 0.1 else f"{value:.3f}"


def reference(part, rows):
    """(peak [MPa], doubt) of a part, or (None, None)."""
    if part.peak is not None:
        return part.peak, part.doubt
    found = [row for row in rows if row["kind"] == "reference"]
    return (float(found[0]["error"]), float(found[0]["band"])) if found else (None, None)


def measured(rows):
    return [row for row in rows if row["kind"] != "reference"]


def errors(rows, true):
    """Rows with the relative error of their peak."""
    return [{**row, "off": abs(float(row["error"]) / true - 1.0)} if row["error"] and true
            else {**row, "off": None} for row in rows]


def least(rows, program, allowed, key):
    """Row of a program of least time within an error, or None."""
    fit = [row for row in rows if row["program"] == program and row["off"] is not None
           and row["off"] <= allowed and row[key]]
    return min(fit, key=lambda row: float(row[key]), default=None)


def programs_of(rows):
    return list(dict.fromkeys(row["program"] for row in rows))


def cell(rows, program, allowed, key, scale=1.0):
    if program not in programs_of(rows):
        return "not run"
    row = least(rows, program, allowed, key)
    if row is None:
        return "not reached"
    method = row["method"].removeprefix(row["program"]).removeprefix("clevis ").strip()
    how = " ".join(word for word in (method, row["setting"]) if word not in ("auto", "clevis"))
    return f"{scale * float(row[key]):.3g} ({how})"


def faster(rows, ours, allowed, key):
    """Programs that reach an error sooner than ours: [(name, how many times)]."""
    own = least(rows, ours, allowed, key)
    for program in programs_of(rows):
        row = least(rows, program, allowed, key)
        if program in (*OURS, LIBRARY) or row is None:
            continue
        if own is None:
            yield program, None
        elif float(row[key]) < float(own[key]):
            yield program, float(own[key]) / float(row[key])


def faster_text(found):
    return ", ".join(name if times is None else f"{name} ({times:.1f} times)"
                     for name, times in found)


def part_section(part, rows):
    true, doubt = reference(part, rows)
    yield f"## {part.title}\n"
    if true is None:
        yield "No reference.\n"
    else:
        yield f"Peak of von Mises stress {true:.6g} ± {doubt:.2g} MPa: {part.source}.\n"
    rows = errors(measured(rows), true)
    yield f"![error of the peak against seconds of the process](peers_{part.name}.svg)\n"
    yield "| program | how | setting | peak MPa | error % | band MPa | process s | wall s | own s | |"
    yield "|---|---|---|---|---|---|---|---|---|---|"
    for row in rows:
        off = "" if row["off"] is None else f"{100.0 * row['off']:.2g}"
        yield (f"| {row['program']} | {row['method']} | {row['setting']} | {row['error']} | {off} "
               f"| {row['band']} | {seconds(number(row['user_s']))} "
               f"| {seconds(number(row['wall_s']))} | {seconds(number(row['work_s']))} "
               f"| {row['remark']} |")
    yield ""


def part_goals(by_problem):
    yield "## Parts: least seconds of a process to an error of the peak\n"
    programs = [OURS[0], "CalculiX 2.20", "dolfinx 0.5"]
    yield f"| part | error | {' | '.join(programs)} | faster than clevis |"
    yield "|---|---|" + "---|" * (len(programs) + 1)
    for part in parts.PARTS:
        rows = by_problem.get(part.name, [])
        rows = errors(measured(rows), reference(part, rows)[0])
        if not rows:
            continue
        for allowed, words in PART_GOALS:
            cells = [cell(rows, program, allowed, "user_s")
                     for program in programs]
            yield (f"| {part.name} | {words} | {' | '.join(cells)} "
                   f"| {faster_text(faster(rows, OURS[0], allowed, 'user_s'))} |")
    yield ""


def with_off(rows):
    return [{**row, "off": number(row["error"])} for row in rows]


def mechanism_goals(by_problem, key, ours, title, scale):
    yield f"## Mechanisms: {title}\n"
    programs = [ours, *(words[0] for name, words in mechanisms.PROGRAMS.items()
                        if name != "work_precision")]
    yield f"| mechanism | error | {' | '.join(programs)} | faster than clevis |"
    yield "|---|---|" + "---|" * (len(programs) + 1)
    for problem in mechanisms.TITLES:
        rows = with_off(by_problem.get(problem, []))
        if not rows:
            continue
        for allowed in MECHANISM_GOALS:
            cells = [cell(rows, program, allowed, key, scale)
                     for program in programs]
            yield (f"| {problem} | {allowed:.0e} | {' | '.join(cells)} "
                   f"| {faster_text(faster(rows, ours, allowed, key))} |")
    yield ""


def mechanism_section(problem, rows):
    yield f"## {mechanisms.TITLES[problem]}\n"
    yield f"![error against seconds of the motion](peers_{problem}.svg)\n"
    yield "| program | method | setting | error | motion ms | process s | wall s | |"
    yield "|---|---|---|---|---|---|---|---|"
    for row in rows:
        work = "" if not row["work_s"] else f"{1e3 * float(row['work_s']):.3g}"
        yield (f"| {row['program']} | {row['method']} | {row['setting']} | {row['error']} | {work} "
               f"| {seconds(number(row['user_s']))} | {seconds(number(row['wall_s']))} "
               f"| {row['remark']} |")
    yield ""


def draw(picture, rows, key, label, folder):
    curves = {}
    for row in rows:
        if row["off"] and row[key]:
            name = row["method"]
            if not name.startswith((row["program"], "clevis")):
                name = row["program"] + ("" if name == "auto" else f" {name}")
            curves.setdefault(name, []).append((row[key], f"{row['off']:.4g}"))
    if curves:
        plot(folder / picture, f'set logscale xy\nset format "10^{{%T}}"\n'
             f'set xlabel "processor seconds {label}"\nset ylabel "error"\n'
             # eight colours, then the same dashed
             "set for [k=1:8] linetype k + 8 lc k lw 2 dt 2\nset linetype cycle 16\n"
             "set key outside right", curves, "1:2")


def text(rows):
    """The page, by lines."""
    by_problem = {}
    for row in rows:
        if row["problem"]:
            by_problem.setdefault(row["problem"], []).append(row)
    machine = next((row["remark"] for row in rows if row["kind"] == "machine"), "")
    yield (HERE / "about.txt").read_text().replace("MACHINE", machine)
    for row in rows:
        if row["kind"] == "skipped":
            yield f"**Left out: {row['program']}** ({row['remark']}).\n"
    if any(part.name in by_problem for part in parts.PARTS):
        yield from part_goals(by_problem)
    if any(problem in by_problem for problem in mechanisms.TITLES):
        yield from mechanism_goals(by_problem, "work_s", LIBRARY,
                                   "least ms of the motion alone to an error", 1e3)
        yield from mechanism_goals(by_problem, "user_s", mechanisms.COMMAND,
                                   "least seconds of the whole process to an error", 1.0)
    for part in parts.PARTS:
        if part.name in by_problem:
            yield from part_section(part, by_problem[part.name])
    for problem in mechanisms.TITLES:
        if problem in by_problem:
            yield from mechanism_section(problem, by_problem[problem])


def write(rows, folder):
    for part in parts.PARTS:
        own = [row for row in rows if row["problem"] == part.name]
        draw(f"peers_{part.name}.svg", errors(measured(own), reference(part, own)[0]), "user_s",
             "of the process", folder.resolve())
    for problem in mechanisms.TITLES:
        own = [row for row in rows if row["problem"] == problem]
        draw(f"peers_{problem}.svg", with_off(own), "work_s", "of the motion",
             folder.resolve())
    (folder / "peers.md").write_text("\n".join(text(rows)).rstrip("\n") + "\n")
