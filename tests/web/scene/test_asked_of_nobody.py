"""What another element asks of a scene that does not hear is answered, with what to do."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
globalThis.document = { documentElement: { lang: "en" }, getElementById: () => null };
const { ASKED, askScene } = await import(`${source}/shared/ask-scene.js`);
const scene = new EventTarget();
const told = () => Promise.race([
  askScene(scene, { kind: "run" }).catch((error) => error.message),
  new Promise((resolve) => setTimeout(resolve, 50, "nothing")),
]);
const first = await told();
scene.addEventListener(ASKED, ({ detail }) => detail.answer(Promise.resolve(detail.message.kind)));
give([first, await told()]);
"""


def test_a_scene_that_does_not_hear_is_told_of() -> None:
    assert in_node(SCRIPT, None) == ["The scene does not answer. Load the page again.", "run"]
