#!/usr/bin/env python3
"""How time and memory grow with the resolution of the ash, its look unchanged.

  tools/figures/growth.py --resolutions 128 256 512
"""
import common


def main():
    parser = common.arguments(__doc__.splitlines()[0])
    parser.add_argument("--resolutions", type=int, nargs="+", default=[128, 256, 512])
    parser.add_argument("--runs", type=int, default=5, help="medians are over so many")
    options = parser.parse_args()
    size = f"{options.size}x{options.size}"
    rows, before = [], None
    with common.temporary_folder() as folder:
        for resolution in options.resolutions:
            ash = ["ash", "--resolution", resolution]
            report = common.run_json([options.plinian, "bench", *ash, "--size", size, "--runs", options.runs,
                                      "--renderer", "gl", "--preset", "fast", "--json", "-q"])
            fast = report["renderers"]["gl"]["fast"]
            file = f"{folder}/ash.vdb"
            common.run([options.plinian, "make", *ash, "-o", file, "-q"])
            leaves = sum(grid["leaves"] for grid in common.run_json([options.plinian, "info", file, "--json"])["grids"])
            # The process that opens the file, as an artist's would; the parser's memory is its own.
            memory, private = common.peak_memory([options.plinian, "render", file, "-o", f"{folder}/a.png", "--size",
                                                  size, "--passes", "1", "--renderer", "gl", "-q"])
            orbit, volume = fast["orbit_frame_ms"], fast["volume_bytes"]
            rows.append([f"{resolution}³", f"{orbit:.0f}", f"{orbit / before:.2f}" if before else "-", leaves,
                         f"{volume / 2**20:.1f}", f"{volume / leaves / 1024:.2f}", f"{memory / 2**20:.0f}",
                         f"{private / 2**20:.0f}", f"{3 * volume / 2**20 + 200:.0f}"])
            before = orbit
            print("  ".join(map(str, rows[-1])), flush=True)
    common.keep(common.table(["ash", "orbit frame [ms]", "growth", "leaves of 8³", "volume on the GPU [MiB]",
                              "of 512 × 2 bytes per leaf", "peak memory [MiB]", "of it private",
                              "3 volumes + 200 MiB"], rows), options.out / "growth.md")


if __name__ == "__main__":
    main()
