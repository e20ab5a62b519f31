#!/usr/bin/env python3
"""The pictures: the default ash in both presets, and TFM, ATFM and the reference side by side with heat maps.

  tools/figures/pictures.py
"""
import common
import quality


def main():
    parser = common.arguments(__doc__.splitlines()[0])
    parser.add_argument("--ash-resolution", type=int, help="of the ash")
    parser.add_argument("--renderer", default="gl")
    options = parser.parse_args()
    out, size = options.out, f"{options.size}x{options.size}"
    out.mkdir(parents=True, exist_ok=True)
    base = [options.plinian, "render", "ash", "--size", size, "-q"]
    if options.ash_resolution:
        base += ["--resolution", options.ash_resolution]
    for preset in ("fast", "high"):
        common.run(base + ["--preset", preset, "--renderer", options.renderer, "-o", out / f"ash-{preset}.png",
                           "-o", out / f"ash-{preset}.exr"])
    common.run(base + ["--renderer", "reference", "-o", out / "ash-reference.exr", "-o", out / "ash-reference.png"])
    for name in ("tfm", "fast"):
        common.run(base + quality.QUALITIES[name] + ["--passes", "1", "--renderer", options.renderer, "-o",
                                                     out / f"ash-{name}-pass.exr"])
    sheet = [options.plinian, "sheet", "-q"]
    common.run(sheet + [out / "ash-tfm-pass.exr", out / "ash-fast-pass.exr", out / "ash-reference.exr", "-o",
                        out / "ash-tfm-atfm-reference.png", "--label", "TFM 6 + 2", "--label",
                        "ATFM 6 + 2", "--label", "reference"])
    common.run(sheet + [out / "ash-tfm-pass.exr", out / "ash-fast-pass.exr", out / "ash-high.exr", "-o",
                        out / "ash-heat.png", "--against", out / "ash-reference.exr", "--label", "TFM 6 + 2",
                        "--label", "fast", "--label", "high, at rest"])
    common.run([options.plinian, "compare", out / "ash-fast-pass.exr", out / "ash-reference.exr", "--report",
                out / "ash-fast.html", "--view", "filmic", "-q"])
    print(f"pictures are in {out}")


if __name__ == "__main__":
    main()
