#!/usr/bin/python3
# Reads a DXF file with ezdxf, audits it and tells what it holds, one line per fact, for write_dxf_test.cpp:
#   units N / errors N / layer NAME / shape LAYER KIND is_closed n_points length left bottom right top / text LAYER height WORDS
import math
import sys

import ezdxf

document = ezdxf.readfile(sys.argv[1])
print("units", document.header.get("$INSUNITS", 0))
print("errors", len(document.audit().errors))
for layer in document.layers:
    print("layer", layer.dxf.name)
for entity in document.modelspace():
    kind = entity.dxftype()
    if kind == "TEXT":
        print("text", entity.dxf.layer, entity.dxf.height, entity.dxf.text)
        continue
    if kind == "LINE":
        points = [entity.dxf.start, entity.dxf.end]
        is_closed = False
    else:
        points = list(entity.points())
        is_closed = entity.is_closed
    ring = points + points[:1] if is_closed else points
    length = sum(math.dist(a, b) for a, b in zip(ring, ring[1:]))
    xs = [p[0] for p in points]
    ys = [p[1] for p in points]
    print("shape", entity.dxf.layer, kind, int(is_closed), len(points), repr(length), min(xs), min(ys), max(xs), max(ys))
