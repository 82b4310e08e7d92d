/** The script of pages with a scene whose reader works a stopwatch or a ruler. It starts no Python. */

import { workRuler } from "./tools/ruler.js";
import { workStopwatch } from "./tools/stopwatch.js";

for (const scene of document.querySelectorAll("carts-scene")) {
  const timed = /** @type {import("./tools/stopwatch.js").Scene} */ (scene);
  if (scene.querySelector('[data-tool="stopwatch"]')) workStopwatch(timed);
  if (scene.querySelector('[data-tool="ruler"]')) workRuler(timed);
}
