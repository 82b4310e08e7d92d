"""`carts completion`: what a shell needs so that the Tab key finishes words."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class

SHELLS = ("bash", "fish", "zsh")


@click.command("completion")
@click.argument("shell", type=click.Choice(SHELLS))
def command(shell: str) -> None:
    """Print what makes the Tab key finish commands, options and file names.

    Once, for your shell (bash 4.4 or later, zsh, fish):

    \b
    echo 'eval "$(carts completion bash)"' >> ~/.bashrc
    echo 'eval "$(carts completion zsh)"' >> ~/.zshrc
    carts completion fish > ~/.config/fish/completions/carts.fish
    """
    from sim.cli import main

    made = get_completion_class(shell)
    assert made is not None  # the choices are click's own
    click.echo(made(main, {}, "carts", "_CARTS_COMPLETE").source())
