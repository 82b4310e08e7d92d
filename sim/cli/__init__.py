"""The command `carts`. Each subcommand is a module of its own and is imported when it is used.

Exit codes: 0 fine, 1 findings, 2 usage.
"""

from __future__ import annotations

import io
import sys
from importlib import import_module
from typing import Any

import click

# name: (module, one line for the overview); the module holds a click command called `command`.
COMMANDS = {
    "build": ("sim.cli.site.build", "Build the site and print the file to double-click."),
    "class": ("sim.cli.classroom.results", "Say what a class answered and learned."),
    "new": ("sim.cli.new", "Make a site, a lesson or a bank to begin with."),
    "check": ("sim.cli.check", "Look for mistakes in lessons and scene files."),
    "fit": ("sim.cli.measured.fit", "Fit the model to the motion of two real carts."),
    "export": ("sim.cli.export", "Write questions for a learning platform."),
    "key": ("sim.cli.key", "Write the right answers of lessons, for the teacher."),
    "completion": ("sim.cli.completion", "Let the Tab key finish words."),
    "cost": ("sim.cli.cost", "Compare stepping methods: error against time."),
    "doctor": ("sim.cli.doctor", "Say what is here, what is missing, how to get it."),
    "law": ("sim.cli.law", "Judge a law of your own, written in Python."),
    "pack": ("sim.cli.site.pack", "Pack the site into one zip, also as SCORM."),
    "plan": ("sim.cli.plan", "Say how a scene would be solved, and why."),
    "serve": ("sim.cli.site.serve", "Show the site while you write it."),
    "single": ("sim.cli.single", "Write one scene as one HTML file."),
    "run": ("sim.cli.run", "Run a scene."),
    "words": ("sim.cli.words", "Write catalogues of a lesson for other languages."),
}


class LazyGroup(click.Group):
    """A group whose subcommands are imported when they are called, not before."""

    def main(self, *args: Any, **more: Any) -> Any:
        """What goes to a file or to another program is UTF-8, on Windows too."""
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, io.TextIOWrapper):
                if stream.isatty():
                    stream.reconfigure(errors="replace")
                else:
                    stream.reconfigure(encoding="utf-8", errors="backslashreplace")
        return super().main(*args, **more)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names in the order of the overview."""
        return sorted(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The subcommand, or None if there is none of that name."""
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = import_module(COMMANDS[cmd_name][0]).command
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The overview, without importing any subcommand."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, COMMANDS[name][1]) for name in self.list_commands(ctx)])

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Like click's own, with the nearest name when there is no such command."""
        try:
            return super().resolve_command(ctx, args)
        except click.UsageError as error:
            from difflib import get_close_matches

            near = get_close_matches(args[0], COMMANDS, n=1)
            if not near:
                raise
            raise click.UsageError(f"{error.message} Did you mean “{near[0]}”?", ctx) from None


@click.group(cls=LazyGroup, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="newtons-carts", message="newtons-carts %(version)s")
def main(**_: Any) -> None:
    """Newton's Carts: exact collision carts, and the lessons built around them."""
