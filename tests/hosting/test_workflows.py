"""The workflows of a fork and of a new site: what exists is called, secrets are nowhere."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Any

import pytest
import yaml

from sim.cli.starter_files import site_files
from tests.hosting.conftest import ROOT
from tests.shell_lines import called

OF_A_FORK = (ROOT / ".github" / "workflows" / "lessons.yml").read_text(encoding="utf-8")
OF_A_SITE = site_files("Mine", "mine")[".github/workflows/lessons.yml"]
BOTH = pytest.mark.parametrize("text", [OF_A_FORK, OF_A_SITE], ids=["fork", "site"])


def jobs(text: str) -> dict[str, Any]:
    return dict(yaml.safe_load(text)["jobs"])


@BOTH
def test_every_step_calls_what_exists(text: str) -> None:
    for step in jobs(text)["build"]["steps"]:
        if "run" in step:
            called(step["run"])


@BOTH
def test_what_builds_may_only_read_and_what_publishes_runs_nothing_of_the_fork(text: str) -> None:
    assert yaml.safe_load(text)["permissions"] == {"contents": "read"}
    assert "secrets." not in text and "pull_request_target" not in text
    build, publish = jobs(text)["build"], jobs(text)["publish"]
    assert set(build["permissions"].values()) == {"read"}
    (checkout,) = [s for s in build["steps"] if s.get("uses", "").startswith("actions/checkout@")]
    assert checkout["with"] == {"persist-credentials": False}
    assert [step["uses"].partition("@")[0] for step in publish["steps"]] == ["actions/deploy-pages"]
    assert "pull_request" in publish["if"]


@BOTH
def test_every_push_checks_publishes_and_attaches_the_zip(text: str) -> None:
    runs = [shlex.split(step["run"]) for step in jobs(text)["build"]["steps"] if "run" in step]
    done = [words[1:3] for words in runs if Path(words[0]).name == "carts"]
    web = "build" if text == OF_A_FORK else "pack"  # of an own site as students get it
    assert done == [["check", "--format"], ["pack", "--out"], [web, "--hosted"]]
    uses = [step.get("uses", "").partition("@")[0] for step in jobs(text)["build"]["steps"]]
    assert "actions/upload-artifact" in uses and "actions/upload-pages-artifact" in uses


def test_a_new_site_can_be_built_where_no_index_has_the_package() -> None:
    """The wheel lies in a folder of the site: pip looks there too, and README says so."""
    (run,) = [s["run"] for s in jobs(OF_A_SITE)["build"]["steps"] if s.get("name") == "Set up"]
    words = shlex.split(run)
    folder = words[words.index("--find-links") + 1]
    files = site_files("Mine", "mine")
    assert f"folder `{folder}`" in files["README.md"]
    assert f"/{folder}/" not in files[".gitignore"]
