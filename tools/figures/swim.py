#!/usr/bin/env python3
"""How the error against the reference changes from frame to frame of an orbit and of a turn of the key light.

  tools/figures/swim.py smoke-dense=smoke-dense.json --frames 6
"""
import common


def main():
    parser = common.arguments(__doc__.splitlines()[0], size=256)
    common.scene_argument(parser)
    parser.add_argument("--frames", type=int, default=4, help="of each movement")
    parser.add_argument("--degrees", type=float, default=1.0, help="from one frame to the next")
    parser.add_argument("--ash-resolution", type=int, default=256)
    options = parser.parse_args()
    scenes = [("ash", ["ash", "--resolution", options.ash_resolution])]
    scenes += [(name, [path]) for name, path in common.scenes_of(options)]
    rows = []
    for name, words in scenes:
        report = common.run_json([options.plinian, "bench", *words, "--size", f"{options.size}x{options.size}",
                                  "--renderer", "gl", "--swim", options.frames, "--swim-degrees", options.degrees,
                                  "--json", "-q"])
        for preset, movements in report["swim"]["gl"].items():
            for movement, worst in movements.items():
                rows.append([name, preset, movement.replace("_", " "), f"{worst['psnr']:.1f}",
                             f"{worst['psnr_step']:.1f}", f"{worst['largest_step']:.3f}",
                             f"{worst['step_over_error']:.2f}"])
                print("  ".join(rows[-1]), flush=True)
    common.keep(f"Worst of {options.frames} frames {options.degrees:g} degrees apart, where alpha > 0.01\n\n" +
                common.table(["scene", "preset", "movement", "frame [dB]", "change of the error [dB]",
                              "largest change of a pixel", "change / error"], rows), options.out / "swim.md")


if __name__ == "__main__":
    main()
