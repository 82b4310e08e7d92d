"""Tables with a row for every reading of one cart: columns say whose it is, and of which run."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.units import Units
from tests.measured.written_films import A, B, T

FILM = list(zip(T, A, B, strict=True))


def rows(*parts: str, shift: float = 0.0) -> str:
    """A line for every cart in every frame: `parts` are the lines of A and of B."""
    told = [
        part.format(t=t, x=x + shift, k=k, count=2 * k + which)
        for k, (t, a, b) in enumerate(FILM)
        for which, (part, x) in enumerate(zip(parts, (a, b), strict=True))
    ]
    return "\n".join(told)


def one_after_the_other(*parts: str) -> str:
    return "\n".join(
        part.format(t=t, x=x) for part, xs in zip(parts, (A, B), strict=True)
        for t, x in zip(T, xs, strict=True)
    )  # fmt: skip


TABLES = {
    "by cart": ("cart,t,x\n" + one_after_the_other("A,{t:.4f},{x:.5f}", "B,{t:.4f},{x:.5f}"), "AB"),
    "by time": ("t,cart,x\n" + rows("{t:.4f},A,{x:.5f}", "{t:.4f},B,{x:.5f}"), "AB"),
    "words under a head of any name": (
        "Zeit (s);Farbe;x (m)\n" + rows("{t:.4f};rot;{x:.5f}", "{t:.4f};blau;{x:.5f}"),
        ("rot", "blau"),
    ),
    "numbers with a point, the time last": (
        ",y,x,mass,frame,particle,t\n"
        + rows("{count},1,{x:.5f},9,{k},0.0,{t:.4f}", "{count},1,{x:.5f},9,{k},1.0,{t:.4f}"),
        "01",
    ),
    "velocities beside": (
        "Time (s),Cart,Position (m),Velocity (m/s)\n"
        + one_after_the_other("{t:.4f},1,{x:.5f},0.3", "{t:.4f},2,{x:.5f},0.2"),
        "12",
    ),
    "quotes": ('"cart","t","x"\n' + rows('"A",{t:.4f},{x:.5f}', '"B",{t:.4f},{x:.5f}'), "AB"),
    "ImageJ, with a column of times": (
        " ,Track n°,Slice n°,X,Y,t (s)\n"
        + one_after_the_other("0,1,0,{x:.5f},50,{t:.4f}", "0,2,0,{x:.5f},50,{t:.4f}"),
        "12",
    ),
    "a small letter once": (
        "cart,t,x\n" + rows("A,{t:.4f},{x:.5f}", "B,{t:.4f},{x:.5f}").replace("\nB,", "\nb,", 1),
        "Ab",
    ),
}


@pytest.mark.parametrize("how", TABLES)
def test_the_carts_of_a_tidy_table_are_read_as_if_they_stood_side_by_side(how: str) -> None:
    text, names = TABLES[how]
    found = read_measured([text])
    assert [track.name for track in found.tracks] == list(names)
    for track, places in zip(found.tracks, (A, B), strict=True):
        assert track.t == pytest.approx(T, abs=1e-4)
        assert track.value == pytest.approx(places, abs=1e-5)


def test_a_line_of_a_tidy_table_is_told_with_its_number() -> None:
    text = "cart,t,x\n" + rows("A,{t:.4f},{x:.5f}", "B,{t:.4f},{x:.5f}")
    lines = text.split("\n")
    assert lines[10].startswith("B,")
    lines[10] = "B,0.0,0.5"
    with pytest.raises(ReadingError, match="line 11: the time goes back: in line 9 it was later"):
        read_measured(["\n".join(lines)])
    lines[10] = "B,near,0.5"
    with pytest.raises(ReadingError, match="line 11: “near” is not a number"):
        read_measured(["\n".join(lines)])


RUNS = {
    "of tidy carts": (
        "run,t,cart,x\n",
        lambda run, shift: rows(
            f"{run},{{t:.4f}},A,{{x:.5f}}", f"{run},{{t:.4f}},B,{{x:.5f}}", shift=shift
        ),
    ),
    "named by words": (
        "Lauf;Zeit (s);Wagen;Ort (m)\n",
        lambda run, shift: rows(
            f"Lauf {run};{{t:.4f}};rot;{{x:.5f}}", f"Lauf {run};{{t:.4f}};blau;{{x:.5f}}",
            shift=shift,
        ),
    ),
    "of carts side by side": (
        "trial,t,x_A,x_B\n",
        lambda run, shift: "\n".join(
            f"{run},{t:.4f},{a + shift:.5f},{b + shift:.5f}" for t, a, b in FILM
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("how", RUNS)
def test_a_column_of_runs_parts_the_rows(how: str) -> None:
    heads, lines = RUNS[how]
    text = heads + lines("3", 0.0) + "\n" + lines("7", 0.25)
    assert read_measured([text]).runs == ("3", "7")
    for asked, shift in (("3", 0.0), ("7", 0.25), ("2", 0.25)):
        found = read_measured([text], Units(run=asked))
        assert len(found.tracks) == 2
        assert found.tracks[0].value == pytest.approx([a + shift for a in A], abs=1e-5)
        assert found.tracks[1].value == pytest.approx([b + shift for b in B], abs=1e-5)


def test_a_column_of_words_beside_two_carts_stays_a_remark() -> None:
    text = "t,x_A,x_B,part\n" + "\n".join(
        f"{t:.4f},{a:.5f},{b:.5f},{'before' if k < 15 else 'after'}"
        for k, (t, a, b) in enumerate(FILM)
    )
    found = read_measured([text])
    assert [track.name for track in found.tracks] == ["A", "B"]
    assert len(found.tracks[0].t) == len(T)


def test_of_three_carts_in_a_tidy_table_two_are_asked_for() -> None:
    text = "cart,t,x\n" + "\n".join(f"{c},{t:.4f},{a:.5f}" for c in "ABC" for t, a, _ in FILM)
    with pytest.raises(ReadingError, match="3 carts: A x, B x, C x"):
        read_measured([text])
