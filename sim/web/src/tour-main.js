/** The script of pages with a scene that shows a first reader three things to do. It starts no Python. */

import { showTour } from "./tour/tour.js";

const first = /** @type {import("./tour/hints.js").Scene | null} */ (
  document.querySelector("carts-scene")
);
if (first) showTour(first);
