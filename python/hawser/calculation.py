"""What the pulling calculation says."""
from __future__ import annotations

import html
from typing import Any

import pandas as pd

from hawser._tables import frame_of, page_html, shown
from hawser.results import Verdict


class Theory:
    """The pulling calculation of a case (docs/reference/results.md, "What `hawser theory` prints").

    Tables by name: theory["stations"], a DataFrame with the unit in every column's name. `names` says which there are.
    """

    def __init__(self, data: dict[str, Any], text: str) -> None:
        self.data = data  # as `hawser theory --format json` has it
        self._text = text

    @property
    def facts(self) -> dict[str, Any]:
        """Single figures: "largest_force_N" (the largest force that any winch needs, pulled forward, N), "reference_total_N" (at the end,
        with the whole cable in), "backward_total_N", "length_m" and more."""
        return {key: value for key, value in self.data.items() if not isinstance(value, (list, dict))}

    @property
    def names(self) -> list[str]:
        """The tables that the case has."""
        return [key for key, value in self.data.items() if isinstance(value, list)]

    def __getitem__(self, name: str) -> pd.DataFrame:
        if name not in self.names:
            raise KeyError(f"no table {name!r}: there are {', '.join(self.names)}")
        return frame_of(self.data[name])

    @property
    def stations(self) -> pd.DataFrame:
        """Tension by station: s_m, slope_deg, paper_N, reference_N, normal_N_per_m, sidewall_N_per_m."""
        return self["stations"]

    @property
    def limits(self) -> pd.DataFrame:
        """The case's limits, each way of pulling: direction, name, value, limit, unit, margin, ok, source."""
        return self["limits"] if "limits" in self.names else pd.DataFrame()

    def verdict(self, direction: str = "forward") -> Verdict:
        """Whether the pull is safe that way: "forward" or "backward"."""
        return Verdict(self.data[f"verdict_{direction}"])

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<hawser theory of {self.data.get('title')!r}: {self.facts.get('reference_total_N', float('nan')):.4g} N>"

    def _repr_html_(self) -> str:
        forces = [("largest winch force", self.facts.get("largest_force_N")), ("pulled forward", self.facts.get("reference_total_N")),
                  ("pulled backward", self.facts.get("backward_total_N"))]
        verdict = self.data.get("verdict_forward")
        if verdict is None:  # derivatives: tables alone
            return f"<pre>{html.escape(self._text)}</pre>"
        columns = [name for name in ("direction", "name", "value", "limit", "unit", "margin", "ok") if name in self.limits]
        return page_html(str(self.data.get("title", "")), f"forward {verdict}; backward {self.data.get('verdict_backward')}",
                         [(name, shown(value, "N")) for name, value in forces if value is not None], self.limits[columns])
