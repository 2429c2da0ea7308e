r"""The reference writes symbols with macros of its own; the specs write plain LaTeX. This is the translation between them.

`\LU{0}{x}` becomes `{}^{0}x`, other macros are replaced as the table says, and braces around a single `\mathbf{x}` are dropped
unless an accent stands before them.
"""

from __future__ import annotations

import re

_GREEK = ("omega", "alpha", "psi", "nu", "theta", "lambda", "tau", "Psi", "Phi")
_PLAIN = {
    r"\cConfig": r"_{\mathrm{config}}",
    r"\cRef": r"_{\mathrm{ref}}",
    r"\cIni": r"_{\mathrm{ini}}",
    r"\tp": r"^{\mathsf{T}}",
    r"\indf": r"_{\mathrm{f}}",
    r"\indr": r"_{\mathrm{r}}",
    r"\indt": r"_{\mathrm{t}}",
    r"\indred": r"_{\mathrm{red}}",
    r"\induser": r"_{\mathrm{user}}",
    r"\Rcal": r"\mathbb{R}",
    r"\Ncal": r"\mathbb{N}",
    r"\Rot": r"\mathbf{A}",
    r"\Null": r"\mathbf{0}",
    r"\pLocB": r"{}^{b}\mathbf{b}",
    r"\pRefG": r"{}^{0}\mathbf{r}",
    r"\pRef": r"\mathbf{r}",
    **{rf"\t{letter}": rf"{{\boldsymbol{{\{letter}}}}}" for letter in _GREEK},
}
_SIMPLE = re.compile(r"\\mathbf\{\w\}|\\d?dot ?\{\\mathbf\{\w\}\}|\\[A-Za-z]+|\w")
_BRACED_VECTOR = re.compile(r"(\\[A-Za-z]+ ?|^|[^A-Za-z}])\{(\\mathbf\{\w\})\}")


def plain_latex(symbol: str) -> str:
    while (start := symbol.find(r"\LU{")) >= 0:
        frame, after_frame = _group(symbol, start + 3)
        body, end = _group(symbol, after_frame)
        while body.startswith("{") and _group(body, 0)[1] == len(body):
            body = body[1:-1]
        inner = body if _SIMPLE.fullmatch(body) else "{" + body + "}"
        symbol = f"{symbol[:start]}{{}}^{{{frame}}}{inner}{symbol[end:]}"
    symbol = re.sub(r"\\[A-Za-z]+", lambda m: _PLAIN.get(m[0], m[0]), symbol)
    return _BRACED_VECTOR.sub(_drop_braces, symbol)


def _drop_braces(match: re.Match[str]) -> str:
    accent = match[1].startswith("\\") and not match[1].startswith(r"\Delta")
    return match[0] if accent else match[1] + match[2]


def _group(text: str, start: int) -> tuple[str, int]:
    """Content of the braces that open at `start`, and where they end."""
    depth = 0
    for position in range(start, len(text)):
        depth += (text[position] == "{") - (text[position] == "}")
        if depth == 0:
            return text[start + 1 : position], position + 1
    raise ValueError(text)
