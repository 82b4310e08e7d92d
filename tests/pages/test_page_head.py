"""The policy stands first, allows exactly the page's own scripts, and names the site."""

from __future__ import annotations

import base64
import hashlib
import re

import pytest

from sim.pages.page_head import (
    Needs,
    blocked,
    finish,
    inline_scripts,
    is_trusted,
    policy,
    trusted_scripts,
)

PAGE = (
    '<!doctype html>\n<html><head>\n<meta charset="utf-8">\n<script>a = 1</script>'
    '<link rel="next" href="b.html"></head><body>\n<script src="x.js"></script>'
    '<script type="application/json">{"b": 2}</script><script type="text/javascript">c()</script>'
    "</body></html>"
)


def finished(page: str = PAGE, *, site_id: str = "a-site", **needs: bool) -> str:
    return finish(
        page,
        audience="offline",
        site_id=site_id,
        page_id="worksheets/first",
        assets="../assets/carts/",
        needs=Needs(**needs),
        trusted=trusted_scripts([PAGE]),
    )


def test_the_policy_is_the_first_thing_in_the_head() -> None:
    assert re.search(r'<head>\s*<meta http-equiv="Content-Security-Policy"', finished())


def test_only_scripts_that_run_are_allowed_and_each_by_its_hash() -> None:
    assert inline_scripts(PAGE) == ["a = 1", "c()"]
    rules = policy("offline", inline_scripts(PAGE))
    for text in ("a = 1", "c()"):
        digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in rules
    assert rules.count("sha256-") == 2


def test_the_offline_policy_is_the_one_in_the_interfaces() -> None:
    assert policy("offline") == (
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
        "img-src 'self' data:; font-src 'self' data:; connect-src 'none'; worker-src blob:; "
        "base-uri 'none'; form-action 'none'"
    )


def test_the_hosted_policy_allows_its_own_origin_more() -> None:
    rules = policy("hosted")
    assert "connect-src 'self'" in rules
    assert "worker-src 'self' blob:" in rules
    assert "manifest-src 'self'" in rules


@pytest.mark.parametrize("audience", ["offline", "hosted"])
def test_no_published_policy_allows_inline_code_or_eval(audience: str) -> None:
    rules = policy(audience, ["a"])  # type: ignore[arg-type]
    assert "unsafe-inline" not in rules
    assert "'unsafe-eval'" not in rules
    assert "http" not in rules


def test_scripts_are_loaded_only_where_they_are_needed() -> None:
    assert "carts.js" not in finished()
    assert "katex" not in finished()
    assert '<script src="../assets/carts/carts.js"></script>' in finished(scenes=True)
    assert "../assets/carts/katex/katex.min.css" in finished(formulas=True)
    assert "carts.css" in finished()


def test_a_script_that_the_theme_did_not_write_is_not_allowed() -> None:
    assert finished().count("sha256-") == 3  # two of the theme, and the watchdog
    smuggled = PAGE.replace("<body>", "<body><script>steal()</script>")
    assert finished(smuggled).count("sha256-") == 3


def test_a_template_may_fill_in_a_path_and_nothing_else() -> None:
    trusted = trusted_scripts(['<script>go(new URL("{{ base | d(x) }}",here))</script>'])
    assert is_trusted('go(new URL("../..",here))', trusted)
    assert not is_trusted('go(new URL("",steal());("",here))', trusted)
    assert not is_trusted("steal()", trusted)


def test_no_page_is_prefetched() -> None:
    assert 'rel="next"' not in finished()


def test_the_site_has_a_name_that_cannot_break_out() -> None:
    page = finished(site_id='x"><script>')
    assert 'content="x&quot;&gt;&lt;script&gt;"' in page


@pytest.mark.parametrize(
    ("content", "what"),
    [
        ('<p style="color: red">', "style= on <p>"),
        ('<img src="x.png" onerror="steal()">', "onerror= on <img>"),
        ('<a href="javascript:steal()">', "href=javascript: on <a>"),
        ('<a href=" JaVaScRiPt:steal()">', "href=javascript: on <a>"),
        ('<img src="https://example.org/x.png">', "<img src=https://example.org/x.png>"),
        ('<img src="//example.org/x.png">', "<img src=//example.org/x.png>"),
        ('<iframe src="https://example.org"></iframe>', "<iframe>"),
        ("<style>p {}</style>", "<style>"),
        ("<script>steal()</script>", "<script> with its text in the page"),
    ],
)
def test_what_the_policy_blocks_is_named_to_the_author(content: str, what: str) -> None:
    assert what in blocked(content)


def test_ordinary_content_is_not_complained_about() -> None:
    content = (
        '<p class="a">x<a href="https://example.org">y</a><img src="z.png" alt="">'
        '<script type="application/json">{}</script></p>'
    )
    assert not blocked(content)
