"""Analysis on synthetic data with known answers. By hand: cd tests && python3 -m unittest
test_packing"""
import unittest

import numpy as np
from tool_support import TOOLS  # noqa: F401  (puts the tools on the path)

import packing


def brute_pairs(x, R, gap=0.0):
    """All pairs by looking at all."""
    distance = np.linalg.norm(x[:, None] - x[None], axis=2)
    return {(i, j) for i, j in zip(*np.nonzero(distance < R[:, None] + R[None] + gap)) if i < j}


def frame(x, z):
    """A frame with some columns."""
    table = np.zeros(len(x), [("x", float), ("y", float), ("z", float)])
    table["x"], table["z"] = x, z
    return table


class Contacts(unittest.TestCase):
    def test_pairs_are_all_pairs(self):
        random = np.random.default_rng(1)
        for gap in (0.0, 0.05, -0.02):
            x, R = random.uniform(-1, 1, (300, 3)), random.uniform(0.02, 0.1, 300)
            found = set(zip(*map(list, packing.pairs(x, R, gap))))
            self.assertEqual(found, brute_pairs(x, R, gap))
            self.assertGreater(len(found), 20)
        flat = np.column_stack([random.uniform(-1, 1, (99, 2)), np.zeros(99)])
        self.assertEqual(set(zip(*map(list, packing.pairs(flat, np.full(99, 0.1))))),
                         brute_pairs(flat, np.full(99, 0.1)))
        self.assertEqual(len(packing.pairs(flat[:1], np.ones(1))[0]), 0)

    def test_coordination_of_a_cubic_lattice(self):
        x = np.array([(i, j, k) for i in range(5) for j in range(5) for k in range(5)], float)
        z = packing.coordination(x, np.full(125, 0.5), 1e-9)
        inside = ((x > 0) & (x < 4)).all(axis=1)
        self.assertTrue((z[inside] == 6).all())
        self.assertEqual(z[0], 3)

    def test_packing_fraction(self):
        x = np.array([(i, j, k) for i in range(4) for j in range(4) for k in range(4)], float)
        low = np.array([0.31, 0.17, 0.43])  # cuts spheres, but holds 8 of them in sum
        share = packing.packing_fraction(x, np.full(64, 0.5), low, low + 2, 89)
        self.assertAlmostEqual(share, np.pi / 6, delta=0.002)
        self.assertEqual(packing.packing_fraction(x, np.full(64, 0.5), (9, 9, 9), (10, 10, 10)), 0)
        self.assertEqual(packing.packing_fraction(x[:1], [5], (0, 0, 0), (1, 1, 1)), 1)


class Heaps(unittest.TestCase):
    def test_line_fit(self):
        x = np.linspace(0, 10, 200)
        slope, shift, error = packing.line_fit(x, 3 * x - 2)
        np.testing.assert_allclose([slope, shift, error], [3, -2, 0], atol=1e-12)
        misses = []
        for seed in range(200):  # the error bar is one standard deviation of the slope
            noise = np.random.default_rng(seed).normal(0, 0.5, 200)
            slope, _, error = packing.line_fit(x, 3 * x - 2 + noise)
            misses.append((slope - 3) / error)
        self.assertAlmostEqual(np.std(misses), 1, delta=0.2)

    def test_angle_of_a_heap(self):
        # A wedge of random grains with flanks of 35 and 25 degrees, its summit at x = 0.4.
        random = np.random.default_rng(2)
        x, z = random.uniform(-1.5, 2.6, 60000), random.uniform(0, 1, 60000)
        left, right = np.tan(np.radians([35, 25]))
        inside = z < np.minimum(1 + left * (x - 0.4), 1 - right * (x - 0.4))
        x, z = x[inside], z[inside]
        angles, errors, lines = packing.angle_of_repose(x, z, np.full(len(x), 0.02))
        self.assertAlmostEqual(angles[0], 35, delta=0.6)
        self.assertAlmostEqual(angles[1], 25, delta=0.6)
        self.assertTrue((errors > 0).all() and (errors < 0.6).all())
        self.assertEqual(len(lines), 2)

    def test_slope_of_a_surface(self):
        random = np.random.default_rng(3)
        x, z = random.uniform(-1, 1, 20000), random.uniform(-1, 1, 20000)
        under = z < -0.5 * x
        angle, error = packing.surface_slope(x[under], z[under], np.full(under.sum(), 0.02), 0.8)
        self.assertAlmostEqual(angle, -np.degrees(np.arctan(0.5)), delta=0.6)
        self.assertLess(error, 0.5)


class Throats(unittest.TestCase):
    def test_arrest(self):
        times = np.arange(10.0)
        passed = np.array([0, 1, 4, 6, 6, 6, 6, 6, 6, 6])
        self.assertEqual(packing.arrest(times, passed, 10 - passed, 2), 3)
        self.assertTrue(np.isnan(packing.arrest(times, passed, 10 - passed, 7)))  # not long enough
        self.assertTrue(np.isnan(packing.arrest(times, passed, 6 - passed, 2)))  # all are through
        self.assertTrue(np.isnan(packing.arrest(times, np.arange(10), 10 - passed, 2)))

    def half_circle(self, discs=12):
        """An arch of discs that touch, and others above it and beside it."""
        angle = np.pi * np.arange(discs + 1) / discs
        radius = 1 / np.sin(np.pi / 2 / discs) / 2
        x, z = -radius * np.cos(angle), radius * np.sin(angle)
        return np.append(x, [0, 1, 99]), np.append(z, [radius + 3, radius + 2, 0]), radius

    def test_an_arch_is_found_and_a_half_circle_has_aspect_ratio_one(self):
        x, z, radius = self.half_circle()
        chain = packing.arch(x, z, np.full(len(x), 0.5), 0.0, 2 * radius - 1)
        self.assertEqual(list(chain), list(range(13)))
        span, height, aspect = packing.arch_shape(x, z, np.full(len(x), 0.5), chain)
        np.testing.assert_allclose([span, height, aspect], [2 * radius, radius, 1])

    def test_a_gap_is_no_arch(self):
        x, z, radius = self.half_circle()
        some = np.ones(len(x), bool)
        some[[5, 6, 7]] = False
        x, z = x[some], z[some] + 20 * (x[some] > 0)
        self.assertEqual(len(packing.arch(x, z, np.full(len(x), 0.5), 0.0, 2 * radius - 1)), 0)
        self.assertEqual(len(packing.arch(x[:0], z[:0], x[:0], 0.0, 1.0)), 0)
        self.assertTrue(np.isnan(packing.arch_shape(x, z, x, np.array([0, 1]))[0]))


class Mixtures(unittest.TestCase):
    def test_lacey_is_zero_unmixed_and_one_random(self):
        random = np.random.default_rng(4)
        x = random.uniform(0, 1, (20000, 3))
        cells = (0, 0, 0), (1, 1, 1), (8, 8, 8)
        unmixed = packing.lacey(*packing.shares(x, x[:, 0] > 0.5, *cells))
        self.assertAlmostEqual(unmixed, 0, delta=1e-12)
        mixed = [packing.lacey(*packing.shares(x, random.random(20000) < 0.3, *cells))
                 for _ in range(20)]
        self.assertAlmostEqual(np.mean(mixed), 1, delta=3 * np.std(mixed) / 20**0.5 + 1e-3)
        half = np.where(x[:, 0] < 0.5, 0.75, 0.25)  # S^2 / S0 = 0.0625 / 0.25
        known = packing.lacey(*packing.shares(x, random.random(20000) < half, *cells))
        self.assertAlmostEqual(known, 0.75, delta=0.02)
        self.assertTrue(np.isnan(packing.lacey(np.array([9, 9]), np.array([9, 9]))))

    def test_shares(self):
        x = np.array([[0.1, 0.1], [0.9, 0.1], [0.9, 0.9]])
        counts, reds = packing.shares(x, [1, 0, 1], (0, 0), (1, 1), (2, 2))
        self.assertEqual(counts.tolist(), [[1, 0], [1, 1]])
        self.assertEqual(reds.tolist(), [[1, 0], [0, 1]])

    def test_dye(self):
        dye = packing.Dye(("x", 0.0), ("z", 0.5))
        self.assertEqual(dye.value(frame([-1, 1], [1, 0.4])).tolist(), [2, 1])
        self.assertEqual(dye.value(frame([-1, -1, 2], [0.4, 0, 1])).tolist(), [0, 1, 2])
        self.assertEqual(dye.value(frame([3, 3, 3], [0, 0, 0])).tolist(), [0, 1, 1])
        self.assertEqual(packing.Dye(("x", 0.0)).value(frame([-1, 1], [9, 9])).tolist(), [0, 1])


class LargeGrains(unittest.TestCase):
    def test_rise(self):
        cycles, height = np.arange(5.0), np.array([1, 1, 2, 4, 3.0])
        self.assertEqual(packing.rise(cycles, height, 3.0), 2.5)
        self.assertEqual(packing.rise(cycles, height, 0.5), 0)
        self.assertTrue(np.isnan(packing.rise(cycles, height, 5.0)))


if __name__ == "__main__":
    unittest.main()
