"""Statistics of paired measurements: is one program slower than another beyond noise?

Two programs take turns; pair i gives d_i = log(new / old). What disturbs both members of a pair alike cancels in d_i, and
which of them runs first is drawn anew for every pair, so that an order effect changes the sign of d_i at random.

The median of d has a confidence interval that asks nothing of the distribution but that pairs are independent: among n pairs
the number of d_i below the true median is binomial (n, 1/2), so the interval from the k-th smallest to the k-th largest misses
it with probability 2 P(B <= k - 1) (the sign test, turned round). Times are skewed and have outliers, which neither a mean nor a
t test survives; the rank statistics that use more of the data (Wilcoxon's) need a symmetric distribution.

A report judges several figures at once; each interval gets an equal share of the error that the whole report may make
(Bonferroni), so that equal programs are called different in at most that share of reports.
"""
import math
import statistics


def binomial_below(n, k):
    """P(B <= k) of B binomial (n, 1/2)."""
    return sum(math.comb(n, i) for i in range(k + 1)) / 2 ** n if k >= 0 else 0.0


def rank(n, error):
    """The largest k with 2 P(B <= k - 1) <= error: the interval runs from the k-th smallest to the k-th largest. 0: none."""
    k = 0
    while 2 * k + 2 <= n and 2 * binomial_below(n, k) <= error:
        k += 1
    return k


def least_pairs(error):
    """So many pairs are needed for an interval at all."""
    return 1 + math.ceil(math.log2(1 / error))


def interval(values, error):
    """(low, high) of the median; (-inf, inf) if there are too few values."""
    k = rank(len(values), error)
    ordered = sorted(values)
    return (ordered[k - 1], ordered[-k]) if k else (-math.inf, math.inf)


def judge(old, new, error, least):
    """Compares paired times. Returns {change, low, high, verdict}; changes are new / old - 1.

    error: probability of a false verdict. least: smaller changes are not called changes, whatever their interval: the
    layout of code and stack in memory alone moves times by as much.
    """
    logs = [math.log(b / a) for a, b in zip(old, new)]
    low, high = interval(logs, error)
    change = math.expm1(statistics.median(logs))
    verdict = "no change beyond noise"
    if low > 0 and change > least:
        verdict = "slower"
    elif high < 0 and change < -least:
        verdict = "faster"
    return {"change": change, "low": math.expm1(low), "high": math.expm1(high), "verdict": verdict}
