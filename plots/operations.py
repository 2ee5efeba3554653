#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the cost of one operation: flip, split, collapse and the others of the thesis's chapter 7.

operations.py FILE.json... --out PICTURE.pdf

The files are results of dsc_bench with rows operation/NAME (also = ["operation"] in a suite).
"""
import sys

from look import script, style  # first: reports a Python without matplotlib

from results import load


def costs(bench):
    """[(label, [nanoseconds, one for each repetition])], cheapest first.
    The counter items_per_second is used if it is present, because an iteration may have a
    batch of operations; otherwise an iteration is one operation.
    """
    found = [m for m in bench.measurements if m.family == "operation" and m.positions]
    result = []
    for m in found:
        kin = [k for k in found if k.positions[0] == m.positions[0]]
        words = [f"{k} {v}" for k, v in m.params.items() if k not in ("iterations", "repeats")
                 and len({t.params.get(k) for t in kin}) > 1]
        rates = m.counters.get("items_per_second", [])
        times = [1e9 / r for r in rates if r > 0] if len(rates) == len(m.times_ns) else []
        label = m.positions[0].replace("_", " ") + (f" ({', '.join(words)})" if words else "")
        result.append((label, times or m.times_ns))
    return sorted(result, key=lambda pair: style.interval(pair[1])[1])


def plain(found):
    (first, low), (last, high) = ((label, style.interval(times)[1]) for label, times in
                                  (found[0], found[-1]))
    if len(found) == 1:
        return f"One {first} takes {style.duration(low / 1e3)}."
    return (f"One operation on the mesh takes from {style.duration(low / 1e3)} ({first}) to "
            f"{style.duration(high / 1e3)} ({last}).")


def draw(bench, published):
    found = costs(bench)
    if not found:
        return []
    ceiling = sorted(1e9 / v["per_second"]
                     for v in load.values(published, "peers", "cavity_retriangulation"))
    fig, grid = style.figure(7.2, 1.55 + 0.34 * len(found))
    axes = grid[0][0]
    everything = [t for _, times in found for t in times] + ceiling
    left = min(everything) / 3
    for place, (_, times) in enumerate(found):
        low, middle, high = style.interval(times)
        axes.errorbar(middle, place, xerr=[[middle - low], [high - middle]], fmt="o", color=style.BLUE,
                      ecolor=style.INK, elinewidth=1, capsize=2.5, zorder=3)
        axes.text(high * 1.1, place, style.duration(middle / 1e3), va="center", fontsize=8.5,
                  zorder=4, color=style.INK, bbox={"facecolor": "white", "edgecolor": "none",
                                                   "pad": 0.6, "alpha": 0.8})
    handles = []
    if ceiling:
        axes.axvspan(*ceiling, color=style.VERMILLION, alpha=0.35, linewidth=0, zorder=1)
        handles.append(style.square("one cavity retriangulation of Galois, range of runs",
                                    style.VERMILLION))
    axes.set(xscale="log", xlim=(left, max(everything) * 3.2), ylim=(-0.6, len(found) - 0.4),
             xlabel="time of one operation")
    axes.set_yticks(range(len(found)), [label for label, _ in found])
    axes.tick_params(axis="y", length=0)
    axes.grid(False, axis="y")
    axes.xaxis.set_major_formatter(lambda value, _: style.tick(value / 1e3))
    axes.minorticks_off()
    style.finish(fig, "Cost per operation", style.caption_text(
        bench.context, style.bars_text([len(times) for _, times in found])), handles)
    return [style.Picture(
        "operations", "Cost per operation", plain(found), fig,
        ["operation", "median ns", "least ns", "most ns", "repetitions"],
        [[label, *(f"{value:,.1f}" for value in (style.interval(times)[1], min(times), max(times))),
          str(len(times))] for label, times in found])]


def main(argv=None):
    return script.main(__doc__, lambda given: draw(load.read_bench(given.files), {}), argv)


if __name__ == "__main__":
    sys.exit(main())
