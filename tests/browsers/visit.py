"""What a student does with a lesson, in a browser behind WebDriver: run, predict, answer, come
back, take the answers home. Each lesson has some of it; what it has must work.
"""

from __future__ import annotations

from dataclasses import dataclass

from .webdriver import Session, soon

PATIENCE = 60.0  # s for a start of Python on a machine that others use too; here it takes 1 to 3
SOON = 20.0  # s for all else

READY = "return document.querySelector('.carts-bar[data-ready]') !== null"
LIVE = "return document.querySelector('carts-scene:not([data-state=live])') === null"
# Each finds one thing and marks it, so that the driver presses and types there as a reader does.
MARK = """const [name, css] = arguments;
  const open = (it) => it.offsetParent !== null && !it.disabled && !it.readOnly && !it.checked;
  const found = [...document.querySelectorAll(css)].find(open);
  found?.setAttribute("data-tried", name);
  return found !== undefined"""
PLAY = "carts-scene .carts-play"
GUESS = """carts-scene .carts-predict :is(input[type=radio][name$=-predict],
  .carts-guess input[type=range])"""
ARROW = """carts-scene:has([data-tried=guess])
  .carts-guess input[type=range]:not([data-tried])"""
SURE = "carts-scene:has([data-tried=guess]) .carts-certainty input"
END = "carts-scene .carts-end"
FIELD = "carts-question :is(textarea, input[type=text], input[type=radio][name$=-answer])"
NODE = "carts-question .carts-q-node:not([data-tried])"
MOVES = """return document.querySelector("[data-tried=play]").closest("carts-scene").time > 0"""
RUNS = "return document.querySelector('[data-tried=lock]').closest('carts-scene').time > 0"
# What a lock does: the run plays, or the reader is asked to talk about it first.
GOES_ON = f"""return (() => {{ {RUNS} }})() || document.querySelector('[data-tried=lock]')
  .closest('carts-scene').querySelector('.carts-talk:not([hidden])') !== null"""
LOCKED = "return document.querySelectorAll('.carts-predict input:checked:disabled').length"
SAVED = """const its = document.querySelector("[data-tried=answer]").closest("carts-question");
  return its.querySelector(".carts-q-saved").textContent === "Saved\""""
ANSWERS = """return [...document.querySelectorAll(
  "carts-question :is(textarea, input[type=text], input[type=radio], .carts-q-linked li)",
)].map((it) =>
  it.localName === "li" ? it.textContent : it.type === "radio" ? it.checked : it.value).join("|")"""
NOBODY = """const without = document.querySelector(".carts-answers-without-code");
  if (without) without.click()"""
WORDS = "Same force, less mass: Äöü 力"


@dataclass(frozen=True)
class Seen:
    """What worked: "live", "play" and "lock" where the lesson has them; an answer always."""

    done: frozenset[str]
    file: str  # the answers taken home


def visit(window: Session, address: str, *, comes_back: bool) -> Seen:
    """Do all that a lesson asks for; who comes back finds it. Raises TimeoutError at what does not
    work."""
    done = set()
    window.fresh()  # each download takes a line of WebKit's window away from the page
    window.go(address)
    window.wait(READY, SOON)
    window.wait(LIVE, PATIENCE)
    if window.run("return document.querySelector('carts-scene') !== null"):
        done.add("live")
    if _mark(window, "play", PLAY):
        window.click("[data-tried=play]")
        window.wait(MOVES, SOON)
        done.add("play")
    if _mark(window, "guess", GUESS):
        _lock(window)
        done.add("lock")
        window.wait(GOES_ON, SOON)
        if window.run(RUNS):
            done.add("play")
    answers, locks = _answer(window), window.run(LOCKED)
    file = _take_home(window)
    if comes_back:
        window.reload()
        window.wait(f"return (() => {{ {ANSWERS} }})() === arguments[0]", SOON, answers)
        window.wait(f"return (() => {{ {LOCKED} }})() === arguments[0]", SOON, locks)
    return Seen(frozenset(done), file)


def _mark(window: Session, name: str, css: str) -> bool:
    return bool(window.run(MARK, name, css))


def _lock(window: Session) -> None:
    window.click("[data-tried=guess]")
    drawn = 0
    while _mark(window, f"arrow-{drawn}", ARROW):
        window.click(f"[data-tried=arrow-{drawn}]")
        drawn += 1
    if _mark(window, "sure", SURE):
        window.click("[data-tried=sure]")
    window.run("""document.querySelector("[data-tried=guess]").closest("carts-scene")
      .querySelector(".carts-lock").setAttribute("data-tried", "lock")""")
    window.click("[data-tried=lock]")
    window.wait(LOCKED, SOON)


def _answer(window: Session) -> str:
    """Answer one question; all answers of the page. Where all wait for a run, that is watched."""
    if not _mark(window, "answer", FIELD) and _mark(window, "end", END):
        window.click("[data-tried=end]")
        window.wait(MARK, SOON, "answer", FIELD)
    if not _mark(window, "answer", FIELD):  # a diagram: from one object to the next
        for name in ("from", "answer"):
            assert _mark(window, name, NODE), "no question takes an answer"
            window.click(f"[data-tried={name}]")
    elif window.run("return document.querySelector('[data-tried=answer]').type === 'radio'"):
        window.click("[data-tried=answer]")
    else:
        window.type("[data-tried=answer]", WORDS)
    window.wait(SAVED, SOON)
    return str(window.run(ANSWERS))


def _take_home(window: Session) -> str:
    """The text of the file that the browser has written into its folder."""
    for older in window.downloads.glob("*.json"):
        older.unlink()
    window.click(".carts-bar-open")
    window.wait(MARK, SOON, "save", ".carts-answers-save")
    window.click("[data-tried=save]")

    def written() -> str:
        window.run(NOBODY)  # nobody has said who works here: without a name, then
        return "".join(path.read_text("utf-8") for path in window.downloads.glob("*.json"))

    return str(soon(written, SOON, "a file of answers"))
