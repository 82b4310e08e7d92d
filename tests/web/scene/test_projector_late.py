"""The browser tells late that it has left the full screen: no page."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

PROJECTOR = """
const { parseHTML } = await import("linkedom");
const scene = (id) => `<carts-scene id="${id}"><div class="carts-frame">
  <button class="carts-project"></button><p class="carts-ask"></p></div></carts-scene>`;
const window = parseHTML(scene("a") + scene("b"));
globalThis.document = window.document;
const wishes = [];
document.documentElement.requestFullscreen = () => new Promise((done) => wishes.push(done));
document.exitFullscreen = async () => void (document.fullscreenElement = null);
const { offerProjector } = await import(`${source}/scene/projector.js`);
const scenes = [...document.querySelectorAll("carts-scene")];
for (const one of scenes) offerProjector(one);
const press = (k) => scenes[k].querySelector(".carts-project").click();
const turn = () => new Promise((done) => setTimeout(done));
const told = () => document.dispatchEvent(new window.Event("fullscreenchange"));
async function fills() {
  document.fullscreenElement = document.documentElement;
  wishes.pop()();
  await turn();
  told();
}
const on = () => scenes.map((one) => one.classList.contains("carts-projector"));
"""


def test_the_end_of_one_scenes_full_screen_does_not_end_that_of_the_next() -> None:
    during, after, left = in_node(
        PROJECTOR
        + """
        press(0);
        await fills();
        press(0);
        press(1);
        told(); // that the first has left it
        const during = on();
        await fills();
        const after = on();
        document.fullscreenElement = null; // by the browser's own key
        told();
        give([during, after, on()]);
        """,
        None,
    )
    assert during == after == [False, True]
    assert left == [False, False]
