#!/usr/bin/env python3
"""Hold messages to one form: what is wrong begins in lower case (it follows
"place: "), what to do is a sentence, with a capital letter and a full stop.
Looks at every call in src that takes a diagnostic's code as a literal, problem
and remedy behind it; texts that are no literals are left out, and first words
that are names (keys, programs).

check_messages.py [ROOT]"""
import re
import sys
from pathlib import Path

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
RAW = re.compile(r'R"(\w*)\(.*?\)\1"', re.S)
CODE = re.compile(r'"[A-Z]\d{3}"')
NAMES = ("CalculiX", "PETSc")


def arguments(text, start):
    """Arguments of a call, from behind its opening parenthesis."""
    found, depth, begin, i = [], 0, start, start
    while i < len(text):
        c = text[i]
        if c == '"':
            literal = LITERAL.match(text, i)
            if not literal:  # the "call" stands in a text
                return []
            i = literal.end() - 1
        elif c == "'":
            i = re.compile(r"'(?:[^'\\]|\\.)'|'").match(text, i).end() - 1
        elif c in "([{":
            depth += 1
        elif c in ")]}" and depth:
            depth -= 1
        elif c in ")]}" or c == "," and not depth:
            found.append(text[begin:i].strip())
            if c != ",":
                break
            begin = i + 1
        i += 1
    return found


def branches(argument):
    """The texts that an argument may be: one, or those of a choice."""
    depth, cuts = 0, [0]
    for m in re.finditer(r'"(?:[^"\\\n]|\\.)*"|::|[()\[\]{}?:]', argument):
        if m[0] in "([{":
            depth += 1
        elif m[0] in ")]}":
            depth -= 1
        elif m[0] in "?:" and not depth:
            cuts.append(m.end())
    parts = [argument[a:b] for a, b in zip(cuts, cuts[1:] + [len(argument)])]
    return parts if len(parts) == 1 else parts[1:]


def texts(argument):
    """(beginning, end) of each branch; None where it is no literal."""
    wrapper = r"(?:fmt::format|std::string)\(\s*"
    for branch in branches(argument):
        text = branch.strip().rstrip("?: \n")
        head = re.match(rf"(?:{wrapper})?" + LITERAL.pattern, text)
        joined = re.match(rf'(?:{wrapper})?((?:"(?:[^"\\\n]|\\.)*"\s*)+)(.*)',
                          text, re.S)
        tail = None
        if joined and not re.search(r"\+", LITERAL.sub("", text)):
            tail = LITERAL.findall(joined[1])[-1]
        yield head and head[1], tail


def complaints(text):
    for call in re.finditer(r"\b(\w+)\(", text):
        given = arguments(text, call.end())
        at = next((i for i, x in enumerate(given) if CODE.fullmatch(x)), None)
        if at is None:
            continue
        first = at + (2 if call[1] == "Error" else 1)
        line = text[:call.start()].count("\n") + 1
        for head, _ in texts(given[first]) if first < len(given) else ():
            if head and head[0].isupper() and not head.startswith(NAMES) and \
                    not re.match(r"[A-Z][\w.]*[A-Z]|[A-Z]\d? = ", head):
                yield line, f'begins with a capital: "{head[:40]}"'
        if first + 2 != len(given):
            continue
        for head, tail in texts(given[first + 1]):
            if head and re.match(r"[a-z]+\b", head):
                yield line, f'begins in lower case: "{head[:40]}"'
            if tail and tail[-1] not in ".:?!":
                yield line, f'has no full stop: "…{tail[-40:]}"'


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    failed = 0
    for path in sorted((root / "src").rglob("*.[ch]*")):
        text = RAW.sub(lambda m: '""' + "\n" * m[0].count("\n"),
                       path.read_text())
        text = re.sub(r"(?<!:)//[^\n]*", lambda m: " " * len(m[0]), text)
        for line, why in complaints(text):
            failed += 1
            print(f"{path.relative_to(root)}:{line}: {why}")
    sys.exit(failed > 0)


main()
