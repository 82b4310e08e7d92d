"""Logs of phones and sensors in a page: zipped, of two phones, with several runs."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.measured.device_reports import lost_at_the_touch
from tests.measured.devices import Motion, phone, sensor_carts
from tests.measured.several_runs import below, beside
from tests.web.conftest import SharePage
from tests.web.figures.measured_bench import LIVE, STARTS, benches, choose, opened
from tests.web.kept_store import MEASURED, written

__all__ = ["benches"]  # a fixture

pytestmark = pytest.mark.browser


def test_two_phones_of_which_one_zipped_its_log_are_compared(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "empty.html")
    page.locator(LIVE).wait_for(timeout=STARTS)
    first, second = (phone(Motion(), cart, seed=cart, clock=0.3 * cart) for cart in (0, 1))
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as pack:
        pack.writestr("meta/device.csv", "property,value\n")
        pack.writestr("Raw Data.csv", first)
    payloads = [
        {"name": "left.zip", "mimeType": "application/zip", "buffer": packed.getvalue()},
        {"name": "right.csv", "mimeType": "text/csv", "buffer": second.encode()},
    ]
    page.locator(".carts-measured-file").set_input_files(payloads)  # type: ignore[arg-type]
    result = page.locator(".carts-measured-result")
    expect(result).to_contain_text("Greatest acceleration of", timeout=STARTS)
    expect(result).to_contain_text("clock is set by the contact itself")
    expect(page.locator(".carts-measured-legend")).to_contain_text("phone on")
    expect(page.locator(".carts-measured-figure .carts-unit").first).to_have_text("a in m/s²")
    heads = page.locator(".carts-measured-table th").all_text_contents()
    assert heads[1].startswith("a of ") and heads[1].endswith(" in m/s²")
    damaged = {**payloads[0], "buffer": packed.getvalue()[:300]}
    page.locator(".carts-measured-file").set_input_files([damaged])  # type: ignore[arg-type]
    expect(page.locator(".carts-measured-unread")).to_contain_text("damaged")
    expect(result).to_contain_text("Greatest acceleration of")  # the last good one stays


@pytest.mark.one_browser
def test_the_run_that_is_read_is_the_one_that_stands_there(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "empty.html")
    page.locator(LIVE).wait_for(timeout=STARTS)
    whole = sensor_carts(Motion(), seed=2).removeprefix("\ufeff")
    heads, *rows = whole.splitlines()
    stopped = [heads, *rows[:5], *("," * heads.count(",") for _ in rows[5:])]
    choose(page, "log.csv", beside(["\n".join(stopped), whole]))
    run = page.locator(".carts-measured-run")
    expect(run).to_have_value("2", timeout=STARTS)
    run.select_option("1")
    expect(page.locator(".carts-measured-unread")).to_contain_text("at least 8 are needed")


@pytest.mark.one_browser
def test_of_several_runs_in_a_log_one_is_chosen(benches: Path, shared_page: SharePage) -> None:
    page = opened(shared_page, benches / "empty.html")
    page.locator(LIVE).wait_for(timeout=STARTS)
    logs = [sensor_carts(Motion(), seed=seed) for seed in (1, 2)]
    choose(page, "log.csv", below(logs).removeprefix("\ufeff"))
    run = page.locator(".carts-measured-run")
    expect(run).to_be_visible(timeout=STARTS)
    expect(run).to_have_value("1")
    first = page.locator(".carts-measured-table table").text_content()
    run.select_option("2")
    expect(page.locator(".carts-measured-table table")).not_to_have_text(first or "")
    written(page, MEASURED)
    page.reload()
    expect(run).to_have_value("2", timeout=STARTS)  # kept with the readings
    table = page.locator(".carts-measured-table table")
    second = table.text_content()
    begin = page.locator(".carts-measured-from")
    begin.fill("0.2")
    begin.press("Enter")
    expect(table).not_to_have_text(second or "")
    expect(run).to_have_value("2")  # a span is of the run that was chosen
    choose(page, "one.csv", logs[0].removeprefix("\ufeff"))
    expect(run).to_be_hidden()


@pytest.mark.one_browser
def test_who_saw_that_the_carts_stayed_together_gets_the_ratio_all_the_same(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "empty.html")
    page.locator(LIVE).wait_for(timeout=STARTS)
    choose(page, "log.csv", lost_at_the_touch(1.6).removeprefix("\ufeff"))
    page.locator(".carts-measured-fit").click()
    refusal = page.locator(".carts-measured-unfitted")
    expect(refusal).to_contain_text("its sensor", timeout=STARTS)
    expect(refusal).to_be_in_viewport()  # by the button that was pressed
    page.get_by_label("I saw that the carts stayed together").check()
    page.locator(".carts-measured-fit").click()
    expect(page.locator(".carts-measured-result")).to_contain_text("The carts stick")
    expect(refusal).to_be_empty()
