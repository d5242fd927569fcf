#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes docs/api.md: what csgcast can be asked, and how that is called in C++, Python, C and on the command line.

Usage: table.py PROJECT_FOLDER            writes docs/api.md
       table.py --check PROJECT_FOLDER    prints what is wrong, and exits 1 if anything is

The names are found in the sources: model/model.h and the headers in HEADERS, bindings/python/csgcast/__init__.pyi,
bindings/c/csgcast.h, and the commands and options in cli/. ROWS says which of them are the same thing. Every name that is
found has to stand in a row, and every name in a row has to be found. A row without a name in a language has a reason
there.
"""
import ast
import re
import sys
from pathlib import Path

# Where functions of C++ are looked for that are no members of Model.
HEADERS = ["csg/exact/composition.h", "csg/solid/parts.h", "csg/solid/primitives.h", "csg/text/statement/builder.h",
           "csg/text/statement/solid_text.h", "csg/text/syntax/reader.h", "csg/text/syntax/writer.h", "measure/section_json.h",
           "measure/section_polylines.h", "measure/section_svg.h", "model/section_file.h", "model/section_image.h",
           "shade/picture/image_file.h"]
# What is declared there and helps others only.
HELPERS = {"unknown_part", "seen_rectangle", "unseen_tolerance", "check_image_path", "image_bytes"}
# Why a language has no name for a thing.
FOOTNOTES = {
    "text": "C and the command line take scene text, which has a statement for it: [scene.md](scene.md).",
    "all": "Every command does it.",
    "engines": "For engines and functions of other modules; other languages ask the model itself.",
    "kept": "A model keeps them for its pictures.",
    "packages": "The package tells it: CMake's `csgcast_VERSION`, or `pkg-config --modversion csgcast-model`.",
    "sums": "The sum of exit - entry over a ray's intervals; awk does it for CSV: [cli.md](cli.md#intervals).",
    "arcs": "The command writes exact arcs; the libraries cut them into chords.",
    "file": "The command writes a file; with `-o -` to standard output.",
    "languages": "A command line has its exit code and its messages.",
    "verify": "It is for who works on csgcast; `verify/verification.h` has it.",
    "map": "The command makes a picture of it; rays, and `measure/thickness.h`, give the numbers.",
    "map_only": "The command draws a map of it, with the rays of a camera.",
    "options": "`RenderOptions::region` asks for it.",
    "channels": "Python and C make each channel as a picture of its own (`mode`).",
    "distributed": "`csgcast.distributed`: [distributed.md](distributed.md).",
    "python": "Python does that: [distributed.md](distributed.md).",
    "shell": "That is a matter of the shell.",
}

# (what, C++, Python, C, command line): names, or "!reason".
ROWS = [
    ("Solids", None),
    ("box, ball, cylinder or cone", ["box", "sphere", "cylinder"], ["box", "sphere", "cylinder"], "!text", "!text"),
    ("other quadrics", ["ellipsoid", "paraboloid", "hyperboloid", "quadric"],
     ["ellipsoid", "paraboloid", "hyperboloid", "quadric"], "!text", "!text"),
    ("half-space, convex polyhedron", ["halfspace", "convex_from_planes", "convex_from_points"], ["halfspace", "convex"], "!text",
     "!text"),
    ("nothing, everything", ["Solid", "Solid::everything"], ["Solid", "empty", "everything"], "!text", "!text"),
    ("union, intersection, difference, complement", ["unite", "intersect", "subtract", "complement"],
     ["union", "intersection", "difference", "complement"], "!text", "!text"),
    ("move, turn, scale, mirror", ["transformed", "translation", "rotation", "scaling", "mirroring", "operator*"],
     ["Solid.transform", "Solid.translate", "Solid.rotate", "Solid.scale", "Solid.mirror"], "!text", "!text"),
    ("a named part with a density", ["named"], ["Solid.part"], "!text", "!text"),
    ("color and material", ["with_look"], ["Solid.color", "Solid.material"], "!text", "!text"),
    ("names of a solid's parts; parts alone", ["part_names", "only_parts"],
     ["Solid.parts", "Solid.only", "Scene.parts", "Scene.only"], ["csgcast_options"], ["--part"]),
    ("bounds of a solid", ["bounds"], ["Solid.bounds"], ["csgcast_bounds"], ["info"]),
    ("Scene texts", None),
    ("read a file, or text", ["read_file", "read", "build", "is_unsupported"], ["load", "read"],
     ["csgcast_load", "csgcast_read", "csgcast_load_with", "csgcast_read_with"], "!all"),
    ("what a text holds", ["SceneDescription"],
     ["Scene", "Scene.solid", "Scene.camera", "Scene.lights", "Scene.background", "Scene.settings", "Scene.warnings"], "!kept",
     ["info"]),
    ("write a solid as a text", ["document_of", "write"], ["Solid.to_text", "save"], "!text", "!text"),
    ("Models", None),
    ("make a solid ready for questions", ["Model::Model"], ["Model", "Solid.compile", "Scene.compile"],
     ["csgcast_load", "csgcast_free"], "!all"),
    ("the scene and its cells, for engines", ["Model::scene", "Model::cells"], "!engines", "!engines", "!engines"),
    ("how large it is", ["Model::counts"], ["Model.counts"], ["csgcast_count"], ["info"]),
    ("its bounds", ["Model::bounds"], ["Model.bounds"], ["csgcast_bounds"], ["info"]),
    ("its parts", ["Model::part_names"], ["Model.parts"],
     ["csgcast_part_count", "csgcast_part_name", "csgcast_part_density"], ["info"]),
    ("the name of a leaf", ["Model::leaf_name"], ["Model.leaf"], ["csgcast_leaf_name"], ["intervals"]),
    ("Rays and points", None),
    ("all intervals of rays", ["Model::intervals"], ["Model.intervals", "Intervals", "Intervals.of"],
     ["csgcast_cast", "csgcast_free_intervals"], ["intervals"]),
    ("how long each ray is inside", "!sums", ["Intervals.lengths_per_ray"], "!sums", "!sums"),
    ("where rays first cross the boundary", ["Model::first_hits"], ["Model.first_hits", "Hits"], ["csgcast_first_hits"],
     ["intervals"]),
    ("whether rays meet the inside", ["Model::any_hits"], ["Model.any_hits"], ["csgcast_any_hits"], ["intervals"]),
    ("whether points are inside", ["Model::locate"], ["Model.locate"], ["csgcast_locate"], ["locate"]),
    ("how thick the solid is where rays enter", ["Model::thickness"], ["Model.thickness"], ["csgcast_thickness"], "!map_only"),
    ("Measures", None),
    ("volume, area, mass, centroid, inertia, bounds", ["Model::measure"], ["Model.measure", "Measures"],
     ["csgcast_measure", "csgcast_measure_parts"], ["measure"]),
    ("a section", ["Model::section"], ["Model.section", "Section"], ["csgcast_cut", "csgcast_free_section"], ["section"]),
    ("a section as a drawing", ["section_svg"], ["Section.svg"], ["csgcast_section_svg"], ["section"]),
    ("a section as JSON", ["section_json"], ["Section.json"], ["csgcast_section_json"], ["section"]),
    ("a section as polylines", ["section_polylines"], ["Section.polyline"], ["csgcast_section_polylines"], "!arcs"),
    ("a section as a file", ["write_section", "section_image"], ["Section.save"], ["csgcast_write_section"], ["section"]),
    ("the thinnest wall", ["Model::thinnest"], ["Model.thinnest"], ["csgcast_thinnest"], ["thickness"]),
    ("a map of thickness", "!map", "!map", "!map", ["thickness"]),
    ("what may be wrong with a solid", ["Model::check"], ["Model.check", "Check"], ["csgcast_check", "csgcast_free_report"],
     ["check"]),
    ("Pictures", None),
    ("a picture in memory", ["Model::render"], ["Model.render"], ["csgcast_render", "csgcast_channels"], "!file"),
    ("a picture as a file", ["write_image"], ["Model.render"], ["csgcast_render_file"], ["render"]),
    ("a part of a picture", "!options", ["tile=", "region="], "!python", ["--tiles", "join"]),
    ("many channels in one picture; transparency", ["layer_bytes", "holds_layers"], "!channels", "!channels", ["--channels", "--alpha", "--bits"]),
    ("camera, lights, background, settings", ["Model::view"], ["Camera", "Light", "Settings"],
     ["csgcast_render_options"], ["--camera"]),
    ("Calls", None),
    ("how many threads work", ["on_threads"], ["threads="], ["csgcast_use_threads"], ["--threads"]),
    ("what went wrong", ["Error"], ["Error"], ["csgcast_last_error"], "!languages"),
    ("progress, and the end of a call", ["ProgressCallback", "Cancelled"], ["progress=", "Cancelled"], ["csgcast_monitor"],
     "!shell"),
    ("the version", "!packages", ["__version__"], ["csgcast_version"], ["--version"]),
    ("help", "!packages", "!packages", "!packages", ["help"]),
    ("many machines", "!python", "!distributed", "!python", ["--rows", "--tiles", "join"]),
    ("compare the answers with exact arithmetic", "!verify", "!verify", "!verify", ["verify"]),
]
COLUMNS = ["C++", "Python", "C", "command line"]

HEAD = """# Every call, in C++, Python, C and on the command line

<!-- Made by tests/api/table.py from the sources; change the rows there. -->

What csgcast can be asked, and what that is called. C++ names are in namespace `csgcast`; `Model` is
in `model/model.h`, and links everything. Python names are in the module `csgcast`. C names are in
`csgcast.h`. A number refers to the reasons below the tables.
[building.md](building.md#progress-and-cancelling) shows how C++ and C cancel a call.
"""


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


def cpp_names(root):
    text = without_comments((root / "model/model.h").read_text())
    public = re.search(r"^class Model \{\n public:(.*?)^ private:", text, re.S | re.M)[1]
    names = {f"Model::{name}" for name in re.findall(r"(~?\w+)\([^()]*(?:\([^()]*\)[^()]*)*\)(?: const| noexcept)?;", public)}
    names -= {"Model::~Model"}
    for header in HEADERS:
        for name in re.findall(r"^[A-Za-z_][\w:<>,&* ]*?[ *&](operator\W+?|\w+)\(", without_comments((root / header).read_text()), re.M):
            names.add(name)
    return names - HELPERS


def cpp_others(root):
    """What rows may name besides: types, and functions of headers that declare much else."""
    found = set()
    for header in ["csg/solid/solid.h", "csg/base/transform.h", "csg/solid/scene_description.h", "csg/base/error.h", "csg/base/progress.h",
                   "csg/solid/bounds.h", "raycast/packets/threads.h"]:
        text = without_comments((root / header).read_text())
        found |= set(re.findall(r"^(?:class|struct) (\w+)", text, re.M)) | set(re.findall(r"^using (\w+) =", text, re.M))
        found |= set(re.findall(r"^[A-Za-z_][\w:<>,&* ]*?[ *&](\w+)\(", text, re.M))
        found |= {f"Solid::{name}" for name in re.findall(r"^  static Solid (\w+)\(", text, re.M)}
    return found


def python_names(root):
    """Names, and the parameters `name=` of Model's methods."""
    names, parameters = set(), set()
    for node in ast.parse((root / "bindings/python/csgcast/__init__.pyi").read_text()).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        if isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
        if isinstance(node, ast.ClassDef):
            methods = [inner for inner in node.body if isinstance(inner, ast.FunctionDef)]
            names |= {f"{node.name}.{inner.name}" for inner in methods if not inner.name.startswith("_")}
            parameters |= {f"{a.arg}=" for inner in methods if node.name == "Model" for a in inner.args.kwonlyargs}
    return names, parameters


def c_names(root):
    """Functions, and structs."""
    text = without_comments((root / "bindings/c/csgcast.h").read_text())
    return set(re.findall(r"^[\w* ]+?\b(csgcast_\w+)\(", text, re.M)), set(re.findall(r"^typedef struct (csgcast_\w+) \{", text, re.M))


def command_names(root):
    """Commands, and options."""
    texts = [path.read_text() for path in sorted((root / "cli").rglob("*.cpp"))]
    return {name for text in texts for name in re.findall(r'Command command\{\s*\.name = "([\w-]+)"', text)}, \
        {name for text in texts for name in re.findall(r'"(?:-\w,)?(--[\w-]+)[,"]', text)}


def faults(root):
    python, parameters = python_names(root)
    functions, structs = c_names(root)
    commands, options = command_names(root)
    needed = [cpp_names(root), python, functions, commands]
    allowed = [needed[0] | cpp_others(root), python | parameters, functions | structs, commands | options]
    rows = [row for row in ROWS if row[1] is not None]
    for column, title in enumerate(COLUMNS):
        named = [name for row in rows if not isinstance(row[1 + column], str) for name in row[1 + column]]
        yield from (f"{title}: {name} stands in no row of tests/api/table.py" for name in sorted(needed[column] - set(named)))
        yield from (f"{title}: the sources have no {name}" for name in sorted(set(named) - allowed[column]))
        for row in rows:
            if isinstance(row[1 + column], str) and row[1 + column][1:] not in FOOTNOTES:
                yield f"{title}: '{row[0]}' has neither a name nor a reason"
            elif not row[1 + column]:
                yield f"{title}: '{row[0]}' has no name"
    used = {row[1 + column][1:] for row in rows for column in range(4) if isinstance(row[1 + column], str)}
    yield from (f"the reason '{reason}' is not used" for reason in FOOTNOTES if reason not in used)


def page():
    numbers = {}

    def cell(content, column):
        if isinstance(content, str):
            return f"({numbers.setdefault(content[1:], len(numbers) + 1)})"
        prefix = "csgcast " if column == 3 else ""
        return ", ".join(f"`{name if name.startswith('-') else prefix + name}`" for name in content)

    lines = []
    for row in ROWS:
        if row[1] is None:
            lines += ["", f"## {row[0]}", "", f"| what | {' | '.join(COLUMNS)} |", "|---|---|---|---|---|"]
        else:
            lines.append(f"| {row[0]} | {' | '.join(cell(content, i) for i, content in enumerate(row[1:]))} |")
    reasons = [f"{number}. {FOOTNOTES[reason]}" for reason, number in numbers.items()]
    return HEAD + "\n".join(lines) + "\n\n## Reasons\n\n" + "\n".join(reasons) + "\n"


def main(arguments):
    checks = "--check" in arguments
    root = Path(next(argument for argument in arguments if not argument.startswith("--")))
    found = list(faults(root))
    target = root / "docs/api.md"
    if checks and (not target.exists() or target.read_text() != page()):
        found.append("docs/api.md is out of date: run tests/api/table.py")
    print("\n".join(found), end="\n" if found else "")
    if not checks and not found:
        target.write_text(page())
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
