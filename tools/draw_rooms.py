#!/usr/bin/env python3
"""Draws which room of the library includes which: docs/pictures/rooms.svg.

usage: draw_rooms.py [--check]

A room stands above those that it may include (tools/rooms.txt, docs/architecture.md). The picture is made of the
includes in include/ and src/ alone; how often one room includes another is told in four classes, so that it changes only
when the structure does. With --check nothing is written, and it is an error when the picture there is another.
"""
import collections
import html
import pathlib
import sys

from check_layering import ROOMS, ROOT, includes, room_of, sources

PICTURE = ROOT / "docs/pictures/rooms.svg"
# Included by nearly all: their arrows are drawn on the left, out of the way of the others.
FOUNDATION = {"core", "math"}
WORDS = {
    "core": "errors, status, threads, random numbers",
    "math": "vectors, poses, exact arithmetic",
    "shapes": "shapes and meshes as checked values",
    "narrow": "two convex things against each other",
    "bounds": "bounding volumes",
    "generate": "meshes and scenes made from a seed",
    "trees": "hierarchies and walks over them",
    "partitions": "grids, octrees, k-d trees, R-trees",
    "broad": "which of many boxes overlap",
    "query": "models, and the questions about them",
    "methods": "what is compared and taught, not production",
    "world": "bodies that move, step by step",
    "io": "files of meshes, scenes, poses",
    "robots": "links, joints, configurations, edges",
    "reports": "reports, pages, plots: a library of its own",
    "distributed": "worlds over MPI: a library of its own",
}
COLOURS = ["#4e79a7", "#b6672a", "#3f8f5b", "#b5454a", "#7b62a3", "#8c6d52", "#c2589a", "#5f6f7f", "#8a8a20", "#2f93a8",
           "#a0522d", "#55609c", "#404a57", "#7a8f3c", "#9c4f78", "#5b7f2b"]
# An upper limit of each class, and how thick its arrows are.
CLASSES = [(4, 1.2, "1 to 4 includes"), (16, 2.4, "5 to 16"), (64, 4.4, "17 to 64"), (None, 7.5, "65 or more")]

LEFT, WIDTH, HEIGHT, STEP, TOP = 330, 300, 52, 80, 96


def class_of(count):
    return next(i for i, (limit, _, _) in enumerate(CLASSES) if limit is None or count <= limit)


def count_includes():
    """How often a file of one room includes one of another, and the rooms that have files."""
    counts, rooms = collections.Counter(), set()
    for base in ["include/toccata", "src"]:
        for path in sources(base):
            parts = path.relative_to(ROOT / base).parts
            if len(parts) < 2:
                continue  # toccata.hpp
            rooms.add(parts[0])
            for quote, included in includes(path):
                other = room_of(included) if quote == '"' else None
                if other not in {None, parts[0]}:
                    counts[parts[0], other] += 1
    return counts, [room for room in reversed(ROOMS) if room in rooms]


class Arrows:
    """The arrows on one side of the rooms, and where each begins and ends: nested, so that few cross."""

    def __init__(self, pairs, rows, on_right):
        self.pairs, self.rows, self.on_right = pairs, rows, on_right
        self.begins, self.ends = {}, {}
        for room in rows:
            incoming = sorted((p for p in pairs if p[1] == room), key=self.span)
            outgoing = sorted((p for p in pairs if p[0] == room), key=self.span, reverse=True)
            places = len(incoming) + len(outgoing)
            for place, pair in enumerate(incoming + outgoing):
                y = self.top_of(room) + HEIGHT * (place + 0.75) / (places + 0.5)
                (self.ends if pair in incoming else self.begins)[pair] = y

    def span(self, pair):
        return self.rows.index(pair[1]) - self.rows.index(pair[0])

    def top_of(self, room):
        return TOP + STEP * self.rows.index(room)

    def drawn(self, pair, count):
        turn = 1 if self.on_right else -1
        kind = class_of(count)
        thickness, head = CLASSES[kind][1], 7 + CLASSES[kind][1]
        x = LEFT + WIDTH if self.on_right else LEFT
        begin, end = self.begins[pair], self.ends[pair]
        bulge = x + turn * (34 + 33 * self.span(pair))
        tip = x + turn * head
        colour = COLOURS[ROOMS.index(pair[0]) % len(COLOURS)]
        told = html.escape(f"{pair[0]} includes {pair[1]}: {CLASSES[kind][2]}")
        return (
            f'<g><title>{told}</title><path d="M {x} {begin:.1f} C {bulge} {begin:.1f}, {bulge} {end:.1f}, {tip:.1f} {end:.1f}" '
            f'fill="none" stroke="{colour}" stroke-width="{thickness}" stroke-opacity="0.75"/>'
            f'<path d="M {x} {end:.1f} L {tip:.1f} {end - head / 2:.1f} L {tip:.1f} {end + head / 2:.1f} Z" fill="{colour}"/></g>'
        )


def box(room, y):
    colour = COLOURS[ROOMS.index(room) % len(COLOURS)]
    middle = LEFT + WIDTH / 2
    return (
        f'<rect x="{LEFT}" y="{y}" width="{WIDTH}" height="{HEIGHT}" rx="6" fill="#ffffff" stroke="{colour}" stroke-width="2"/>'
        f'<text x="{middle}" y="{y + 22}" font-size="17" font-weight="bold" fill="{colour}">{room}</text>'
        f'<text x="{middle}" y="{y + 41}" font-size="13" fill="#444444">{html.escape(WORDS.get(room, ""))}</text>'
    )


def legend(y):
    """A sample of each class, below the rooms."""
    lines = []
    for i, (_, thickness, words) in enumerate(CLASSES):
        x = 110 + 210 * i
        lines.append(f'<path d="M {x} {y} H {x + 50}" stroke="#666666" stroke-width="{thickness}"/>')
        lines.append(f'<text x="{x + 60}" y="{y + 5}" font-size="14" fill="#333333" text-anchor="start">{words}</text>')
    return lines


def picture():
    counts, rows = count_includes()
    left = Arrows([p for p in counts if p[1] in FOUNDATION], rows, on_right=False)
    right = Arrows([p for p in counts if p[1] not in FOUNDATION], rows, on_right=True)
    height = TOP + STEP * len(rows) + 40
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="960" height="{height}" viewBox="0 0 960 {height}" '
        'font-family="DejaVu Sans, Verdana, sans-serif" text-anchor="middle">',
        f'<rect width="960" height="{height}" fill="#fbfbf8"/>',
        '<text x="480" y="34" font-size="20" font-weight="bold" fill="#222222">The rooms of the library, and which includes which</text>',
        f'<text x="160" y="68" font-size="14" fill="#333333">includes of core and math</text>',
        f'<text x="{LEFT + WIDTH + 150}" y="68" font-size="14" fill="#333333">includes of other rooms</text>',
    ]
    for arrows in [left, right]:
        for pair in sorted(arrows.pairs, key=lambda p: (-arrows.span(p), p)):
            lines.append(arrows.drawn(pair, counts[pair]))
    lines += [box(room, left.top_of(room)) for room in rows]
    lines += legend(height - 32)
    return "\n".join([*lines, "</svg>"]) + "\n"


def main():
    drawn = picture()
    if "--check" not in sys.argv[1:]:
        PICTURE.write_text(drawn)
        return 0
    if PICTURE.exists() and PICTURE.read_text() == drawn:
        print("the picture of the rooms is up to date")
        return 0
    print(f"{PICTURE.relative_to(ROOT)} is not that of today's includes: run tools/draw_rooms.py")
    return 1


if __name__ == "__main__":
    sys.exit(main())
