#!/usr/bin/env python3
"""Tests of the checks of budget.py: `python3 benches/scripts/test_budget.py`."""

import unittest

from budget import CLAIMS, ONE, USUAL, accepted_slow, changed, claims, hardest, read


def holding():
    """Counts with which every claim holds."""
    counted = {"ten.cycles": 1000, ONE: 100, "chain_of_ten.cycles": 1000, "ten_of_ten.cycles": 1000, "constants.cycles": 1000}
    counted["forward.at_160x120"] = 1000
    for _, small, large, times, _, without in CLAIMS:
        fixed = counted[without] if without else 0
        counted[large] = fixed + times * (counted[small] - fixed)
    return counted


class Checks(unittest.TestCase):
    def test_changes_up_to_two_percent_are_accepted(self):
        for before, now in [(1000, 1000), (1000, 1020), (1000, 980), (92, 96)]:
            self.assertEqual(changed({"walk": before}, {"walk": now}), [])

    def test_larger_changes_are_reported_in_both_directions(self):
        self.assertEqual(changed({"walk": 1000}, {"walk": 1021}), ["walk: 1000 instructions before, 1021 now, +2.10 %"])
        self.assertEqual(len(changed({"walk": 1000}, {"walk": 900})), 1)

    def test_new_and_missing_benchmarks_are_reported(self):
        self.assertEqual(changed({"old": 1}, {"new": 1}), ["new: new, 1 instructions", "old: no longer counted"])

    def test_a_line_without_a_count_is_refused(self):
        self.assertRaises(ValueError, read, "walk many\n")

    def test_a_frame_above_the_bound_is_reported(self):
        counted = {"component.eye": 999, "vision.noise": 51, "vision.flat": 50, USUAL: 10}
        self.assertEqual(hardest(counted), ["vision.noise: 5.1 × a typical frame, at most 5.0 × is allowed"])
        self.assertEqual(len(hardest({"vision.noise": 1})), 1)

    def test_each_claim_can_fail(self):
        self.assertTrue(all(holds for holds, _ in claims(holding())))
        self.assertFalse(any(holds for holds, _ in claims({})))
        for text, _, large, *_ in CLAIMS:
            failed = [line for holds, line in claims(holding() | {large: 2 * holding()[large]}) if not holds]
            self.assertTrue(any(text in line for line in failed), text)

    def test_a_check_that_accepts_the_slowdown_is_reported(self):
        committed = holding() | {"vision.noise": 1000, USUAL: 1000}
        slow = {name: 1_000_000 if "hundred" in name else 10_000 for name in committed} | {USUAL: 1000, ONE: 1100}
        slow |= {"tuned_off.cycles": 11_000, "tunable_forward.at_160x120": 11_000, "a_hundred_robots_of_ten.cycles": 2_000_000}
        self.assertEqual(accepted_slow(committed, slow), [])
        for name, count in [("vision.noise", 4000), ("ten_of_a_hundred.cycles", 10_000), ("ten.cycles", 1010)]:
            self.assertNotEqual(accepted_slow(committed, slow | {name: count}), [], name)


if __name__ == "__main__":
    unittest.main()
