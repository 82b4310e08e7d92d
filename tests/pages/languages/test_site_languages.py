"""Small sites with lessons in other languages: by folder, by front matter, by the theme."""

from __future__ import annotations

import re
from pathlib import Path

from mkdocs.structure.nav import Link, Section

from sim.cli.site.build import build_site
from sim.pages.language import LANGUAGES
from sim.pages.text.theme_words import MENU_WORDS
from sim.pages.translate.page_turns import own_lessons_first
from tests.conftest import ROOT
from tests.pages.given.small_site import CONFIG, MakeSite, lesson, make_site

__all__ = ["make_site"]  # a fixture


def test_a_folder_named_by_a_language_holds_lessons_that_speak_it(make_site: MakeSite) -> None:
    """The translation keeps the ids of its lesson; the rest of the site stays English. The theme
    speaks as the page does, its menu and its search too."""
    root = make_site(first=lesson())
    (root / "worksheets" / "zh-Hans").mkdir()
    text = lesson().replace("A lesson", "一课")
    (root / "worksheets" / "zh-Hans" / "first.md").write_text(text, encoding="utf-8")
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    page = (site / "worksheets" / "zh-Hans" / "first.html").read_text(encoding="utf-8")
    assert '<html lang="zh-Hans"' in page
    assert ">播放<" in page
    words = '<script src="../../assets/carts/words.zh-Hans.js"></script>'
    assert 0 < page.index(words) < page.index("assets/carts/carts.js")
    script = (site / "assets" / "carts" / "words.zh-Hans.js").read_text(encoding="utf-8")
    assert '"Pause":"暂停"' in script
    english = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert "carts/words." not in english
    assert ">Play<" in english
    assert 'placeholder="搜索"' in page and 'role="dialog" aria-label="查找"' in page
    assert 'placeholder="Search"' in english and 'role="dialog" aria-label="Search"' in english
    assert "简体中文" in (site / "index.html").read_text(encoding="utf-8")


def test_the_pages_of_a_site_are_turned_in_one_language(make_site: MakeSite) -> None:
    """The last lesson in English had led on into Malay, and the page after the lessons back."""
    feet = CONFIG.replace("font: false", "font: false, features: [navigation.footer]")
    feet = feet.replace("worksheets/}]", "worksheets/}, {Sandbox: box.md}]")
    lessons = {name: lesson(identity=name) for name in ("first", "second")}
    root = make_site(feet, **lessons)
    (root / "docs" / "box.md").write_text("# Box\n", encoding="utf-8")
    for language in ("ms", "ta"):
        (root / "worksheets" / language).mkdir()
        for name, text in lessons.items():
            path = root / "worksheets" / language / f"{name}.md"
            path.write_text(text, encoding="utf-8")
    site = build_site(root, hosted=False, strict=True)
    assert site is not None

    def turns(page: str) -> list[str]:
        text = (site / page).read_text(encoding="utf-8")
        return re.findall(r'<a href="([^"]*)" class="md-footer__link', text)

    assert turns("index.html") == ["worksheets/first.html"]
    assert turns("worksheets/second.html") == ["first.html", "../box.html"]
    assert turns("box.html") == ["worksheets/second.html"]
    for language in ("ms", "ta"):
        assert turns(f"worksheets/{language}/first.html") == ["second.html"]
        assert turns(f"worksheets/{language}/second.html") == ["first.html"]


def test_the_lessons_of_a_page_s_language_come_first_in_its_menu() -> None:
    """Ten in English and seven in Malay stood above those in Tamil; and those in all other
    languages lay between the head and an English lesson, for whoever goes by the Tab key."""
    names = [name for language, name in sorted(LANGUAGES.items()) if language != "en"]
    english = [Link("Newton's first law", "first.html"), Link("Newton's second law", "second.html")]
    lessons = Section("Lessons", [*english, *(Section(name, []) for name in names)])
    first = [one.title for one in english]
    words = {"ta": "பிற மொழிகள்", "zh-Hans": "其他语言", "ms": "Bahasa lain", "": "Other languages"}
    for language, folded in words.items():
        own_lessons_first([lessons], f"worksheets/{language}/first.md")
        name = [LANGUAGES[language]] if language else []
        assert [one.title for one in lessons.children] == [*name, *first, folded]
        others = lessons.children[-1]
        assert isinstance(others, Section)  # a part in a part: the theme closes those in it
        told = [one.title for one in others.children]
        assert told == [one for one in names if one not in name]
        assert others.parent is lessons


def test_a_lesson_may_say_what_language_it_speaks(make_site: MakeSite) -> None:
    root = make_site(first=lesson().replace("title:", "language: ta\ntitle:"))
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert '<html lang="ta"' in page
    assert (site / "assets" / "carts" / "words.ta.js").exists()
    assert 'placeholder="தேடு"' in page


def test_the_menu_speaks_as_the_page_and_a_teacher_s_own_names_stay(make_site: MakeSite) -> None:
    """The parts of the menu and the switch of the colours; on English pages nothing changes."""
    ours = CONFIG.replace("{Home: index.md}, ", "{Home: index.md}, {Our carts: own.md}, ")
    ours = ours.replace("worksheets/}]", "worksheets/}, {Sandbox: box.md}]")
    ours = ours.replace("font: false", "font: false, features: [navigation.footer]")
    shades = "palette: [{scheme: default, toggle: {icon: material/weather-night, name: Dark}}]"
    root = make_site(ours.replace("font: false", f"font: false, {shades}"), first=lesson())
    for name in ("own", "box"):
        (root / "docs" / f"{name}.md").write_text("# Ours\n", encoding="utf-8")
    (root / "worksheets" / "ms").mkdir()
    (root / "worksheets" / "ms" / "first.md").write_text(lesson(), encoding="utf-8")
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    english = _menu((site / "worksheets" / "first.html").read_text(encoding="utf-8"))
    assert {"Home", "Lessons", "Our carts", "Dark"} <= english
    page = (site / "worksheets" / "ms" / "first.html").read_text(encoding="utf-8")
    malay = _menu(page)
    assert page.count("Ruang cuba") == 1  # in the menu alone: the foot turns in one language
    assert "Sandbox" not in page
    assert {"Laman utama", "Pelajaran", "Our carts", "Gelap"} <= malay
    assert not {"Home", "Lessons", "Dark"} & malay


def _menu(page: str) -> set[str]:
    """The names in a page's menu, and of the switch of its colours."""
    found = re.findall(r'md-ellipsis">\s*([^<]+?)\s*<|<label [^>]*title="([^"]+)"', page)
    return {"".join(name) for name in found}


def test_the_menu_of_our_own_site_is_in_the_catalogues() -> None:
    """The top row of mkdocs.yml stands on every page of a lesson, translated ones too."""
    config = Path(ROOT, "mkdocs.yml").read_text(encoding="utf-8")
    parts = re.findall(
        r"^ {2}- ([^:\n]+):", config.partition("\nnav:")[2].partition("\n\n")[0], re.MULTILINE
    )
    switches = re.findall(r"^ {8}name: (\w+)$", config, re.MULTILINE)
    assert {*parts, *switches} == MENU_WORDS


def test_the_theme_s_language_is_that_of_every_page(make_site: MakeSite) -> None:
    root = make_site(CONFIG.replace("font: false", "font: false, language: ms"), first=lesson())
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    for name in ("index.html", "worksheets/first.html"):
        page = (site / name).read_text(encoding="utf-8")
        assert '<html lang="ms"' in page
        assert "words.ms.js" in page


def test_the_length_of_a_part_is_told_in_the_language_of_its_page(make_site: MakeSite) -> None:
    parts = "\n\n## First part {: data-minutes=8 }\n\n## Second part {: .more data-minutes=5 }\n"
    root = make_site(f"{CONFIG}markdown_extensions: [attr_list]\n", first=lesson() + parts)
    (root / "worksheets" / "zh-Hans").mkdir()
    (root / "worksheets" / "zh-Hans" / "first.md").write_text(lesson() + parts, encoding="utf-8")
    site = build_site(root, hosted=False, strict=False)
    assert site is not None
    for name, told in (
        ("first.html", ["8 min", "optional, 5 min"]),
        ("zh-Hans/first.html", ["8分钟", "选做，5分钟"]),
    ):
        page = (site / "worksheets" / name).read_text(encoding="utf-8")
        assert re.findall(r'data-length="([^"]*)"', page) == told


def test_an_english_page_says_so_in_a_site_of_another_language(make_site: MakeSite) -> None:
    """By its front matter or its folder; where nothing is said it speaks as the theme does."""
    for theme, plain in (("ms", "ms"), ("de", "de")):
        config = CONFIG.replace("font: false", f"font: false, language: {theme}")
        told = lesson().replace("title:", "language: en\ntitle:")
        root = make_site(config, first=told, second=lesson(identity="two"))
        (root / "worksheets" / "en").mkdir(exist_ok=True)
        (root / "worksheets" / "en" / "third.md").write_text(lesson(identity="three"))
        site = build_site(root, hosted=False, strict=False)
        assert site is not None
        for name, language in (("first", "en"), ("en/third", "en"), ("second", plain)):
            page = (site / "worksheets" / f"{name}.html").read_text(encoding="utf-8")
            assert f'<html lang="{language}"' in page, (theme, name)
