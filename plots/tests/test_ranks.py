# SPDX-License-Identifier: MIT
"""Tests of the model of many ranks and of its picture."""
from parallel import rank_model as model
from parallel import ranks
from results import load
from tests import samples
from tests.samples import Case

NETWORK = model.Network(latency_us=2.0, gigabytes_per_s=12.5)


class Model(Case):
    def run_of(self, **change):
        return model.read(self.write("ranks.json", {**samples.ranks(), **change}))

    def test_a_file_is_read_for_one_rank(self):
        run = self.run_of()
        self.assertAlmostEqual(run.step, 100)
        self.assertAlmostEqual(run.serial, 1)  # 2 for both ranks
        self.assertAlmostEqual(run.alone, 61)
        self.assertAlmostEqual(run.bytes, 25000)
        self.assertAlmostEqual(run.repeat_one, 20)
        self.assertAlmostEqual(self.run_of(ranks=5).repeat_one, 5)

    def test_messages(self):
        self.assertEqual(NETWORK.told_to(0, 25000, 3), 0)
        # A round of each exchange, and 25,000 bytes at 12,500 in a microsecond.
        self.assertAlmostEqual(NETWORK.told_to(1, 25000, 3), 3 * 2 + 2)
        self.assertAlmostEqual(NETWORK.told_to(3, 25000, 3), 3 * 2 * 2 + 3 * 2)
        self.assertAlmostEqual(NETWORK.told_to(4, 25000, 3), 3 * 3 * 2 + 4 * 2)
        self.assertAlmostEqual(NETWORK.told_to(1023, 0, 1), 10 * 2)

    def test_a_step(self):
        run = self.run_of()
        self.assertAlmostEqual(model.step(run, 1, NETWORK), 61)
        self.assertAlmostEqual(model.step(run, 2, NETWORK), 60 + 10 + 20 + 2 + 8)
        self.assertAlmostEqual(model.step(run, 4, NETWORK), 60 + 10 + 60 + 4 + 18)
        self.assertAlmostEqual(model.efficiency(run, 4, NETWORK), 61 / 152)
        self.assertAlmostEqual(model.measured(run), 61 / 100)

    def test_neighbours_alone(self):
        run = self.run_of()
        self.assertAlmostEqual(model.step(run, 2, NETWORK, told=6), 60 + 10 + 20 + 1 + 8)
        seven = model.step(run, 7, NETWORK, told=6)
        self.assertAlmostEqual(seven, 60 + 10 + 120 + 1 + 3 * 3 * 2 + 6 * 2)
        self.assertAlmostEqual(model.step(run, 1024, NETWORK, told=6), seven)

    def test_the_spread_of_repetitions(self):
        runs = [self.run_of(wall_s=s) for s in (0.005, 0.006, 0.0055)]
        self.assertEqual(model.over(runs, lambda run: round(run.step)), (100, 110, 120))

    def test_counts(self):
        self.assertEqual(model.counts(8), [1, 2, 4, 8])
        self.assertEqual(model.counts()[-1], 1024)

    def test_what_cannot_be_a_run_of_ranks_is_refused(self):
        for change, words in (({"ranks": 1}, "two or more"), ({"steps": 0}, "no step"),
                              ({"rank_us_per_step": {"work": 0.0, "tell": 1.0, "wait": 1.0,
                                                     "repeat": 1.0}}, "without work"),
                              ({"rank_us_per_step": {"work": 1.0}}, "'tell'")):
            with self.assertRaisesRegex(load.InputFault, words):
                self.run_of(**change)


class Pictures(Case):
    def test_what_is_modelled_is_labelled(self):
        path = self.write("ranks.json", samples.ranks())
        picture, = ranks.draw([model.read(path)] * 3, None)
        self.assertIn("modelled", picture.title)
        legend = [text.get_text() for legend in picture.figure.legends
                  for text in legend.get_texts()]
        self.assertEqual([text.split(":")[0] for text in legend],
                         ["measured", "modelled", "projected, not built"])
        self.assertIn("2 ranks with a share each take 1.64 times as long", picture.sentence)
        self.assertIn("up to 2 ranks", picture.sentence)  # 61 / 100; 61 / 129 for three
        self.assertEqual([row[0] for row in picture.rows][:3], ["1", "2", "4"])
        self.assertEqual(picture.rows[2][-2], "40.1 %")

    def test_without_runs_there_is_none(self):
        self.assertEqual(list(ranks.draw([], None)), [])

    def test_the_page_has_it(self):
        path = self.write("ranks.json", samples.ranks())
        status, errors, text = self.run_report("--ranks", path)
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("2 ranks with a share each", text)
        status, errors, text = self.run_report()
        self.assertIn("No run in several processes was measured", text)
