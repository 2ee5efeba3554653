# SPDX-License-Identifier: MIT
"""The sentence under each diagram of error against time, computed from its points."""
from accuracy import precision_data as data
from look import style


def _seconds(value):
    return style.duration(value * 1e6)


def _times(factor):
    return f"{style.digits(factor, 2 if factor < 100 else 3)} times"


def against_peers(line, peers):
    """Compares the default with the most precise point of another program that it reaches."""
    theirs = [(e, t, p.tool) for p in peers if p.is_measured for e, t in p.points]
    ours = data.points(line)
    if not theirs or not ours:
        return ""
    # For each program its best point among those whose error our line crosses.
    reached = [(e, t, tool, data.time_at(line, e)) for e, t, tool in theirs]
    reached = [r for r in reached if r[3] is not None]
    if reached:
        error, seconds, tool, mine = min(reached)
        text = (f"At an error of {style.digits(error)}, that of {tool} after "
                f"{_seconds(seconds)}, the default takes {_seconds(mine)}, ")
        return text + (f"{_times(seconds / mine)} less" if seconds >= mine else
                       f"{_times(mine / seconds)} as much")
    error, seconds, run = ours[0]
    better = [t for t in theirs if error < t[0] and seconds < t[1]]
    if better:
        close, time, tool = min(better)
        return (f"Already at h = {data.length(run.h)} the default errs by {style.digits(error)} "
                f"after {_seconds(seconds)}, where {tool} errs by {style.digits(close)} after "
                f"{_seconds(time)}")
    close, time, tool = min(theirs)
    error, seconds, run = ours[-1]
    return (f"The default reaches {style.digits(error)} in {_seconds(seconds)}; {tool}, with "
            f"{style.digits(close)} after {_seconds(time)}, is out of its range")


def common_error(lines):
    """The smallest error of the default that another method with a mesh reaches."""
    rivals = [line for m, line in lines.items()
              if m != data.DEFAULT and line[0].group != "markers"]
    return min((e for e, _, _ in data.points(lines[data.DEFAULT])
                if any(data.time_to(line, e) is not None for line in rivals)), default=None)


def among_ours(lines):
    """Which method reaches an error of the default first."""
    error = common_error(lines)
    if error is None:
        return ""
    reached = {m: data.time_to(line, error) for m, line in lines.items()
               if line[0].group != "markers"}
    reached = {m: t for m, t in reached.items() if t is not None}
    base = reached.pop(data.DEFAULT, None)
    if base is None or not reached:
        return ""
    best = min(reached, key=reached.get)
    text = f"of the {len(reached) + 1} methods that reach {style.digits(error)} at the end, "
    # A difference of less than a tenth cannot be measured on a busy machine.
    if reached[best] > base / 1.1:
        worst = max(reached, key=reached.get)
        near = sum(t <= 1.1 * base for t in reached.values())
        text += (f"none is faster than the default ({_seconds(base)}) by more than a tenth"
                 + (f", {near} come within a tenth of it" if near > 1 else
                    ", one comes within a tenth of it" if near else ""))
        return text + (f", and {worst} takes {_times(reached[worst] / base)} as long"
                       if reached[worst] > 1.1 * base else "")
    return (text + f"{best} is the fastest: {_seconds(reached[best])}, "
            f"{_times(base / reached[best])} less than the default")


def against_floor(lines):
    """The time and error of the mesh beside those of a polygon of markers alone."""
    floor = lines.get("markers, cubic")
    mine = data.points(lines[data.DEFAULT])
    if not floor or not mine:
        return ""
    error, seconds, run = mine[-1]
    twin = [(e, t) for e, t, r in data.points(floor) if r.h == run.h]
    if not twin:
        return ""
    return (f"bare markers at h = {data.length(run.h)} err by {style.digits(twin[0][0])} in "
            f"{_seconds(twin[0][1])}, the mesh by {style.digits(error)} in {_seconds(seconds)}")


def plain(lines, peers):
    """The default beside other programs, or alone where none was measured."""
    title = next(iter(lines.values()))[0].title
    if data.DEFAULT not in lines:
        return f"{title}: the default method was not run, so there is nothing to compare with."
    text = against_peers(lines[data.DEFAULT], peers)
    if not text:
        error, seconds, run = data.points(lines[data.DEFAULT])[-1]
        text = (f"with edges of length {data.length(run.h)} the default errs by "
                f"{style.digits(error)} after {_seconds(seconds)}")
    return f"{title}: {text[0].lower()}{text[1:]}."


def sentence(lines, peers):
    title = next(iter(lines.values()))[0].title
    broken = [r for line in lines.values() for r in line if not r.holds]
    if data.DEFAULT not in lines:
        return f"{title}: the default method was not run, so there is nothing to compare with."
    parts = [against_peers(lines[data.DEFAULT], peers), among_ours(lines), against_floor(lines)]
    text = "; ".join(part for part in parts if part)
    if not text:
        error, seconds, run = data.points(lines[data.DEFAULT])[-1]
        text = (f"the default errs by {style.digits(error)} at h = {data.length(run.h)} after "
                f"{_seconds(seconds)}")
    text = text[0].upper() + text[1:] + "."
    if broken:
        methods = sorted({r.method for r in broken}, key=list(lines).index)
        text += (f" In {style.counted(len(broken), 'run')} a triangle was inverted or a vertex "
                 f"did not arrive: {style.listing(methods)}.")
    return text
