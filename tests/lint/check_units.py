#!/usr/bin/env python3
"""Count the functions of src/**/*.h that take or return numbers (double,
Eigen) and the share of them whose unit stands in reach; fail below
LEAST_PERCENT. In reach is: the function's docstring or trailing ///<, the
docstring of the group it stands in (no blank line between), or that of its
class. Left out: private and protected members, overrides (their contract is
the base's), data members.

check_units.py [ROOT] [--list MODULE]"""
import re
import sys
from pathlib import Path

LEAST_PERCENT = 90

NUMBER = r"\bdouble\b|\bEigen::(?!Index\b|VectorXi\b|MatrixXi\b)\w+"
SYMBOL = (r"(?:kg|km|mm|µm|m|N|rad|ms|µs|s|Pa|MPa|GPa|J|W|K|V|A|H|Wb|Hz|ohm|Ω"
          r"|deg|°|rpm|%|B|bytes?|SI|1|exponent)")
# [N], [N, N m], [kg m²], [1/s²], [J/(kg K)], [N/m^exponent]; [0, 1] is a range
# of pure numbers
UNIT = re.compile(
    rf"\[\s*(?:1/)?\(?{SYMBOL}(?:(?:[\s/·(),;^²³⁴⁵⁶⁻¹]|\bor\b|\band\b)*"
    rf"(?:{SYMBOL}(?![a-zA-Z])|[2-6](?![a-zA-Z])))*[\s)²³⁴⁵⁶⁻¹]*\]|\[[−-]?[01], ?1\]")
# Words that say of numbers that they are pure, or carry the units of others.
PURE = re.compile(
    r"\b(SI|(?i:relative|ratio|pure numbers?|weights|coefficients?|matrix|matrices"
    r"|shape functions?|unit (vectors?|normals?|length|axis)|units? of|orthonormal"
    r"|reference (cell|coordinates)))\b")


class Scope:
    def __init__(self, doc="", public=True, hidden=False):
        self.doc, self.public, self.hidden = doc, public, hidden


class Function:
    def __init__(self, line, head, docs, trailing):
        self.line, self.head, self.docs, self.trailing = line, head, docs, trailing

    def has_unit(self):
        return any(UNIT.search(doc) or PURE.search(doc)
                   for doc in [*self.docs, " ".join(self.trailing)])


def without_arguments(text):
    """The text without <…>, so that what parentheses are left are a function's."""
    text = re.sub(r"operator\s*(\(\)|\[\]|[^\s\w(]+)", "operator_", text)
    before = None
    while before != text:
        before, text = text, re.sub(r"<[^<>]*>", "", text)
    return text


def is_function(head):
    return re.match(r"[^=(]*[\w~]\s*\(", without_arguments(head)) is not None and not (
        re.match(r"(using|typedef|friend|static_assert|return|extern)\b", head))


def signature(head):
    """Up to the closing parenthesis of the parameters."""
    start = head.find("operator()(") + 10 if "operator()(" in head else 0
    depth = angle = 0
    for i, c in enumerate(head):
        if i < start:
            continue
        angle += (c == "<") - (c == ">")
        if c == "(":
            depth += 1
        if c == ")":
            depth -= 1
            if depth == 0 and angle <= 0:
                return head[:i + 1]
    return head


class Header:
    """A header read from its top; style of clang-format."""

    def __init__(self, path, number):
        self.number = number  # pattern of a type of numbers
        self.functions = []
        self.scopes = [Scope()]
        self.head_line, self.head_doc = 0, []  # head: what is being declared
        self.begin()  # pending: docs of what follows; group: of those before it
        self.skip = self.parentheses = 0
        for line_number, line in enumerate(path.read_text().splitlines(), 1):
            self.read_line(line_number, line)

    def read_line(self, number, line):
        line = re.sub(r'"[^"]*"', '""', line)
        comment = re.search(r"//.*", line)
        code, doc = line, ""
        if comment:
            code, doc = line[:comment.start()], comment[0]
        outside = self.skip == 0
        if not code.lstrip().startswith("#"):
            for c in code:
                self.read(c, number)
        if self.skip > 0:
            return
        if doc.startswith("///<"):
            (self.head_doc if self.head.strip() else self.last).append(doc[4:])
        elif doc.startswith("///"):
            self.pending.append(doc[3:])
        elif outside and not line.strip() and not self.head.strip():
            self.pending, self.group = [], []

    def read(self, c, number):
        if self.skip > 0:
            self.skip += (c == "{") - (c == "}")
            if self.skip == 0 and self.in_body:
                self.head = ""
        elif c == "{" and self.parentheses == 0:
            self.open()
        elif c == "{":
            self.skip, self.in_body = 1, False
        elif c == "}":
            self.scopes.pop()
            self.begin()
        elif c == ";" and self.parentheses == 0:
            self.declare()
            self.head = ""
        elif c.strip() or self.head:
            self.parentheses += (c == "(") - (c == ")")
            if not self.head:
                self.head_line, self.head_doc = number, []
            self.head += c if c.strip() else " "
            access = re.fullmatch(r"(public|private|protected)\s*:", self.head)
            if access:
                self.scopes[-1].public = access[1] == "public"
                self.begin()

    def begin(self):
        self.head, self.pending, self.group, self.last = "", [], [], []

    def open(self):
        head = re.sub(r"^template\s*<.*?>\s*(?=class|struct)", "", self.head.strip())
        kind = re.match(r"(?:inline )?(namespace|class|struct|union)\b", head)
        if is_function(head):
            self.declare()
            self.skip, self.in_body = 1, True
        elif kind is None:  # an enum, an initializer
            self.skip, self.in_body = 1, False
        else:
            outer = self.scopes[-1]
            self.scopes.append(Scope(" ".join([outer.doc, *self.pending]),
                                     kind[1] != "class", outer.hidden or not outer.public))
            self.begin()

    def declare(self):
        head, scope = self.head.strip(), self.scopes[-1]
        self.group = self.pending or self.group
        self.pending, self.last = [], self.head_doc
        if (is_function(head) and scope.public and not scope.hidden
                and not re.search(r"\boverride\b|=\s*(delete|default)$", head)
                and re.search(self.number, signature(head))):
            self.functions.append(Function(
                self.head_line, head, [" ".join(self.group), scope.doc], self.head_doc))


def aliases(headers):
    """Names of types that stand for numbers."""
    names = set()
    for path in headers:
        for name, target in re.findall(r"using (\w+) =\s*([^;]*);", path.read_text()):
            if re.match(rf"(std::(vector|array|optional)<)?({NUMBER})", target):
                names.add(name)
    return names


def read(root):
    """{path in src: [Function]}"""
    headers = sorted((root / "src").rglob("*.h"))
    number = "|".join([NUMBER, *(rf"\b{name}\b" for name in sorted(aliases(headers)))])
    found = {}
    for path in headers:
        found[path.relative_to(root / "src").as_posix()] = Header(path, number).functions
    return found


def percent(some, all_):
    return 100.0 if all_ == 0 else 100.0 * some / all_


def check(root, listed):
    count = {}
    for path, functions in read(root).items():
        module = path.split("/")[0]
        row = count.setdefault(module, [0, 0])
        for function in functions:
            row[0] += function.has_unit()
            row[1] += 1
            if module == listed and not function.has_unit():
                print(f"src/{path}:{function.line}: {re.sub(r' +', ' ', function.head)}")
    if listed:
        return 0
    for module, (some, all_) in sorted(count.items()):
        print(f"{module:12} {some:4} / {all_:4} {percent(some, all_):6.1f} %")
    some, all_ = (sum(row[i] for row in count.values()) for i in (0, 1))
    print(f"{'all':12} {some:4} / {all_:4} {percent(some, all_):6.1f} %")
    if percent(some, all_) < LEAST_PERCENT:
        print(f"functions with units: below {LEAST_PERCENT} % "
              "(see --list MODULE; CONTRIBUTING.md, Docstrings)")
        return 1
    return 0


if __name__ == "__main__":
    arguments = sys.argv[1:]
    module = None
    if "--list" in arguments:
        at = arguments.index("--list")
        module = arguments[at + 1]
        del arguments[at:at + 2]
    sys.exit(check(Path(arguments[0] if arguments else "."), module))
