"""The libraries of this process."""


def loaded_mujocos():
    """Returns the files of all MuJoCos in this process."""
    with open("/proc/self/maps") as maps:
        return {line.split()[-1] for line in maps if "libmujoco" in line}
