#!/usr/bin/env python3
"""Checks that the module exports no symbol: its initialiser runs on loading and needs no name. exports.py LIBRARY"""
import shutil
import subprocess
import sys

if shutil.which("nm") is None:
    print("nm (binutils) is absent")
    sys.exit(77)
lines = subprocess.run(["nm", "-D", "--defined-only", sys.argv[1]], check=True, capture_output=True, text=True).stdout
names = [line.split()[-1] for line in lines.splitlines()]
# Symbols that sanitizers and coverage add to every library.
foreign = ("__asan", "__ubsan", "__tsan", "__odr_asan", "__gcov")
own = [name for name in names if not name.startswith(foreign)]
if own:
    print("exported: " + " ".join(own[:20]))
sys.exit(1 if own else 0)
