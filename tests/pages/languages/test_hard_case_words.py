"""The table of hard cases in another language: all but what each case says of itself."""

from __future__ import annotations

import re

from markupsafe import escape

from sim.pages.hard_cases import ALL
from sim.pages.hard_cases.block import HardCasesBlock
from sim.pages.hard_cases.render import render_hard_cases
from sim.pages.language import speaking
from sim.pages.language.catalogue import own_words_script, words_script
from tests.pages.given.interface_words import BRACKETS, untold


def test_the_table_is_told_in_the_language_of_its_page() -> None:
    with speaking(BRACKETS):
        made = render_hard_cases(HardCasesBlock("hard"))
    made = re.sub(r"<pre.*?</pre>", "", made, flags=re.DOTALL)
    for case in ALL:
        for own in (case.sentence, case.why, case.name):
            made = made.replace(str(escape(own)), "")
    assert untold(made) == set()


def test_only_pages_with_the_table_carry_its_words() -> None:
    for language in ("ms", "ta", "zh-Hans"):
        assert '"blows up":' in own_words_script("hard", language)
        assert '"blows up":' not in words_script(language)
