#!/usr/bin/env python3
# A person's whole session in the real window under Xvfb, with mouse and keys alone: open, pin, run, compare, accept, cut
# and join by hand, solve the rest, undo and redo everything, save, die in the middle of a change, recover, export. What
# comes out is proved by netwright-cli, and the pins are looked for in the files. Where to click is read from what
# --tell-widgets reports. Usage: window_session.py NETWRIGHT NETWRIGHT-CLI MODEL.obj. Ends with 77 where tools are missing.
import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zipfile

PATIENCE = 240  # seconds for anything that is awaited; an idle machine needs a few at most


def fail(what):
    sys.exit("failed: " + what)


def await_that(what, holds):
    """Until it holds; what it returns then."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = holds()
        if found:
            return found
        time.sleep(0.03)
    fail(what)


class Screen:
    """An X server of its own. Two that start at once could pick the same number, so they queue."""

    def __enter__(self):
        with open(os.path.join(tempfile.gettempdir(), "netwright_smoke_test.lock"), "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            reading, writing = os.pipe()
            self.server = subprocess.Popen(
                ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"],
                pass_fds=[writing], stderr=subprocess.DEVNULL)
            os.close(writing)
            number = os.read(reading, 16).decode().strip()
            time.sleep(1)
        os.environ["DISPLAY"] = ":" + number
        return self

    def __exit__(self, *_):
        self.server.kill()
        self.server.wait()


class Editor:
    """The program, what it tells, and a person's two hands."""

    def __init__(self, program, folder, *arguments):
        self.told = os.path.join(folder, "told")
        self.process = subprocess.Popen([program, "--tell-widgets", self.told, "--size", "1500x940", *arguments])
        self.lines()

    def lines(self):
        if self.process.poll() is not None:
            fail(f"the program ended by itself with {self.process.returncode}")
        if not os.path.exists(self.told):
            return []
        with open(self.told, encoding="utf-8") as file:
            return [line.rstrip("\n").split("\t") for line in file]

    def all(self, kind):
        return [line[1:] for line in self.lines() if line[0] == kind]

    def title(self):
        return " ".join(self.all("title")[0]) if self.all("title") else ""

    def await_title(self, words):
        await_that(f"the title says “{words}”, not “{self.title()}”", lambda: words in self.title())

    def await_net(self):
        """A replay for the eyes is watched to its end."""
        await_that("one piece is found and proved", lambda: "– one piece, proved –" in self.title())

    def widget(self, name, state="on"):
        """Its middle, once it is there in that state and lies still."""

        def rect():
            return [w[1:] for w in self.all("widget") if w[0] == name and w[5] == state]

        def still():
            before = rect()
            time.sleep(0.1)
            return before and before == rect() and before[0]

        x, y, width, height, _ = await_that(f"the widget {name} is {state}", still)
        return int(x) + int(width) // 2, int(y) + int(height) // 2

    def steps(self):
        return [int(n) for n in self.all("step")[0]] if self.all("step") else [0, 0]

    def faces(self, view):
        return [dict(zip(("number", "x", "y"), line)) for line in self.all(view + "-face")]

    def edges(self, view, **wanted):
        keys = ("number", "x", "y", "kind", "pin", "face", "other")
        edges = [dict(zip(keys, line)) for line in self.all(view + "-edge")]
        return [e for e in edges if all(e[k] == v for k, v in wanted.items())]

    @staticmethod
    def xdotool(*words):
        subprocess.run(["xdotool", *(str(word) for word in words)], check=True)

    def key(self, keys):
        self.xdotool("key", "--delay", 60, keys)

    def point(self, x, y):
        self.xdotool("mousemove", x, y)

    def into_view(self, name, state="on"):
        """Turns the wheel over the panel at the left until the widget is between the toolbar and the status bar."""
        top, bottom = 120, 880
        for _ in range(60):
            x, y = self.widget(name, state)
            if top < y < bottom:
                return x, y
            self.point(5, 500)
            self.xdotool("click", 5 if y >= bottom else 4)
            time.sleep(0.2)
        fail(f"{name} does not come into view")

    def click_in_panel(self, name):
        self.point(*self.into_view(name))
        time.sleep(0.15)
        self.press()

    def click(self, name):
        self.point(*self.widget(name))
        time.sleep(0.15)
        self.press()

    def press(self):
        self.xdotool("mousedown", 1)
        time.sleep(0.1)
        self.xdotool("mouseup", 1)

    def point_at(self, view, kind, choose):
        """Moves the pointer to what is chosen and waits until the window means just that. Pictures move by themselves,
        when pages are laid out, so each try chooses anew. What was chosen at last."""

        def meant():
            chosen = choose()
            if chosen is None:
                return None
            x, y = int(chosen["x"]), int(chosen["y"])
            self.xdotool("mousemove", x + 1, y, "mousemove", x, y)
            time.sleep(0.2)
            is_still = any(line[:3] == [chosen["number"], str(x), str(y)] for line in self.all(f"{view}-{kind}"))
            is_still = is_still and self.all("laying-out") == [["no"]]
            return chosen if is_still and [chosen["number"]] in self.all("hovered-" + kind) else None

        return await_that(f"the wanted {kind} of the {view} is under the pointer", meant)

    def make_step(self, what, do):
        """Does something that is one undo step."""
        before = self.steps()[0]
        do()
        await_that(f"{what} is one step of the history", lambda: self.steps() == [before + 1, before + 1])

    def die(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()
        os.remove(self.told)


def middlemost(places):
    """The place nearest to the middle of all; none of none."""
    middle = [sum(int(p[axis]) for p in places) / max(len(places), 1) for axis in ("x", "y")]
    away = lambda p: (int(p["x"]) - middle[0]) ** 2 + (int(p["y"]) - middle[1]) ** 2
    return min(places, key=away, default=None)


def apart(edges, taken):
    """The middlemost edge that has no face in common with those taken."""
    faces = {f for e in taken for f in (e["face"], e["other"])}
    return middlemost([e for e in edges if e["kind"] != "border" and not faces & {e["face"], e["other"]}])


def sides(edge):
    return frozenset((int(edge["face"]) - 1, int(edge["other"]) - 1))


def pins_shown(editor):
    """How many folds and cuts are pinned in the model's view."""
    return [len({e["number"] for e in editor.edges("model", pin=pin)}) for pin in ("fold", "cut")]


def pin_all(editor):
    """Root, three folds, two cuts, in the model's view."""
    root = editor.point_at("model", "face", lambda: middlemost(editor.faces("model")))
    editor.make_step("the pinned root", lambda: editor.key("r"))
    chosen = []
    for pin, key in (("fold", "g"), ("fold", "g"), ("fold", "g"), ("cut", "c"), ("cut", "c")):
        edge = editor.point_at("model", "edge", lambda: apart(editor.edges("model"), chosen))
        chosen.append(edge)
        editor.make_step(f"the edge that must be a {pin}", lambda: editor.key(key))
        await_that("the pin is shown", lambda: editor.edges("model", number=edge["number"], pin=pin))
    return int(root["number"]) - 1, {sides(e) for e in chosen[:3]}, {sides(e) for e in chosen[3:]}


def compare_runs(editor):
    editor.make_step("the net of the first run", lambda: editor.key("space"))
    editor.await_net()
    editor.make_step("the net of the second run", lambda: editor.key("n"))
    editor.await_net()
    for run, state in (("runs/1", "on"), ("runs/2", "off"), ("runs/1", "on")):
        editor.click_in_panel(run)
        editor.await_title("run " + run[-1])
        editor.widget("runs/accept", state)
    editor.make_step("the accepted run", lambda: editor.click_in_panel("runs/accept"))
    editor.widget("runs/accept", "off")


def edit_by_hand(editor):
    """Cuts a fold, joins a cut; the rest is solved around both. Their faces."""
    editor.click("toolbar/Join and cut")
    pinned = [e for pin in ("fold", "cut") for e in editor.edges("model", pin=pin)]

    def point_at_a(kind, taken):
        return editor.point_at("net", "edge", lambda: apart(editor.edges("net", kind=kind, pin="none"), taken))

    cut = point_at_a("fold", pinned)
    editor.make_step("the cut by hand", editor.press)
    editor.await_title("2 pieces")
    joined = point_at_a("cut", pinned + [cut])
    editor.make_step("the join by hand", editor.press)
    await_that("the joined edge is a fold", lambda: editor.edges("net", number=joined["number"], kind="fold"))
    editor.key("Escape")
    editor.make_step("solving the rest", lambda: editor.key("shift+space"))
    editor.await_net()
    return sides(cut), sides(joined)


def undo_and_redo_all(editor):
    count = editor.steps()[1]
    for k in range(count, 0, -1):
        editor.key("ctrl+z")
        await_that(f"step {k} is undone", lambda: editor.steps() == [k - 1, count])
    editor.await_title("ready to unfold")
    if pins_shown(editor) != [0, 0]:
        fail("pins are left after everything was undone")
    editor.widget("toolbar/Undo", "off")
    for k in range(1, count + 1):
        editor.key("ctrl+y")
        await_that(f"step {k} is redone", lambda: editor.steps() == [k, count])
    editor.await_net()
    if pins_shown(editor) != [3, 2]:
        fail("not all pins are back after everything was redone")
    editor.widget("toolbar/Redo", "off")


def stored(path):
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("project.json"))


def pinned_corners(project, word):
    """Edges are stored as faces and their corners in turn."""
    flat = project["pins"][word]
    return list(zip(flat[::2], flat[1::2]))


def save(editor, path):
    editor.key("ctrl+s")
    editor.widget("browser/name")
    editor.key("Return")
    await_that("the project is saved", lambda: os.path.exists(path) and "•" not in editor.title())


def die_in_a_change(editor, folder):
    """A fourth pinned fold, of a cut so that the net must change, is autosaved when the program dies with a branch in hand."""
    taken = [e for pin in ("fold", "cut") for e in editor.edges("model", pin=pin)]
    edge = editor.point_at("model", "edge", lambda: apart(editor.edges("model", kind="cut", pin="none"), taken))
    editor.make_step("the fourth fold", lambda: editor.key("g"))
    editor.make_step("the net under all pins", lambda: editor.key("shift+space"))
    editor.await_net()

    def is_kept():
        files = [os.path.join(folder, name) for name in os.listdir(folder)] if os.path.isdir(folder) else []
        kept = [stored(file) for file in files if zipfile.is_zipfile(file)]
        return any(len(pinned_corners(k, "must_fold")) == 4 and k["run"]["proved"] for k in kept)

    await_that("the finished run is autosaved", is_kept)
    editor.click("toolbar/Join and cut")
    face = editor.point_at("net", "face", lambda: next(iter(editor.faces("net")), None))
    editor.xdotool("mousedown", 1)
    for k in range(1, 6):
        editor.xdotool("mousemove", int(face["x"]) + 12 * k, int(face["y"]) + 8 * k)
        time.sleep(0.1)
    editor.die()
    return sides(edge)


def export(editor, path, *items):
    for item in ("File", *items):
        editor.click("menu/" + item)
    editor.widget("browser/name")
    editor.key("Return")
    await_that(f"{path} is exported", lambda: os.path.exists(path) and os.path.getsize(path) > 0)


def faces_of_obj(path):
    with open(path, encoding="utf-8") as file:
        rows = [line.split()[1:] for line in file if line.startswith("f ")]
    return [[int(corner.split("/")[0]) - 1 for corner in row] for row in rows]


def side_of(polygon, corner):
    return frozenset((polygon[corner], polygon[(corner + 1) % len(polygon)]))


def pairs(faces):
    """Which faces share an edge, and which edge that is."""
    owners = {}
    for number, polygon in enumerate(faces):
        for corner in range(len(polygon)):
            owners.setdefault(side_of(polygon, corner), []).append(number)
    return {edge: frozenset(both) for edge, both in owners.items() if len(both) == 2}


def check(cli, fold, project, model, pins):
    """The files alone: is it a net, and does it keep every pin?"""
    root, folds, cuts = pins
    for path in (fold, project):
        verdict = json.loads(subprocess.run([cli, "verify", path, "--json"], check=True, capture_output=True).stdout)
        if not verdict["verified"] or verdict["pieces"] != 1 or verdict["overlaps"] != 0:
            fail(f"{path} is no proved net in one piece: {verdict}")
    with open(fold, encoding="utf-8") as file:
        net = json.load(file)
    assignment = {frozenset(edge): kind for edge, kind in zip(net["edges_vertices"], net["edges_assignment"])}
    folded = {both for edge, both in pairs(net["faces_vertices"]).items() if assignment[edge] in "MVF"}
    faces = faces_of_obj(model)
    if len(net["faces_vertices"]) != len(faces):
        fail("the net has other faces than the model")
    if not folds <= folded:
        fail(f"pinned folds are cut in the exported net: {folds - folded}")
    if not cuts <= set(pairs(faces).values()) - folded:
        fail("pinned cuts are folds in the exported net")
    kept = stored(project)
    of_corner = pairs(faces)

    def pinned(word):
        return {of_corner[side_of(faces[f], c)] for f, c in pinned_corners(kept, word)}

    if kept["pins"]["root"] != root or pinned("must_fold") != folds or pinned("must_cut") != cuts:
        fail(f"the project holds other pins than were set: {kept['pins']}")
    if kept["tree"][root] != -1 or kept["tree"].count(-1) != 1:
        fail("the net is not laid out from the pinned root")
    return folded


def whole_session(program, cli, given, folder):
    model, project, fold = (os.path.join(folder, name) for name in ("model.obj", "model.netwright", "model.fold"))
    shutil.copy(given, model)
    editor = Editor(program, folder, model)
    editor.await_title("ready to unfold")
    root, folds, cuts = pin_all(editor)
    compare_runs(editor)
    cut, joined = edit_by_hand(editor)
    undo_and_redo_all(editor)
    save(editor, project)
    folds |= {die_in_a_change(editor, os.path.join(folder, "state", "netwright"))}

    editor = Editor(program, folder)
    editor.click("recover/0/recover")
    editor.await_net()
    await_that("all pinned edges are recovered", lambda: pins_shown(editor) == [4, 2])
    export(editor, fold, "Export as", "FOLD file…")
    export(editor, os.path.join(folder, "model.pdf"), "Export PDF…")
    editor.key("ctrl+s")
    await_that("the recovered project is saved", lambda: "•" not in editor.title())
    editor.key("ctrl+q")
    if editor.process.wait(PATIENCE) != 0:
        fail("the program ends well")
    folded = check(cli, fold, project, model, (root, folds, cuts))
    if cut in folded or joined not in folded:
        fail("the edits by hand are lost")
    with open(os.path.join(folder, "model.pdf"), "rb") as pdf:
        if pdf.read(4) != b"%PDF":
            fail("the exported pages are a PDF")


def main():
    missing = [tool for tool in ("Xvfb", "xdotool") if shutil.which(tool) is None]
    if missing:
        print("skipped: not installed:", *missing)
        sys.exit(77)
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder, Screen():
        os.environ.update(HOME=folder, XDG_CONFIG_HOME=os.path.join(folder, "config"), LIBGL_ALWAYS_SOFTWARE="1",
                          XDG_STATE_HOME=os.path.join(folder, "state"))
        try:
            whole_session(*sys.argv[1:4], folder)
        except BaseException:
            if len(sys.argv) > 4:  # a picture of the moment, for who looks into a failure
                subprocess.run(["import", "-window", "root", sys.argv[4]], check=False)
            raise
    print(f"the whole session held, in {time.monotonic() - begin:.0f} s")


if __name__ == "__main__":
    main()
