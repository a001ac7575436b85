"""A script for the window that drags the camera around, another position in every picture; and what came of it."""

import json
import math
import sys

WARM_UP, MOVES = 20, 120


def write_script():
    def line(frame, **step):
        print(json.dumps({"frame": frame, **step}))

    line(0, event="key", key="1", mods=["ctrl"])
    line(1, do="wait_idle")
    line(2, event="mouse_move", at=[640, 250])
    line(4, event="mouse_down", button="left", at=[640, 250])
    for i in range(WARM_UP):
        line(6 + i, event="mouse_move", at=[640 + 8 * i, 250 + 2 * i])
    first = 7 + WARM_UP
    line(first - 1, do="dump_state", file="before.json")  # begins to count anew
    for i in range(MOVES):
        at = [640 + int(150 * math.sin(i / 6 + 0.1)), 250 + int(60 * math.sin(i / 4 + 0.3))]
        line(first + i, event="mouse_move", at=at)
    line(first + MOVES, do="dump_state", file="after.json")
    line(first + MOVES + 1, event="mouse_up", button="left", at=[640, 250])
    line(first + MOVES + 2, do="quit")


def report():
    with open("after.json") as file:
        pace = json.load(file)["pace"]
    drawn = pace["scene_draws"] / pace["seconds"]
    print(
        f"{pace['pictures']} pictures, {pace['scene_draws']} of them with the view drawn anew, in {pace['seconds']:.2f} s: "
        f"{drawn:.1f} of those a second; the slowest took {1e3 * pace['worst_seconds']:.0f} ms"
    )


write_script() if sys.argv[1:] == ["script"] else report()
