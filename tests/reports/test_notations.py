"""Exact output of both notations for the expressions that tempt to err, and what no input may do to them."""

import ast
from xml.etree import ElementTree

import numpy as np
import pytest
import typst as typst_compiler
from hypothesis import given
from hypothesis import strategies as st

import app.engine.formulas  # noqa: F401  (registers every formula)
from app.engine.formula import registered
from app.reports import mathml, symbols, typst
from app.reports.expression import Expression, read, substituted
from app.reports.mathml import MathmlWriter
from app.reports.symbols import Symbol
from app.reports.typst import TypstWriter
from tests.reports import examples

HOSTILE = "</math><script>alert(1)</script>&\"'\\ #eval $x$ [*] @a //"


def tree(source: str) -> Expression:
    return read(ast.parse(source, mode="eval").body)


def plain(source: str) -> str:
    """MathML of an expression with the invisible groups taken out."""
    return MathmlWriter().write(tree(source)).replace("<mrow>", "").replace("</mrow>", "")


A, B, C = "<mi>a</mi>", "<mi>b</mi>", "<mi>c</mi>"
OPEN, CLOSE, PLUS, MINUS, DOT = "<mo>(</mo>", "<mo>)</mo>", "<mo>+</mo>", "<mo>−</mo>", "<mo>·</mo>"
X, TWO = "<mi>x</mi>", "<mn>2</mn>"
SLIM = '<mspace width="0.4em"></mspace>'

EXPECTED_MATHML = [
    ("a/(b*c)", f"<mfrac>{A}{B}{DOT}{C}</mfrac>"),
    ("a/b*c", f"<mfrac>{A}{B}</mfrac>{DOT}{C}"),
    ("a/b/c", f"<mfrac><mfrac>{A}{B}</mfrac>{C}</mfrac>"),
    ("(a+b)/(a-b)", f"<mfrac>{A}{PLUS}{B}{A}{MINUS}{B}</mfrac>"),
    ("a-(b-c)", f"{A}{MINUS}{OPEN}{B}{MINUS}{C}{CLOSE}"),
    ("a-b-c", f"{A}{MINUS}{B}{MINUS}{C}"),
    ("a+(b+c)", f"{A}{PLUS}{B}{PLUS}{C}"),
    ("a*(b+c)", f"{A}{DOT}{OPEN}{B}{PLUS}{C}{CLOSE}"),
    ("a*-b", f"{A}{DOT}{OPEN}{MINUS}{B}{CLOSE}"),
    ("-(a+b)", f"{MINUS}{OPEN}{A}{PLUS}{B}{CLOSE}"),
    ("-x**2", f"{MINUS}<msup>{X}{TWO}</msup>"),
    ("(-x)**2", f"<msup>{OPEN}{MINUS}{X}{CLOSE}{TWO}</msup>"),
    ("(a+b)**2", f"<msup>{OPEN}{A}{PLUS}{B}{CLOSE}{TWO}</msup>"),
    ("(a/b)**2", f"<msup>{OPEN}<mfrac>{A}{B}</mfrac>{CLOSE}{TWO}</msup>"),
    ("a**b**c", f"<msup>{A}<msup>{B}{C}</msup></msup>"),
    ("(a**b)**c", f"<msup>{OPEN}<msup>{A}{B}</msup>{CLOSE}{C}</msup>"),
    ("sqrt(a*b)", f"<msqrt>{A}{DOT}{B}</msqrt>"),
    ("J_RED_s**2", "<msubsup><mi>J</mi><mtext>RED,s</mtext><mn>2</mn></msubsup>"),
    ("exp(-a)", f'<msup><mi mathvariant="normal">e</mi>{MINUS}{A}</msup>'),
    ("total(a*b)", f"<mo>∑</mo>{A}{DOT}{B}"),
    ("total(a)*b", f"{OPEN}<mo>∑</mo>{A}{CLOSE}{DOT}{B}"),
    ("maximum(a, 0)", f'<mi>max</mi>{OPEN}{A}<mo separator="true">,</mo><mn>0</mn>{CLOSE}'),
    ("abs(a)", f'<mo form="prefix" stretchy="true">|</mo>{A}<mo form="postfix" stretchy="true">|</mo>'),
    (
        "where(a > 0, b, c)",
        f'<mo form="prefix" stretchy="true">{{</mo><mtable><mtr><mtd>{B}</mtd><mtd>{SLIM}<mtext>if</mtext>{SLIM}{A}'
        f"<mo>&gt;</mo><mn>0</mn></mtd></mtr><mtr><mtd>{C}</mtd><mtd>{SLIM}<mtext>otherwise</mtext>{SLIM}</mtd></mtr></mtable>",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("source", "expected"), EXPECTED_MATHML)
def test_mathml(source: str, expected: str) -> None:
    assert plain(source) == expected


EXPECTED_TYPST = [
    ("a/(b*c)", "frac(a, b dot.op c)"),
    ("a-(b-c)", "a minus lr((b minus c))"),
    ("-x**2", 'class("unary", minus) attach(x, t: "2")'),
    ("(-x)**2", 'attach(lr((class("unary", minus) x)), t: "2")'),
    ("(a+b)**2", 'attach(lr((a + b)), t: "2")'),
    ("a/b/c", "frac(frac(a, b), c)"),
    ("sqrt(a/b)", "sqrt(frac(a, b))"),
    ("mu_L*d", "attach(μ, b: upright(L)) dot.op d"),
    ("J_RED_s**2", 'attach(J, b: upright("RED,s"), t: "2")'),
    ("2*pi*f", '"2" dot.op π dot.op f'),
    ("minimum(a, b/c)", 'op("min") lr((a, frac(b, c)))'),
    ("abs(a-b)", "abs(a minus b)"),
    ("total(M_k**2)/t", 'frac(sum attach(M, b: upright(k), t: "2"), t)'),
    ("where(a <= 0, b, c)", 'cases(b & quad " if " a ≤ "0", c & quad " otherwise ")'),
]


@pytest.mark.parametrize(("source", "expected"), EXPECTED_TYPST)
def test_typst(source: str, expected: str) -> None:
    assert TypstWriter().write(tree(source)) == expected


NUMBERS = {"a": -3.0, "b": 1.5e-7, "v": [4.0, -2.0, 0.0], "w": list(range(40))}


def test_negative_numbers_are_bracketed_where_a_sign_or_a_power_is_near() -> None:
    shown = MathmlWriter().write(substituted(tree("c - a**2"), NUMBERS))
    assert shown.replace("<mrow>", "").replace("</mrow>", "") == (
        f"{C}{MINUS}<msup>{OPEN}{MINUS}<mn>3</mn>{CLOSE}{TWO}</msup>"
    )


def test_a_power_of_ten_is_no_text() -> None:
    shown = MathmlWriter().write(substituted(tree("b"), NUMBERS))
    assert shown == "<mrow><mn>1.5</mn><mo>·</mo><msup><mn>10</mn><mrow><mo>−</mo><mn>7</mn></mrow></msup></mrow>"
    assert TypstWriter().write(substituted(tree("b"), NUMBERS)) == (
        '"1.5" dot.op attach("10", t: class("unary", minus) "7")'
    )


def test_a_long_array_is_shortened() -> None:
    shown = TypstWriter().write(substituted(tree("total(w)"), NUMBERS))
    assert shown == 'sum lr(["0"; "1"; "2"; "…"; "39"])'


@pytest.mark.parametrize(
    ("name", "symbol"),
    [
        ("mu_L", Symbol("μ", "L")),
        ("Delta_x", Symbol("x", prefix="Δ")),
        ("Delta", Symbol("Δ")),
        ("J_RED_s", Symbol("J", "RED,s")),
        ("x_dd", Symbol("x", "dd")),
        ("eta_G", Symbol("η", "G")),
        ("lambda_", Symbol("λ")),
        ("M_alpha", Symbol("M", "α")),
        ("eta'", Symbol("η", primes="′")),
        ("J_X'", Symbol("J", "X'")),
        ("M1", Symbol("M", "1")),
        ("DN", Symbol("DN")),
        ("_", Symbol("_")),
    ],
)
def test_a_name_is_read_as_a_symbol(name: str, symbol: Symbol) -> None:
    assert symbols.read(name) == symbol


def test_words_of_a_formula_are_translated() -> None:
    german = {"if": "wenn", "otherwise": "sonst"}
    shown = mathml.of_expression(tree("where(a > 0, b, c)"), translate=lambda text: german.get(text, text))
    assert "<mtext>wenn</mtext>" in shown
    assert "<mtext>sonst</mtext>" in shown
    assert "otherwise" not in shown


def test_a_symbol_that_is_markup_stays_text() -> None:
    line = mathml.with_numbers(examples.sample_through_stage, {"M": 1.0, "eta": 1.0}, 1.0, name=HOSTILE)[0]
    parsed = ElementTree.fromstring(line)
    known = "math mrow mi mo mn mtext msub msup msubsup mtable mtr mtd mfrac mspace"
    assert {element.tag for element in parsed.iter()} <= set(known.split())
    assert "script" in "".join(parsed.itertext())


@given(st.text(max_size=60))
def test_any_symbol_gives_well_formed_mathml(name: str) -> None:
    printable = "".join(c for c in name if c.isprintable())
    ElementTree.fromstring(mathml.symbol(f"x{printable}"))


def test_any_symbol_and_text_is_inert_in_typst() -> None:
    texts = [
        HOSTILE,
        '"',
        "\\",
        '\\"',
        "\n\n= Heading",
        "a\u0000b",
        "\u202e",
        "{",
        "]]",
        "$",
        "#panic()",
        "``",
        "\\u{41}",
    ]
    lines = [f"${typst.symbol(f'x{words}')}$ ${typst.symbol(words)}$ #{typst.literal(words)}\n" for words in texts]
    compile_typst("\n".join(lines))


@given(st.text(max_size=40))
def test_a_literal_holds_exactly_the_printable_text(words: str) -> None:
    shown = "".join(c if c.isprintable() or c == "\n" else " " for c in words)
    assert ast.literal_eval(typst.literal(words)) == shown  # same escapes as in Python


def compile_typst(source: str) -> bytes:
    made = typst_compiler.compile(source.encode(), font_paths=typst_compiler.Fonts(include_system_fonts=False))
    assert isinstance(made, bytes)
    return made


def test_every_formula_is_set_by_typst() -> None:
    source = []
    for formula in registered().values():
        inputs = examples.inputs_of(formula)
        with np.errstate(all="ignore"):
            value = formula(**inputs)
        lines = (*typst.symbolic(formula), *typst.with_numbers(formula, inputs, value))
        source += [f"$ {line} $" for line in lines]
    assert compile_typst("\n".join(source)).startswith(b"%PDF")


@pytest.mark.parametrize("name", list(registered()))
def test_every_formula_is_well_formed_mathml(name: str) -> None:
    for line in mathml.symbolic(registered()[name]):
        assert ElementTree.fromstring(line).tag == "math"
