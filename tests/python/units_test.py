"""Numbers of every key are in SI: runs against closed forms, which know nothing of files and units."""

import unittest

import numpy as np

import plastica
from plastica import Beam, InitialMotion, Load, Material, PointMass, Probe, Region, Support
from support import TestCase, cantilever

E, RHO = 210e9, 7850.0
WIDTH = 0.02
I = WIDTH**4 / 12.0
EI = E * I
WEIGHT = 9.81 * RHO * WIDTH**2
CLAMP = Support(kind="clamp", at="start")


def tip_of(**changed):
    """At the end, of 200 segments; loads are small, so that Euler and Bernoulli's beam is linear."""
    scene = cantilever(beam=Beam(length=1.0, segments=200), **changed)
    return plastica.simulate(scene).probes["tip"][-1]


class Units(TestCase):
    def assertNear(self, value, truth, relative=5e-5):
        """The chain of 200 segments is off by 1/N^2 of a cantilever's tip: 2.5e-5."""
        self.assertLess(abs(value / truth - 1.0), relative, f"{value} is not {truth}")

    def test_loads(self):
        for load, truth in (
            (Load(at="end", force=[0.0, -1.0, 0.0]), -1.0 / (3.0 * EI)),
            (Load(at="end", moment=[1.0, 0.0, 0.0]), -1.0 / (2.0 * EI)),
            (Load(at="start", to="end", force=[0.0, -1.0, 0.0]), -1.0 / (8.0 * EI)),
            (Load(from_=0.0, to=1.0, force=[0.0, -1.0, 0.0]), -1.0 / (8.0 * EI)),
            (Load(from_=0.0, to=1.0, moment=[1.0, 0.0, 0.0]), -1.0 / (3.0 * EI)),
        ):
            self.assertNear(tip_of(loads=[load]), truth)

    def test_supports(self):
        push = [Load(at="end", force=[0.0, -1.0, 0.0])]
        turned = Support(kind="clamp", at="start", rotation=[0.01, 0.0, 0.0])
        self.assertNear(tip_of(supports=[turned], loads=[]), -np.sin(0.01), 1e-9)
        spring = Support(kind="elastic", at="end", stiffness=[0.0, 5000.0, 0.0])
        self.assertNear(tip_of(supports=[CLAMP, spring], loads=push),
                        -1.0 / (3.0 * EI + 5000.0))
        turning = Support(kind="elastic", at="start", stiffness=[1e12, 1e12, 1e12],
                          rotational_stiffness=[1000.0, 1e9, 1e9])
        self.assertNear(tip_of(supports=[turning], loads=push), -1.0 / 1000.0 - 1.0 / (3.0 * EI),
                        1e-4)
        bed = Support(kind="elastic", at="start", to="end", stiffness=[1e3, 1e3, 1e3])
        even = [Load(at="start", to="end", force=[0.0, -10.0, 0.0])]
        self.assertNear(tip_of(supports=[bed], loads=even), -0.01)
        head = Support(kind="roller", at="end", hold=["y"], translation=[0.0, -1e-3, 0.0])
        scene = cantilever(beam=Beam(length=1.0, segments=200), supports=[CLAMP, head], loads=[],
                           probes=[Probe(name="pull", kind="reaction", component="y")])
        self.assertNear(plastica.simulate(scene).probes["pull"][-1], -1e-3 * 3.0 * EI)
        pillar = Support(kind="pillar", at="end", normal="y", gap=1e-4)
        self.assertNear(tip_of(supports=[CLAMP, pillar],
                               loads=[Load(at="end", force=[0.0, -100.0, 0.0])]), -1e-4, 1e-9)

    def test_gravity_and_masses(self):
        for gravity in ([0.0, -9.81, 0.0], {"y": -9.81}, {"acceleration": [0.0, -9.81, 0.0]}):
            self.assertNear(tip_of(loads=[], gravity=gravity), -WEIGHT / (8.0 * EI))
        self.assertNear(
            tip_of(loads=[], gravity=[0.0, -9.81, 0.0], masses=[PointMass(at="end", mass=2.0)]),
            -WEIGHT / (8.0 * EI) - 2.0 * 9.81 / (3.0 * EI))

    def test_regions(self):
        stiff = Region(from_="start", to=0.5, section={"height": 0.04, "width": 0.02},
                       material=Material(youngs_modulus=105e9))
        other = 105e9 * 0.02 * 0.04**3 / 12.0
        truth = (1.0 - 0.5**3) / (3.0 * other) + 0.5**3 / (3.0 * EI)
        self.assertNear(tip_of(loads=[Load(at="end", force=[0.0, -1.0, 0.0])], regions=[stiff]),
                        -truth)

    def test_axes(self):
        push = [Load(at="end", force=[0.0, -1.0, 0.0])]
        bent = cantilever(
            beam=Beam(shape="polyline", points=np.array([[0, 0, 0], [0, 0, 0.5], [0, 0, 1.0]]),
                      segments=200), loads=push)
        self.assertNear(plastica.simulate(bent).probes["tip"][-1], -1.0 / (3.0 * EI))
        arc = cantilever(beam=Beam(length=1.0, shape="arc", arc_angle=0.5 * np.pi, arc_towards="y",
                                   segments=400), loads=push)
        end = plastica.simulate(arc).position[0, -1]
        np.testing.assert_allclose(end, [0.0, 2.0 / np.pi, 2.0 / np.pi], atol=1e-5)

    def test_torsion(self):
        scene = cantilever(section={"shape": "circle", "radius": 0.01},
                           loads=[Load(at="end", moment=[0.0, 0.0, 10.0])],
                           probes=[Probe(name="twist", kind="rotation", component="z")])
        shear = E / 2.6
        self.assertNear(plastica.simulate(scene).probes["twist"][-1],
                        10.0 / (shear * 0.5 * np.pi * 0.01**4), 1e-9)

    def test_motion(self):
        flying = cantilever(
            supports=[], loads=[], beam=Beam(length=1.0, segments=8),
            solver={"analysis": "dynamics", "duration": 0.1, "time_step": 1e-3},
            initial_motions=[InitialMotion(velocity=[0.0, 1.0, 0.0], spin=[2.0, 0.0, 0.0])],
            probes=[Probe(name="turn", kind="rotation", component="x"),
                    Probe(name="way", kind="displacement", at=0.5, component="y")])
        done = plastica.simulate(flying)
        self.assertNear(done.probes["turn"][-1], 0.2, 1e-6)
        self.assertNear(done.probes["way"][-1], 0.1, 1e-6)
        self.assertNear(done.time[-1], 0.1, 1e-12)

    def test_histories(self):
        for history, truth in (
            ({"time": [0.0, 1.0, 3.0], "factor": [0, 1, 0.5]}, np.interp),
            ({"period": 2.0, "cycles": 1, "phase": 0.5 * np.pi, "offset": 0.5},
             lambda t: 0.5 + np.cos(np.pi * t)),
            ({"smooth_step": [0.0, 2.0]}, lambda t: 3.0 * (t / 2) ** 2 - 2.0 * (t / 2) ** 3),
        ):
            scene = cantilever(loads=[Load(at="end", force=[0, -1, 0], history=history)],
                               solver={"steps": 12})
            done = plastica.simulate(scene)
            wanted = (np.interp(done.time, history["time"], history["factor"])
                      if truth is np.interp else truth(done.time))
            # A sine is of cubic pieces, 2e-8 off.
            np.testing.assert_allclose(done.factor, wanted, rtol=0.0, atol=1e-7)

    def test_hardening_in_lists(self):
        scene = plastica.Scene(
            material=Material(youngs_modulus=200e9, yield_stress=300e6, hardening={
                "law": "multilinear", "plastic_strain": [0.01, 0.02],
                "flow_stress": [400e6, 450e6]}),
            drive=plastica.Drive(strain=np.linspace(0.0, 0.02225, 90)))
        stress = plastica.simulate(scene).probes["stress"]
        self.assertNear(stress[-1], 450e6, 1e-9)  # 450 MPa/200 GPa + 0.02

    def test_natural_frequencies(self):
        scene = cantilever(beam=Beam(length=1.0, segments=200), solver={"frequencies": 1})
        scene.loads[0].force = [0.0, -1e-6, 0.0]
        frequency = plastica.simulate(scene).vibration["frequency"][0]
        truth = 1.875104**2 * np.sqrt(EI / (RHO * WIDTH**2)) / (2.0 * np.pi)
        self.assertNear(frequency, truth, 2e-4)  # rotary inertia takes 1e-4


if __name__ == "__main__":
    unittest.main()
