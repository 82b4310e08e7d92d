"""What a reader types as a number, in boxes of sliders and of predictions."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node


def test_typed_numbers_are_read_as_people_mean_them() -> None:
    read = in_node(
        """const { readTyped } = await import(source + "/shared/typed.js");
        give(data.map(readTyped));""",
        ["1.5", "1,5", " 2 ", "−0,25", "1e-3", ".5", "1,000", "12,500", "1,000,000", "0,500",
         "500 g", "1,5 kg", "1e309", "NaN", "", "one", "1.2.3", "٣", "9" * 100, "1 0000", "1 000"],
    )  # fmt: skip
    values = [r.get("value", r.get("text", "problem")) for r in read]
    assert values[:6] == [1.5, 1.5, 2, -0.25, 0.001, 0.5]
    assert values[9] == 0.5
    assert values[10:12] == ["500 g", "1.5 kg"]
    assert [v for k, v in enumerate(values) if k in {6, 7, 8} or 12 <= k < 20] == ["problem"] * 11
    assert values[20] == 1000
    assert read[6]["problem"] == "1,000 can mean 1 or 1000: type 1 or 1000"
    assert read[7]["problem"] == "12,500 can mean 12.5 or 12500: type 12.5 or 12500"


def test_a_comma_before_three_digits_has_two_readings_with_a_unit_too() -> None:
    typed = ["1,000 kg", "12,500g", "1,000,000 g", "1,234.5 kg", "1,234.5", "1,2345 kg", "0,500 kg"]
    scene, question = in_node(
        """const { readTyped } = await import(source + "/shared/typed.js");
        const { readNumber } = await import(source + "/question/marking/typed-number.js");
        give([data.map(readTyped), data.map((one) => readNumber(one, { kg: 1, g: 0.001 }))]);""",
        typed,
    )
    assert [one.get("problem") for one in scene] == [
        "1,000 can mean 1 or 1000: type 1 or 1000",
        "12,500 can mean 12.5 or 12500: type 12.5 or 12500",
        "Type 1000000 without commas.",
        *["Type 1234.5 without commas."] * 2,
        *[None] * 2,
    ]
    assert scene[5:] == [{"text": "1.2345 kg"}, {"text": "0.500 kg"}]
    assert [one.get("problem") for one in question] == [one.get("problem") for one in scene]


def test_a_refused_preset_leaves_all_values_as_they_were() -> None:
    found = in_node(
        """const { Values } = await import(source + "/scene/values.js");
        const values = new Values();
        values.ask({ "A.mass": 2 });
        values.good = { "A.mass": 2 };
        const back = values.replace({ "contact.law": "hertz" });
        values.giveUp({ "contact.law": "hertz" });
        back();
        const refused = { ...values.wanted };
        values.undo();
        give([refused, values.wanted, values.canUndo]);""",
        None,
    )
    assert found == [{"A.mass": 2}, {}, False]


def test_a_preset_that_is_refused_after_a_reset_takes_no_undo_away() -> None:
    found = in_node(
        """const { Values } = await import(source + "/scene/values.js");
        const values = new Values();
        values.ask({ "A.mass": 2 });
        values.good = { "A.mass": 2 };
        values.reset();
        const back = values.replace({ "contact.law": "hertz" });
        values.giveUp({ "contact.law": "hertz" });
        back();
        values.undo();
        give(values.wanted);""",
        None,
    )
    assert found == {"A.mass": 2}


def test_a_slider_shows_the_gravity_and_the_track_of_the_run() -> None:
    found = in_node(
        """const { valueIn } = await import(source + "/scene/controls.js");
        const header = { bodies: [], gravity: 1.62, track: { length: 2.5 }, until: 3 };
        give(["gravity", "track.length", "until"].map((one) => valueIn(header, one)));""",
        None,
    )
    assert found == [1.62, 2.5, 3]


def test_a_refused_value_leaves_nothing_to_undo() -> None:
    found = in_node(
        """const { Values } = await import(source + "/scene/values.js");
        const values = new Values();
        const undone = () => [values.canUndo, { ...values.wanted }];
        const found = [];
        values.ask({ "A.mass": -1 });
        values.giveUp({ "A.mass": -1 });
        found.push(undone());
        values.ask({ "A.mass": 2 }); // at once, of the same slider: a change of its own
        values.good = { "A.mass": 2 };
        found.push(undone());
        values.ask({ "A.velocity": "far" });
        values.giveUp({ "A.velocity": "far" });
        found.push(undone());
        values.undo();
        found.push(undone());
        values.ask({ "A.mass": 3 });
        values.good = { "A.mass": 3 };
        values.ask({ "A.mass": -3 }); // one drag, refused at its end only
        values.giveUp({ "A.mass": -3 });
        found.push(undone());
        give(found);""",
        None,
    )
    assert found == [
        [False, {}],
        [True, {"A.mass": 2}],
        [True, {"A.mass": 2}],
        [False, {}],
        [True, {"A.mass": 3}],
    ]


def test_a_slider_that_has_gone_on_is_not_put_back_by_an_older_answer() -> None:
    """Else each step by a key would begin where the run on the screen is, and be lost."""
    pending = in_node(
        """const { Values } = await import(source + "/scene/values.js");
        const values = new Values();
        values.ask({ "A.mass": 1.1 });
        values.ask({ "A.mass": 1.2, "B.mass": 3 });
        values.good = { "A.mass": 1.1, "B.mass": 3 };
        const waiting = [...values.pending];
        values.good = { ...values.wanted };
        give([waiting, [...values.pending]]);""",
        None,
    )
    assert pending == [["A.mass"], []]


def test_a_value_refused_while_python_starts_does_not_end_the_scene() -> None:
    """What it joined was refused: it was given up, and the scene is asked for once more. A scene
    that is refused itself stays so."""
    states = in_node(
        """globalThis.requestAnimationFrame = (act) => setTimeout(act, 0);
        globalThis.document = { createElement: () => ({}) };
        globalThis.location = { hash: "" };
        const { Live } = await import(source + "/scene/live.js");
        const found = [];
        for (const refusals of data) {
          let left = refusals;
          const note = { hidden: true, textContent: "", dataset: {}, setAttribute() {},
            classList: { remove() {} } };
          const element = Object.assign(new EventTarget(), {
            dataset: {}, querySelector: () => note, querySelectorAll: () => [note] });
          const client = Object.assign(new EventTarget(), { state: "ready" });
          const live = new Live(element, client, {
            first: async () => {
              if (left-- > 0) throw Object.assign(new Error("overlap"), { refused: true });
            },
            told: () => true, stepwise: () => false, link: () => {}, failed: () => {},
          });
          live.follow();
          await live.ready.catch(() => {});
          found.push(element.dataset.state);
        }
        give(found);""",
        [0, 1, 2],
    )
    assert states == ["live", "live", "failed"]


def test_a_sign_that_stands_apart_and_wide_figures_are_read_alike_everywhere() -> None:
    typed = ["- 0.5", "－０．５", "- 1,000", "１，０００", "− 3", "- -3"]
    scene, question, *words = in_node(
        """const { readTyped } = await import(source + "/shared/typed.js");
        const { readNumber, withUnit } = await import(
          source + "/question/marking/typed-number.js");
        give([data.map(readTyped), data.map((one) => readNumber(one, { kg: 1 })),
          withUnit("－５", "kg"), withUnit("0.03 ± 0.01", "N")]);""",
        typed,
    )
    assert [one.get("value") for one in scene] == [-0.5, -0.5, None, None, -3, None]
    assert [one.get("value") for one in question] == [one.get("value") for one in scene]
    assert scene[2]["problem"].startswith("-1,000 can mean -1 or -1000")
    assert scene[3]["problem"].startswith("1,000 can mean 1 or 1000")
    assert words == ["－５ kg", "0.03 ± 0.01 N"]


def test_what_is_no_unit_of_the_question_is_answered_with_what_to_type() -> None:
    plain, momentum = {"": 1, "%": 0.01}, {"kg m/s": 1, "N s": 1, "Ns": 1, "kgm/s": 1, "kgms⁻¹": 1}
    said = in_node(
        """const { readNumber } = await import(source + "/question/marking/typed-number.js");
        give(data.map(([typed, units]) => readNumber(typed, units).problem));""",
        [["0.2 kg", plain], ["1/5", plain], ["3 / 10", momentum], ["1 kg", momentum]],
    )
    fraction = "A fraction is not read here: work it out and type for example 0.5"
    assert said == [
        "“kg” does not fit here: it is a number without a unit.",
        fraction,
        fraction,
        "“kg” does not fit here. Units: kg m/s, N s",
    ]
