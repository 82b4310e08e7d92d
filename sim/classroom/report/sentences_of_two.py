"""What two groups beside each other say, in plain words: interval first, p last."""

from __future__ import annotations

from sim.classroom.report.numerals import signed
from sim.classroom.report.sentences import of_p
from sim.classroom.statistics.compare import PaperZ, TTest
from sim.scene.notation import number
from sim.scene.said import counted, joined, listed, said, template

ONE_CLASS = template(
    "Each group is one class here. 30 students in one room are not 30 independent experiments: "
    "the real uncertainty is larger than shown, and no p-value for the teaching is given."
)
WHO_KNOWS = template(
    "The table does not say which classes the groups are made of (a column “class” tells it). If "
    "each group is one class: 30 students in one room are not 30 independent experiments, and the "
    "real uncertainty is larger than shown. So no p-value is given in words."
)
ADJUSTED = template("Adjusted for the start (ANCOVA)")
RAW_GAINS = template("Raw gains")


def of_baseline(test: TTest | None, z: PaperZ, groups: tuple[str, str]) -> str:
    """Where two groups stood before anything was taught."""
    first, second = groups
    start = said("Before teaching: Z = {z}.", z=signed(z.z))
    if test:
        start = said(
            "Before teaching: {first} minus {second} is {difference} marks, anything from {low} to "
            "{high} would fit (Z = {z}).",
            first=first, second=second, difference=signed(test.difference), low=signed(test.low),
            high=signed(test.high), z=signed(z.z),
        )  # fmt: skip
    if abs(z.z) > 1:
        return joined(start, template(
            "The groups started apart. A group that starts low tends to rise by itself. Read the "
            "adjusted difference first."
        ))  # fmt: skip
    return joined(start, template("The groups started close together."))


def of_difference(what: str, test: TTest, groups: tuple[str, str], *, with_p: bool) -> str:
    """Two groups: interval first, then what it means, then perhaps p."""
    first, second = groups
    text = said(
        "{what}: {first} minus {second} is {difference} ± {error} marks (difference ± standard "
        "error); anything from {low} to {high} would fit (95 % interval).",
        what=what, first=first, second=second, difference=signed(test.difference),
        error=number(test.se), low=signed(test.low), high=signed(test.high),
    )  # fmt: skip
    open_ = template("We could not tell: this does not show that there is no difference.")
    return joined(text, open_ if test.low <= 0 <= test.high else "", of_p(test.p) if with_p else "")


def of_paper_z(z: float) -> str:
    """Equation (4) of the paper."""
    return said("The paper's Z of the raw gains, equation (4), is {z}.", z=signed(z))


def too_few(n: int, group: str, fewest: int) -> str:
    """A group that is too small to be compared."""
    return counted(
        "1 student of “{group}” took both tests: no comparison with fewer than {fewest}.",
        "{n} students of “{group}” took both tests: no comparison with fewer than {fewest}.",
        n=n, group=group, fewest=f"{fewest}",
    )  # fmt: skip


def of_classes(counts: tuple[int, int], groups: tuple[str, str], *, robust: bool) -> str:
    """What may be concluded where whole classes were taught in one way or the other."""
    made = listed([
        counted("“{group}” of 1 class", "“{group}” of {n} classes", n=count, group=group)
        for group, count in zip(groups, counts, strict=True)
    ])  # fmt: skip
    if robust:
        return said(
            "The groups are made of classes: {made}. Students of one class are alike: read the "
            "interval that counts classes. The others are for students assigned one by one, and "
            "too narrow.",
            made=made,
        )
    return said(
        "The groups are made of classes: {made}. Students of one class are alike, so the intervals "
        "are too narrow. From eight classes on, at least two in each group, an interval that "
        "counts classes is given.",
        made=made,
    )
