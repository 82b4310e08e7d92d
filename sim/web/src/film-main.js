/**
 * The script of films, loaded when one is wanted. `cartsFilm.open(bench, file, take)` puts a film into a bench of
 * readings; `take(name, [text], same)` gets what was read, as a file of readings would say it.
 * `cartsFilm.camera(bench, take, tell)` makes one.
 */

import { filmWithCamera } from "./film/camera.js";
// @ts-expect-error: the bundler puts the style here
import styleText from "./film/film.css?text";
import { Session } from "./film/session.js";
import { inside } from "./film/skeleton.js";
import { need, parsed } from "./shared/dom.js";

const style = new CSSStyleSheet();
style.replaceSync(styleText);
document.adoptedStyleSheets = [...document.adoptedStyleSheets, style];

/** @param {HTMLElement} bench @param {File} file @param {import("./measured/films.js").Take} take */
function open(bench, file, take) {
  const section = parsed(inside(bench.id || "film").text);
  need(bench, ".carts-measured-source").after(section);
  return new Session(section, file, take);
}

/** @param {HTMLElement} bench @param {(file: File) => void} take @param {(text: string) => void} tell */
const camera = (bench, take, tell) =>
  filmWithCamera(need(bench, ".carts-measured-source"), take, tell);

/** @type {any} */ (globalThis).cartsFilm = { open, camera };
