"""What the bench makes of its runs. By hand: cd tests && python3 -m unittest test_bench"""
import sys
import unittest
from pathlib import Path

VERIFICATION = Path(__file__).resolve().parents[1] / "verification"
sys.path[:0] = [str(VERIFICATION / "bench"), str(VERIFICATION)]
import lammps_runs  # noqa: E402  (after the path is set)
import machinery  # noqa: E402
from parts import scaling  # noqa: E402


class Bench(unittest.TestCase):
    RUNS = ({"time": 6, "blocks": [1, 2, 3], "pairs": 4},
            {"time": 9, "blocks": [4, 4, 1], "pairs": 4},
            {"time": 7, "blocks": [2, 1, 4], "pairs": 4})

    def test_a_block_counts_at_its_lowest(self):
        self.assertEqual(machinery.summary(self.RUNS),
                         {"time": 7, "low": 6, "high": 9, "floor": 1 + 1 + 1, "pairs": 4})

    def test_one_run_is_its_own_floor(self):
        result = machinery.summary(self.RUNS[:1])
        self.assertEqual((result["floor"], result["time"]), (6, 6))

    def test_words_of_a_time(self):
        self.assertEqual(machinery.cell(machinery.summary(self.RUNS)), "3 (7 ± 21 %)")

    def test_rates_count_at_their_highest(self):
        self.assertEqual(machinery.highest([{"a": 1, "b": 5}, {"a": 2, "b": 4}]), {"a": 2, "b": 5})

    def test_what_the_program_prints(self):
        self.assertEqual(machinery.parse("time,3,ns\nblocks,1 2,ns\npairs,4.5,1\n"),
                         {"time": 3, "blocks": [1, 2], "pairs": 4.5})
        self.assertEqual(machinery.parse("blocks,3,ns\n"), {"blocks": [3]})

    def test_clock_of_lammps_is_that_of_its_last_run(self):
        text = "Step CPU\n 0 0\n 9 7.5\nLoop time of 7.5 on 1 procs\nPer MPI rank memory\n" \
               "Step          CPU\n 10   0 \n   15  0.25\n 20 0.75\n" \
               "Loop time of 0.75 on 1 procs\n99.9% CPU use with 1 MPI tasks\n"
        self.assertEqual(lammps_runs.clock(text), [0, 0.25, 0.75])

    def test_exponents(self):
        rows = [{"state": "packing", "N": n, "ours1_time": 5 * n ** 0.1, "ours1_floor": 2,
                 "ours1_contacts": n ** 0.05} for n in (1000, 10_000, 100_000)]
        rows.append({"state": "poly", "N": 7, "ours1_time": 1, "ours1_floor": 1})
        for value, contacts, p in (("time", False, 1.1), ("floor", False, 1),
                                   ("time", True, 1.1 / 1.05)):
            self.assertAlmostEqual(scaling.exponent(rows, "ours1", contacts, value), p)


if __name__ == "__main__":
    unittest.main()
