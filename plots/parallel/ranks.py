# SPDX-License-Identifier: MIT
"""Weak scaling over ranks: measured on those of this machine, modelled up to 1,024."""
from look import style
from parallel import rank_model as model

NETWORK = model.Network()
AS_IT_IS, NEIGHBOURS_ONLY = style.VERMILLION, style.BLUE


def draw(runs, context):
    """One Picture of all runs, which are repetitions of one, or none without any."""
    if runs:
        yield _picture(runs, context)


def plain(runs):
    """The modelled number of ranks up to which half of the machines' time is work."""
    enough = max(n for n in range(1, model.MOST + 1) if _band(runs, n)[1] >= 0.5)
    _, value, _ = model.over(runs, model.measured)
    return (f"{runs[0].ranks} ranks with a share each take {1 / value:.2f} times as long for a step "
            f"as one with its own; by the model half of the time is work up to {enough} ranks, "
            "because each repeats what all others do.")


def _band(runs, n, told=None):
    return model.over(runs, lambda r: model.efficiency(r, n, NETWORK, told))


def _line(axes, runs, colour, told, line):
    counts = model.counts()
    bands = [_band(runs, n, told) for n in counts]
    axes.plot(counts, [100 * b[1] for b in bands], color=colour, linestyle=line, zorder=3,
              marker="o", markersize=4.5, **style.hollow(colour))
    axes.fill_between(counts, [100 * b[0] for b in bands], [100 * b[2] for b in bands],
                      color=colour, alpha=0.15, linewidth=0, zorder=2)


def _picture(runs, context):
    fig, grid = style.figure(7.2, 4.4, 1, 1)
    axes = grid[0][0]
    _line(axes, runs, AS_IT_IS, None, style.DASHED)
    _line(axes, runs, NEIGHBOURS_ONLY, model.NEIGHBOURS, (0, (1, 1.5)))
    low, value, high = model.over(runs, model.measured)
    axes.errorbar([runs[0].ranks], [100 * value], color=AS_IT_IS, capsize=2.5, zorder=5,
                  yerr=[[100 * (value - low)], [100 * (high - value)]])
    axes.plot([runs[0].ranks], [100 * value], marker="D", linestyle="none", zorder=6,
              **style.solid(AS_IT_IS))
    axes.set_xscale("log", base=2)
    axes.set_xticks(model.counts(), [style.whole(n) for n in model.counts()])
    axes.set_ylim(0, 105)
    axes.set_xlabel("ranks, each with the same share of the work")
    axes.set_ylabel("efficiency  $t_1\\,/\\,t_n$, %")
    handles = [style.key("measured", AS_IT_IS, "D", "none"),
               style.key("modelled: each tells all others", AS_IT_IS, "o", style.DASHED,
                         style.hollow),
               style.key(f"projected, not built: each tells {model.NEIGHBOURS} neighbours",
                         NEIGHBOURS_ONLY, "o", (0, (1, 1.5)), style.hollow)]
    name = "Several processes: weak scaling, modelled beyond those measured"
    style.finish(fig, name, style.caption_text(context, (
        f"Scene {runs[0].scene}, {style.size_label(runs[0].triangles)} triangles on "
        f"{runs[0].ranks} ranks. Modelled from the times of one rank and a network with "
        f"{NETWORK.latency_us:g} µs a message and {NETWORK.gigabytes_per_s:g} GB/s for each rank, "
        f"if {model.ASSUMPTIONS}. Medians over {style.counted(len(runs), 'run')}, shaded from the "
        "least to the most.")), handles)
    return style.Picture("ranks", name, plain(runs), fig, *_table(runs))


def _table(runs):
    header = ["ranks", "work", "telling", "repeating", "serial", "network", "a step", "efficiency",
              "telling neighbours only"]
    return header, [_row(runs, n) for n in model.counts()]


def _row(runs, n):
    def middle(value):
        return model.over(runs, value)[1]

    times = [middle(lambda r: r.work), middle(lambda r: r.tell if n > 1 else 0),
             middle(lambda r: (n - 1) * r.repeat_one), middle(lambda r: n * r.serial),
             middle(lambda r: NETWORK.told_to(n - 1, r.bytes, r.exchanges)),
             middle(lambda r: model.step(r, n, NETWORK))]
    shares = [middle(lambda r: model.efficiency(r, n, NETWORK)),
              middle(lambda r: model.efficiency(r, n, NETWORK, model.NEIGHBOURS))]
    return [style.whole(n), *map(style.duration, times), *(f"{100 * s:.1f} %" for s in shares)]
