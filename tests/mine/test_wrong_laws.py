"""Laws in Python: what is said of those that cannot be asked, and what bounds leave as it is."""

from __future__ import annotations

from typing import Any

import pytest

from sim.mine.arguments import ARGUMENTS
from sim.mine.follow import follow
from sim.mine.instance import Instance, read_law
from sim.mine.judge.search import judge
from sim.mine.wrong import WrongLawError
from sim.scene import read_scene
from tests.mine.laws import PAIR, SPRING, with_law

WRONG_TEXTS = {
    "no Python": ("def force(overlap)\n    return 1\n", 1, "not Python"),
    "no function": ("x = 1\n", 1, "no function called force"),
    "another module": ("import math\nimport os\ndef force(overlap):\n    return 1\n", 2, "“os”"),
    "a part of another": ("from sys import path\ndef force(overlap):\n    return 1\n", 1, "“sys”"),
    "an unknown argument": ("\ndef force(overlap, speed):\n    return 1\n", 2, "“speed”"),
    "a star": ("def force(*all):\n    return 1\n", 1, "without *"),
    "not a number": ("def force(overlap):\n    x = 1\n    return 'much'\n", 3, "this is str"),
    "nothing": ("def force(overlap):\n    overlap + 1\n", 1, "without a return"),
    "nan": ("def force(overlap):\n    x = 1e300 * 1e300\n    return x - x\n", 3, "nan"),
    "infinity": ("def force(overlap):\n    return 1e308 * 10 + overlap\n", 2, "inf"),
    "a complex number": ("def force(overlap):\n    return (overlap - 1) ** 0.5\n", 2, "complex"),
    "a division by nought": ("def force(overlap):\n    a = 0\n    return 1 / a\n", 3, "Zero"),
    "an unknown name": ("def force(overlap):\n    return k * overlap\n", 2, "“k”|'k'"),
    "an endless loop": ("def force(overlap):\n    x = 1\n    while x:\n        x = 2\n",
                        3, "goes on and on"),
    "an endless loop outside": ("while True:\n    pass\ndef force(overlap):\n    return 1\n", 1,
                                "goes on and on"),
    "a long count": ("def force(overlap):\n    return sum(i for i in range(10**9))\n", 2, "range"),
    "a function that calls itself": (
        "def f(x):\n    return f(x)\ndef force(overlap):\n    return f(1)\n", 1, "Recursion"
    ),
    "a huge power": ("def force(overlap):\n    return 10 ** 10 ** 10\n", 2, "power"),
    "a huge power in place": (
        "def force(overlap):\n    x = 9\n    x **= 9 ** 5\n    return 1\n", 3, "power"
    ),
    "a power in a list": (
        "def force(overlap):\n    x = [9]\n    x[0] **= 9 ** 5\n    return 1\n", 3, "power"
    ),
    "a long shift": ("def force(overlap):\n    return 1 << 10 ** 6\n", 2, "whole number"),
    "a number squared again and again": (
        "def force(overlap):\n    x = 9\n    for k in range(16):\n        x = x * x\n    return 1",
        4, "whole number"
    ),
    "a long list": ("def force(overlap):\n    return len([0] * 10 ** 6)\n", 2, "list or text"),
    "a list that doubles itself": (
        "def force(overlap):\n    x = [1]\n    for k in range(20):\n        x += x\n    return 1\n",
        4, "list or text"
    ),
    "a wide text": ("def force(overlap):\n    x = '%100000d' % 1\n    return 1\n", 2, "too wide"),
    "a wide field": ("def force(overlap):\n    x = f'{1:100000}'\n    return 1\n", 2, ":100000"),
    "a reckoned width": ("def force(overlap):\n    x = f'{1:{9}}'\n    return 1\n", 2, ":{*}"),
    "a filled text": ("def force(overlap):\n    return len('a'.ljust(10 ** 6))\n", 2, "ljust"),
    "bytes, whose width has no bound": (
        "def force(overlap):\n    x = b'%99999d' % 1\n    return 1\n", 2, "b''"
    ),
    "a text put in for each letter": (
        "def force(overlap):\n    return len('aa'.replace('a', 'b' * 9))\n", 2, "replace"
    ),
    "lists added up": (
        "def force(overlap):\n    return len(sum([[0] * 9000] * 9, []))\n", 2, "list or text"
    ),
    "a list that is extended by itself": (
        "def force(overlap):\n    a = [1]\n    a.extend(a)\n    return 1\n", 3, "extend"
    ),
    "a list put into itself": (
        "def force(overlap):\n    a = [1]\n    a[0:0] = a\n    return 1\n", 3, "[:] ="
    ),
    "a list put into itself in place": (
        "def force(overlap):\n    a = [1]\n    a[0:0] += a\n    return 1\n", 3, "[:] ="
    ),
    "a list made of itself": (
        "def force(overlap):\n    a = [1]\n    for k in range(20):\n        a = [*a, *a]\n"
        "    return 1\n", 4, "list or text"
    ),
    "a text made of itself": (
        "def force(overlap):\n    a = 'a'\n    for k in range(20):\n        a = f'{a}{a}'\n"
        "    return 1\n", 4, "list or text"
    ),
    "the text of a list of long texts": (
        "def force(overlap):\n    return len(str([['a' * 9000] * 9] * 9))\n", 2, "list or text"
    ),
    "a long list in a text": (
        "def force(overlap):\n    return len('%s' % (['a' * 9000] * 9,))\n", 2, "list or text"
    ),
    "a factorial": (
        "import math\ndef force(overlap):\n    math.factorial(2000)\n    return 1\n", 3, "number"
    ),
    "a product": (
        "from math import prod\ndef force(overlap):\n    prod(range(1, 2000))\n    return 1\n",
        3, "number"
    ),
    "rounded to nothing": (
        "def force(overlap):\n    return round(5, -10 ** 5)\n", 2, "whole number"
    ),
    "a lambda that calls itself twice": (
        "f = lambda n: f(n - 1) + f(n - 1) if n else 1\ndef force(overlap):\n    return f(16)\n",
        1, "goes on and on"
    ),
    "a deep nest": (f"def force(overlap):\n    return {'+'.join('1' * 2000)}\n", 1, "longer"),
    "more than can be reckoned with": ("def force(overlap):\n    return 1e308\n", 2, "too large"),
    "force taken away": ("def force(overlap):\n    return 1\ndel force\n", 1, "no function"),
    "force as a number": ("def force(overlap):\n    return 1\nforce = 3\n", 1, "no function"),
    "a file": ("def force(overlap):\n    return len(open('x').read())\n", 2, "“open”"),
    "what lies below": ("def force(overlap):\n    return ().__class__\n", 2, "“__class__”"),
    "a try that swallows": (
        "def force(overlap):\n    try:\n        return 1\n    finally:\n        pass\n", 2, "“try”"
    ),
    "a class": ("class A:\n    pass\ndef force(overlap):\n    return 1\n", 1, "“class”"),
    "too long": ("#" * 20_001, 1, "longer"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG_TEXTS)
def test_a_law_that_cannot_be_asked_is_told_with_its_line(name: str) -> None:
    text, line, words = WRONG_TEXTS[name]
    with pytest.raises(WrongLawError) as found:
        Instance(read_law(text)).ask([0.01, 0.1, *[1.0] * (len(ARGUMENTS) - 2)])
    assert found.value.line == line
    assert any(word in found.value.message for word in words.split("|")), found.value.message


def test_the_mark_that_some_editors_write_is_no_part_of_a_law() -> None:
    assert Instance(read_law("\ufeff" + SPRING)).ask([0.01, *[1.0] * (len(ARGUMENTS) - 1)]) == 0.01


@pytest.mark.parametrize("body", ["-stiffness * overlap", "-300 * overlap ** 2", "-5"])
def test_a_law_of_the_wrong_sign_is_told_so_and_not_that_its_steps_disagree(body: str) -> None:
    """Carts that pull each other in get faster for ever, as smoothly as a cosh."""
    text = f"def force(overlap, rate, stiffness):\n    return {body}\n"
    with pytest.raises(WrongLawError, match="pulls the carts into each other") as found:
        judge(text)
    assert "sign" in found.value.hint
    assert found.value.line == 1


def test_a_run_of_a_law_of_the_wrong_sign_ends_with_that_and_not_with_a_velocity() -> None:
    text = "def force(overlap, rate, stiffness):\n    return -stiffness * overlap\n"
    for file in ({"until": 3.0}, {"until": 30.0}):
        with pytest.raises(WrongLawError, match="pulls the carts into each other"):
            follow(read_scene(with_law(PAIR | file, text, stiffness=100)))


def test_carts_may_fall_into_a_well_that_gives_them_back() -> None:
    """It pulls at first, and pushes deeper in: no energy is made, and the steps agree."""
    text = "def force(overlap, rate):\n    return 400 * overlap - 20 * math.exp(-overlap / 0.01)\n"
    assert judge("import math\n" + text).holds


@pytest.mark.parametrize(
    "force",
    [
        "2e6 * (overlap - 0.001)",
        "5e4 * (overlap - 0.01)",
        "-5.0 if overlap < 0.02 else 500 * (overlap - 0.02)",
        "50 if overlap > 0.01 else -50",
    ],
)
def test_a_well_with_a_bottom_is_judged_and_not_called_a_wrong_sign(force: str) -> None:
    """Its pull fades towards the bottom, and beyond it it pushes, however deep and stiff it is."""
    text = f"def force(overlap, rate):\n    return {force}\n"
    assert len(judge(text).verdicts) > 1


@pytest.mark.parametrize("force", ["1e12", "1e50", "1e99"])
def test_no_velocity_of_a_huge_force_is_told_that_is_no_number(force: str) -> None:
    text = f"def force(overlap, rate):\n    return {force}\n"
    told = [verdict.sentence for verdict in judge(text).verdicts]
    assert not any("nan" in sentence or "inf" in sentence for sentence in told)
    with pytest.raises(WrongLawError, match="too large"):
        follow(read_scene(with_law(PAIR, text)))


def test_bounds_change_nothing_of_what_a_law_computes() -> None:
    text = """\
seen = [0, [1]]

def force(overlap, side):
    same, n, word, first = seen[1], 3, "ab", "%s: " % side
    seen[1] += [2, 3]
    seen[len(first) - 6] += len(first)
    same *= 2
    low, *others = [*seen[1], *map(len, [str(side), f"{overlap:.2f} {n}"])]
    assert isinstance(side, str) and sum(others, 0.5) and sum([[1], [2]], [3]) == [3, 1, 2]
    n **= 3
    n <<= 2
    word *= 2
    word += word
    force.calls = n
    force.calls *= n
    square = lambda a: a * a
    lengths = len(word) + sum(seen[1]) + seen[0] + low + len(others)
    return n % 7 + lengths + square(n) / 7 + overlap * 3 ** 2 + force.calls
"""
    plain: dict[str, Any] = {}
    exec(text, plain)
    law = Instance(read_law(text))
    for overlap in (0.1, 0.3):
        asked: list[Any] = [1.0] * len(ARGUMENTS)
        asked[0], asked[-1] = overlap, "left"
        assert law.ask(asked) == plain["force"](overlap, "left")
