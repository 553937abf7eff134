"""Units worked out from their symbols alone, with nothing of the product's: "kN m2", "N.m/rad", "6 m/min" as a factor and powers
of kg, m, s and rad."""
import math
import re

# symbol: factor, (kg, m, s, rad)
SYMBOLS = {"m": (1, (0, 1, 0, 0)), "g": (1e-3, (1, 0, 0, 0)), "t": (1e3, (1, 0, 0, 0)), "s": (1, (0, 0, 1, 0)),
           "min": (60, (0, 0, 1, 0)), "h": (3600, (0, 0, 1, 0)), "rad": (1, (0, 0, 0, 1)), "deg": (math.pi / 180, (0, 0, 0, 1)),
           "N": (1, (1, 1, -2, 0)), "Pa": (1, (1, -1, -2, 0)), "Hz": (1, (0, 0, -1, 0)), "J": (1, (1, 2, -2, 0)), "W": (1, (1, 2, -3, 0)),
           "rpm": (2 * math.pi / 60, (0, 0, -1, 1)), "%": (0.01, (0, 0, 0, 0)), "1": (1, (0, 0, 0, 0))}
PREFIXES = {"k": 1e3, "M": 1e6, "G": 1e9, "m": 1e-3, "c": 1e-2, "u": 1e-6, "": 1}


def symbol(text):
    if text in SYMBOLS:
        return SYMBOLS[text]
    factor, powers = SYMBOLS[text[1:]]
    return PREFIXES[text[0]] * factor, powers


def unit(text):
    """(factor, (kg, m, s, rad)) of a unit."""
    factor, powers = 1.0, [0, 0, 0, 0]
    for place, part in enumerate(text.split("/")):
        for word in re.split(r"[ .*]", part):
            name, power = re.fullmatch(r"([A-Za-z%1]+?)(-?\d+)?", word).groups() if word != "1" else ("1", None)
            sign = (-1 if place else 1) * int(power or 1)
            one, own = symbol(name)
            factor *= one ** sign
            powers = [p + sign * q for p, q in zip(powers, own)]
    return factor, tuple(powers)


def column(name):
    """The unit at the end of a column's name: "slip_m_per_s" has m/s, "mean" none."""
    words = r"(?:kg|rad|m2|m|s|N|W|Pa|J)"
    found = re.search(rf"_({words}(?:_m\b)?)(?:_per_({words}))?$", name)
    return unit(found.group(1).replace("_", " ") + (f"/{found.group(2)}" if found.group(2) else "")) if found else unit("1")
