# SPDX-License-Identifier: MIT
"""What creating and merging copies of the submeshes costs: the thesis's way (strategy copy) beside
the strategies that work in place, as ratios of the times of a step. Measured rows only."""
from parallel import series
from look import style


def ratios(bench):
    """[(copy's row, {strategy: (ratio, row in place)})], in-place rows of the same family, size
    and threads (of several the fastest), and the sequential one."""
    found = series.rows(bench)
    result = []
    for mine in (r for r in found if r.strategy == "copy"):
        beside = {}
        for row in found:
            serial = row.strategy == "sequential"
            if (row.family, row.triangles) != (mine.family, mine.triangles) \
                    or row.strategy in ("copy", "reference") \
                    or not (serial or row.threads == mine.threads):
                continue
            if row.strategy not in beside or row.median < beside[row.strategy][1].median:
                beside[row.strategy] = (mine.median / row.median, row)
        result.append((mine, beside))
    return sorted(result, key=lambda pair: (series.families(found).index(pair[0].family),
                                            pair[0].triangles, pair[0].threads))


def sentence(found):
    """The range of ratios of each strategy in place."""
    spans = {}
    for _, beside in found:
        for strategy, (ratio, _) in beside.items():
            if strategy != "sequential":
                spans.setdefault(strategy, []).append(ratio)
    if not spans:
        return "Copies were measured, but no strategy that works in place."
    words = []
    for strategy, values in sorted(spans.items(), key=lambda pair: style.order(pair[0])):
        low, high = style.digits(min(values)), style.digits(max(values))
        words.append(f"{low if low == high else f'{low} to {high}'} times as long as "
                     f"{strategy}")
    text = ("A step that creates submeshes as copies and merges them takes "
            + style.listing(words) + " in place with the same threads")
    doubtful = sum(mine.doubtful or any(r.doubtful for _, r in beside.values())
                   for mine, beside in found)
    return text + (f"; {doubtful} of {style.counted(len(found), 'row')} were measured "
                   "oversubscribed or under load" if doubtful else "") + "."


def table(bench):
    """(sentence, header, rows), or None where nothing was copied."""
    found = ratios(bench)
    if not found:
        return None
    strategies = sorted({s for _, beside in found for s in beside}, key=style.order)
    header = ["scene", "triangles", "threads", "copy: t_n a step"] + [
        f"copy / {s}" for s in strategies] + [""]
    rows = []
    for mine, beside in found:
        involved = [mine] + [r for _, r in beside.values()]
        flags = ["oversubscribed"] if any(r.oversubscribed for r in involved) else []
        flags += ["under load"] if any(r.loaded for r in involved) else []
        rows.append([series.title(mine.family), style.whole(mine.triangles), str(mine.threads),
                     style.duration(mine.median)]
                    + [style.digits(beside[s][0]) if s in beside else "–" for s in strategies]
                    + [", ".join(flags)])
    return sentence(found), header, rows
