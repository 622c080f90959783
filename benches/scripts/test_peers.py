#!/usr/bin/env python3
"""Tests of the check of the claims in peers.py: `python3 benches/scripts/test_peers.py`."""

import unittest

from peers import ACTIVE, BONSAI, BICA, BOXED, BY_HAND, CALLBACKS, CHAIN_3, CHAIN_10, CHAIN_100, CHANNELS, COPPER, DIAMOND, EMPTY, \
    FALLBACK, FORWARD, LATENT, SEQUENCE, SIZED, SIZED_CHAIN, SIZED_FORWARD, SIZED_MACHINE, SMLANG, STATIG, TIMED, TREE_10, \
    TREE_100, Figures, judge, times


def at_the_limits():
    """Figures at the limits of all claims."""
    figures = Figures()
    ten = {BICA: 15, TIMED: 60, COPPER: 120, CALLBACKS: 300, CHANNELS: 300, BOXED: 19.6, BY_HAND: 13.1}
    figures.times = {(design, CHAIN_10): ns for design, ns in ten.items()}
    figures.times |= {(STATIG, SIZED_MACHINE): 10, (SMLANG, SIZED_MACHINE): 10}
    figures.times |= {(BICA, TREE_10): 11, (BICA, TREE_100): 126.4, (BICA, ACTIVE): 10, (BICA, LATENT): 10.95}
    for workload in [CHAIN_3, CHAIN_100, DIAMOND, FORWARD, *SIZED]:
        figures.times |= {(BICA, workload): 11.5, (BOXED, workload): 15, (BY_HAND, workload): 10}
    figures.times |= {(BICA, SEQUENCE): 10, (BONSAI, SEQUENCE): 40, (BICA, FALLBACK): 10, (BONSAI, FALLBACK): 100}
    figures.heap = {(BICA, CHAIN_10): 0}
    return figures


def violated(figures):
    return [place for place, (_, _, holds) in enumerate(judge(figures)) if not holds]


class Claims(unittest.TestCase):
    def test_figures_at_the_limits_pass(self):
        self.assertEqual(violated(at_the_limits()), [])

    def test_a_slower_bica_violates_each_claim(self):
        for design, workload, by, expected in [
            (BICA, CHAIN_10, 1.01, [0, 2, 3, 11, 12]),
            (BICA, CHAIN_3, 1.001, [10]),
            (BICA, CHAIN_3, 1.01, [9, 10]),
            (BICA, CHAIN_100, 1.1, [13, 14]),
            (BICA, DIAMOND, 1.1, [15, 16]),
            (BICA, FORWARD, 1.1, [17, 18]),
            (BICA, SIZED_CHAIN, 1.01, [19]),
            (BICA, SIZED_FORWARD, 1.01, [20]),
            (BICA, SIZED_MACHINE, 1.01, [21, 22, 23]),
            (TIMED, CHAIN_10, 1.01, [1]),
            (BICA, SEQUENCE, 1.01, [4]),
            (BICA, FALLBACK, 1.01, [5]),
            (BICA, TREE_100, 1.01, [6]),
            (BICA, LATENT, 1.01, [7]),
            (BICA, LATENT, 0.5, []),
        ]:
            figures = at_the_limits()
            figures.times[design, workload] *= by
            self.assertEqual(violated(figures), expected, (design, workload, by))

    def test_a_cost_that_shrinks_with_the_number_is_not_linear(self):
        figures = at_the_limits()
        figures.record(BICA, TREE_100, 93)
        self.assertEqual(violated(figures), [6])

    def test_one_allocation_violates_the_claim(self):
        figures = at_the_limits()
        figures.heap[BICA, FORWARD] = 0.001
        self.assertEqual(violated(figures), [8])

    def test_a_claim_without_a_measurement_does_not_hold(self):
        self.assertEqual(violated(Figures()), list(range(24)))

    def test_the_minimum_time_counts(self):
        figures = at_the_limits()
        figures.record(BICA, CHAIN_10, 99)
        self.assertEqual(violated(figures), [])

    def test_the_table_omits_what_is_empty(self):
        figures = Figures()
        figures.times = {(BICA, CHAIN_10): 15, (COPPER, CHAIN_10): 120}
        text = times(figures, "ns per cycle (times BICA's)", EMPTY)
        self.assertIn("| copper-rs (always timed)    | 120 (8.00 x) |", text)
        self.assertNotIn("statig", text)
        self.assertNotIn("diamond", text)


if __name__ == "__main__":
    unittest.main()
