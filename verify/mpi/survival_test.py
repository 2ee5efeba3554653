# SPDX-License-Identifier: MIT
"""Thirty runs in several processes that are killed, find a damaged checkpoint, or a disk that is full:
none is lost. DSC_SEED chooses others, DSC_TRIALS another number of them."""
import os
import unittest

import survival


class Survival(unittest.TestCase):
    def test_none_is_lost(self):
        trials = survival.run_trials(int(os.environ.get("DSC_TRIALS", "30")),
                                     int(os.environ.get("DSC_SEED", "1")))
        print(survival.table(trials))
        self.assertEqual([(one.number, one.kind, one.lost) for one in trials if one.lost], [])


if __name__ == "__main__":
    unittest.main()
