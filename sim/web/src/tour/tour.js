/**
 * Three hints on the first scene of a page: pull a cart, press Play, pull the time back. One at a time,
 * in the empty sky of the picture, and only while its control can be used. Whoever has done a thing, or
 * has closed the hints, is never shown it again on this computer.
 */

import { tr } from "../../../view/language.js";
import { html, need, say } from "../shared/dom.js";
import { BROWSER, recall, retain } from "../shared/tab.js";
import { HINTS, isPulled } from "./hints.js";

/** @typedef {import("./hints.js").Scene} Scene */
/** @typedef {import("./hints.js").Hint} Hint */

const KEY = "carts-tour"; // names of the hints that are not shown again
const MOVING = ".carts-cart, .carts-velocity, .carts-acting";
const HERE = "carts-tour-here"; // on the control that the hint is about
const REST = 150; // ms after the last change: each look for room lays the page out anew, several times
let resting = 0;

/** @param {Scene} scene the first of the page */
export function showTour(scene) {
  const kept = recall(KEY, BROWSER);
  const done = new Set(Array.isArray(kept) ? kept : []);
  if (HINTS.every(({ name }) => done.has(name))) return;
  const card = html("div", "carts-tour");
  const text = html("span", "carts-tour-text");
  const close = html("button", "carts-tour-close", "×");
  close.setAttribute("type", "button");
  close.setAttribute("aria-label", tr("No more hints"));
  card.setAttribute("role", "note");
  card.append(text, close);

  /** @param {string[]} names */
  const finish = (...names) => {
    if (names.every((name) => done.has(name))) return;
    for (const name of names) done.add(name);
    retain(KEY, [...done], BROWSER);
  };
  let before = 0; // the time shown when it was last looked at, in s
  const look = () => {
    const playing = scene.querySelector(".carts-is-playing") !== null;
    if (playing) finish("play");
    else if (scene.time > 0 && scene.time < before) finish("back");
    before = scene.time;
    const busy = playing || scene.matches(".carts-asks, .carts-projector");
    point(scene, card, text, busy ? undefined : nextHint(scene, done));
    if (done.size >= HINTS.length) end();
  };
  let asked = false;
  const soon = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      look();
    });
  };

  const leaving = new AbortController();
  const options = { signal: leaving.signal, capture: true, passive: true };
  for (const kind of ["click", "input", "keyup", "pointerup", "carts-watched"]) {
    scene.addEventListener(kind, soon, options);
  }
  const pull = (/** @type {Event} */ event) => {
    if (isPulled(event)) finish("drag");
  };
  scene.addEventListener("pointerdown", pull, options);
  close.addEventListener("click", () => {
    finish(...HINTS.map(({ name }) => name));
    if (document.activeElement === close) need(scene, ".carts-play").focus();
    look();
  });
  const changes = new MutationObserver(soon);
  changes.observe(scene, {
    attributes: true,
    attributeFilter: ["class", "data-state", "disabled"],
    subtree: true,
  });
  const end = () => {
    leaving.abort();
    changes.disconnect();
  };
  look();
}

/** @param {Scene} scene @param {Set<string>} done @returns {Hint | undefined} */
function nextHint(scene, done) {
  return HINTS.find((hint) => !done.has(hint.name) && hint.place(scene) && hint.can(scene));
}

/** Shows the hint, or none. @param {Scene} scene @param {HTMLElement} card @param {HTMLElement} text @param {Hint | undefined} hint */
function point(scene, card, text, hint) {
  const place = hint?.place(scene);
  for (const old of scene.querySelectorAll(`.${HERE}`)) {
    if (old !== place) old.classList.remove(HERE);
  }
  const world = scene.querySelector(".carts-world");
  if (!hint || !place || !world) {
    card.remove();
    return;
  }
  const words = hint.text(scene);
  const isNew = card.parentElement !== world || text.textContent !== words;
  say(text, words);
  if (!place.classList.contains(HERE)) place.classList.add(HERE);
  if (card.parentElement !== world) world.append(card);
  clearTimeout(resting);
  if (isNew) settle(scene, card);
  else resting = setTimeout(settle, REST, scene, card);
}

/** In the sky, in its middle or a corner; at the foot, on the scale, where it would cover less of what moves, above the line of what is in this model; below all, where it would cover something everywhere. @param {Scene} scene @param {HTMLElement} card */
function settle(scene, card) {
  const foot = scene.querySelector(".carts-world > p.carts-acting");
  card.style.setProperty("--foot", `${foot?.getBoundingClientRect().height ?? 0}px`);
  const under = ["", "end", "start", "low", "below"].map((at) => {
    card.dataset.at = at; // no class: a change of class asks for a look at the hints
    return { at, count: covered(scene, card) };
  });
  const least = Math.min(...under.map(({ count }) => count));
  card.dataset.at = under.find(({ count }) => count === least)?.at;
}

/** How many carts and arrows lie under the hint. @param {Scene} scene @param {HTMLElement} card */
function covered(scene, card) {
  const own = card.getBoundingClientRect();
  return [...scene.querySelectorAll(MOVING)].filter((part) => {
    const box = part.getBoundingClientRect();
    const beside = box.left >= own.right || box.right <= own.left;
    return box.width > 0 && !beside && box.top < own.bottom && box.bottom > own.top;
  }).length;
}
