"""The policy stands first, the theme's own scripts may run, and the page knows its site's name."""

from __future__ import annotations

import re
from typing import Any

from sim.pages.head.page_head import Needs, finish, own_words
from sim.pages.head.policy import trusted_scripts

PAGE = (
    '<!doctype html>\n<html><head>\n<meta charset="utf-8">\n<script>a = 1</script>'
    '<link rel="next" href="b.html"></head><body>\n<script src="x.js"></script>'
    '<script type="application/json">{"b": 2}</script><script type="text/javascript">c()</script>'
    "</body></html>"
)


def finished(page: str = PAGE, *, site_id: str = "a-site", **needs: Any) -> str:
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


def test_scripts_are_loaded_only_where_they_are_needed() -> None:
    assert "carts.js" not in finished()
    assert "katex" not in finished()
    assert '<script src="../assets/carts/carts.js"></script>' in finished(scenes=True)
    assert "../assets/carts/katex/katex.min.css" in finished(formulas=True)
    assert "carts.css" in finished()


def test_words_of_readings_come_behind_the_others_and_only_where_readings_are() -> None:
    own = own_words("<carts-measured id=a>", "ms")
    page = finished(language="ms", measured=True, own_words=own)
    names = re.findall(r'<script src="../assets/carts/([^"]+)"', page)
    assert names[:3] == ["words.ms.js", "words-measured.ms.js", "measured.js"]
    assert "words-measured" not in finished(language="ms") + finished(measured=True)
    assert own_words("<carts-measured id=a>", "en") == ()
    assert own_words("<carts-scene id=a><carts-map id=b>", "ta") == ("map",)


def test_a_script_that_the_theme_did_not_write_is_not_allowed() -> None:
    assert finished().count("sha256-") == 3  # two of the theme, and the watchdog
    smuggled = PAGE.replace("<body>", "<body><script>steal()</script>")
    assert finished(smuggled).count("sha256-") == 3


def test_no_page_is_prefetched() -> None:
    assert 'rel="next"' not in finished()


def test_the_site_has_a_name_that_cannot_break_out() -> None:
    page = finished(site_id='x"><script>')
    assert 'content="x&quot;&gt;&lt;script&gt;"' in page


def test_what_a_page_asks_stands_before_every_script_that_asks_for_it() -> None:
    """A scene looks there whether what was predicted answers its question; it does not wait."""
    outline = {"lesson": "first", "hash": "", "items": []}
    page = finished(scenes=True, outline=outline)
    assert page.index('id="carts-lesson"') < page.index("carts.js") < page.index("answers.js")
