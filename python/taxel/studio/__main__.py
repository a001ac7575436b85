"""`python -m taxel.studio scene.xml`: opens a scene in MuJoCo's own Studio."""

from __future__ import annotations

import argparse
import sys

from taxel import studio
from taxel.errors import Error


def main() -> int:
    """Runs the command. Returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m taxel.studio", description="Opens a scene with tactile sensors in MuJoCo's own Studio."
    )
    parser.add_argument("scene", help="file of the scene: XML, URDF or MJZ")
    parser.add_argument(
        "--gfx",
        default="opengl_headless",
        help="graphics of Studio: opengl_headless (default), opengl_software without a graphics card, web for the browser",
    )
    parser.add_argument("--width", type=int, default=1280, help="width of the window in pixels")
    parser.add_argument("--height", type=int, default=860, help="height of the window in pixels")
    parser.add_argument("--port", type=int, default=0, help="port of --gfx web; 0: the first free one from 8080 on")
    options = parser.parse_args()
    try:
        studio.run(
            options.scene, graphics=options.gfx, width=options.width, height=options.height, port=options.port
        )
    except (Error, ImportError) as error:
        print(f"taxel.studio: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
