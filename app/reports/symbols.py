"""Reads a name of the code as the symbol that a reader knows: ``mu_L`` is a Greek mu with the subscript L."""

import re
from dataclasses import dataclass
from functools import lru_cache

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
    "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "omicron": "ο", "pi": "π", "rho": "ρ",
    "sigma": "σ", "tau": "τ", "upsilon": "υ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "Gamma": "Γ",
    "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Phi": "Φ", "Psi": "Ψ",
    "Omega": "Ω",
}  # fmt: skip
"""Names of Greek letters as they are spelt in code."""
_PREFIX = "Delta"
"""A leading ``Delta_`` belongs to what follows: ``Delta_t_1`` is the difference Δt with the subscript 1."""


@dataclass(frozen=True)
class Symbol:
    """A symbol taken apart: ``prefix`` (Δ or nothing), ``base``, ``primes`` and ``subscript``, all plain text."""

    base: str
    subscript: str = ""
    prefix: str = ""
    primes: str = ""

    @property
    def text(self) -> str:
        """The symbol in one line of plain text.

        >>> read("mu_L").text, read("J_RED_s").text
        ('μ_L', 'J_RED,s')
        """
        return f"{self.prefix}{self.base}{self.primes}" + (f"_{self.subscript}" if self.subscript else "")


@lru_cache(maxsize=2000)
def read(name: str) -> Symbol:
    """Read a name: parts are divided by ``_``, the first is the base and the others are its subscript.

    >>> read("Delta_x"), read("x_dd").subscript, read("eta'").primes, read("M1").subscript
    (Symbol(base='x', subscript='', prefix='Δ', primes=''), 'dd', '′', '1')
    """
    parts = [part for part in name.strip().split("_") if part]
    prefix = ""
    if len(parts) > 1 and parts[0] == _PREFIX:
        prefix, parts = GREEK[_PREFIX], parts[1:]
    if not parts:
        return Symbol(name)
    base, primes = parts[0].rstrip("'′"), "′" * (len(parts[0]) - len(parts[0].rstrip("'′")))
    numbered = re.fullmatch(r"([^\W\d]+)(\d+)", base)
    below = [*([numbered[2]] if numbered else []), *parts[1:]]
    letter = numbered[1] if numbered else base
    return Symbol(GREEK.get(letter, letter), ",".join(_greek_words(part) for part in below), prefix, primes)


def _greek_words(part: str) -> str:
    return ",".join(GREEK.get(word, word) for word in part.split(","))
