#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the rules of the house that no compiler checks. Usage: check.py PROJECT_FOLDER

Includes point down only, cli -> shade, measure, query, verify -> raycast -> csg; they start with the module's name; a .cpp includes its own header
first. What is below MODULE/detail/ is included by that module and by the tests, never by a public header. Each library of a kind
of picture is seen by one file of shade/, CGAL only by the tests. No file is longer than 400 lines, no function longer than 60 unless a comment
`// long: REASON` stands right above it or inside it. Names of test cases have no semicolon, at which CTest parts them. Prints file:line: breach for each, and exits 1 if there is one.
"""
import re
import sys
from pathlib import Path

BELOW = {"csg": [], "raycast": ["csg"], "shade": ["csg", "raycast"], "measure": ["csg", "raycast"], "query": ["csg", "raycast"], "capi": ["csg", "raycast", "measure", "query"],
         "verify": ["csg", "raycast"],
         "cli": ["csg", "raycast", "shade", "measure", "query", "verify"],
         "python": ["csg", "raycast", "shade", "measure", "query"]}  # what each module may include besides itself
MODULES = list(BELOW)
FOLDERS = MODULES + ["tests", "examples"]
MAX_FILE, MAX_FUNCTION = 400, 60

# The libraries of the kinds of pictures, by the names of their headers.
PICTURE_LIBRARIES = {"libpng": r"png\w*\.h", "libjpeg": r"(jpeglib|jerror|turbojpeg)\.h", "libtiff": r"tiff\w*\.h",
                     "OpenEXR": r"((OpenEXR|Imath)/.*|(Imf|Imath|Iex|IlmThread)\w*\.h)"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)')
COMMENT_OR_LITERAL = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>[^(\s]*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S)


def includes(text):
    """(line number, '"' or '<', path) of each include."""
    for number, line in enumerate(text.splitlines(), 1):
        if match := INCLUDE.match(line):
            yield number, match[1], match[2]


def code_only(text):
    """The text with comments, literals and preprocessor lines blanked out; line breaks stay where they are."""
    blank = lambda match: '""' + "\n" * match[0].count("\n")
    text = COMMENT_OR_LITERAL.sub(blank, text)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda match: "\n" * match[0].count("\n"), text, flags=re.M)


def functions(text):
    """(first line, last line) of each function body outside other functions: each {..} whose head has a parenthesis."""
    line, head, head_line = 1, "", 1
    open_braces = []  # for each open brace: the line its function's head starts on, or None for a namespace, class, list
    for char in code_only(text):
        if char == "\n":
            line += 1
        inside = any(open_braces)
        if char == "{":
            open_braces.append(head_line if "(" in head and not inside else None)
        elif char == "}" and open_braces:
            if start := open_braces.pop():
                yield start, line
        if char in "{};":
            head = ""
        elif head or not char.isspace():
            head_line = head_line if head else line
            head += char


def picture_library(path):
    """The library of pictures that a header belongs to; None if there is none."""
    return next((name for name, headers in PICTURE_LIBRARIES.items() if re.fullmatch(headers, path)), None)


def check_sizes(name, text):
    lines = text.splitlines()
    if len(lines) > MAX_FILE:
        yield f"{name}:{len(lines)}: longer than {MAX_FILE} lines"
    for first, last in functions(text):
        excused = any(re.search(r"// long: \S", line) for line in lines[max(first - 2, 0):last])
        if last - first + 1 > MAX_FUNCTION and not excused:
            yield f"{name}:{first}: a function of {last - first + 1} lines, more than {MAX_FUNCTION}"


def check_includes(name, text, own_header):
    """`own_header`: the path of the header beside a .cpp, None if there is none."""
    module = name.split("/")[0]
    visible = BELOW[module] + [module] if module in MODULES else FOLDERS
    is_public_header = name.endswith(".h") and module in MODULES and "/detail/" not in name
    found = list(includes(text))
    if own_header and (not found or found[0][2] != own_header):
        yield f'{name}:1: its first include is not "{own_header}"'
    for line, quote, path in found:
        where, target = f"{name}:{line}", path.split("/")[0]
        if quote == '"' and target not in FOLDERS:
            yield f'{where}: "{path}" does not start with a module'
        elif quote == '"' and target not in visible:
            yield f"{where}: {module} may not include {path}"
        elif quote == '"' and "/detail/" in path and (is_public_header or module not in (target, "tests")):
            yield f"{where}: {path} is private"
        elif target == "CGAL" and module != "tests":
            yield f"{where}: CGAL is for the tests alone"
        elif (library := picture_library(path)) and module not in ("shade", "tests"):
            yield f"{where}: {library} is for one file of shade alone"


def check_test_names(name, text):
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r'TEST_CASE\("[^"]*;', line):
            yield f"{name}:{number}: a test case with a semicolon in its name"


def check(root):
    seen_by = {}  # the first file of shade that includes a library of pictures
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[hc]*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            name, text = path.relative_to(root).as_posix(), path.read_text()
            header = path.with_suffix(".h") if path.suffix == ".cpp" else None
            own_header = header.relative_to(root).as_posix() if header and header.exists() else None
            yield from check_sizes(name, text)
            yield from check_test_names(name, text)
            yield from check_includes(name, text, own_header)
            for library in {picture_library(target) for _, _, target in includes(text)} - {None}:
                if folder == "shade" and seen_by.setdefault(library, name) != name:
                    yield f"{name}:1: {library} is seen by {seen_by[library]} already"


if __name__ == "__main__":
    breaches = list(check(Path(sys.argv[1])))
    print("\n".join(breaches))
    sys.exit(1 if breaches else 0)
