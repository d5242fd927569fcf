#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The standard scenes: made once here, written for csgcast or for POV-Ray, so that both draw the same solid in the same light.

usage: scenes.py NAME csg|pov > FILE
       scenes.py --list
"""
import math
import random
import sys
from dataclasses import dataclass



@dataclass
class Ball:
    center: tuple
    radius: float


@dataclass
class Box:
    lower: tuple
    upper: tuple


@dataclass
class Cone:
    """A frustum, or a cylinder, of `height` along +axis from the centre of its bottom."""
    bottom: tuple
    axis: int
    bottom_radius: float
    top_radius: float
    height: float


@dataclass
class Operation:
    name: str  # union, difference, intersection
    children: list


@dataclass
class Picture:
    """What a scene is, and from where and in what light it is seen. `fov` is vertical, in degrees; pictures are square."""
    solid: Operation
    eye: tuple = (4, -5, 3.5)
    look_at: tuple = (0, 0, 0)
    fov: float = 30
    light: tuple = (6, -4, 9)
    background: tuple = (.2, .3, .4)
    color: tuple = (.8, .6, .3)
    ambient: float = .15
    diffuse: float = .7
    specular: float = .3
    shininess: float = 40
    brightness: float = 1  # of the light


def union(*children):
    return Operation("union", list(children))


def intersection(*children):
    return Operation("intersection", list(children))


def difference(*children):
    return Operation("difference", list(children))


def cylinder(bottom, axis, radius, height):
    return Cone(bottom, axis, radius, radius, height)


def cube():
    return Box((-1, -1, -1), (1, 1, 1))


# The scenes.

def angel():
    """The textbook's: a cube, rounded by a ball, drilled along its axes."""
    drills = [cylinder(tuple(-2 if i == axis else 0 for i in range(3)), axis, .6, 4) for axis in range(3)]
    return Picture(difference(intersection(cube(), Ball((0, 0, 0), 1.35)), *drills))


def die():
    corners = [(-.55, -.55), (.55, .55), (-.55, .55), (.55, -.55)]
    faces = [  # axis and side, pips
        (0, 1, [(0, 0)]),
        (0, -1, [*corners, (-.55, 0), (.55, 0)]),
        (1, -1, corners[:2]),
        (1, 1, [*corners, (0, 0)]),
        (2, 1, [corners[0], (0, 0), corners[1]]),
        (2, -1, corners)]
    pips = []
    for axis, side, places in faces:
        for u, v in places:
            center = [0, 0, 0]
            center[axis], center[(axis + 1) % 3], center[(axis + 2) % 3] = side * 1.05, u, v
            pips.append(Ball(tuple(center), .2))
    return Picture(difference(intersection(cube(), Ball((0, 0, 0), 1.42)), *pips))


def sponge(level=3):
    """Menger's, as a cube less all its square bars."""
    bars = []
    for k in range(level):
        cells = 3 ** k
        width = 2.0 / cells
        starts = [-1 + width * (i + 1 / 3) for i in range(cells)]
        for a in starts:
            for b in starts:
                for axis in range(3):
                    lower, upper = [0, 0, 0], [0, 0, 0]
                    lower[axis], upper[axis] = -1.5, 1.5
                    for side, start in ((1, a), (2, b)):
                        lower[(axis + side) % 3], upper[(axis + side) % 3] = start, start + width / 3
                    bars.append(Box(tuple(lower), tuple(upper)))
    return Picture(difference(cube(), *bars))


def flange(bolts=12):
    """A machined part: boss, bore, keyway, chamfers, countersunk bolt holes, ribs."""
    holes = []
    for i in range(bolts):
        angle = 2 * math.pi * i / bolts
        x, y = round(1.5 * math.cos(angle), 9), round(1.5 * math.sin(angle), 9)
        holes += [cylinder((x, y, -.5), 2, .12, 2), Cone((x, y, .22), 2, .12, .25, .12)]
    disc = intersection(cylinder((0, 0, 0), 2, 1.9, .3), Ball((0, 0, -.9), 2.2))
    hub = union(cylinder((0, 0, .2), 2, .8, 1.0), Cone((0, 0, .3), 2, 1.1, .8, .3))
    cross = union(Box((-1.4, -.08, .2), (1.4, .08, .9)), Box((-.08, -1.4, .2), (.08, 1.4, .9)))
    ribs = intersection(cross, Cone((0, 0, .2), 2, 1.5, .5, .9))
    keyway = Box((-.1, .3, -1), (.1, .62, 3))
    bore = union(cylinder((0, 0, -1), 2, .45, 4), Cone((0, 0, 1.05), 2, .45, .65, .2), keyway)
    return Picture(difference(union(disc, hub, ribs), bore, union(*holes)), eye=(5, -6, 5), look_at=(0, 0, .3), fov=32)


def flush(n=6):
    """Coincident faces everywhere: bricks that touch, slots and holes that end flush with the surface."""
    cells = [(i, j) for i in range(n) for j in range(n)]
    bricks = [Box((i, j, 0), (i + 1, j + 1, 1)) for i, j in cells]
    slots = [Box((i + .25, 0, .5), (i + .75, n, 1)) for i in range(n)]
    holes = [cylinder((i + .5, j + .5, 0), 2, .2, 1) for i, j in cells]
    return Picture(difference(union(*bricks), *slots, *holes), eye=(14, -9, 11), look_at=(n / 2, n / 2, 0), fov=34,
                   light=(12, -6, 18))


def random_balls(count, seed):
    """Balls in a cube, their sizes such that they overlap now and then whatever their number."""
    random_number = random.Random(seed)
    balls = []
    for _ in range(count):
        center = tuple(round(random_number.uniform(-1, 1), 6) for _ in range(3))
        balls.append(Ball(center, round(random_number.uniform(.3, 1) * .9 / count ** (1 / 3), 6)))
    return balls


def balls(count):
    return Picture(union(*random_balls(count, 7)))


def swiss(count):
    return Picture(difference(cube(), *random_balls(count, 11)))


SCENES = {
    "angel": angel, "die": die, "flange": flange, "flush": flush,
    "sponge": sponge, "sponge2": lambda: sponge(2), "sponge4": lambda: sponge(4),
    "balls": lambda: balls(10000), "balls1k": lambda: balls(1000), "balls100k": lambda: balls(100000),
    "swiss": lambda: swiss(10000), "swiss1k": lambda: swiss(1000), "swiss100k": lambda: swiss(100000),
}


# The writers.

def numbers(values):
    """Decimals that read back to the same doubles."""
    return ", ".join(repr(float(value)) for value in values)


TURN_FROM_Z = ("[[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]",  # z to x
               "[[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]]")  # z to y


def csg_leaf(leaf):
    if isinstance(leaf, Ball):
        return f"translate([{numbers(leaf.center)}]) {{ sphere(r = {float(leaf.radius)}); }}"
    if isinstance(leaf, Box):
        size = [b - a for a, b in zip(leaf.lower, leaf.upper)]
        return f"translate([{numbers(leaf.lower)}]) {{ cube(size = [{numbers(size)}]); }}"
    cone = f"cylinder(h = {float(leaf.height)}, r1 = {float(leaf.bottom_radius)}, r2 = {float(leaf.top_radius)});"
    if leaf.axis < 2:
        cone = f"multmatrix({TURN_FROM_Z[leaf.axis]}) {{ {cone} }}"
    return f"translate([{numbers(leaf.bottom)}]) {{ {cone} }}"


def pov_leaf(leaf):
    if isinstance(leaf, Ball):
        return f"sphere {{ <{numbers(leaf.center)}>, {leaf.radius} }}"
    if isinstance(leaf, Box):
        return f"box {{ <{numbers(leaf.lower)}>, <{numbers(leaf.upper)}> }}"
    top = list(leaf.bottom)
    top[leaf.axis] += leaf.height
    if leaf.bottom_radius == leaf.top_radius:
        return f"cylinder {{ <{numbers(leaf.bottom)}>, <{numbers(top)}>, {leaf.bottom_radius} }}"
    return f"cone {{ <{numbers(leaf.bottom)}>, {leaf.bottom_radius}, <{numbers(top)}>, {leaf.top_radius} }}"


def lines(solid, brackets, write_leaf, depth):
    """The lines of a tree; these trees are a few levels deep, however wide."""
    indent = "  " * depth
    if not isinstance(solid, Operation):
        yield indent + write_leaf(solid)
        return
    yield f"{indent}{solid.name}{brackets} {{"
    for child in solid.children:
        yield from lines(child, brackets, write_leaf, depth + 1)
    yield indent + "}"


def csg(picture):
    p = picture
    return "\n".join([
        f"camera(eye = [{numbers(p.eye)}], look_at = [{numbers(p.look_at)}], up = [0, 0, 1], fov = {p.fov});",
        f"light(position = [{numbers(p.light)}], color = [1, 1, 1], intensity = {p.brightness});",
        f"background([{numbers(p.background)}]);",
        f"material(color = [{numbers(p.color)}], ambient = {p.ambient}, diffuse = {p.diffuse}, "
        f"specular = {p.specular}, shininess = {p.shininess}) {{",
        *lines(p.solid, "()", csg_leaf, 1), "}\n"])


def pov(picture):
    """POV-Ray's world is left-handed: a negative `right` turns it round. Its `angle` is horizontal, so pictures must be square."""
    p = picture
    return "\n".join([
        "#version 3.7;",
        "global_settings { assumed_gamma 1.0 max_trace_level 5 }",
        f"camera {{ location <{numbers(p.eye)}> sky z right -x up y angle {p.fov} look_at <{numbers(p.look_at)}> }}",
        f"light_source {{ <{numbers(p.light)}> color rgb {p.brightness} }}",
        f"background {{ color rgb <{numbers(p.background)}> }}",
        f"#default {{ texture {{ pigment {{ color rgb <{numbers(p.color)}> }} "
        f"finish {{ ambient {p.ambient} diffuse {p.diffuse} phong {p.specular} phong_size {p.shininess} }} }} }}",
        *lines(p.solid, "", pov_leaf, 0), ""])


WRITERS = {"csg": csg, "pov": pov}


def main(arguments):
    if arguments == ["--list"]:
        print(*SCENES)
    elif len(arguments) == 2 and arguments[0] in SCENES and arguments[1] in WRITERS:
        print(WRITERS[arguments[1]](SCENES[arguments[0]]()), end="")
    else:
        sys.exit(__doc__.strip())


if __name__ == "__main__":
    main(sys.argv[1:])
