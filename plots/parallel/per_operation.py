# SPDX-License-Identifier: MIT
"""What one operation costs, in nanoseconds: a bar for each operation of the library (thesis,
chapter 7), with the raw ceiling measured on another Delaunay code beside it."""
import statistics

from matplotlib.ticker import FuncFormatter, NullFormatter

from results import load
from parallel import series
from look import style


def costs(bench):
    """[(label, [nanoseconds a repetition])], cheapest first.

    The counter items_per_second counts where it is written, because an iteration may hold a
    batch of operations; otherwise an iteration is one operation.
    """
    found = [m for m in bench.measurements if m.family == "operation" and m.positions]
    names = [m.positions[0] for m in found]
    result = []
    for m in found:
        kin = [k for k in found if k.positions[0] == m.positions[0]]
        words = [f"{k} {v}" for k, v in m.params.items() if k not in ("iterations", "repeats")
                 and len({t.params.get(k) for t in kin}) > 1]
        rates = m.counters.get("items_per_second", [])
        times = [1e9 / r for r in rates if r > 0] if len(rates) == len(m.times_ns) else []
        times = times or m.times_ns
        label = m.positions[0].replace("_", " ")
        if names.count(m.positions[0]) > 1 and words:
            label += f" ({', '.join(words)})"
        result.append((label, times))
    return sorted(result, key=lambda pair: statistics.median(pair[1]))


def plain(found):
    medians = [(label, statistics.median(times)) for label, times in found]
    (first, low), (last, high) = medians[0], medians[-1]
    if len(medians) == 1:
        return f"One {first} takes {style.duration(low / 1e3)}."
    return (f"One operation on the mesh takes from {style.duration(low / 1e3)} ({first}) to "
            f"{style.duration(high / 1e3)} ({last}).")


def sentence(found, ceiling):
    medians = [(label, statistics.median(times)) for label, times in found]
    first, last = medians[0], medians[-1]
    text = f"The cheapest operation is {first[0]} with {style.duration(first[1] / 1e3)}"
    if len(medians) > 1:
        text += f" and the most expensive {last[0]} with {style.duration(last[1] / 1e3)}"
    if ceiling:
        below = sum(cost < ceiling[1] for _, cost in medians)
        text += (f"; {below} of {len(medians)} cost less than a cavity retriangulation of Galois "
                 f"({style.duration(ceiling[0] / 1e3)} to {style.duration(ceiling[1] / 1e3)})")
    return text + "."


def draw(bench, published):
    found = costs(bench)
    if not found:
        return []
    galois = load.entry(published, "peers", "cavity_retriangulation")
    ceiling = sorted(1e9 / v["per_second"] for v in galois["values"]) if galois else None
    fig, grid = style.figure(7.2, 1.55 + 0.34 * len(found))
    axes = grid[0][0]
    everything = [t for _, times in found for t in times] + list(ceiling or [])
    left, right = min(everything) / 3, max(everything) * 3.2
    for place, (label, times) in enumerate(found):
        middle = statistics.median(times)
        axes.barh(place, middle - left, left=left, height=0.6, color=style.BLUE, alpha=0.85,
                  linewidth=0, zorder=2)
        axes.errorbar(middle, place, xerr=[[middle - min(times)], [max(times) - middle]],
                      fmt="none", ecolor=style.INK, elinewidth=1, capsize=2.5, zorder=3)
        axes.text(max(times) * 1.1, place, style.duration(middle / 1e3), va="center", ha="left",
                  fontsize=8.5, zorder=4, color=style.INK,
                  bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8})
    handles = []
    if ceiling:
        axes.axvspan(*ceiling, color=style.VERMILLION, alpha=0.35, linewidth=0, zorder=1)
        handles.append(style.key("one cavity retriangulation of Galois, range of runs",
                                 style.VERMILLION, width=5))
        handles[0].set_alpha(0.35)
    axes.set_xscale("log")
    axes.set_xlim(left, right)
    axes.set_ylim(-0.6, len(found) - 0.4)
    axes.set_yticks(range(len(found)), [label for label, _ in found])
    axes.tick_params(axis="y", length=0)
    axes.grid(False, axis="y")
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.tick(value / 1e3)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("time of one operation")
    style.finish(fig, "Cost per operation", style.caption_text(
        bench.context, "Medians over repetitions; bars from the fastest to the slowest; "
        "logarithmic axis."), handles)
    rows = [[label, f"{statistics.median(times):,.1f}", f"{min(times):,.1f}",
             f"{max(times):,.1f}", str(len(times))] for label, times in found]
    return [style.Picture("per_operation", "Cost per operation", plain(found), fig,
                          ["operation", "median ns", "least ns", "most ns", "repetitions"], rows,
                          sentence(found, ceiling))]
