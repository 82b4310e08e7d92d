"""Every scene of the registry is in the gallery, and what stands there comes out."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.report.plan import plan
from sim.dynamics.result.finished import Run
from tests import registry

FOLDER = Path(__file__).parents[1] / "docs" / "gallery"
PAGES = sorted(FOLDER.glob("*.md"))
MOST_SCENES = 10
VELOCITY = re.compile(r"([A-Za-z][\w-]*): ([+−]?)(\d+(?:\.\d+)?) m/s")
WARMED = re.compile(r"Warmed the bumpers: (\d+(?:\.\d+)?) J")
WORK = re.compile(r"Work of (\w+): ([+−])(\d+(?:\.\d+)?) J")


def sections() -> dict[str, str]:
    """The text of each section by the scene file that it shows."""
    found: dict[str, str] = {}
    for page in PAGES:
        for section in re.split(r"^## ", page.read_text(encoding="utf-8"), flags=re.M)[1:]:
            for name in re.findall(r"^file: (\S+)\.yml$", section, re.M):
                assert name not in found, f"{name} is in the gallery twice"
                found[name] = section
    return found


SECTIONS = sections()


def draft(name: str) -> str:
    """A section for a scene, with the numbers of its run."""
    done = run(registry.scene(name))
    speeds = ", ".join(
        f"{cart.name}: {signed(v)} m/s" for cart, v in zip(done.scene.carts, done.v, strict=True)
    )
    tiers = ", ".join(f"tier {tier}" for tier in tiers_of(done))
    return (
        f"## {done.scene.title} {{ #{name} }}\n\n(what it is about)\n\n"
        f"```scene\nid: gallery-{name}\nfile: {name}.yml\nshow: [v, F]\n```\n\n"
        f"**Expected.** {speeds}. Warmed the bumpers: {abs(round(done.ledger.warmed, 6)):.4g} J.\n"
        f"**Plan.** {tiers}.\n{{: data-search-exclude }}\n"
    )


def signed(v: float) -> str:
    text = f"{abs(v):.4g}" if abs(v) > 1e-9 else "0"
    return text if text == "0" else ("+" if v > 0 else "−") + text


def tiers_of(done: Run) -> list[int]:
    return sorted({phase.tier for phase in plan(done)})


def on_its_effects_page(name: str) -> bool:
    """A scene in an effect's folder may be shown on the effect's own page instead."""
    page = registry.PATHS[name].parents[1] / "page.md"
    return page.is_file() and f"file: {name}.yml" in page.read_text(encoding="utf-8")


@pytest.mark.parametrize("name", registry.NAMES)
def test_every_scene_is_in_the_gallery(name: str) -> None:
    assert name in SECTIONS or on_its_effects_page(name), (
        f"tests/scenes/{name}.yml is not in the gallery. Put this into a page of docs/gallery/ "
        f"and write what it is about:\n\n{draft(name)}"
    )


def test_the_gallery_shows_no_scene_that_is_not_there() -> None:
    assert set(SECTIONS) <= set(registry.NAMES)


@pytest.mark.parametrize("name", sorted(SECTIONS))
def test_the_expected_result_is_what_comes_out(name: str) -> None:
    done = run(registry.scene(name))
    _, _, text = SECTIONS[name].partition("**Expected.**")
    text = " ".join(text.split())
    told = {cart: (sign, figures) for cart, sign, figures in VELOCITY.findall(text)}
    assert set(told) == {cart.name for cart in done.scene.carts}, draft(name)
    for cart, v in zip(done.scene.carts, done.v, strict=True):
        sign, figures = told[cart.name]
        value = float(figures) * (-1 if sign == "−" else 1)
        assert sign or value == 0, f"{cart.name}: + or − in front, please"
        assert abs(v - value) <= tolerance(figures), (cart.name, v, draft(name))
    (warmed,) = WARMED.findall(text)
    assert abs(done.ledger.warmed - float(warmed)) <= tolerance(warmed), draft(name)
    works = done.ledger.works
    assert {kind for kind, _, _ in WORK.findall(text)} == set(works), works
    for kind, sign, figures in WORK.findall(text):
        value = float(figures) * (-1 if sign == "−" else 1)
        assert abs(works[kind] - value) <= tolerance(figures), (kind, works)


@pytest.mark.parametrize("name", sorted(SECTIONS))
def test_the_plan_in_words_names_the_tiers_that_were_needed(name: str) -> None:
    _, _, text = SECTIONS[name].partition("**Plan.**")
    told = sorted({int(tier) for tier in re.findall(r"tier (\d)", text)})
    assert told == tiers_of(run(registry.scene(name))), draft(name)


def tolerance(figures: str) -> float:
    """Half of the last digit told, but no more than a thousandth of the number; 0 is nought."""
    half_a_figure = 0.5 * 10.0 ** -len(figures.partition(".")[2])
    return min(half_a_figure, 1e-3 * float(figures)) + 1e-12


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_page_of_the_gallery_is_light_enough_for_an_old_laptop(page: Path) -> None:
    """Every scene is half a page of SVG and comes to life by itself: ten at most."""
    assert page.read_text(encoding="utf-8").count("```scene") <= MOST_SCENES, "begin another page"
