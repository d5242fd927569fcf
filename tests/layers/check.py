#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the rules of the house that no compiler checks. Usage: check.py PROJECT_FOLDER

Rooms and floors. A room is a folder that FLOORS names, with all that is below it and in no other room. A file includes
its own room, and rooms on lower floors of its module or of the modules below it (BELOW). No rooms include each other in
a circle. No room has more than 30 files; folders in it that are no rooms, such as those of the kinds of surfaces, count by
themselves, but for detail/.

Headers. Paths start with the module's name, and a .cpp includes its own header first. What stands in a room's detail/
is for that room and the tests. The public headers of a module are those that its CMakeLists.txt lists: they include
public headers only and name nothing of namespace detail; other modules include nothing else (SHARED: but these). They
take and give arrays of numbers as spans or vectors, not as pointers, but for the C interface.

Classes. The member functions of a class stand in one .cpp, or in several that all bear the class's name.

Libraries. Each library of a kind of picture is seen by one file of shade/, CGAL by the tests only. No public header
includes Eigen, but for the one that is about it (EIGEN_HEADERS).

Tests. A file with test cases is called *_test.cpp, and only such a file. Names of test cases have no semicolon, at
which CTest parts them, and do not begin with a dash.

Docs. Lines of the .md files in docs/ and beside it have at most 100 columns, but for tables, links and blocks of code.

Prints file:line: breach for each, and exits 1 if there is one. Sizes are places to look, not rules: --sizes lists the
files of more than 400 lines and the functions of more than 60.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

BELOW = {
    "csg": [],
    "raycast": ["csg"],
    "measure": ["csg", "raycast"],
    "query": ["csg", "raycast"],
    "verify": ["csg", "raycast"],
    "shade": ["csg", "raycast"],
    "model": ["csg", "raycast", "measure", "query", "shade"],
    "bindings": ["csg", "raycast", "measure", "query", "shade", "model"],
    "cli": ["csg", "raycast", "measure", "query", "verify", "shade", "model"],
}  # what each module may include besides itself
MODULES = list(BELOW)
FOLDERS = MODULES + ["tests", "examples"]

# The rooms of each module, floor by floor from the bottom up.
FLOORS = [
    ["csg/base", "raycast/simd", "shade/light", "shade/module", "measure/sheet", "cli/output"],
    ["csg/exact", "csg/file", "raycast/line", "shade/film", "measure/search", "measure/section", "cli/input"],
    ["csg/solid", "raycast/surface", "shade/picture", "shade/trace", "cli/manual"],
    ["csg/text/syntax", "raycast/weld", "cli/command"],
    ["csg/text/statement", "raycast/scene"],
    ["raycast/ray", "raycast/cells/formula"],
    ["raycast/cells/build"],
    ["raycast/cells"],
    ["raycast/packets"],
    ["measure", "query", "verify", "shade", "model", "bindings/c", "bindings/python", "cli"],
]
APART = {("raycast/cells", "raycast/ray"), ("raycast/ray", "raycast/cells/formula")}  # whatever their floors
SHARED = {"raycast/simd": ["shade"]}  # a room whose headers are not public, and the modules that see it all the same
EIGEN_HEADERS = ["query/eigen_views.h"]  # the public headers whose users need Eigen
MOST_FILES = 30
LONG_FILE, LONG_FUNCTION = 400, 60

# The libraries of the kinds of pictures, by the names of their headers.
PICTURE_LIBRARIES = {"libpng": r"png\w*\.h", "OpenImageIO": r"OpenImageIO/.*", "libwebp": r"webp/.*"}

FLOOR = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)')
COMMENT_OR_LITERAL = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>[^(\s]*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S)
NUMBER_POINTER = re.compile(r"\b(?:double|float|int|long|size_t|u?int\d+_t)(?: const)? ?\*")
MEMBER = re.compile(r"^(?=\S)(?:[\w:<>,&*\[\] ]+[ &*])?((?:\w+::)+)(?:~?\w+|operator[^\s(]+) ?\(", re.M)


def room_of(name):
    """The room that a file stands in; None if it is in none, as tests are."""
    return max((room for room in FLOOR if name.startswith(room + "/")), key=len, default=None)


def folder_of(name, room):
    """The folder that a file of a room counts for: the room with its detail/, or an inner folder."""
    inner = name[len(room) + 1:].split("/")[0]
    return room if inner == "detail" or inner == Path(name).name else f"{room}/{inner}"


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


def public_headers(root):
    """The headers that the modules' CMakeLists.txt list."""
    listed = set()
    for path in root.glob("**/CMakeLists.txt"):
        folder = path.parent.relative_to(root)
        if folder.parts and folder.parts[0] in MODULES:
            for match in re.finditer(r"PUBLIC_HEADERS([^)]*)\)", path.read_text()):
                listed |= {(folder / header).as_posix() for header in match[1].split()}
    return listed


def check_include(name, path, public):
    """What is wrong with an include of a header of the project; None if nothing is."""
    module, target = name.split("/")[0], path.split("/")[0]
    if target not in FOLDERS:
        return f'"{path}" does not start with a module'
    if module not in MODULES:
        return None
    if target != module and target not in BELOW[module]:
        return f"{module} may not include {path}"
    own, other = room_of(name), room_of(path)
    if "/detail/" in path and own != other:
        return f"{path} is private"
    if target != module and path not in public and module not in SHARED.get(other, []):
        return f"{path} is not public"
    if name in public and path not in public:
        return f"a public header includes {path}, which is not public"
    if own and other and own != other and target == module:
        if FLOOR[other] > FLOOR[own]:
            return f"{own} may not include {path}, which is on a higher floor"
        if FLOOR[other] == FLOOR[own] or {(own, other), (other, own)} & APART:
            return f"{own} may not include {path}: neither room builds on the other"
    return None


def check_includes(name, text, own_header, public):
    """`own_header`: the path of the header beside a .cpp, None if there is none."""
    module = name.split("/")[0]
    found = list(includes(text))
    if own_header and (not found or found[0][2] != own_header):
        yield f'{name}:1: its first include is not "{own_header}"'
    for line, quote, path in found:
        if quote == '"' and (breach := check_include(name, path, public)):
            yield f"{name}:{line}: {breach}"
        elif path.startswith("CGAL/") and module != "tests":
            yield f"{name}:{line}: CGAL is for the tests alone"
        elif path.startswith("Eigen/") and name in public and name not in EIGEN_HEADERS:
            yield f"{name}:{line}: a public header that all users of the module would need Eigen for"
        elif (library := picture_library(path)) and module not in ("shade", "tests"):
            yield f"{name}:{line}: {library} is for one file of shade alone"


def check_public(name, text):
    for number, line in enumerate(code_only(text).splitlines(), 1):
        if re.search(r"\bdetail\b", line):
            yield f"{name}:{number}: a public header names detail"
        if NUMBER_POINTER.search(line) and not name.startswith("bindings/c/"):
            yield f"{name}:{number}: a public header has a pointer to numbers"


def check_tests(name, text):
    has_cases = False
    for number, line in enumerate(text.splitlines(), 1):
        has_cases = has_cases or line.startswith("TEST_CASE(")
        if re.match(r'TEST_CASE\("[^"]*;', line):
            yield f"{name}:{number}: a test case with a semicolon in its name"
        if line.startswith('TEST_CASE("-'):
            yield f"{name}:{number}: a test case whose name is an option to Catch"
    if name.startswith("tests/") and has_cases != name.endswith("_test.cpp"):
        yield f"{name}:1: a file is called *_test.cpp if it has test cases, and only then"


def check_widths(root):
    """Lines of docs, but for tables, links and what stands in a block of code."""
    for path in sorted([*root.glob("docs/*.md"), *root.glob("*.md")]):
        is_code = False
        for number, line in enumerate(path.read_text().splitlines(), 1):
            is_code ^= line.startswith("```")
            if len(line) > 100 and not is_code and not line.startswith(("|", "![", "    ")):
                yield f"{path.relative_to(root)}:{number}: a line of {len(line)} columns, more than 100"


def circles(edges):
    """Rooms that include each other in a circle, each circle once, as `a -> b -> a`."""
    reached = {}
    for start in edges:
        seen, todo = set(), [start]
        while todo:
            todo += [room for room in edges.get(todo.pop(), ()) if room not in seen and not seen.add(room)]
        reached[start] = seen
    told = set()
    for room in sorted(edges):
        circle = sorted(other for other in reached[room] if room in reached.get(other, ()))
        if circle and circle[0] not in told:
            told |= set(circle)
            yield " -> ".join(circle + circle[:1])


def words(name):
    """BoxTree2D -> box_tree2_d."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def classes_in(text):
    """The classes whose member functions a .cpp defines. A nested class belongs to the outermost one."""
    for match in MEMBER.finditer(code_only(text)):
        scopes = [scope for scope in match[1].split("::") if scope and scope[0].isupper()]
        if scopes:
            yield scopes[0]


def check_classes(homes):
    """`homes`: for each (room, class) the files with its member functions."""
    for (_, owner), files in sorted(homes.items()):
        strangers = [name for name in sorted(files) if words(owner) not in Path(name).stem]
        if len(files) > 1 and strangers:
            yield f"{strangers[0]}:1: {owner} is spread over {len(files)} files, and this one does not bear its name"


def sources(root):
    """(path from the root, text) of each source file."""
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[hc]*")):
            if path.suffix in (".h", ".cpp"):
                yield path.relative_to(root).as_posix(), path.read_text()


def check(root):
    public = public_headers(root)
    seen_by = {}  # the first file of shade that includes a library of pictures
    edges, homes, files_in = defaultdict(set), defaultdict(set), defaultdict(int)
    for name, text in sources(root):
        header = name[:-4] + ".h" if name.endswith(".cpp") else None
        own_header = header if header and (root / header).exists() else None
        yield from check_includes(name, text, own_header, public)
        yield from check_tests(name, text)
        if name in public:
            yield from check_public(name, text)
        if room := room_of(name):
            files_in[folder_of(name, room)] += 1
            edges[room] |= {other for _, _, path in includes(text) if (other := room_of(path)) and other != room}
        if name.endswith(".cpp") and name.split("/")[0] in MODULES:
            for owner in classes_in(text):
                homes[room, owner].add(name)
        for library in {picture_library(target) for _, _, target in includes(text)} - {None}:
            if name.startswith("shade/") and seen_by.setdefault(library, name) != name:
                yield f"{name}:1: {library} is seen by {seen_by[library]} already"
    for circle in circles(edges):
        yield f"{circle.split()[0]}:1: rooms include each other: {circle}"
    for room, count in sorted(files_in.items()):
        if count > MOST_FILES:
            yield f"{room}:1: a room of {count} files, more than {MOST_FILES}"
    yield from check_classes(homes)
    yield from check_widths(root)
    for header in sorted(public):
        if not (root / header).exists():
            yield f"{header}:1: listed as a public header, but there is none"


def sizes(root):
    for name, text in sources(root):
        if (lines := len(text.splitlines())) > LONG_FILE:
            yield f"{name}:1: {lines} lines"
        for first, last in functions(text):
            if last - first + 1 > LONG_FUNCTION:
                yield f"{name}:{first}: a function of {last - first + 1} lines"


if __name__ == "__main__":
    asked = sizes if "--sizes" in sys.argv else check
    found = list(asked(Path(next(argument for argument in sys.argv[1:] if not argument.startswith("--")))))
    print("\n".join(found))
    sys.exit(1 if found and asked is check else 0)
