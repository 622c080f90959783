#!/usr/bin/env python3
"""Tests of the checks of times.py: `python3 benches/scripts/test_times.py`."""

import unittest

from times import draw, findings, merge, row, rows_of

HEADER = {"components": ["Ball"], "phases": ["sensing", "acting", "the whole chain", "with an image"], "budgets_us": [5.0], "chain_us": 9.0}


def rows(*repetitions, budget=5.0):
    """Rows of repetitions in which the component takes these times, ns, and each phase 1 ns."""
    cycles = [[[time, 1, 1, 1, 1] for time in times] for times in repetitions]
    return rows_of(HEADER | {"budgets_us": [budget]}, cycles)


class Checks(unittest.TestCase):
    def test_one_slow_run_exceeds_the_budget(self):
        found = findings(rows([1000, 5100, 1000], [1000, 5300, 1000]), 100, None, [])
        self.assertEqual(found, ["Ball takes 5.1 µs in its slowest run and declares 5.0 µs: make it faster, or raise `budget_us`"])
        self.assertEqual(findings(rows([1000, 5100], budget=5.1), 100, None, []), [])

    def test_an_interruption_appears_only_in_the_maximum(self):
        ball = rows([1000, 90_000, 1000], [1000, 1200, 80_000])[0]
        self.assertEqual((ball["p50"], ball["p99"], ball["max"], ball["ever"]), (1.0, 1.2, 1.2, 90.0))

    def test_a_component_that_never_ran_is_reported(self):
        self.assertIn("Ball ran in none of the games", findings(rows([None]), 100, None, [])[0])

    def test_repetitions_that_differ_are_refused(self):
        self.assertRaises(SystemExit, merge, [[[1]], [[None]]])
        self.assertRaises(ValueError, merge, [[[1], [1]], [[1]]])

    def test_quantiles_use_the_nearest_rank(self):
        found = row("x", range(200, 0, -1), 0, None)
        self.assertEqual((found["p50"], found["p99"], found["max"]), (100, 198, 200))

    def test_a_chain_above_its_limits_is_reported(self):
        self.assertEqual(findings(rows([1]), 0.0001, None, []), ["the slowest chain takes 0.00 ms, the limit is 0.00 ms"])
        self.assertEqual(len(findings(rows([1]), 100, 1e-9, [("chain", 1, 200)])), 2)

    def test_a_bar_above_the_budget_is_red(self):
        self.assertGreater(draw(rows([6000]), "160x120", 100).count("#c0392b"), draw(rows([4000]), "160x120", 100).count("#c0392b"))


if __name__ == "__main__":
    unittest.main()
