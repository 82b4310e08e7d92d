"""`carts export`: a bank of questions for a learning platform."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import click

from sim.cli.check import report
from sim.pages.classroom.gift import gift
from sim.pages.classroom.losses import Target, losses
from sim.pages.classroom.moodle import moodle_xml
from sim.pages.classroom.portable import Portable, portable
from sim.pages.classroom.qti.package import qti_package
from sim.pages.question.quiz import read_bank_text

ENDINGS = {"moodle": ".moodle.xml", "gift": ".gift.txt", "qti": ".qti.zip"}
WRITERS: dict[str, Callable[[str, Sequence[Portable]], str | bytes]] = {
    "moodle": moodle_xml,
    "gift": gift,
    "qti": qti_package,
}


@click.command("export")
@click.argument("bank", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--form", help="Only the questions of this form in the bank, in its order.")
@click.option(
    "--to",
    "target",
    type=click.Choice(sorted(ENDINGS)),
    default="moodle",
    show_default=True,
    help="Moodle XML, GIFT, or a package of QTI 3.0.",
)
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="The file to write (default: build/export/BANK and an ending).",
)
@click.pass_context
def command(
    ctx: click.Context, bank: Path, form: str | None, target: Target, out: Path | None
) -> None:
    """Write a bank of questions for Moodle and other learning platforms.

    BANK is a file of worksheets/banks. The file holds the right answers: import it, and do not hand
    it out.

    \b
    carts export worksheets/banks/forces-and-motion.yml
    carts export worksheets/banks/forces-and-motion.yml --form test-15 --to gift
    carts export worksheets/banks/forces-and-motion.yml --to qti
    """
    found, findings = read_bank_text(bank.read_text(encoding="utf-8"), bank.as_posix())
    if found is None:
        report(findings)
        ctx.exit(1)
    if form is not None and form not in found.forms:
        known = ", ".join(found.forms) or "none"
        raise click.UsageError(f"the bank has no form “{form}”; its forms: {known}")
    ids = found.forms[form] if form else tuple(found.items)
    taken, left = portable(found.items[name] for name in ids)
    made = WRITERS[target](found.title, taken)
    content = made.encode("utf-8") if isinstance(made, str) else made
    out = out or Path("build/export") / f"{bank.stem}{ENDINGS[target]}"
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_bytes(content)
    click.echo(f"{out}: {len(taken)} questions")
    for sentence in (*left, *losses(taken, target)):
        click.echo(sentence, err=True)
