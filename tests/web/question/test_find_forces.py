"""Hidden forces: found once by the reader from m Δv / Δt, then shown, and kept."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.question.answering import find, saved_file
from tests.web.scene.given.widget_site import MEETING, live, lock, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

HIDDEN = {**MEETING, "id": "hidden", "forces": "hidden", "show": ["v"]}
ASKING = {**HIDDEN, "id": "asking", "predict": {"choice": ["It stops", "It turns back"]}}

FORGET = """indexedDB.databases()
  .then((all) => all.map(({ name }) => indexedDB.deleteDatabase(name)))"""

MEAN_ON_B = """const { header } = await (async () => {
    const script = JSON.parse(el.querySelector("script.carts-baked").textContent);
    return { header: script };
  })();
  const of = (kind) => header.events.find((e) => e.kind === kind && e.bodies.includes("B"));
  const [touch, parting] = [of("contact"), of("separate")];
  return (1.0 * (parting.after.B - touch.before.B)) / (parting.t - touch.t);"""


@pytest.mark.one_browser
def test_a_found_force_shows_them_all_and_is_kept(
    shared_page: SharePage, widget_site: Path
) -> None:
    path = write_page(widget_site, "hidden", HIDDEN)
    page = live(shared_page(path), "hidden")
    expect(page.locator('#hidden .carts-graph[data-quantity="F"]')).to_have_count(0)
    mean = on_scene(page, MEAN_ON_B, name="hidden")
    assert mean > 0
    on_scene(page, "await el.set({'A.velocity': 0.61}); await el.set({'A.velocity': 0.6})",
             name="hidden")  # fmt: skip
    assert "Which way" in find(page, f"{-mean:.3f}")
    assert "mass of A" in find(page, f"{mean / 2:.3f}")
    third = find(page, "123")
    assert "m = 1" in third
    assert "not a number" in find(page, "lots")
    assert "find the force on A too" in find(page, f"{mean:.2f}".replace(".", ","))
    expect(page.locator("#hidden .carts-found")).to_be_hidden()
    assert " N " not in page.locator("#hidden").inner_text().replace("Mean force on", "")
    page.reload()
    live(page, "hidden")
    expect(page.locator("#hidden .carts-find-note")).to_contain_text("find the force on A too")
    find(page, f"{-mean:.2f}", which="A, while it touches B")
    expect(page.locator("#hidden .carts-found")).to_be_visible()
    expect(page.locator("#hidden .carts-find")).to_have_count(0)
    expect(page.locator('#hidden .carts-graph[data-quantity="F"]')).to_be_visible()
    live(page, "hidden")
    on_scene(page, "await el.set({'B.mass': 2}).catch(() => {}); el.time = 1.2", name="hidden")
    expect(page.locator("#hidden .carts-reset")).to_be_enabled()
    page.reload()
    live(page, "hidden")
    expect(page.locator("#hidden .carts-found")).to_be_visible()


@pytest.mark.one_browser
def test_half_of_a_pair_does_not_go_with_that_of_another_run(
    shared_page: SharePage, widget_site: Path
) -> None:
    """−4 N on A and 5.5 N on B stood there as the forces that were found."""
    page = live(shared_page(write_page(widget_site, "hidden", HIDDEN)), "hidden")
    mean = on_scene(page, MEAN_ON_B, name="hidden")
    assert "find the force on A too" in find(page, f"{mean:.2f}")
    note = page.locator("#hidden .carts-find-note")
    on_scene(page, "await el.set({'A.velocity': 0.3})", name="hidden")
    expect(note).to_have_text("")
    find(page, f"{-mean / 2:.2f}", which="A, while it touches B")
    expect(page.locator("#hidden .carts-found")).to_be_hidden()
    expect(note).to_contain_text("find the force on B too")


@pytest.mark.one_browser
def test_the_next_reader_is_not_told_the_forces_that_the_one_before_has_found(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "asking-again", ASKING)), "asking")
    page.get_by_role("radio", name="It stops").check()
    lock(page, "asking")
    expect(page.locator("#asking .carts-find")).to_be_visible()
    mean = on_scene(page, MEAN_OF_RUN, name="asking")
    assert "find the force on A too" in find(page, f"{mean:.3f}", "asking")
    find(page, f"{-mean:.3f}", "asking", "A, while it touches B")
    expect(page.locator("#asking .carts-found")).to_be_visible()
    page.locator("#asking .carts-again").click()
    page.locator("#asking .carts-forget-yes").click()
    expect(page.locator("#asking .carts-found")).to_be_hidden()
    page.wait_for_function(f"async () => (await ({KEPT})()) === undefined")
    page.reload()
    live(page, "asking")
    expect(page.locator("#asking .carts-found")).to_be_hidden()


MEAN_OF_RUN = """const of = (kind) =>
    el.trajectory.events.find((e) => e.kind === kind && e.bodies.includes("B"));
  const [touch, parting] = [of("contact"), of("separate")];
  return (1.0 * (parting.after.B - touch.before.B)) / (parting.t - touch.t);"""
KEPT = """async () => {
  const [{ name }] = (await indexedDB.databases()).filter((one) => !one.name.endsWith("-measured"));
  const open = indexedDB.open(name);
  const db = await new Promise((done) => { open.onsuccess = () => done(open.result); });
  const all = db.transaction("answers").objectStore("answers").getAll();
  await new Promise((done) => { all.onsuccess = done; });
  return all.result.find((entry) => entry.type === "found-force");
}"""


@pytest.mark.one_browser
def test_what_another_tab_found_and_when_the_first_was_found_is_kept(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "hidden", HIDDEN)), "hidden")
    other = page.context.new_page()
    other.goto(page.url)
    live(other, "hidden")
    mean = on_scene(page, MEAN_ON_B, name="hidden")
    assert "find the force on A too" in find(page, f"{mean:.2f}")
    first = page.evaluate(KEPT)
    find(other, f"{-mean:.2f}", which="A, while it touches B")
    expect(other.locator("#hidden .carts-found")).to_be_visible()
    kept = other.evaluate(KEPT)
    assert len(kept["found"]) == 2
    assert kept["first"] == first["first"] < kept["last"]
    other.close()


@pytest.mark.one_browser
def test_a_file_with_found_forces_is_read_by_the_teacher_and_brought_back(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "newtons-third-law.html", folder=site)
    name = "third-light-into-heavy"
    live(page, name)
    page.locator(f"#{name} .carts-options input").first.check()
    page.locator(f"#{name} .carts-certainty input").first.check()
    page.locator(f"#{name} .carts-lock").click()
    page.locator(f"#{name} .carts-talk-run:visible").or_(
        page.locator(f"#{name} .carts-end:enabled")
    ).first.click()
    page.locator(f"#{name} .carts-end:enabled").click()
    page.locator(f"#{name} .carts-find input").wait_for(state="attached")
    find(page, "-2.41", name, "A, while it touches B")
    find(page, "2.41", name, "B, while it touches A")
    told = page.locator(f"#{name} .carts-found")
    expect(told).to_contain_text("Mean force on A by B: −2.4")  # what was found stays on the page
    content = saved_file(page)  # read there by what Class results reads it with
    assert "found-force" in {item["type"] for item in content["items"]}
    page.evaluate(
        "indexedDB.databases().then((all) => all.map((d) => indexedDB.deleteDatabase(d.name)))"
    )
    page.reload()
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers input[type=file]").set_input_files(
        {"name": "a.json", "mimeType": "application/json", "buffer": json.dumps(content).encode()}
    )
    expect(page.locator(".carts-answers")).not_to_contain_text("damaged")
    expect(told).to_be_visible()


@pytest.mark.one_browser
def test_what_is_asked_about_found_forces_opens_when_they_are_found(
    site: Path, open_page: OpenPage
) -> None:
    """“What do your numbers say?” could be answered without any number."""
    page = open_page(site / "worksheets" / "newtons-third-law.html", folder=site)
    name, asked = "third-light-into-heavy", page.locator("#third-why-flies .carts-q-ask")
    live(page, name)
    page.locator(f"#{name} .carts-options input").first.check()
    page.locator(f"#{name} .carts-certainty input").first.check()
    page.locator(f"#{name} .carts-lock").click()
    page.locator(f"#{name} .carts-talk-run").click()
    page.locator(f"#{name} .carts-end:enabled").click()
    expect(page.locator("#third-read-a .carts-q-ask")).to_be_visible()  # it is on the run
    expect(asked).to_be_hidden()
    waits = page.locator("#third-why-flies .carts-q-waits")
    expect(waits).to_contain_text("when you have found the forces of the run above")
    find(page, "-2.41", name, "A, while it touches B")
    expect(asked).to_be_hidden()
    find(page, "2.41", name, "B, while it touches A")
    expect(asked).to_be_visible()
    page.reload()
    expect(asked).to_be_visible()


@pytest.mark.one_browser
def test_the_forces_are_hidden_in_whatever_the_page_says_before(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "hidden", HIDDEN)), "hidden")
    on_scene(page, "el.time = 1.6", name="hidden")
    assert page.locator("#hidden .carts-push:visible").count() == 0
    assert " N " not in page.locator("#hidden").inner_text().replace("Mean force on", "")


@pytest.mark.one_browser
def test_a_locked_prediction_stays_when_the_forces_are_found(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "asking", ASKING)), "asking")
    assert page.locator("#asking .carts-find button").is_disabled()
    page.locator("#asking .carts-options input").first.check()
    lock(page, "asking")
    expect(page.locator("#asking .carts-results")).to_be_visible()
    answer = page.evaluate("document.querySelector('#asking').trajectory !== null")
    assert answer
    mean = on_scene(
        page,
        """const { v, t, F } = el.trajectory;
        const touching = [...F["A-B"]].map((f, k) => [f, k])
        .filter(([f]) => f > 0).map(([, k]) => k);
        const [i, j] = [touching[0] - 1, touching.at(-1) + 1];
        return 1.0 * (v.B[j] - v.B[i]) / (t[j] - t[i]);""",
        name="asking",
    )
    find(page, f"{mean:.3f}", "asking")
    find(page, f"{-mean:.3f}", "asking", "A, while it touches B")
    expect(page.locator("#asking .carts-found")).to_be_visible()
    expect(page.locator("#asking .carts-results")).to_be_visible()
    expect(page.locator('#asking .carts-graph[data-quantity="F"]')).to_be_visible()
    expect(page.locator("#asking .carts-compared")).to_be_visible()


@pytest.mark.one_browser
def test_a_run_without_a_contact_that_lasts_says_so(
    shared_page: SharePage, widget_site: Path
) -> None:
    path = write_page(widget_site, "apart", {**HIDDEN, "id": "apart", "until": "1 s"})
    page = live(shared_page(path), "apart")
    expect(page.locator("#apart .carts-find-note")).to_have_text(
        "In this run no two touch for a time that can be read off."
    )
    assert page.locator("#apart .carts-find button").is_disabled()
