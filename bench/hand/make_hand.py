"""Writes a robot hand whose links are all covered with taxels, and which closes around a ball: 21 skins, 773 taxels.

make_hand.py FOLDER writes FOLDER/hand.xml, a mesh and a layout for each link.
"""
import json
import math
import pathlib
import sys

PALM = (0.042, 0.04, 0.011)  # half sizes [m]
FINGERS = ("first", "second", "third", "fourth", "thumb")
LINKS = ("base", "proximal", "middle", "tip")
WIDTH, THICKNESS = 0.009, 0.008  # half sizes of the links of a finger [m]
BALL = 0.045  # radius [m]


def half_length(finger, link):
    """Half the length of a link [m]. No two links are equal, so that no two skins are."""
    return (0.0165 + 0.0004 * finger - 0.0007 * link) * (0.75 if FINGERS[finger] == "thumb" else 1)


def grid(half, radius, straight, rounded):
    """Coordinates along one axis of a face of a rounded box, evenly in its angles and then evenly along it."""
    angles = [math.pi / 4 * (1 - k / rounded) for k in range(rounded)]
    edge = [half - radius + radius * math.tan(a) for a in angles]
    inner = [(half - radius) * (1 - 2 * k / straight) for k in range(straight + 1)]
    return edge + inner + [-x for x in reversed(edge)]


def rounded(point, half, radius):
    """The point of a rounded box in the direction of a point of the box around it, and the normal there."""
    inner = [max(-(h - radius), min(h - radius, x)) for x, h in zip(point, half)]
    away = [x - i for x, i in zip(point, inner)]
    length = math.sqrt(sum(a * a for a in away))
    normal = [a / length for a in away]
    return [i + radius * n for i, n in zip(inner, normal)], normal


def rounded_box(half, radius, straight, round_steps):
    """Vertices and triangles of a box whose edges are rounded."""
    vertices, number, faces = [], {}, []

    def vertex(point):
        key = tuple(round(x, 9) for x in point)
        if key not in number:
            number[key] = len(vertices)
            vertices.append(rounded(point, half, radius)[0])
        return number[key]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        us, vs = (grid(half[k], radius, straight, round_steps) for k in (u, v))
        for side in (1, -1):

            def corner(i, j):
                point = [0.0, 0.0, 0.0]
                point[axis], point[u], point[v] = side * half[axis], us[i], vs[j]
                return vertex(point)

            for i in range(len(us) - 1):
                for j in range(len(vs) - 1):
                    a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
                    faces += [(a, b, c), (a, c, d)] if side > 0 else [(a, c, b), (a, d, c)]
    return vertices, faces


def write_obj(file, vertices, faces):
    lines = ["v " + " ".join(f"{x:.9g}" for x in v) for v in vertices]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


def link_taxels(half, radius):
    """Six rows of six around the side of a link that closes on the ball, from one flank to the other."""
    taxels = []
    for row in range(6):
        y = half[1] * (-0.75 + 1.5 * row / 5)
        for column in range(6):
            angle = math.radians(-75 + 150 * column / 5)
            scale = min(half[0] / max(abs(math.sin(angle)), 1e-9), half[2] / max(math.cos(angle), 1e-9))
            place, normal = rounded([scale * math.sin(angle), y, scale * math.cos(angle)], half, radius)
            taxels.append({"center": place, "normal": normal, "radius": 0.004})
    return taxels


def palm_taxels(half):
    """Seven rows, of eight and seven in turn."""
    taxels = []
    for row in range(7):
        columns = 8 - row % 2
        for column in range(columns):
            x = half[0] * 0.85 * (2 * column / (columns - 1) - 1) * (columns - 1) / 7
            y = half[1] * (-0.8 + 1.6 * row / 6)
            taxels.append({"center": [x, y, half[2]], "normal": [0, 0, 1], "radius": 0.008})
    return taxels


def write_skin(folder, name, half, radius, taxels, rounded_steps=3, straight=6):
    vertices, faces = rounded_box(half, radius, straight, rounded_steps)
    write_obj(folder / f"{name}.obj", vertices, faces)
    layout = {
        "format": "taxel-layout",
        "version": 1,
        "name": name.replace("_", " "),
        "mesh": {"file": f"{name}.obj"},
        "frame": {"distal": [0, 1, 0], "pad": [0, 0, 1]},
        "material": {"modulus": 50000, "thickness": 0.002, "dissipation": 5, "friction": 0.8},
        "taxels": [{"id": k, **taxel} for k, taxel in enumerate(taxels)],
    }
    (folder / f"{name}.taxels.json").write_text(json.dumps(layout, indent=1) + "\n", encoding="utf-8")
    return len(taxels)


def finger_bodies(finger):
    """The links of a finger as nested bodies: y along the finger, z towards the ball."""
    name = FINGERS[finger]
    thumb = name == "thumb"
    place = (0, -PALM[1] - 0.003, 0) if thumb else (0.0205 * (finger - 1.5), PALM[1] + 0.003, 0)
    text, ends = [], []
    for k, link in enumerate(LINKS):
        half = half_length(finger, k)
        turn = ' euler="0 0 180"' if thumb and k == 0 else ""
        text.append(f'<body name="{name}_{link}" pos="{place[0]:.9g} {place[1]:.9g} {place[2]:.9g}"{turn}>')
        text.append(f'<joint name="{name}_{link}" class="finger"/>')
        text.append(f'<geom name="{name}_{link}" class="skin" mesh="{name}_{link}" pos="0 {half:.9g} 0" mass="0.012"/>')
        ends.append("</body>")
        place = (0, 2 * half + 0.0015, 0)
    return text + ends


def touched(skin, skins):
    """The geoms that a skin touches: the ball, and all links that are not jointed to its own."""

    def is_jointed(a, b):
        finger_a, _, link_a = a.partition("_")
        finger_b, _, link_b = b.partition("_")
        if "palm" in (a, b):
            return LINKS[0] in (link_a, link_b)
        return finger_a == finger_b and abs(LINKS.index(link_a) - LINKS.index(link_b)) == 1

    return " ".join(["ball"] + [other for other in skins if other != skin and not is_jointed(skin, other)])


def scene(skins):
    def each(pattern):
        return [pattern.format(file=skin, name=skin, others=touched(skin, skins)) for skin in skins]

    joints = [f"{finger}_{link}" for finger in FINGERS for link in LINKS]
    layout = (
        '<instance name="{name}"><config key="layout" value="{file}.taxels.json"/>'
        '<config key="geom" value="{name}"/><config key="others" value="{others}"/></instance>'
    )
    lines = [
        '<mujoco model="a hand of 21 skins">',
        '<compiler angle="degree" autolimits="true"/>',
        '<option timestep="0.002" integrator="implicitfast"/>',
        '<extension><plugin plugin="taxel.sensor">',
        *each(layout),
        "</plugin></extension>",
        '<default><geom contype="0" conaffinity="0"/>',
        '<default class="skin"><geom type="mesh"/></default>',
        '<default class="finger"><joint axis="1 0 0" range="-5 100" damping="0.02" armature="1e-4"/>',
        '<position kp="1" dampratio="1" ctrlrange="0 1.7" forcerange="-0.1 0.1"/></default></default>',
        "<asset>",
        *each('<mesh name="{file}" file="{file}.obj"/>'),
        "</asset>",
        "<worldbody>",
        '<light pos="0 -0.3 0.6" dir="0 0.4 -1"/>',
        '<geom name="floor" type="plane" size="0.3 0.3 0.01" pos="0 0 -0.2"/>',
        f'<body name="ball" pos="0 0.002 {PALM[2] + BALL + 0.001:.9g}"><freejoint/>',
        f'<geom name="ball" type="sphere" size="{BALL}" mass="0.1" rgba="0.35 0.55 0.75 1"/></body>',
        '<body name="palm"><geom name="palm" class="skin" mesh="palm" mass="0.2"/>',
        *(line for finger in range(len(FINGERS)) for line in finger_bodies(finger)),
        "</body></worldbody>",
        "<actuator>",
        *(f'<position name="{joint}" class="finger" joint="{joint}"/>' for joint in joints),
        "</actuator>",
        "<sensor>",
        *each('<plugin name="{name} taxels" plugin="taxel.sensor" instance="{name}"/>'),
        "</sensor>",
        '<keyframe><key name="grasp" ctrl="' + " ".join(["1.5 0.9 0.9 0.9"] * 4 + ["1.5 0.35 0.3 0.3"]) + '"/></keyframe>',
        "</mujoco>",
    ]
    return "\n".join(lines) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    skins, taxels = ["palm"], write_skin(folder, "palm", PALM, 0.008, palm_taxels(PALM), straight=12)
    for f, finger in enumerate(FINGERS):
        for k, link in enumerate(LINKS):
            half = (WIDTH, half_length(f, k), THICKNESS)
            skins.append(f"{finger}_{link}")
            taxels += write_skin(folder, skins[-1], half, 0.006, link_taxels(half, 0.006))
    (folder / "hand.xml").write_text(scene(skins), encoding="utf-8")
    print(f"{len(skins)} skins, {taxels} taxels: {folder / 'hand.xml'}")


if __name__ == "__main__":
    main()
