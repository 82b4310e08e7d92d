"""What is taken out of a page hears nothing of it any more: a preview puts its parts there anew."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.web.conftest import OpenPage
from tests.web.question.question_site import (
    BANK,
    question_site,
    questions_page,
    ready,
    write_page,
)
from tests.web.runtime.boot_site import ROOT, bundle

__all__ = ["question_site"]  # a fixture

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

LESSON = """
```scene
id: seen
carts:
  A: {mass: 0.5 kg, position: 0.4 m, velocity: 0.6 m/s}
  B: {mass: 1 kg, position: 1.3 m}
until: 3 s
watch: first
```

```question
id: said
type: single
after: seen
ask: What did you see?
options: [{text: They met, correct: true}, {text: Nothing}]
```

!!! after "What was it?"
    They met.
"""

WORLDS = """<carts-worlds data-for="seen" hidden>
<script type="application/json">{"worlds": []}</script></carts-worlds>"""

HEARD = """async (body) => {
  const heard = [], looking = new Set();
  const listen = EventTarget.prototype.addEventListener;
  EventTarget.prototype.addEventListener = function (kind, act, options) {
    heard.push({ target: this ?? window, kind, signal: options?.signal });
    return listen.call(this ?? window, kind, act, options);
  };
  const { observe, disconnect } = MutationObserver.prototype;
  MutationObserver.prototype.observe = function (...all) {
    looking.add(this);
    return observe.apply(this, all);
  };
  MutationObserver.prototype.disconnect = function () {
    looking.delete(this);
    return disconnect.call(this);
  };
  const script = document.createElement("script");
  script.src = "assets/carts/worlds.js";
  document.body.append(script);
  await customElements.whenDefined("carts-worlds");
  const holder = document.createElement("div");
  holder.innerHTML = body;
  for (const one of [...document.querySelector("main").children]) one.remove();
  heard.length = 0;
  looking.clear();
  document.querySelector("main").append(holder);
  const wait = (then) => new Promise((go) => setTimeout(go, then));
  while (!holder.querySelector("carts-question[data-ready]")) await wait(20);
  const ours = (target) => /^class/.test(String(target.constructor)); // the book, the worker
  const outside = heard.filter(({ target }) => target === window ||
    (target instanceof Node ? !holder.contains(target) : ours(target)));
  const before = outside.length;
  holder.remove();
  await wait(20);
  const still = outside.filter(({ signal }) => !signal?.aborted).map(({ kind }) => kind);
  return { before, still, looking: looking.size };
}"""


@pytest.mark.parametrize("name", ["gone", "gone-quiz"])
def test_what_left_the_page_hears_nothing_of_it(
    name: str, question_site: Path, open_page: OpenPage
) -> None:
    text, banks = LESSON, None
    if name == "gone-quiz":
        text, banks = (BANK / "test.md").read_text(encoding="utf-8"), BANK
    path = write_page(question_site, name, text, banks)
    bundle(ROOT / "sim" / "web" / "src" / "worlds-main.js", path.parent / "assets/carts/worlds.js")
    page = ready(open_page(path))
    body = questions_page(name, text, banks)[0].split("<main>")[1].split("</main>")[0]
    body += WORLDS if name == "gone" else ""
    found: dict[str, Any] = page.evaluate(HEARD, body)
    assert found["before"] > 3
    assert found["still"] == []
    assert found["looking"] == 0
