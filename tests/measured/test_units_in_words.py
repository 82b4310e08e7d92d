"""Units as students write them, “v in cm/s” and “x (CM)” among them; and what is said of others."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from tests.measured.written_films import A, B, T, is_the_film, table


def speeds(heads: str, size: float) -> str:
    """A moves at 0.5 m/s and B stands, until they share the half of it."""
    rows = [heads]
    rows += [f"{k * 0.02:.2f};{v / size:g};{u / size:g}" for k in range(60)
             for v, u in [(0.5, 0.0) if k < 30 else (0.1, 0.4)]]  # fmt: skip
    return "\n".join(rows)


@pytest.mark.parametrize(("heads", "size"), [
    ("t in s;v_A in m/s;v_B in m/s", 1), ("t (s);v1 in cm/s;v2 in cm/s", 0.01),
    ("Zeit in s;Geschwindigkeit A in m/s;Geschwindigkeit B in m/s", 1),
    ("t (s);v_A in (m/s);v_B in (m/s)", 1), ("t (s);v_A (cm·s⁻¹);v_B (cm·s⁻¹)", 0.01),
    ("t (s);v_A (cm s^-1);v_B (cm s^-1)", 0.01), ("t (s);v_A (M/S);v_B (M/S)", 1),
])  # fmt: skip
def test_a_velocity_is_read_in_whatever_way_its_unit_is_written(heads: str, size: float) -> None:
    found = read_measured([speeds(heads, size)])
    ways = [track.value[-1] - track.value[0] for track in found.tracks]
    assert ways == pytest.approx([0.354, 0.236], abs=0.001)


@pytest.mark.parametrize(("unit", "size"), [("dm", 0.1), ("CM", 0.01), ("M", 1), ("MM", 1e-3)])
def test_a_column_that_is_called_like_a_cart_is_a_place_in_its_unit(unit: str, size: float) -> None:
    """“A (dm)” was an acceleration: of the letter, whatever the unit said."""
    assert is_the_film(read_measured([table(f"t (s),A ({unit}),B ({unit})", size=size)]))


@pytest.mark.parametrize(("heads", "unit"), [
    ("t (s),A (px),B (px)", "px"), ("t (s),v_A (cm/min),v_B (cm/min)", "cm/min"),
])  # fmt: skip
def test_a_unit_that_nobody_knows_is_named(heads: str, unit: str) -> None:
    with pytest.raises(ReadingError, match=f"“{unit}” is no unit that is known here"):
        read_measured([table(heads)])


def test_how_many_carts_a_table_has_is_told_whatever_their_columns_are_called() -> None:
    film = zip(T, A, B, strict=True)
    rows = "\n".join(f"{t:.4f},{a:.4f},{b:.4f},{a + b:.4f}" for t, a, b in film)
    with pytest.raises(ReadingError, match="3 carts: A, B, C"):
        read_measured([f"t (s),A (m),B (m),C (m)\n{rows}"])
    one = "\n".join(f"{t:.4f},{a:.4f}" for t, a in zip(T, A, strict=True))
    with pytest.raises(ReadingError, match="1 cart"):
        read_measured([f"t (s),A (m)\n{one}"])


DIGITS = {
    "wide": str.maketrans("0123456789.", "０１２３４５６７８９．"),
    "Arabic": str.maketrans("0123456789.", "٠١٢٣٤٥٦٧٨٩٫"),
    "Tamil": str.maketrans("0123456789", "௦௧௨௩௪௫௬௭௮௯"),
}


@pytest.mark.parametrize("script", DIGITS)
def test_numbers_are_read_in_the_digits_of_other_scripts(script: str) -> None:
    heads, *rows = table("t (s),A (m),B (m)").split("\n")
    assert is_the_film(read_measured(["\n".join([heads, *(one.translate(DIGITS[script])
                                                          for one in rows)])]))  # fmt: skip


def test_heads_with_a_space_stand_over_columns_that_two_spaces_part() -> None:
    lines = table("t (s),A (m),B (m)").replace(",", "   ").split("\n")
    lines[0] = lines[0].replace("   ", "  ")
    assert is_the_film(read_measured(["\n".join(lines)]))
