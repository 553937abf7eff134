"""A checker with a pocket calculator: the pieces that the page works out, all pieces of its table and the total, from the page's own numbers.

Usage: check_by_hand.py HAWSER CASE...
Each result must be what its formula gives of the numbers as they are printed, within what their last digits leave open.
"""
import html
import math
import os
import re
import subprocess
import sys
import tempfile

NUMBER = r"(-?[\d.]+)"
DEGREE = math.pi / 180


def half(text):
    """Half a unit of a printed number's last digit."""
    return 0.5 * 10.0 ** -len(text.partition(".")[2])


def rounding(formula, texts):
    """The formula of printed numbers, and what their last digits may change of it."""
    values = [float(t) for t in texts]
    result = formula(*values)
    off = sum(abs(formula(*values[:i], v + half(t), *values[i + 1:]) - result) for i, (v, t) in enumerate(zip(values, texts)))
    return result, off


def straight(T, w, mu, L, slope):
    return T + w * L * (mu * math.cos(slope * DEGREE) + math.sin(slope * DEGREE))


def level(T, w, mu, R, turn):
    x = mu * turn * DEGREE
    return T * math.cosh(x) + math.hypot(T, w * R) * math.sinh(x)


def particular(w, mu, R, k, m, slope):
    return -k * w * R / (1 + mu * mu) * (2 * m * math.sin(slope) + (1 - m * m) * math.cos(slope))


def upright(T, w, mu, R, start, end, side=1):
    """One part of a bend in a vertical plane: over a crest (end below start), or in a sag on the inner side (1) or the bottom (-1)."""
    k = 1 if end > start else -1
    m, a, b = k * mu * side, start * DEGREE, end * DEGREE
    return particular(w, mu, R, k, m, b) + (T - particular(w, mu, R, k, m, a)) * math.exp(m * (b - a))


class Page:
    def __init__(self, text):
        self.bad, self.done = [], []
        by_hand = text[text.index("To be followed by hand"):text.index("<details>")]
        self.hand = html.unescape(re.sub(r"<(?!/?(?:b|p|tr|td)\b)[^>]+>", "", by_hand.replace("<br>", "\n")))
        table = text[text.index("The route piece by piece, full of cable (fr"):]
        table = table[:table.index("</table>")]
        heads = [re.sub(r"<[^>]+>", " ", h).split() for h in re.findall(r"<th(?: [^>]*)?>(.*?)(?=<th\b|</tr>)", table, re.S)]
        self.newtons = 1000.0 if "kN" in heads[[" ".join(h[:2]) for h in heads].index("forward: in")] else 1.0
        names = ["name", "from", "to", "angle", "R", "turns", "slope", "mu", "rest", "in", "out"]
        self.rows = [dict(zip(names, map(html.unescape, re.findall(r"<td(?: [^>]*)?>(.*?)(?=<td\b|</tr>)", row)))) for row in table.split("<tr>")[2:]]

    def check(self, what, formula, texts, printed, unit=1.0):
        result, off = rounding(formula, texts)
        off += half(printed) * unit + 1e-9
        self.done.append(what)
        if not abs(result - float(printed) * unit) <= off:
            self.bad.append(f"{what}: {result:.4f} of the page's numbers, {printed} on the page, {off:.4f} by rounding")

    def pieces(self):
        for part in re.findall(r"<b>.*?(?=<p><b>|<p>What)", self.hand, re.S):
            name = re.match(r"<b>(.*?)</b>", part).group(1)
            T, w, mu = re.search(rf"T1 = {NUMBER} N, w = {NUMBER} N/m, μ = {NUMBER}", part).groups()
            shown = re.search(rf"the table of pieces has {NUMBER} N", part).group(1)
            results = re.findall(rf"<b>{NUMBER} N</b>", part)
            if found := re.search(rf"L = {NUMBER} m, α = {NUMBER}°", part):
                self.check(f"{name}, straight", straight, [T, w, mu, *found.groups()], results[0])
            elif found := re.search(rf"R = {NUMBER} m, θ = {NUMBER}°", part):
                self.check(f"{name}, level bend", level, [T, w, mu, *found.groups()], results[0])
            elif "dT/ds" in part:
                self.steps(name, part, w, mu, results[0])
            else:
                self.parts(name, part, T, w, mu, results)
            near = 2e-3 * abs(float(shown)) if "dT/ds" in part else 0.11
            if abs(float(results[-1]) - float(shown)) > near:
                self.bad.append(f"{name}: {results[-1]} by hand, {shown} in the table")
            if found := re.search(rf"T/R = {NUMBER} / {NUMBER} = {NUMBER} N/m", part):
                self.check(f"{name}, T/R", lambda t, r: t / r, found.groups()[:2], found.group(3))

    def parts(self, name, part, T, w, mu, results):
        R = re.search(rf"R = {NUMBER} m", part).group(1)
        for i, (m, a, b) in enumerate(re.findall(rf"m = {NUMBER}, {NUMBER}° … {NUMBER}°", part)):
            side = 1 if float(m) * (1 if float(b) > float(a) else -1) >= 0 else -1
            self.check(f"{name}, {'sag' if float(b) > float(a) else 'crest'}", lambda *v, s=side: upright(*v, s), [T, w, mu, R, a, b], results[i])
            T = results[i]

    def steps(self, name, part, w, mu, result):
        rows = [re.findall(rf"<td>{NUMBER}</td>", r) for r in part.split("<tr>") if "<td>" in r]
        h = re.search(rf"h = L / \d+ = {NUMBER} m", part).group(1)
        for s, T, kappa, tz, nz, bz, N, rate in rows:
            self.check(f"{name}, N at {s} m", lambda t, k, n, b, v: math.hypot(t * k - v * n, v * b), [T, kappa, nz, bz, w], N)
            self.check(f"{name}, dT/ds at {s} m", lambda n, t, u, v: u * n + v * t, [N, tz, mu, w], rate)
        rates = [r[7] for r in rows]
        weights = [1, 2, 2, 1] * (len(rows) // 4)
        self.check(f"{name}, steps", lambda t, step, *k: t + step / 6 * sum(a * b for a, b in zip(weights, k)), [rows[0][1], h, *rates], result)

    def table(self):
        """Every piece that lies level or in a vertical plane, of the table alone; w stands beside the pieces above."""
        w = re.search(rf"w = {NUMBER} N/m", self.hand).group(1)
        u = self.newtons
        for row, after in zip(self.rows, self.rows[1:] + [None]):
            T, out, mu, slope = row["in"], row["out"], row["mu"], row["slope"]
            if row["turns"] == "":
                self.check(f"{row['name']} of the table", lambda t, v, m, a, b, g: straight(t * u, v, m, b - a, g), [T, w, mu, row["from"], row["to"], slope], out, u)
            elif row["turns"] in ("left", "right") and float(slope) == 0:
                self.check(f"{row['name']} of the table", lambda t, v, m, r, g: level(t * u, v, m, r, g), [T, w, mu, row["R"], row["angle"]], out, u)
            elif row["turns"] in ("up", "down"):
                up = 1 if row["turns"] == "up" else -1
                w_, R_ = float(w), float(row["R"])
                if up < 0 or float(T) * u > w_ * R_:
                    self.check(f"{row['name']} of the table", lambda t, v, m, r, g, a: upright(t * u, v, m, r, g, g + up * a),
                               [T, w, mu, row["R"], slope, row["angle"]], out, u)
            if after and after["in"] != out:
                self.bad.append(f"{row['name']}: {out} out, {after['in']} into the next")

    def total(self):
        start, last, drag, winch = re.search(rf"Total: {NUMBER} N at the start, {NUMBER} N out of the last piece, {NUMBER} N of drag on the rope: "
                                             rf"{NUMBER} N at the winch", self.hand).groups()
        self.check("total", lambda a, b: a + b, [last, drag], winch)
        self.check("first piece", lambda a: a, [start], self.rows[0]["in"], self.newtons)
        self.check("last piece", lambda a: a, [last], self.rows[-1]["out"], self.newtons)


def main(hawser, cases):
    bad = []
    for case in cases:
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "page.html")
            subprocess.run([hawser, "theory", case, "--report", "-o", out], check=True, capture_output=True)
            page = Page(open(out, encoding="utf-8").read())
        page.pieces()
        page.table()
        page.total()
        bad += [f"{case}: {b}" for b in page.bad]
        print(f"{case}: {len(page.done)} sums, {len(page.bad)} wrong")
    print("\n".join(bad))
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
