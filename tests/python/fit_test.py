"""Tests taxel.fit."""
import json
import pathlib
import tempfile
import unittest

import taxel


class FitTest(unittest.TestCase):
    def test_finds_the_gains_of_presses_that_it_read_itself(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            layout = taxel.Layout.read(taxel.FINGERTIP)
            model = taxel.SensorModel(layout)
            ball = {"shape": {"type": "sphere", "size": [0.004]}}
            pad = min(range(len(layout.centers)), key=lambda k: layout.normals[k][1])  # faces -y
            center, normal = layout.centers[pad], layout.normals[pad]
            start = (center + 0.0065 * normal).tolist()
            presses = {"format": "contact-case", "version": 1, "a": {"layout": str(taxel.FINGERTIP)},
                       "b": {**ball, "pos": start}}
            (folder / "ball.json").write_text(json.dumps(presses))
            rows = [(0.001 * place, -0.0001 * step)
                    for place in range(-3, 4) for step in (0, 0, 24, 26, 28, 30, 32, 34, 28, 0)]
            poses = [[start[0] + x, start[1] - depth, start[2], 1, 0, 0, 0] for x, depth in rows]
            readings = model.read(taxel.Object(ball), poses).readings
            names = [f"taxel_{k}" for k in range(len(layout.centers))]
            lines = ["x [m],y [m]," + ",".join(names)]
            for (x, _), pose, values in zip(rows, poses, readings):
                lines.append(",".join(map(repr, [x, pose[1] - start[1], *(50 + 3 * float(v) for v in values)])))
            (folder / "presses.csv").write_text("\n".join(lines) + "\n")
            fit = taxel.fit(folder / "presses.csv", layout=taxel.FINGERTIP, case=folder / "ball.json",
                            free=["x0", "y0", "gain"], press_axis="y", out=folder / "fit")
            self.assertGreater(fit["runs"][0]["r2"], 0.9999)
            self.assertAlmostEqual(fit["runs"][0]["taxels"][pad]["gain"], 3, delta=0.03)
            self.assertEqual([p["name"] for p in fit["free"]], ["x0", "y0"])
            self.assertTrue((folder / "fit" / "bells.svg").exists())
            with self.assertRaisesRegex(taxel.Error, "is no parameter"):
                taxel.fit(folder / "presses.csv", layout=taxel.FINGERTIP, case=folder / "ball.json", free=["radios"])


if __name__ == "__main__":
    unittest.main()
