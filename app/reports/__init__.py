"""Calculations made readable: formulas to MathML and Typst, sheets to pages and PDF."""
