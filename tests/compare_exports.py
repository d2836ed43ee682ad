#!/usr/bin/python3
# Holds the PDF, SVG and DXF of one net, all on one sheet without the net's numbers, against its FOLD file: page size, fonts,
# layers, closed outlines, lengths. Uses poppler, mupdf, librsvg and ezdxf. Prints a line "FAIL …" for each difference, "agree" at the end.
#   compare_exports.py FOLDER/net WIDTH_MM HEIGHT_MM
import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import ezdxf

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
POINT = 25.4 / 72

stem, width, height = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])


def expect(is_true, what):
    if not is_true:
        print("FAIL", what)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def around(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:] + points[:1]))


def same(a, b, tolerance):
    return len(a) == len(b) and all(abs(x - y) < tolerance for x, y in zip(sorted(a), sorted(b)))


fold = json.load(open(stem + ".fold"))
coords = fold["vertices_coords"]
edges = {"M": [], "V": []}
border = 0
for (a, b), letter, angle in zip(fold["edges_vertices"], fold["edges_assignment"], fold["edges_foldAngle"]):
    length = math.dist(coords[a], coords[b])
    if letter == "B":
        border += length
        expect(angle == 0, "a border edge is folded")
    elif abs(angle) > 1.001:  # flatter ones are not drawn
        expect((angle < 0) == (letter == "M"), f"{letter} has the angle {angle}")
        edges[letter].append(length)

# PDF
info = output("pdfinfo", stem + ".pdf")
size = re.search(r"Page size:\s+([\d.]+) x ([\d.]+) pts", info)
expect(abs(float(size[1]) * POINT - width) < 0.1 and abs(float(size[2]) * POINT - height) < 0.1, "poppler: page of " + size[0])
box = re.search(r'<MediaBox l="0" b="0" r="([\d.]+)" t="([\d.]+)"', output("mutool", "pages", stem + ".pdf"))
expect(abs(float(box[1]) * POINT - width) < 0.1 and abs(float(box[2]) * POINT - height) < 0.1, "mupdf: page of " + box[0])
fonts = output("pdffonts", stem + ".pdf").splitlines()[2:]
expect(fonts and all(re.search(r"\+.* yes yes yes +\d+ +\d+$", font) for font in fonts), f"a font is not an embedded subset: {fonts}")
strokes = []
for path in re.findall(r"<stroke_path(.*?)</stroke_path", output("mutool", "trace", stem + ".pdf"), re.S):
    points = [tuple(map(float, p)) for p in re.findall(r'(?:move|line)to x="([-\d.]+)" y="([-\d.]+)"', path)]
    strokes.append([(x * POINT, y * POINT) for x, y in points])
lines = [math.dist(*s) for s in strokes if len(s) == 2]
for length in edges["M"] + edges["V"]:
    expect(any(abs(line - length) < 0.1 for line in lines), f"PDF: no line of {length} mm")

# SVG
root = ElementTree.parse(stem + ".svg").getroot()
expect(root.get("viewBox") == f"0 0 {width:g} {height:g}" and root.get("width") == f"{width:g}mm", "SVG: " + str(root.attrib))
layers = {group.get(INKSCAPE + "label"): group for group in root.iter(SVG + "g")}
expect(sorted(layers) == ["Cut", "Fold Mountain", "Fold Tab", "Fold Valley", "Labels", "Print", "Regmarks"], f"SVG: {list(layers)}")


def svg_paths(layer):
    for path in layers[layer].iter(SVG + "path"):
        yield path.get("d"), [tuple(map(float, p)) for p in re.findall(r"([-\d.]+),([-\d.]+)", path.get("d"))]


outlines = []
for data, points in svg_paths("Cut"):
    expect(data.endswith("Z") and data.count("M") == 1, "SVG: an outline is not one closed path")
    outlines.append(points)
for layer, letter in (("Fold Mountain", "M"), ("Fold Valley", "V")):
    lengths = [math.dist(points[0], points[-1]) for _, points in svg_paths(layer)]
    expect(same(lengths, edges[letter], 1e-2), f"SVG: {layer} has {len(lengths)} lines, not those of the net")
for layer in ("Cut", "Fold Mountain", "Fold Valley", "Fold Tab"):
    colours = {re.search(r"stroke:(#\w+)", path.get("style"))[1] for path in layers[layer]}
    expect(len(colours) <= 1, f"SVG: {layer} has the colours {colours}")
output("rsvg-convert", "-o", stem + "_rsvg.png", stem + ".svg")

# DXF
document = ezdxf.readfile(stem + ".dxf")
expect(not document.audit().errors, "DXF: ezdxf finds errors")
expect(document.header["$INSUNITS"] == 4 and document.header["$MEASUREMENT"] == 1, "DXF: not in millimetres")
space = document.modelspace()
cut = list(space.query('*[layer=="CUT"]'))
expect(all(e.dxftype() == "POLYLINE" and e.is_closed for e in cut), "DXF: an outline is not one closed polyline")
turned = [[(p[0], height - p[1]) for p in e.points()] for e in cut]
expect(
    len(turned) == len(outlines)
    and all(len(a) == len(b) and all(math.dist(p, q) < 1e-3 for p, q in zip(a, b)) for a, b in zip(turned, outlines)),
    "DXF and SVG differ in their outlines",
)
length = sum(map(around, outlines))
expect(any(abs(around(s) - length) < 0.5 for s in strokes) or len(outlines) > 1, "PDF: no path as long as the outline")
print("outline", length, "border", border, "folds", len(edges["M"]), len(edges["V"]), "tabs", len(list(svg_paths("Fold Tab"))))
print("agree")
