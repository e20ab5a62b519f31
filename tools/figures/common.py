"""What the figure scripts share: running plinian, scenes under another light, tables."""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def arguments(description, **defaults):
    """A parser with what every script takes."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--plinian", default=str(ROOT / "build/release/bin/plinian"), help="the program")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/figures", help="folder for what is made")
    parser.add_argument("--size", type=int, default=defaults.get("size", 512), help="pixels along a side")
    return parser


def scene_argument(parser):
    parser.add_argument("scenes", nargs="*", metavar="NAME=SCENE.json", default=[],
                        help="neutral scenes beside ash, as smoke-dense=path/to/smoke-dense.json")


def scenes_of(options):
    """Name and file of each scene that was named on the command line."""
    for entry in options.scenes:
        name, _, path = entry.partition("=")
        if not path:
            sys.exit(f"{entry}: expected NAME=SCENE.json")
        yield name, pathlib.Path(path).resolve()


def run(command, accept=(0,)):
    """Runs a command. Returns what it printed; ends the script with its error where it fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode not in accept:
        sys.exit(f"failed with {done.returncode}: {' '.join(map(str, command))}")
    return done.stdout


def run_json(command):
    return json.loads(run(command))


def peak_memory(command):
    """Runs a command. Returns its peak resident memory, children aside, and the peak of what of it is private
    (not the pages of libraries and files) [bytes]; the latter is sampled every few milliseconds."""
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
    private = 0
    while True:
        found, status, usage = os.wait4(process.pid, os.WNOHANG)
        if found:
            break
        try:
            lines = pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines()
            private = max([private] + [int(line.split()[1]) for line in lines if line.startswith("RssAnon")])
        except OSError:
            pass
        time.sleep(0.003)
    if status != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}")
    return usage.ru_maxrss * 1024, private * 1024


def direction(azimuth, elevation):
    """Towards the camera or a light; degrees, 0 from +z, 90 from +x."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return [math.sin(a) * math.cos(e), math.sin(e), math.cos(a) * math.cos(e)]


# Degrees from the camera's azimuth, and above the horizon.
LIGHTS = {"front": (-25.0, 30.0), "side": (-90.0, 25.0), "back": (165.0, 25.0)}
ASH_AZIMUTH = 30.0


def ash_scene(resolution=None):
    """The default medium with one key light and no sky, in which directions can be set."""
    scene = {"volume": "ash", "camera": {"azimuth": ASH_AZIMUTH, "elevation": -1.0},
             "lights": [{"name": "key", "type": "directional", "irradiance": [12.566] * 3}]}
    if resolution:
        scene["resolution"] = resolution
    return scene


def read_scene(path):
    """A neutral scene with its volume's path made absolute."""
    scene = json.loads(path.read_text())
    volume = pathlib.Path(scene["volume"])
    if volume.suffix == ".vdb" and not volume.is_absolute():
        scene["volume"] = str((path.parent / volume).resolve())
    return scene


def lit_from(scene, light):
    """The scene with its first light moved to the front, the side or the back of what the camera sees."""
    camera = scene["camera"]
    if "eye" in camera:
        away = [a - b for a, b in zip(camera["eye"], camera["target"])]
        azimuth = math.degrees(math.atan2(away[0], away[2]))
    else:
        azimuth = camera["azimuth"]
    turn, elevation = LIGHTS[light]
    lit = json.loads(json.dumps(scene))
    lit["lights"][0]["toward"] = direction(azimuth + turn, elevation)
    return lit


def write_scene(scene, path):
    path.write_text(json.dumps(scene, indent=1))
    return path


def table(header, rows):
    """A Markdown table."""
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def keep(text, path):
    """Prints a table and writes it beside the pictures."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    print(text)


def temporary_folder():
    return tempfile.TemporaryDirectory(prefix="plinian-figures-")
