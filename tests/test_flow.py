"""flow.py on synthetic data with known answers; two teaching scenes from solver to result.csv."""
import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

TOOLS = Path(__file__).resolve().parents[1] / "tinydem"
sys.path.insert(0, str(TOOLS))
import flow  # noqa: E402

SCENE = {"rho": 2000.0, "E": 1e8, "nu": 0.25, "en": 0.9, "mus": 0.2}


class Fits(unittest.TestCase):
    """Lines and powers."""

    def test_exact_line(self):
        """Points on a line give it back, without an error."""
        x = np.array([0.0, 1, 3, 4])
        line = flow.line_fit(x, 2 - 0.5 * x)
        self.assertAlmostEqual(line.a, 2, 12)
        self.assertAlmostEqual(line.b, -0.5, 12)
        self.assertLess(line.db, 1e-12)

    def test_errors_are_those_of_many_trials(self):
        """The scatter of fits to noisy points is the error that a fit claims, within 10 %."""
        random, x, dy = np.random.default_rng(1), np.linspace(0, 5, 20), 0.3
        for known in (True, False):
            fits = [flow.line_fit(x, 1 + 2 * x + random.normal(0, dy, 20),
                                  np.full(20, dy) if known else None) for _ in range(1000)]
            self.assertAlmostEqual(np.std([f.b for f in fits]) / np.mean([f.db for f in fits]), 1,
                                   delta=0.1)
            self.assertAlmostEqual(np.std([f.a for f in fits]) / np.mean([f.da for f in fits]), 1,
                                   delta=0.1)

    def test_zero(self):
        """Where a line meets the axis, and how much that scatters."""
        random, x, dy = np.random.default_rng(10), np.linspace(3, 5, 20), np.full(20, 0.05)
        zeros = [flow.line_fit(x, 2 * x - 4 + random.normal(0, 0.05, 20), dy).zero()
                 for _ in range(1000)]
        zero, error = np.array(zeros).T
        self.assertAlmostEqual(zero.mean(), 2, delta=0.01)
        self.assertAlmostEqual(zero.std() / error.mean(), 1, delta=0.1)

    def test_chi2_sees_a_wrong_model(self):
        """About 1 for a line with its noise, large for a parabola."""
        random, x = np.random.default_rng(2), np.linspace(0, 1, 200)
        y, dy = x + random.normal(0, 0.05, 200), np.full(200, 0.05)
        self.assertAlmostEqual(flow.line_fit(x, y, dy).chi2, 1, delta=0.3)
        self.assertGreater(flow.line_fit(x, y + 2 * x**2, dy).chi2, 5)

    def test_power(self):
        """An exact power law."""
        x = np.array([1.0, 2, 5, 9])
        law = flow.power_fit(x, 3 * x**1.7)
        self.assertAlmostEqual(law.b, 1.7, 12)
        self.assertAlmostEqual(np.exp(law.a), 3, 11)

    def test_block_mean_of_noise(self):
        """For independent values the error is sigma/sqrt(n), within the spread of five blocks."""
        random = np.random.default_rng(3)
        results = [flow.block_mean(random.normal(7, 1, 100)) for _ in range(300)]
        means, errors = np.array(results).T
        self.assertAlmostEqual(means.mean(), 7, delta=0.02)
        self.assertAlmostEqual(np.sqrt(np.mean(errors**2)), 0.1, delta=0.01)


class Waves(unittest.TestCase):
    """Rows of spheres."""

    def test_peak_and_width_of_a_gaussian(self):
        """Between the samples; sampled with four points per sigma."""
        t = np.linspace(0, 10, 161)
        f = 3 * np.exp(-0.5 * ((t[:, None] - [4.03, 6.21]) / 0.25)**2) + 1e-300
        time, top = flow.peaks(t, f)
        np.testing.assert_allclose(time, [4.03, 6.21], rtol=1e-9)
        np.testing.assert_allclose(top, 3, rtol=1e-9)
        self.assertAlmostEqual(flow.width_at_half(t, f[:, 0]), 2.3548 * 0.25, delta=2e-3)

    def test_two_spheres_swap_velocities(self):
        """The ODE of a chain of two equal spheres, and the momentum of unequal ones."""
        x, v = flow.hertz_chain([0, 0.021], [1, 0], [0.01, 0.01], SCENE, np.array([0.0, 0.02]))
        np.testing.assert_allclose(v[-1], [0, 1], atol=1e-7)
        np.testing.assert_allclose(x[0], [0, 0.021])
        _, v = flow.hertz_chain([0, 0.031], [1, 0], [0.02, 0.01], SCENE, np.array([0.03]))
        np.testing.assert_allclose(v[0], [7 / 9, 16 / 9], atol=1e-7)  # masses 8 : 1

    def test_duration_of_a_collision(self):
        """Hertz's 2.94 delta/v against the ODE: when do the spheres part?"""
        scene, t = SCENE, np.linspace(0, 2e-3, 20001)
        x, _ = flow.hertz_chain([0, 0.02], [1, 0], [0.01, 0.01], scene, t)
        touching = np.diff(x, axis=1)[1:, 0] < 0.02
        self.assertAlmostEqual(t[1:][touching].max() / flow.hertz_duration(1.0, 0.01, scene), 1, 3)

    def test_nesterenko(self):
        """The form with the force: V = 0.6802 (2E/(a rho^1.5 (1 - nu^2)))^(1/3) F^(1/6)."""
        v, a = 0.1, 0.02
        V = flow.nesterenko_speed(v, SCENE)
        E, rho, nu = SCENE["E"], SCENE["rho"], SCENE["nu"]
        force = E * a**2 / (3 * (1 - nu**2)) * (v / V)**1.5  # strain v/V
        same = 0.6802 * (2 * E / (a * rho**1.5 * (1 - nu**2)))**(1 / 3) * force**(1 / 6)
        self.assertAlmostEqual(V / same, 1, 3)
        self.assertAlmostEqual(flow.nesterenko_speed(32 * v, SCENE) / V, 2, 12)
        self.assertAlmostEqual(np.cos(np.sqrt(10) / 5 * flow.NESTERENKO_WIDTH / 2)**4, 0.5, 12)


class Flows(unittest.TestCase):
    """Silos, chutes, heaps."""

    def test_discharge(self):
        """The slope, and no error for a constant rate; noise gives its error."""
        t = np.linspace(0, 3, 61)
        rate, error = flow.discharge_rate(t, 40 + 250 * t)
        self.assertAlmostEqual(rate, 250, 9)
        self.assertLess(error, 1e-9)
        random = np.random.default_rng(4)
        steps = random.poisson(20, (400, 60))
        results = np.array([flow.discharge_rate(t, np.append(0, s.cumsum())) for s in steps])
        self.assertAlmostEqual(results[:, 0].mean(), 400, delta=2)
        self.assertAlmostEqual(results[:, 0].std() / np.sqrt(np.mean(results[:, 1]**2)), 1,
                               delta=0.12)

    def test_beverloo(self):
        """C, k and the exponent of exact rates; the claimed errors cover noise."""
        D = np.array([6.0, 8, 10, 14])
        for power in (1.5, 2.5):
            C, k, *_ = flow.beverloo_fit(D, 30 * (D - 1.4)**power, 0.01 * D, power)
            self.assertAlmostEqual(C, 30, 8)
            self.assertAlmostEqual(k, 1.4, 8)
            self.assertAlmostEqual(
                flow.beverloo_exponent(D, 30 * (D - 1.4)**power, D, 1.4)[0], power, 10)
        random, W = np.random.default_rng(5), 30 * (D - 1.4)**1.5
        fits = np.array([flow.beverloo_fit(D, W * (1 + random.normal(0, 0.02, 4)), 0.02 * W)
                         for _ in range(500)])
        self.assertAlmostEqual(fits[:, 1].std() / fits[:, 3].mean(), 1, delta=0.15)
        self.assertAlmostEqual(fits[:, 0].std() / fits[:, 2].mean(), 1, delta=0.15)
        self.assertAlmostEqual(fits[:, 4].mean(), 1, delta=0.15)

    def test_bagnold(self):
        """Any exponent is found again, with an error that covers the noise."""
        z, h, random = np.linspace(1, 8, 12), 10.0, np.random.default_rng(6)
        for n in (1.0, 1.5):
            v = flow.bagnold(z, h, 0.2, 1.3, n)
            dv = np.full(12, 0.002)
            best, error = flow.bagnold_fit(z, v + random.normal(0, 0.002, 12), dv, h)
            self.assertLess(abs(best[2] - n), 3 * error[2])
            self.assertLess(error[2], 0.1)
        self.assertEqual(flow.bagnold(12.0, h, 0.2, 1.3), 1.5)  # above the surface

    def test_cone(self):
        """Grains at random in a cone: its height profile and its foot."""
        random, number, foot, top = np.random.default_rng(7), 40000, 0.5, 0.2
        r = foot * np.sqrt(random.uniform(size=number))
        frame = np.zeros(number, [(name, float) for name in "xyzR"])
        angle = random.uniform(0, 2 * np.pi, number)
        keep = random.uniform(size=number) < 1 - r / foot  # as many as the cone is high there
        frame["x"], frame["y"] = r * np.cos(angle), r * np.sin(angle)
        frame = frame[keep]
        volume = np.pi / 3 * foot**2 * top
        frame["R"] = (0.6 * volume / len(frame) * 3 / (4 * np.pi))**(1 / 3)
        edges = np.linspace(0, 0.6, 31)
        h, centre = flow.height_profile(frame, edges), (edges[1:] + edges[:-1]) / 2
        np.testing.assert_allclose(h[5:20], top * (1 - centre[5:20] / foot), atol=0.012)
        front, error = flow.runout(centre, h, 0.02, 0.12)
        self.assertLess(abs(front - foot), 3 * error)
        self.assertLess(error, 0.01)
        self.assertTrue(np.isnan(flow.runout(centre, 0 * h, 0.02, 0.12)[0]))

    def test_lube(self):
        """Its two branches."""
        np.testing.assert_allclose(flow.lube_runout([0.5, 1, 4]), [0.62, 1.24, 3.2])

    def test_binned(self):
        """Means, numbers and empty bins."""
        mean, number = flow.binned([0.1, 0.2, 2.5], [1.0, 3.0, 5.0], [0, 1, 2, 3])
        np.testing.assert_array_equal(number, [2, 0, 1])
        np.testing.assert_array_equal(mean, [2, np.nan, 5])


class Gas(unittest.TestCase):
    """Haff's law and kinetic theory."""

    def test_fit_of_an_exact_law(self):
        """tau and exponent of exact data."""
        t = np.linspace(0, 10, 200)
        E = 5 / (1 + t / 2.5)**2
        tau, error = flow.haff_fit(t, E)
        self.assertAlmostEqual(tau, 2.5, 9)
        self.assertLess(error, 1e-9)
        self.assertAlmostEqual(flow.haff_exponent(t, E, 2.5)[0], 2, 9)
        self.assertAlmostEqual(flow.haff_exponent(t, 5 / (1 + t / 2.5)**1.7, 2.5)[0], 1.7, 9)

    def test_error_of_tau(self):
        """Collisions at random instants: the scatter of tau is what the error says."""
        random, taus = np.random.default_rng(8), []
        for _ in range(300):
            y = np.append(0, np.cumsum(random.exponential(0.01, 200)))  # a jump per collision
            t = 2.0 * 0.01 * np.arange(201)
            taus.append(flow.haff_fit(t, 1 / (1 + y)**2))
        taus, errors = np.array(taus).T
        self.assertAlmostEqual(taus.mean(), 2, delta=0.03)
        self.assertAlmostEqual(taus.std() / np.sqrt(np.mean(errors**2)), 1, delta=0.35)

    def test_kinetic_theory_of_a_thin_gas(self):
        """In a huge box only the dilute rate is left: zeta = 4/3 (1 - e^2) n d^2 sqrt(pi T/m)."""
        R, N, side, energy = 1e-3, 1000, 100.0, 1e-6
        mass = 4 / 3 * np.pi * SCENE["rho"] * R**3
        T, n = 2 * energy / 3 / N, N / side**3
        zeta = 4 / 3 * (1 - SCENE["en"]**2) * n * (2 * R)**2 * np.sqrt(np.pi * T / mass)
        _, pairs, walls = flow.haff_time(SCENE, R, N, side, energy)
        self.assertAlmostEqual(pairs * zeta / 2, 1, 4)
        flux = n * np.sqrt(T / (2 * np.pi * mass))  # of grains on a unit of wall; each brings T
        loss = (1 - SCENE["en"]**2) * flux * T * 6 * side**2
        self.assertAlmostEqual(walls * loss / (2 * energy), 1, 3)

    def test_room_at_the_walls(self):
        """The share of directions with room for a neighbour, against throwing dice."""
        random, q = np.random.default_rng(9), 0.05
        x, n = random.uniform(size=(400000, 3)), random.normal(size=(400000, 3))
        other = x + q * n / np.linalg.norm(n, axis=1)[:, None]
        share = np.mean(np.all((other > 0) & (other < 1), axis=1))
        room = 1 - 3 / 2 * q + 2 / np.pi * q**2 - q**3 / (4 * np.pi)
        self.assertAlmostEqual(share, room, delta=4 * np.sqrt(room * (1 - room) / 400000))


class Billiard(unittest.TestCase):
    """Closed forms of the table."""

    def test_rolling_share(self):
        """5/7 on a hard table; less on a soft one."""
        self.assertAlmostEqual(flow.rolling_share(0.03, 0), 5 / 7, 14)
        self.assertLess(flow.rolling_share(0.03, 0.003), 5 / 7)

    def test_throw(self):
        """Coulomb's angle for hard balls; sliding and sticking meet at tan = 7/2 mu (1 + e)."""
        hard = {**SCENE, "E": 1e30}
        limit = np.arctan(3.5 * SCENE["mus"] * (1 + SCENE["en"]))
        self.assertAlmostEqual(flow.sliding_throw(limit, 1.0, 0.03, hard), np.arctan(0.2), 9)
        self.assertAlmostEqual(flow.sticking_throw(limit, SCENE), np.arctan(0.2), 12)
        self.assertLess(flow.sliding_throw(limit, 1.0, 0.03, SCENE), np.arctan(0.2))


@unittest.skipUnless("TINYDEM" in os.environ, "set TINYDEM to the program")
class Scenes(unittest.TestCase):
    """Solver, measure.py and result.csv of the scenes that run in a second."""

    def measure(self, name):
        """{quantity: (value, error, expected text)} of a scene."""
        scene = TOOLS / "scenes" / name
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["TINYDEM"], "", "", folder, "--quiet", "--scene",
                            scene / "scene.ini"], check=True)
            subprocess.run([sys.executable, scene / "measure.py", folder], check=True,
                           stdout=subprocess.DEVNULL)
            self.assertGreater((Path(folder) / "result.png").stat().st_size, 10000)
            with open(Path(folder) / "result.csv", newline="") as file:
                rows = list(csv.DictReader(file))
        return {r["quantity"]: (float(r["value"]), float(r["error"]), r["expected"]) for r in rows}

    def test_newtons_cradle(self):
        """Second order in dt: measured 7e-6 of the striking speed. The line: to the last bit."""
        results = self.measure("newtons_cradle")
        for row in (1, 2, 3, 4):
            self.assertLess(results[f"row {row}, largest difference to the ODE"][0], 2e-5)
        share, _, expected = results["row 2, last ball / striker"]
        self.assertAlmostEqual(share, 0.98747, 5)
        self.assertAlmostEqual(float(expected.split(",")[0]), 0.98747, 5)
        self.assertLess(abs(results["relative change of the momentum"][0]), 1e-14)
        self.assertEqual(results["way off the line"][0], 0)

    def test_billiard(self):
        """Rolling: 1e-6 off the closed form; throw: 0.001 degrees, of cuts that stick far more."""
        results = self.measure("billiard")
        rolling, _, expected = results["ball 0, speed of rolling / speed of the start"]
        self.assertAlmostEqual(rolling, float(expected.split(",")[0]), delta=5e-6)
        throw = results["throw - closed form, mean of the cuts that slide"]
        self.assertLess(abs(throw[0]), 0.01)
        self.assertLess(results["throw angle at a cut of 5 degrees"][0], 0.5)


if __name__ == "__main__":
    unittest.main()
