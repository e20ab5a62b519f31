#!/usr/bin/env python3
"""What frames and edits cost, in turn with another program on the same scene.

  tools/figures/speed.py smoke-dense=smoke-dense.json --against 'vdb_render.sh {scene} {out}'
"""
import shlex

import common


def main():
    parser = common.arguments(__doc__.splitlines()[0])
    common.scene_argument(parser)
    parser.add_argument("--runs", type=int, default=5, help="medians are over so many")
    parser.add_argument("--against", help="a command; {scene} and {out} stand for the scene file and a picture")
    options = parser.parse_args()
    size = f"{options.size}x{options.size}"
    options.out.mkdir(parents=True, exist_ok=True)
    rows, machine = [], ""
    with common.temporary_folder() as folder:
        scenes = [("ash", None)] + list(common.scenes_of(options))
        for name, path in scenes:
            command = [options.plinian, "bench", path or "ash", "--size", size, "--runs", options.runs, "--renderer",
                       "gl", "--json", "-q"]
            if options.against and path:
                # The other program reads its size from the scene.
                scene = common.read_scene(path)
                scene["size"] = [options.size, options.size]
                # Its volume has to be found from there too.
                copy = common.write_scene(scene, options.out / f"{name}.json")
                scene["volume"] = common.os.path.relpath(scene["volume"], copy.parent)
                common.write_scene(scene, copy)
                command += ["--against", options.against.format(scene=shlex.quote(str(copy)),
                                                                out=shlex.quote(f"{folder}/other.exr"))]
            report = common.run_json(command)
            machine = report["machine"]
            other = report.get("against", {}).get("ms")
            for preset in ("fast", "high"):
                times, ratios = report["renderers"]["gl"][preset], report["ratios"]
                ratio = lambda key: f"{ratios[f'gl.{preset}.{key}']:.1f}" if f"gl.{preset}.{key}" in ratios else "-"
                rows.append([name, preset] + [f"{times[key]:.0f}" for key in
                                              ("orbit_frame_ms", "albedo_edit_ms", "extinction_edit_ms", "light_edit_ms",
                                               "frame_change_ms", "map_build_ms")] +
                            [ratio("dual_march_over_orbit_frame"), f"{other:.0f}" if other else "-",
                             ratio("against_over_orbit_frame"), ratio("against_over_light_edit")])
                print("  ".join(rows[-1]), flush=True)
    common.keep(f"{machine}, {size}, median of {options.runs} alternating runs, in milliseconds and ratios run by run\n\n" +
                common.table(["scene", "preset", "orbit frame", "albedo edit", "extinction edit", "light edit",
                              "frame change", "maps", "dual march / orbit", "other program", "other / orbit",
                              "other / light edit"], rows), options.out / "speed.md")


if __name__ == "__main__":
    main()
