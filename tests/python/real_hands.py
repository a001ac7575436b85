"""Grasps a ball with the Shadow and the Allegro hand of MuJoCo Menagerie, whose links get generated skins."""
import pathlib
import unittest

import mujoco
import numpy as np

import taxel

HANDS = pathlib.Path(__file__).resolve().parents[3] / "shared" / "real" / "hands"
MASS, GRAVITY = 0.05, 9.81

# Joints and controls of a grasp that came to rest: 24 or 16 joints, then the ball's pose.
SHADOW = {
    "file": "shadow_hand/right_hand.xml",
    "links": ("rh_ffdistal", "rh_mfdistal", "rh_rfdistal", "rh_lfdistal", "rh_thdistal"),
    "pad": (0, -1, 0),
    "radius": 0.03,
    "qpos": "0.0144 -0.0344 0.0748 0.1451 0.9720 0.1153 -0.0008 0.2398 1.0442 0.1060 0.0865 0.1003 0.5496 0.5322 0.6076 "
            "0.2744 -0.2005 0.4698 0.4920 0.7915 1.0970 -0.1337 -0.2586 -0.1818 0.3711 -0.0209 0.0755 0.9959 0.0400 "
            "-0.0227 0.0774",
    "ctrl": "0.0144 0.0374 1.0472 1.0910 -0.1442 -0.2036 -0.1456 0.3491 0.2132 1.1073 0.0167 0.2791 1.2517 0.3491 0.2095 "
            "1.1025 0.6601 0.3491 -0.1530 0.9738",
}
ALLEGRO = {
    "file": "wonik_allegro/right_hand.xml",
    "links": ("ff_tip", "mf_tip", "rf_tip", "th_tip", "ff_distal", "mf_distal", "rf_distal", "th_distal"),
    "pad": (1, 0, 0),
    "radius": 0.03,
    "qpos": "-0.1781 1.2660 0.1717 0.0237 0.0443 1.0963 0.5340 -0.2054 0.4215 1.5808 -0.0755 -0.2070 1.1724 0.2909 0.5752 "
            "-0.1063 -0.0008 -0.0305 0.1149 0.9474 0.1093 -0.0652 0.2936",
    "ctrl": "-0.2107 1.3708 0.2245 0.0428 0.1506 1.2290 0.5776 -0.2051 0.4700 1.6100 -0.0381 -0.1687 1.3960 0.3305 0.7820 "
            "-0.0101",
}


def numbers(text):
    return np.array([float(word) for word in text.split()])


def scene_of(hand, output):
    """Returns the scene of a hand with a ball, whose links have a lattice of taxels that read forces."""
    spec = mujoco.MjSpec.from_file(str(HANDS / hand["file"]))
    ball = spec.worldbody.add_body(name="ball")
    ball.add_freejoint(name="ball")
    ball.add_geom(name="ball", type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[hand["radius"], 0, 0], mass=MASS)
    for name in hand["links"]:
        skin = taxel.generate(spec, body=name, pitch=0.005, max_slope=80, pad=hand["pad"], distal=[0, 0, 1])
        skin.set_value("/readout/aggregate", "force")
        skin.set_value("/material/modulus", 1e5)
        skin.set_value("/material/friction", 1.0)
        geoms = [geom for geom in spec.body(name).geoms if geom.meshname]
        link = next((geom for geom in geoms if not (geom.contype or geom.conaffinity)), geoms[0])
        link.name = name
        for geom in spec.body(name).geoms:
            geom.contype = geom.conaffinity = 0  # the skin touches the ball in their place
        taxel.attach(spec, name, skin, others=["ball"], output=output, tangential_stiffness=1e8, bristles=300)
    return spec.compile()


@unittest.skipUnless(HANDS.exists(), f"{HANDS} is absent")
class RealHandsTest(unittest.TestCase):
    def grasp(self, hand):
        """Holds a ball for ten seconds and checks the forces after each of the last five."""
        model, reader = scene_of(hand, ["wrench"]), scene_of(hand, ["elastic_wrench", "readings"])
        data, poses = mujoco.MjData(model), mujoco.MjData(reader)
        data.qpos[:], data.ctrl[:] = numbers(hand["qpos"]), numbers(hand["ctrl"])
        complaints = []
        mujoco.set_mju_user_warning(complaints.append)
        try:
            for second in range(1, 11):
                mujoco.mj_step(model, data, nstep=round(1 / model.opt.timestep))
                if second > 5:
                    self.check_weight(model, data)
                    poses.qpos[:] = data.qpos
                    mujoco.mj_forward(reader, poses)
                    self.check_readings(reader, poses)
        finally:
            mujoco.set_mju_user_warning(None)
        self.assertEqual(complaints, [])
        self.assertFalse(any(warning.number for warning in data.warning))
        self.assertLess(np.linalg.norm(data.body("ball").xpos - numbers(hand["qpos"])[-7:-4]), 0.015)

    def check_weight(self, model, data):
        carried = sum(sensor.force for sensor in taxel.readings(model, data).values())  # on the links
        np.testing.assert_allclose(carried, [0, 0, -MASS * GRAVITY], atol=0.01 * MASS * GRAVITY)

    def check_readings(self, model, data):
        """Each reading is an integral of the pressure; on a curved skin their sum is a little more than the force."""
        pressed = [(sensor.values.sum(), np.linalg.norm(sensor.elastic_force))
                   for sensor in taxel.readings(model, data).values()]
        touching = [(total, force) for total, force in pressed if force > 0.1]
        self.assertGreaterEqual(len(touching), 2)
        for total, force in touching:
            self.assertAlmostEqual(total / force, 1, delta=0.01)

    def test_shadow_hand_holds_a_ball(self):
        self.grasp(SHADOW)

    def test_allegro_hand_holds_a_ball(self):
        self.grasp(ALLEGRO)


if __name__ == "__main__":
    unittest.main()
