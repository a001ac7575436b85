"""A script for the window that lets a simulation run by the clock, and what came of it."""

import json
import sys

WARM_UP = 8


def write_script(pictures):
    def line(frame, **step):
        print(json.dumps({"frame": frame, **step}))

    line(0, do="wait_idle")
    line(1, event="key", key="2", mods=["ctrl"])
    line(2, do="wait_idle")
    line(3, event="key", key="Backspace")  # from the start
    line(3, event="key", key="Space")
    last = 4 + WARM_UP + pictures
    for frame in range(4, last):
        if frame == 4 + WARM_UP:
            line(frame, do="dump_state", file="before.json")  # begins to count anew
        else:
            line(frame, event="mouse_move", at=[600 + frame % 2, 300])
    line(last, do="dump_state", file="after.json")
    line(last + 1, do="quit")


def report():
    with open("before.json") as file:
        begin = json.load(file)["simulation"]["time"]
    with open("after.json") as file:
        state = json.load(file)
    pace, simulation = state["pace"], state["simulation"]
    if not simulation["playing"]:
        sys.exit("the simulation had ended before the last picture")
    drawn = pace["scene_draws"] / pace["seconds"]
    speed = (simulation["time"] - begin) / pace["seconds"]
    print(f"{drawn:.1f} pictures a second, each of another step; {speed:.2f} times real time simulated")


write_script(int(sys.argv[2])) if sys.argv[1:2] == ["script"] else report()
