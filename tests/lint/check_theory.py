#!/usr/bin/env python3
"""Fail if a chapter of docs/theory promises what is not there, or is hard to read.

    check_theory.py

Every test that a chapter names exists: suites and cases of unit tests, files,
tests of ctest. Every section with a formula names its source and its test. Every
section that a comment of the sources cites (docs/theory.md, "Title") is there,
and in the index. Sentences have under 20 words on average.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INDEX = ROOT / "docs/theory.md"
LONGEST = 20.0


def suites():
    """{suite: cases} of all GoogleTest sources."""
    found = {}
    for file in (ROOT / "tests").rglob("*.cc"):
        for suite, case in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)",
                                      file.read_text(), re.M):
            found.setdefault(suite, set()).add(case)
    for file in (ROOT / "tests").rglob("*.cc"):
        for suite in re.findall(r"TYPED_TEST\((\w+),", file.read_text()):
            found.setdefault(suite, set())
    return found


def ctest_names():
    lists = ROOT / "tests/regression/CMakeLists.txt"
    names = {f"regression.{name}" for name in
             re.findall(r"^clevis_(?:script|regression)\((\w[\w.]*)", lists.read_text(), re.M)}
    for file in (ROOT / "tests/verification").rglob("CMakeLists.txt"):
        names |= set(re.findall(r"NAME (verification\.[\w.]+)", file.read_text()))
    return names


def test_faults(text, known, names, files):
    """Of the code spans that look like tests."""
    for word in sorted(set(re.findall(r"`([^`\n]+)`", text))):
        if match := re.fullmatch(r"([A-Z]\w+)\.(\w+|\*)", word):
            suite, case = match.groups()
            if suite not in known or (case != "*" and case not in known[suite]):
                yield f"no test {word}"
        elif re.fullmatch(r"(regression|verification)\.[\w.]+", word):
            if word not in names:
                yield f"no test {word}"
        elif "/" in word and re.search(r"\.(cc|py)$", word):
            if not (ROOT / word).is_file():
                yield f"no file {word}"
        elif re.fullmatch(r"\w+\.(cc|py)", word) and word not in files:
            yield f"no file {word}"


def sections(text):
    """Title and body of each heading below the first."""
    parts = re.split(r"^##+ (.*)$", text, flags=re.M)
    return list(zip(parts[1::2], parts[2::2]))


def source_faults(text):
    for title, body in sections(text):
        if not re.search(r"^ {4,}\S", body, re.M):
            continue
        for word in ("Source", "Test"):
            if not re.search(rf"\b{word}s?: ", body):
                yield f'"{title}" has a formula and no {word.lower()}'


def prose(text):
    """Sentences, without tables, formulas, headings, sources and tests."""
    kept = []
    for block in re.split(r"\n\s*\n|\n(?=- |\d\. )", text):
        line = block.strip()
        if not line or line[0] in "#|`[" or block.startswith("    ") or re.match(
                r"(- )?(Sources?|Tests?): ", line):
            continue
        kept.append(re.sub(r"^(- |\d\. )", "", re.sub(r"\s+", " ", line)))
    ends = r"(?<=[.?!])[*)]*\s+(?=[A-Z*`(√ΦΠ|0-9])"
    return [s for line in kept for s in re.split(ends, line) if re.search(r"[a-z]{3}", s)]


def mean_length(text):
    sentences = prose(text)
    return sum(len(s.split()) for s in sentences) / max(1, len(sentences))


def cited_titles():
    for folder in ("src", "tests"):
        for file in (ROOT / folder).rglob("*"):
            if file.suffix not in (".h", ".cc"):
                continue
            text = re.sub(r"\n\s*//+ ?", " ", file.read_text())
            for title in re.findall(r'docs/theory\.md,\s*"([^"]+)"', text):
                yield title, file.relative_to(ROOT)


def main():
    chapters = sorted((ROOT / "docs/theory").glob("*.md"))
    known, names = suites(), ctest_names()
    files = {p.name for p in (ROOT / "tests").rglob("*") if p.is_file()}
    faults, titles = [], set()
    for chapter in chapters:
        text = chapter.read_text()
        titles |= {title for title, _ in sections(text)}
        mean = mean_length(text)
        found = [*test_faults(text, known, names, files), *source_faults(text)]
        if mean >= LONGEST:
            found.append(f"{mean:.1f} words a sentence, under {LONGEST:.0f} wanted")
        if f"theory/{chapter.name}" not in INDEX.read_text():
            found.append("is not in docs/theory.md")
        faults += [f"docs/theory/{chapter.name}: {fault}" for fault in found]
        if "--list" in sys.argv:
            print(f"{chapter.name}: {mean:.1f} words a sentence")
    faults += [f'{file}: docs/theory has no section "{title}"'
               for title, file in cited_titles() if title not in titles]
    print("\n".join(faults) or f"{len(chapters)} chapters hold")
    return len(faults) > 0 or not chapters


if __name__ == "__main__":
    sys.exit(main())
