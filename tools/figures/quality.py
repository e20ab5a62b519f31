#!/usr/bin/env python3
"""How near the presets come to the reference: ash and other scenes under front, side and back light.

Each picture is the preset's own single pass; tfm is fast with the full-range series as published.
  tools/figures/quality.py smoke-dense=smoke-dense.json smoke-thin=smoke-thin.json
"""
import common

TFM = ["--preset", "fast", "--encoding", "tfm", "--set", "map.density_weighting=1"]
QUALITIES = {"fast": ["--preset", "fast"], "high": ["--preset", "high"], "tfm": TFM}


def main():
    parser = common.arguments(__doc__.splitlines()[0])
    common.scene_argument(parser)
    parser.add_argument("--light", action="append", choices=sorted(common.LIGHTS), help="may be repeated; all")
    parser.add_argument("--ash-resolution", type=int, help="of the ash")
    parser.add_argument("--renderer", default="gl")
    options = parser.parse_args()
    scenes = [("ash", common.ash_scene(options.ash_resolution))]
    scenes += [(name, common.read_scene(path)) for name, path in common.scenes_of(options)]
    options.out.mkdir(parents=True, exist_ok=True)
    size = f"{options.size}x{options.size}"
    rows = []
    with common.temporary_folder() as folder:
        for name, scene in scenes:
            for light in options.light or list(common.LIGHTS):
                stem = options.out / f"{name}-{light}"
                path = common.write_scene(common.lit_from(scene, light), stem.with_suffix(".json"))
                base = [options.plinian, "render", path, "--size", size, "-q"]
                truth = f"{folder}/truth.exr"
                common.run(base + ["-o", truth, "-o", f"{stem}-reference.png", "--renderer", "reference"])
                for quality, arguments in QUALITIES.items():
                    picture = f"{folder}/picture.exr"
                    common.run(base + arguments + ["-o", picture, "-o", f"{stem}-{quality}.png", "--passes", "1",
                                                   "--renderer", options.renderer])
                    found = common.run_json([options.plinian, "compare", picture, truth, "--json", "-q"])
                    flips = {entry["exposure"]: entry["mean"] for entry in found["flip"]}
                    rows.append([name, light, quality, f"{found['psnr']:.1f}", f"{found['psnr_mask']:.1f}",
                                 f"{found['ssim']:.4f}", f"{flips[0]:.4f}", f"{flips[3]:.4f}",
                                 f"{found['max_error']:.3f}", f"{found['mean_ratio']:.4f}"])
                    print("  ".join(rows[-1]), flush=True)
    common.keep(common.table(["scene", "light", "quality", "PSNR [dB]", "where alpha > 0.01", "SSIM", "FLIP",
                              "FLIP at +3 stops", "largest error", "mean / reference"], rows),
                options.out / "quality.md")


if __name__ == "__main__":
    main()
