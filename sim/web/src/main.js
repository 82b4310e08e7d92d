/** The page's script: one worker for all scenes, started when the page is idle or first touched. */

import "./shared/older.js";
import { costElement } from "./cost/element.js";
import { hardElement } from "./hard/element.js";
import { mapElement } from "./map/element.js";
import { besideScript, pagePython, startWhenIdle } from "./runtime/page-python.js";
import { sceneElement } from "./scene/element.js";

/** @returns {string[]} what the scenes of this page need besides bare Python */
function packages() {
  const scenes = [...document.querySelectorAll("carts-scene")];
  const names = scenes.flatMap((scene) => (scene.getAttribute("data-packages") ?? "").split(" "));
  return [...new Set(names.filter(Boolean))];
}

const client = pagePython(packages);
customElements.define("carts-scene", sceneElement(client, besideScript("prepared/")));
customElements.define("carts-map", mapElement(client));
customElements.define("carts-cost", costElement(client));
customElements.define("carts-hard", hardElement(client));
if (document.querySelector("carts-scene")) startWhenIdle(client);
document.documentElement.dataset.cartsScenes = ""; // the whole script has run: see watchdog.js
