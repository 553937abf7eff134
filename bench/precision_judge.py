"""What bench/precision.py makes of its runs: errors of histories, the frontier of work against error, fits of the order."""
import bisect
import math

from common import slope


def at_times(times, known, values):
    """A history (dense rows `known`, `values`) at other times, by straight lines between its rows; level beyond its ends."""
    found = []
    for t in times:
        k = min(max(bisect.bisect_left(known, t), 1), len(known) - 1)
        share = (t - known[k - 1]) / (known[k] - known[k - 1])
        found.append(values[k - 1] + min(max(share, 0.0), 1.0) * (values[k] - values[k - 1]))
    return found


def rms(times, values):
    """Root of the mean square over time, by the trapezoidal rule."""
    total = sum((times[k + 1] - times[k]) * (values[k] ** 2 + values[k + 1] ** 2) / 2 for k in range(len(times) - 1))
    return math.sqrt(total / (times[-1] - times[0]))


def errors(run, reference):
    """Errors of a run's histories, as shares: {rms, largest, peak, load}; load is None where nothing bears loads.

    Both are {"time": [..], "force": [..], "tension": [..], "loads": {name: [..]}, "line": number or None}; the reference has
    dense rows. rms and largest: of the force, over the reference's largest; peak: of the largest tension, on the run's rows;
    load: the largest of the loads' RMS differences over the largest load, or the difference of the line load.
    """
    times = run["time"]

    def wrong(values, key):
        return [a - b for a, b in zip(values, at_times(times, reference["time"], key))]

    force = wrong(run["force"], reference["force"])
    scale = max(abs(value) for value in reference["force"])
    peak = max(at_times(times, reference["time"], reference["tension"]))
    load = None
    if reference["loads"]:
        heaviest = max(max(values) for values in reference["loads"].values())
        load = max(rms(times, wrong(run["loads"][name], values)) for name, values in reference["loads"].items()) / heaviest
    elif reference["line"]:
        load = abs(run["line"] / reference["line"] - 1)
    return {"rms": rms(times, force) / scale, "largest": max(abs(value) for value in force) / scale,
            "peak": abs(max(run["tension"]) / peak - 1), "load": load}


def extrapolate(coarse, fine, order=2):
    """Histories for no segment length at all from those with h and h/2, on the latter's times (Richardson)."""
    def limit(a, b):
        return b + (b - a) / (2**order - 1)

    def series(a, b):
        return [limit(*pair) for pair in zip(at_times(fine["time"], coarse["time"], a), b)]

    return {"time": fine["time"], "force": series(coarse["force"], fine["force"]),
            "tension": series(coarse["tension"], fine["tension"]),
            "loads": {name: series(coarse["loads"][name], values) for name, values in fine["loads"].items()},
            "line": limit(coarse["line"], fine["line"]) if fine["line"] else None}


def frontier(points):
    """Points (work, error, ...) than which no other is both cheaper and as accurate, by rising work."""
    kept, best = [], math.inf
    for point in sorted(points, key=lambda p: (p[0], p[1])):
        if point[1] < best:
            kept.append(point)
            best = point[1]
    return kept


def work_for(curve, error):
    """Least work at which a curve of points (work, error), in the order of its parameter, has at most this error.

    Between neighbours of which one has more and one less error the parameter could be chosen: straight in the logarithms.
    None if the curve is never as accurate.
    """
    found = [work for work, wrong in curve if wrong <= error]
    for (work_a, wrong_a), (work_b, wrong_b) in zip(curve, curve[1:]):
        if (wrong_a > error) != (wrong_b > error) and min(wrong_a, wrong_b) > 0:
            share = math.log(error / wrong_a) / math.log(wrong_b / wrong_a)
            found.append(math.exp(math.log(work_a) + share * math.log(work_b / work_a)))
    return min(found, default=None)


def cheapest(curves, error):
    """(work, name) of the cheapest of several curves {name: points} at this error; (None, None) if none gets there."""
    found = [(work_for(points, error), name) for name, points in curves.items()]
    return min(((work, name) for work, name in found if work is not None), default=(None, None))


def fit_order(points, floor, ceiling):
    """Exponent of a power law through points (parameter, value, error) with floor < error < ceiling; None below three."""
    used = [(x, y) for x, y, error in points if floor < error < ceiling]
    return slope([x for x, _ in used], [y for _, y in used]) if len(used) >= 3 else None


def observed_order(errors_by_length, floor=0.0):
    """log2 of the ratio of the errors above the floor with the two finest segment lengths {length: error}; None without two.

    Each length is half of the one before.
    """
    last = [error for _, error in sorted(errors_by_length.items()) if error > floor][:2]
    return math.log2(last[1] / last[0]) if len(last) == 2 else None
