"""Draws globe.png, the world map on the sample globe: coastlines written down by hand in degrees, flat colours,
a graticule. Needs nothing but Python: python3 draw_globe.py"""

import pathlib
import struct
import zlib

WIDTH, HEIGHT, FINER = 1024, 512, 3  # drawn three times finer each way, then averaged

OCEAN, DEEP, LINE = (82, 147, 188), (62, 122, 168), (122, 176, 208)
LAND, FOREST, SAND, TUNDRA, ICE = (143, 184, 106), (94, 152, 88), (226, 201, 138), (190, 200, 170), (240, 244, 247)

COASTS = {
    "North America": "-168,66 -156,71 -128,70 -110,68 -95,72 -82,68 -94,60 -92,57 -82,55 -79,51 -78,56 -76,62 "
    "-68,59 -64,60 -56,52 -66,49 -60,46 -70,43 -74,40 -76,35 -81,31 -80,25 -82,29 -90,29 -97,27 -97,21 -91,18 "
    "-87,21 -88,16 -83,15 -83,10 -79,9 -77,8 -80,7 -84,9 -88,13 -95,16 -105,20 -112,29 -114,31 -110,23 -114,28 "
    "-117,33 -122,37 -124,43 -124,48 -130,54 -140,60 -150,60 -158,57 -164,55 -157,59 -165,62",
    "Greenland": "-46,60 -52,66 -55,70 -68,76 -60,82 -30,83 -18,80 -20,72 -32,68 -40,65",
    "South America": "-77,8 -72,12 -62,10 -52,5 -50,0 -35,-6 -39,-14 -41,-22 -48,-26 -54,-34 -58,-36 -62,-40 "
    "-66,-46 -69,-52 -74,-52 -74,-44 -72,-30 -70,-18 -76,-14 -81,-5 -80,1",
    "Africa": "-6,35 10,37 11,33 20,31 32,31 35,27 39,18 43,11 51,11 46,3 40,-4 40,-15 35,-20 35,-25 31,-30 "
    "26,-34 19,-34 15,-26 12,-16 13,-6 9,0 9,4 4,6 -4,5 -8,4 -13,9 -17,14 -16,21 -12,28 -9,32",
    "Eurasia": "-9,37 -9,43 -2,43 -1,46 -4,48 2,51 8,54 8,57 10,57 10,54 14,54 21,55 24,59 29,60 22,60 22,63 "
    "25,65 21,65 17,61 18,59 16,56 13,55 11,59 6,58 5,61 12,66 18,69 26,71 40,67 34,66 40,64 45,68 54,68 68,68 "
    "73,72 80,73 100,77 113,74 130,71 150,71 170,69 180,68 180,65 178,62 165,60 162,57 157,51 156,57 163,62 "
    "155,59 142,59 136,54 141,52 140,48 132,43 128,40 129,36 126,34 126,38 121,40 118,38 122,37 119,35 122,31 "
    "119,25 113,22 108,21 106,18 109,13 105,9 100,13 99,9 104,1 101,3 98,8 98,16 94,17 91,22 87,21 80,15 78,8 "
    "74,15 72,21 67,25 57,27 52,28 48,30 51,25 56,26 59,22 54,17 45,13 43,13 39,21 35,28 34,31 36,36 28,36 "
    "27,40 34,42 41,41 38,45 33,46 29,45 28,41 23,40 23,37 19,42 13,45 18,40 16,38 10,44 3,43 -1,38 -5,36",
    "Chukotka": "-180,68 -170,66 -173,64 -180,65",
    "Australia": "114,-22 122,-18 129,-15 136,-12 136,-15 140,-17 142,-11 146,-19 153,-25 151,-33 147,-38 "
    "140,-38 135,-34 129,-32 118,-35 115,-34",
    "Tasmania": "145,-41 148,-41 147,-44",
    "Great Britain": "-5,50 1,51 1,53 -2,56 -3,58 -6,57 -4,54 -4,52",
    "Ireland": "-10,52 -6,52 -6,55 -9,54",
    "Iceland": "-24,65 -22,64 -16,64 -14,65 -19,66",
    "Madagascar": "44,-25 47,-25 50,-16 49,-12 44,-17",
    "Japan": "130,32 136,34 140,35 142,40 145,43 141,45 140,41 137,37 132,35",
    "Sumatra": "95,5 104,-2 106,-6 102,-4 97,1",
    "Java": "105,-6 114,-7 114,-9 106,-8",
    "Borneo": "109,1 113,-3 117,-3 119,5 116,7 112,3",
    "Sulawesi": "119,-5 121,-1 125,1 121,1 119,-1",
    "Philippines": "120,18 122,18 125,8 124,6 122,9",
    "New Guinea": "131,-1 138,-2 147,-6 150,-10 143,-8 138,-8 133,-4",
    "New Zealand": "173,-35 178,-38 175,-41 171,-46 166,-46 172,-41 174,-38",
    "Cuba": "-85,22 -76,21 -75,20 -84,22",
    "Hispaniola": "-74,20 -69,19 -73,18",
    "Ceylon": "80,9 82,7 80,6",
    "Taiwan": "120,23 121,25 122,25 121,22",
    "Baffin": "-88,73 -80,73 -66,67 -66,62 -76,64 -84,70",
    "Victoria": "-116,73 -103,71 -105,69 -117,70",
    "Ellesmere": "-90,77 -64,82 -80,83 -92,81",
    "Spitsbergen": "12,79 25,80 17,77",
    "Novaya Zemlya": "52,71 57,70 68,76 60,76",
    "Antarctica": "-180,-78 -150,-76 -100,-73 -75,-71 -60,-64 -61,-74 -40,-78 -10,-71 40,-69 90,-66 135,-66 "
    "165,-71 180,-78 180,-90 -180,-90",
}
LAKES = ["47,45 53,46 54,41 53,37 49,37 49,41", "-92,47 -84,46 -82,43 -87,42 -87,45", "32,0 34,0 33,-3 31,-2"]
SANDS = [
    "-17,28 -6,31 10,33 32,30 35,27 37,20 30,15 10,15 -16,16", "36,31 48,30 56,23 54,17 45,13 39,21",
    "52,40 75,45 110,45 105,38 80,38 62,33 52,33", "116,-24 130,-19 141,-22 143,-31 128,-31 118,-29",
    "13,-17 20,-18 24,-27 17,-30 14,-24", "-116,40 -104,38 -102,27 -112,31", "-71,-5 -69,-25 -72,-30 -76,-14",
]
FORESTS = [
    "-80,5 -60,6 -48,-3 -52,-14 -66,-14 -76,-8", "9,5 20,6 28,3 31,-3 26,-8 16,-7 11,-2", "95,20 110,20 120,5 150,-10 95,-5",
    "-140,62 -118,64 -95,57 -75,58 -58,51 -68,46 -92,48 -108,53 -122,47", "10,61 30,66 60,64 100,67 132,64 142,56 120,52 90,56 60,55 30,58",
]


def points(text):
    return [tuple(float(x) for x in pair.split(",")) for pair in text.split()]


def fill(mask, outline):
    """Marks the pixels of a polygon in a coarse mask of rows of bytes, by the even-odd rule."""
    for row in range(HEIGHT * FINER):
        latitude = 90 - 180 * (row + 0.5) / (HEIGHT * FINER)
        crossings = []
        for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
            if (y0 <= latitude) != (y1 <= latitude):
                crossings.append(x0 + (latitude - y0) / (y1 - y0) * (x1 - x0))
        crossings.sort()
        for left, right in zip(crossings[::2], crossings[1::2]):
            begin = max(0, round((left + 180) / 360 * WIDTH * FINER))
            end = min(WIDTH * FINER, round((right + 180) / 360 * WIDTH * FINER))
            mask[row][begin:end] = b"\1" * max(0, end - begin)


def mask_of(outlines):
    mask = [bytearray(WIDTH * FINER) for _ in range(HEIGHT * FINER)]
    for text in outlines:
        fill(mask, points(text))
    return mask


def fine_rows():
    land, lakes = mask_of(COASTS.values()), mask_of(LAKES)
    sands, forests = mask_of(SANDS), mask_of(FORESTS)
    ice = mask_of([COASTS["Antarctica"], COASTS["Greenland"], COASTS["Ellesmere"], COASTS["Spitsbergen"]])
    for row in range(HEIGHT * FINER):
        latitude = 90 - 180 * (row + 0.5) / (HEIGHT * FINER)
        on_parallel = row % (HEIGHT * FINER // 6) < FINER
        plain = TUNDRA if abs(latitude) > 67 else LAND
        sea = OCEAN if abs(latitude) < 45 else DEEP
        colours = []
        for x in range(WIDTH * FINER):
            if land[row][x] and not lakes[row][x]:
                colours.append(ICE if ice[row][x] else SAND if sands[row][x] else
                               FOREST if forests[row][x] and plain is LAND else plain)
            elif latitude > 82:
                colours.append(ICE)
            else:
                colours.append(LINE if on_parallel or x % (WIDTH * FINER // 16) < FINER else sea)
        yield colours


def averaged():
    rows = []
    for colours in fine_rows():
        rows.append(colours)
        if len(rows) < FINER:
            continue
        line = bytearray(b"\0")
        for x in range(0, WIDTH * FINER, FINER):
            block = [c for r in rows for c in r[x:x + FINER]]
            line += bytes(sum(c[k] for c in block) // len(block) for k in range(3))
        yield bytes(line)
        rows = []


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)
png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
png += chunk(b"IDAT", zlib.compress(b"".join(averaged()), 9)) + chunk(b"IEND", b"")
pathlib.Path(__file__).with_name("globe.png").write_bytes(png)
