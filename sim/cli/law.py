"""`carts law`: judge a law of one's own; look for a scene in which it breaks physics."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sim.cli import scene_file
from sim.pages.findings import Finding
from sim.scene.laws import is_written

if TYPE_CHECKING:
    from sim.mine.judge.verdict import Judgement
    from sim.mine.wrong import WrongLawError
    from sim.scene import Scene

MINE = "mine.py"
"""What a scene calls a law whose own name none may have: of standard input, 2nd.py, my law.py."""

CHECKS = ("third-law", "energy", "galilei", "mirror", "order", "step")


@click.command("law")
@click.argument("law", metavar="FILE.py")
@click.option("--scene", "name", metavar="SCENE", help="Begin with it: a file, or LESSON.md#ID.")
@click.option(
    "--budget",
    type=click.IntRange(min=1000),
    help="How often the law may be asked.  [default: 60000]",
)
@click.option("--seed", type=int, help="Of the random scenes.  [default: 20]")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option(
    "--yaml",
    "wanted",
    type=click.Choice(CHECKS),
    help="Print only the worst scene of this check, as a scene file.",
)
def command(
    law: str,
    name: str | None,
    budget: int | None,
    seed: int | None,
    as_json: bool,
    wanted: str | None,
) -> None:
    """Judge a law that you wrote: a file with a function “force”.

    The judge looks for a scene in which the law breaks what every force between two bodies keeps:
    Newton's third law, energy, Galilei's trains, the mirror, the order of the carts, and that
    shorter steps give the same motion. Exit code 1 means that it found one.

    \b
    carts law mine.py
    carts law mine.py --scene my-scene.yml --budget 500000
    carts law mine.py --yaml third-law > worst.yml
    """
    if as_json and wanted:
        raise click.UsageError("--json and --yaml exclude each other.")
    from sim.mine.judge.document import document
    from sim.mine.judge.search import IN_A_PAGE, SEED, judge
    from sim.mine.wrong import WrongLawError

    text = scene_file.text_of(law, "law")
    file = Path(law).name if is_written(Path(law).name) else MINE
    try:
        judged = judge(
            text,
            file,
            scene=_scene(name, file, text),
            budget=budget or IN_A_PAGE,
            seed=SEED if seed is None else seed,
        )
    except WrongLawError as error:
        scene_file.fail([_finding(law, error)])
    if as_json:
        click.echo(json.dumps(document(judged), allow_nan=False, ensure_ascii=False))
    elif wanted:
        _one_scene(judged, wanted)
    else:
        click.echo(_told(scene_file.shown_name(law), judged, _again(law, name, budget, seed)))
    sys.exit(0 if judged.holds else 1)


def _finding(law: str, error: WrongLawError) -> Finding:
    return Finding(scene_file.shown_name(law), error.line, 1, "law", error.message, error.hint)


def _scene(name: str | None, file: str, text: str) -> Scene | None:
    """The scene of the option; its contact may name this law or any other."""
    return scene_file.read(name, laws={file: text}) if name else None


def _one_scene(judged: Judgement, wanted: str) -> None:
    from sim.mine.judge.as_yaml import as_yaml

    verdict = next(one for one in judged.verdicts if one.check == wanted)
    if verdict.scene is None:
        click.echo(f"Nothing was found: {verdict.says}.", err=True)
    else:
        click.echo(as_yaml(verdict.scene, verdict.sentence), nl=False)


def _again(law: str, name: str | None, budget: int | None, seed: int | None) -> str:
    """The same call, so that it judges the same scenes; empty where the law came by a pipe."""
    if "-" in (law, name):
        return ""
    options = {"--scene": name, "--budget": budget, "--seed": seed}
    given = [str(part) for pair in options.items() if pair[1] is not None for part in pair]
    quoted = subprocess.list2cmdline if os.name == "nt" else shlex.join
    return quoted(["carts", "law", law, *given])


def _told(law: str, judged: Judgement, again: str) -> str:
    """For people: what holds, what does not, and where it can be seen."""
    lines = [f"{law}: {judged.sentence}", ""]
    for one in judged.verdicts:
        lines.append(f"{'holds ' if one.holds else 'BROKEN'}  {one.check:<10} {one.says}")
        if one.scene is not None:
            lines += [f"{'':19}{text}" for text in (one.sentence, _scene_line(one.scene))]
    broken = [one.check for one in judged.verdicts if not one.holds]
    if broken and again:
        lines += ["", f"The scene itself: {again} --yaml {broken[0]}"]
    return "\n".join(lines)


def _scene_line(scene: Mapping[str, Any]) -> str:
    carts = scene["carts"]
    return "; ".join(f"{n}: {c['mass']:g} kg, {c['velocity']:g} m/s" for n, c in carts.items())
