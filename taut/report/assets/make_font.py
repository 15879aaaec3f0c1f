#!/usr/bin/python3
"""Makes the fonts of the report from Debian's STIX fonts (package fonts-stix, SIL OFL 1.1):

  taut_math.woff2         Latin, Greek, digits, operators, arrows and the italic letters of formulas, from STIXMath
  taut_math_italic.woff2  the letters of symbols in running text and drawings, from STIX-Italic

  ./make_font.py [folder of the .otf files]

Needs python3-fonttools and python3-brotli. The OFL reserves the name STIX Fonts, so the subsets are called Taut Math;
their licence stands beside them in taut_math.LICENSE.txt. The MATH table stays: browsers stretch roots, fractions and
parentheses with it.
"""
import pathlib
import sys

from fontTools import subset
from fontTools.ttLib import TTFont

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "/usr/share/fonts/opentype/stix-word")

GREEK = [(0x0391, 0x03A9), (0x03B1, 0x03D6), (0x03F0, 0x03F5)]
MATH = GREEK + [
    (0x0020, 0x007E), (0x00A0, 0x017F),  # Latin with accents
    (0x2010, 0x2027), (0x2030, 0x203A), (0x2061, 0x2064), (0x2070, 0x208E),  # dashes, quotes, primes, small digits
    (0x2102, 0x2102), (0x210E, 0x210F), (0x2190, 0x21FF), (0x2200, 0x222A), (0x2234, 0x228B), (0x2295, 0x22A5),
    (0x22C5, 0x22C6), (0x2308, 0x230B), (0x2713, 0x2713), (0x27E8, 0x27E9), (0x25A0, 0x25CF),
    (0x1D434, 0x1D467), (0x1D6E2, 0x1D71B),  # the italic letters of one-letter symbols
]


def let_bars_grow(variants):
    """STIX builds a tall | from pieces of |, but lets them overlap on one side only: browsers refuse to join them."""
    glyphs = variants.VertGlyphCoverage.glyphs
    for name, construction in zip(glyphs, variants.VertGlyphConstruction):
        parts = construction.GlyphAssembly.PartRecords if construction.GlyphAssembly else []
        for part in parts:
            if len(parts) == 2 and parts[0].glyph == parts[1].glyph == name:
                part.StartConnectorLength = part.EndConnectorLength = part.FullAdvance // 2


def make(source, target, style, ranges):
    font = TTFont(folder / source, recalcTimestamp=False)
    options = subset.Options(layout_features=["kern", "liga", "ssty", "dtls", "flac"], hinting=False,
                             name_IDs=[0, 1, 2, 3, 4, 6, 13, 14], notdef_outline=True, glyph_names=False,
                             drop_tables=["FFTM", "DSIG"])
    worker = subset.Subsetter(options)
    worker.populate(unicodes=[c for low, high in ranges for c in range(low, high + 1)])
    worker.subset(font)
    if "MATH" in font:
        let_bars_grow(font["MATH"].table.MathVariants)
    postscript = f"TautMath-{style}"
    for record in font["name"].names:
        new = {1: "Taut Math", 2: style, 3: postscript, 4: f"Taut Math {style}", 6: postscript}.get(record.nameID)
        if new is not None:
            record.string = new
    cff = font["CFF "].cff
    cff.fontNames = [postscript]
    cff[0].FullName = f"Taut Math {style}"
    cff[0].FamilyName = "Taut Math"
    font.flavor = "woff2"
    path = pathlib.Path(__file__).with_name(target)
    font.save(path)
    print(f"{target}: {path.stat().st_size} bytes, {len(font.getGlyphOrder())} glyphs, MATH {'MATH' in font}")


make("STIXMath-Regular.otf", "taut_math.woff2", "Regular", MATH)
make("STIX-Italic.otf", "taut_math_italic.woff2", "Italic",
     GREEK + [(0x0020, 0x0020), (0x0027, 0x002F), (0x0030, 0x0039), (0x0041, 0x005A), (0x0061, 0x007A), (0x2032, 0x2033)])
