"""The policies of pages and of single files: what may run, each script by its hash."""

from __future__ import annotations

import base64
import hashlib
import html

import pytest

from sim.pages.head.policy import (
    inline_scripts,
    is_trusted,
    policy_of_file,
    policy_of_page,
    trusted_scripts,
)
from sim.pages.text.blocked import blocked

PAGE = (
    '<head><script>a = 1</script></head><body><script src="x.js"></script>'
    '<script type="application/json">{"b": 2}</script><script type="text/javascript">c()</script>'
    "</body>"
)


def by_hash(text: str) -> str:
    digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
    return f"'sha256-{digest}'"


def test_only_scripts_that_run_are_allowed_and_each_by_its_hash() -> None:
    assert inline_scripts(PAGE) == ["a = 1", "c()"]
    rules = policy_of_page("offline", inline_scripts(PAGE))
    for text in ("a = 1", "c()"):
        assert by_hash(text) in rules
    assert rules.count("sha256-") == 2


def test_the_offline_policy_is_the_one_in_the_interfaces() -> None:
    assert policy_of_page("offline") == (
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
        "img-src 'self' data:; font-src 'self' data:; connect-src 'none'; worker-src blob:; "
        "base-uri 'none'; form-action 'none'"
    )


def test_a_page_may_play_what_lies_beside_it_only_where_it_plays_something() -> None:
    for audience in ("offline", "hosted"):
        assert "media-src" not in policy_of_page(audience)  # type: ignore[arg-type]
        assert "media-src 'self'" in policy_of_page(audience, films=True)  # type: ignore[arg-type]


def test_the_hosted_policy_allows_its_own_origin_more() -> None:
    rules = policy_of_page("hosted")
    assert "connect-src 'self'" in rules
    assert "worker-src 'self' blob:" in rules
    assert "manifest-src 'self'" in rules


@pytest.mark.parametrize("audience", ["offline", "hosted"])
def test_no_published_policy_allows_inline_code_or_eval(audience: str) -> None:
    rules = policy_of_page(audience, ["a"])  # type: ignore[arg-type]
    assert "unsafe-inline" not in rules
    assert "'unsafe-eval'" not in rules
    assert "http" not in rules


@pytest.mark.parametrize("python", [False, True])
def test_a_single_file_runs_what_it_has_in_itself_and_asks_nobody(python: bool) -> None:
    rules = html.unescape(policy_of_file(["p {}"], ["go()", "go()"], python=python))
    wasm = "'wasm-unsafe-eval' " if python else ""
    assert f"script-src {wasm}{by_hash('go()')};" in rules
    assert f"style-src {by_hash('p {}')};" in rules
    assert rules.startswith("default-src 'none';")
    assert "connect-src" not in rules
    assert "unsafe-inline" not in rules


def test_a_template_may_fill_in_a_path_and_nothing_else() -> None:
    trusted = trusted_scripts(['<script>go(new URL("{{ base | d(x) }}",here))</script>'])
    assert is_trusted('go(new URL("../..",here))', trusted)
    assert not is_trusted('go(new URL("",steal());("",here))', trusted)
    assert not is_trusted("steal()", trusted)


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
