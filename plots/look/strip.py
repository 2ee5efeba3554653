# SPDX-License-Identifier: MIT
"""A line for each configuration with its time on a logarithmic axis: drawn in place of a curve over
sizes if only one size was run."""
import statistics

from matplotlib.ticker import FuncFormatter, NullFormatter

from look import style


def draw(axes, entries, label):
    """entries: [(name, microseconds a repetition, marker keywords, colour)], from top down."""
    entries = entries[::-1]
    for place, (_, times, marks, colour) in enumerate(entries):
        middle = statistics.median(times)
        axes.errorbar(middle, place, xerr=[[middle - min(times)], [max(times) - middle]],
                      fmt="none", ecolor=colour, elinewidth=1, capsize=2.5, zorder=3)
        axes.plot([middle], [place], color=colour, linestyle="none", zorder=4, **marks)
        axes.annotate(style.duration(middle), (max(times), place), (9, 0),
                      textcoords="offset points", va="center", fontsize=8.5, zorder=5,
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8})
    everything = [t for _, times, _, _ in entries for t in times]
    axes.set_xscale("log")
    axes.set_xlim(min(everything) / 2, max(everything) * 5)
    axes.set_ylim(-0.6, len(entries) - 0.4)
    axes.set_yticks(range(len(entries)), [name for name, *_ in entries])
    axes.tick_params(axis="y", length=0)
    axes.grid(True, axis="y", linestyle=(0, (1, 2)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.tick(value)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(label)
