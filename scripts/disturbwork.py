"""What scripts/disturb lets the program do: commands, and a folder in which they run."""

import array
import contextlib
import os
import struct
import subprocess
import sys

SCENE = """Camera "perspective" "float fov" 40
Film "rgb" "string filename" "film.exr" "integer xresolution" {size} "integer yresolution" {size}
Sampler "independent" "integer pixelsamples" 2
WorldBegin
LightSource "distant" "point3 from" [1 1 -1] "point3 to" [0 0 0]
Translate 0 0 4
Shape "displacedsphere" "string displacementmap" "map.png" "float maxdispl" 10
"""
PATH = "frame,eye_x,eye_y,eye_z,look_x,look_y,look_z\n0,0,0,0,0,0,1\n9999,1,0,0,0,0,1\n"

# Each command with work for a second or longer, and its outputs; a star stands for the numbers of frames.
WORK = {
    "render": ("render planet.pbrt -o out.exr --spp 60000", "out.exr"),
    "render, partial": ("render planet.pbrt -o out.exr --spp 60000 --write-partial --cropwindow 0.4,0.6,0.4,0.6", "out.exr"),
    "render, frames": ("render planet.pbrt -o f-%04d.png --path path.csv --frames 0-9999", "f-*.png"),
    "render, host": ("render planet.pbrt -o out.exr --spp 60000 --device host", "out.exr"),
    "render, naive": ("render planet.pbrt -o out.exr --spp 60000 --marcher naive", "out.exr"),
    "render, large map": ("render large.tif -o out.png", "out.png"),
    "verify": ("verify planet.pbrt --resolution 1600,1200", ""),
    "query": ("query planet.pbrt many.csv -o out.csv", "out.csv"),
    "query, certified": ("query planet.pbrt many.csv -o out.csv --certify", "out.csv"),
    "bake": ("bake planet.pbrt -o out.exr --quantities sky,horizon", "out.exr"),
    "bench": ("bench --quick", ""),
    "diff": ("diff wide.exr wide.exr -o out.png", "out.png"),
    "info": ("info large.tif", ""),
    "info --scan": ("info large.tif --scan", ""),
    "generate": ("generate moon -o out.png --size 8192,4096", "out.png"),
    "generate tif": ("generate fractal -o out.tif --size 8192,4096", "out.tif"),
    "import": ("import out.tif west.tif east.tif --resolution 4096,2048", "out.tif"),
    "merge": ("merge -o out.exr left.exr right.exr", "out.exr"),
    "selftest": ("selftest", ""),
    "devices": ("devices", ""),
    "view": ("view planet.pbrt", ""),
    "view, large map": ("view large.tif", ""),
}
# The same with little work: what they write can be compared.
SHORT = {
    "render": ("render planet.pbrt -o out.exr --reproducible", "out.exr"),
    "render, Film": ("render planet.pbrt --json --reproducible", "film.exr"),
    "render, frames": ("render planet.pbrt -o f-%04d.png --path path.csv --frames 0-2", "f-0000.png"),
    "render, host": ("render planet.pbrt -o out.png --device host --progress always", "out.png"),
    "render, stdout": ("render planet.pbrt -o - --format png", ""),
    "render, tiled map": ("render tall.tif -o out.png --resolution 320,240 --mem-limit 16M", "out.png"),
    "verify": ("verify planet.pbrt --sample 10 --progress always", ""),
    "query": ("query planet.pbrt few.csv -o out.csv", "out.csv"),
    "query, stdout": ("query planet.pbrt few.csv", ""),
    "bake": ("bake planet.pbrt -o out.exr --quantities slope --resolution 256,128", "out.exr"),
    "diff": ("diff left.exr left.exr -o out.png", "out.png"),
    "info": ("info planet.pbrt", ""),
    "info, map": ("info map.png --json", ""),
    "generate": ("generate moon -o out.png --size 512,256", "out.png"),
    "import": ("import out.tif west.tif east.tif --resolution 512,256", "out.tif"),
    "merge": ("merge -o out.exr left.exr right.exr --reproducible", "out.exr"),
    "devices": ("devices", ""),
    "help": ("--help", ""),
}
KILLED = ("render", "render, frames", "query", "bake", "generate", "import", "merge", "render, tiled map")


def write_tiff(path, width, height):
    """A map of one strip and 16 bits that is written at once, whatever its size."""
    entries = [(256, 4, width), (257, 4, height), (258, 3, 16), (259, 3, 1), (262, 3, 1), (273, 4, 8 + 2 + 12 * 9 + 4),
               (277, 3, 1), (278, 4, height), (279, 4, 2 * width * height)]
    with open(path, "wb") as file:
        file.write(struct.pack("<2sHIH", b"II", 42, 8, len(entries)))
        for tag, kind, value in entries:
            file.write(struct.pack("<HHII", tag, kind, 1, value))
        file.write(struct.pack("<I", 0))
        row = array.array("H", ((37 * x * x) % 65521 for x in range(width))).tobytes()
        for _ in range(height):
            file.write(row)


class Place:
    """A folder with the inputs of all commands, caches beside it, and what is in it."""

    def __init__(self, program, folder, display, quick):
        self.program, self.folder, self.caches = program, folder / "work", folder / "caches"
        self.folder.mkdir()
        self.display = display
        size = 256 if quick else 1024
        (self.folder / "planet.pbrt").write_text(SCENE.format(size=size))
        (self.folder / "path.csv").write_text(PATH)
        header, ray = "ox,oy,oz,dx,dy,dz\n", "{},0.2,0,0,0,1\n"
        (self.folder / "few.csv").write_text(header + ray.format(0.1) * 100)
        (self.folder / "many.csv").write_text(header + "".join(ray.format(k % 999 / 1000) for k in range(300000)))
        write_tiff(self.folder / "tall.tif", 4096, 2048)
        for words in ("generate moon -o map.png --size 1024,512",
                      "bake planet.pbrt -o west.tif --quantities height --resolution 256,256 --bounds -180,0,-90,90",
                      "bake planet.pbrt -o east.tif --quantities height --resolution 256,256 --bounds 0,180,-90,90",
                      "render planet.pbrt -o left.exr --tile 1/2", "render planet.pbrt -o right.exr --tile 2/2"):
            self.make(words)
        if not quick:
            write_tiff(self.folder / "large.tif", 12288, 6144)
            self.make("render planet.pbrt -o wide.exr --spp 1 --resolution 3000,3000")
        self.inputs = set(os.listdir(self.folder))

    def make(self, words):
        run = subprocess.run([self.program, *words.split()], cwd=self.folder, env=self.environment(), capture_output=True)
        if run.returncode != 0:
            sys.exit(f"{words}: {run.stderr.decode()}")

    def environment(self, caches=None):
        """With the caches of this place, or others; Mesa's may be the caller's."""
        shaders = caches or os.environ.get("MESA_SHADER_CACHE_DIR", self.caches)
        return dict(os.environ, XDG_CACHE_HOME=str(caches or self.caches), MESA_SHADER_CACHE_DIR=str(shaders),
                    DISPLAY=self.display or "", ASAN_OPTIONS="detect_leaks=0")

    def start(self, words, caches=None, **streams):
        streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **streams}
        process = subprocess.Popen([self.program, *words.split()], cwd=self.folder, env=self.environment(caches), **streams)
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, process.pid, 0)  # not that of this script
        return process

    def made(self):
        return {name: (self.folder / name).read_bytes() for name in sorted(set(os.listdir(self.folder)) - self.inputs)}

    def clean(self):
        for name in set(os.listdir(self.folder)) - self.inputs:
            (self.folder / name).unlink()
