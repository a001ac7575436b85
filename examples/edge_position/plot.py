"""Draws the errors of edge_position.py over the spacing of the taxels as SVG: text and numbers in, no other library."""
import html
import math

WIDTH, HEIGHT = 820, 520
LEFT, TOP, RIGHT, BOTTOM = 70, 20, 560, 465  # edges of the axes; the legend is to their right
COLOURS = ["#009E73", "#0072B2", "#D55E00", "#CC79A7", "#000000"]  # of Okabe and Ito, for any colour vision


class Axes:
    """The places of numbers: the spacing along x, the logarithm of the error along y."""

    def __init__(self, rows, required):
        errors = [row.rms_low for row in rows] + [row.within_high for row in rows] + [required]
        self.low, self.high = 0.8 * min(error for error in errors if error > 0), 1.25 * max(errors)
        first, last = min(row.spacing for row in rows), max(row.spacing for row in rows)
        room = 0.05 * (last - first) or 0.5
        self.first, self.last = first - room, last + room

    def x(self, spacing):
        return LEFT + (RIGHT - LEFT) * (spacing - self.first) / (self.last - self.first)

    def y(self, error):
        part = math.log(max(error, self.low) / self.low) / math.log(self.high / self.low)
        return BOTTOM - (BOTTOM - TOP) * part

    def ticks(self):
        """Returns 1, 2 and 5 times powers of 10 between the ends."""
        powers = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        numbers = [factor * 10.0**power for power in powers for factor in (1, 2, 5)]
        return [number for number in numbers if self.low <= number <= self.high]


def line(points, colour, width=2, dashes=""):
    places = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return (f'<polyline points="{places}" fill="none" stroke="{colour}" stroke-width="{width}"'
            f'{f" stroke-dasharray={chr(34)}{dashes}{chr(34)}" if dashes else ""}/>')


def text(x, y, words, anchor="start", turned=False):
    turn = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turned else ""
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{turn}>{html.escape(words)}</text>'


def draw_axes(axes, rows):
    for error in axes.ticks():
        yield line([(LEFT, axes.y(error)), (RIGHT, axes.y(error))], "#dddddd", 1)
        yield text(LEFT - 8, axes.y(error) + 4, f"{error:g}", "end")
    for spacing in sorted({row.spacing for row in rows}):
        yield line([(axes.x(spacing), BOTTOM), (axes.x(spacing), BOTTOM + 5)], "#555555", 1)
        yield text(axes.x(spacing), BOTTOM + 20, f"{spacing:g}", "middle")
    yield line([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], "#555555", 1)
    yield text((LEFT + RIGHT) / 2, BOTTOM + 42, "spacing of the taxels [mm]", "middle")
    yield text(18, (TOP + BOTTOM) / 2, "error of the position of the edge [mm]", "middle", turned=True)


def draw_curve(axes, points, colour, dashes):
    """Draws places, intervals and the line between them: (spacing, error, low, high)."""
    yield line([(axes.x(spacing), axes.y(error)) for spacing, error, _, _ in points], colour, 2, dashes)
    for spacing, error, low, high in points:
        x = axes.x(spacing)
        yield line([(x, axes.y(low)), (x, axes.y(high))], colour, 1.2)
        for end in low, high:
            yield line([(x - 4, axes.y(end)), (x + 4, axes.y(end))], colour, 1.2)
        yield f'<circle cx="{x:.1f}" cy="{axes.y(error):.1f}" r="3.5" fill="{"#ffffff" if dashes else colour}" stroke="{colour}"/>'


def draw_errors(rows, name_of, required):
    """Returns the plot of the rows as SVG. `name_of` returns the name of a noise, `required` is an error [mm]."""
    axes = Axes(rows, required)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
             'font-family="Helvetica, Arial, sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>', *draw_axes(axes, rows)]
    parts.append(line([(LEFT, axes.y(required)), (RIGHT, axes.y(required))], "#000000", 1.5, "8 3 2 3"))
    parts.append(text(LEFT + 6, axes.y(required) - 6, f"required: {required:g} mm"))
    legend = TOP + 10
    for number, noise in enumerate(dict.fromkeys(row.noise for row in rows)):
        colour = COLOURS[number % len(COLOURS)]
        own = sorted((row for row in rows if row.noise == noise), key=lambda row: row.spacing)
        curves = [([(row.spacing, row.within, row.within_low, row.within_high) for row in own], "6 4", "95 % of touches within"),
                  ([(row.spacing, row.rms, row.rms_low, row.rms_high) for row in own], "", "RMS error")]
        parts.append(text(RIGHT + 20, legend, name_of(noise)))
        for points, dashes, label in curves:
            legend += 20
            parts += draw_curve(axes, points, colour, dashes)
            parts += [line([(RIGHT + 20, legend - 4), (RIGHT + 56, legend - 4)], colour, 2, dashes), text(RIGHT + 64, legend, label)]
        legend += 30
    return "\n".join(parts) + "\n</svg>\n"
