/** What is wired anew each time the inside of a scene is put there: buttons, menus, forces to find. */

import { WANTED } from "../../../view/ledger-effects.js";
import { FindForces } from "../predict/find-forces.js";
import { Predict } from "../predict/predict.js";
import { need } from "../shared/dom.js";
import { refusal } from "../shared/waiting.js";
import { Controls, valueIn } from "./controls.js";
import { How } from "./how/how.js";
import { Ladder } from "./ladder.js";
import { Presets } from "./presets.js";
import { offerProjector } from "./projector.js";
import { TakeAlong } from "./take-along/take-along.js";

/** @typedef {import("./values.js").Settings} Settings */
/**
 * @typedef {{reset: () => void, undo: () => void, preset: (changes: Settings, name: string) => void,
 *   found: (said: string[]) => void, settings: () => Settings, told: () => boolean, change: import("./controls.js").Change,
 *   stops: import("./controls.js").Stops}} Acts
 *   `told`: no prediction is waited for
 */

/** Ends what an inside hears from beyond it: the next one takes its place. @type {WeakMap<HTMLElement, AbortController>} */
const lives = new WeakMap();

/**
 * @param {HTMLElement} element @param {import("../../../view/types.js").Baked} baked
 * @param {import("./scene-view.js").SceneView} view @param {import("../runtime/client.js").Client} client
 * @param {Acts} acts
 */
export function wireInside(element, baked, view, client, acts) {
  lives.get(element)?.abort();
  const life = new AbortController();
  lives.set(element, life);
  element.querySelector(".carts-reset")?.addEventListener("click", acts.reset);
  element.querySelector(".carts-undo")?.addEventListener("click", acts.undo);
  const presets = new Presets(element, baked.fence, acts.preset);
  presets.show({}, baked.run.header);
  const { scene, controls, switches } = baked.fence;
  const sliders = new Controls(element, controls, acts, switches);
  view.draggable({
    ready: () => sliders.on && acts.told() && view.player.time === 0 && !view.player.playing,
    value: (target) => valueIn(view.run.header, target),
    change: (control, value, at) => sliders.take(control.set, value, at),
  });
  const [writing, counting] = [{}, {}]; // who asks: apart from the requests for runs
  const program = async () => {
    const set = { ...acts.settings() };
    const { header } = await client.ask(writing, () => ({ kind: "model", scene, set }));
    if (!header.ok) throw refusal(header.problems ?? []);
    return String(/** @type {any} */ (header).text);
  };
  new TakeAlong(element, baked, () => ({ ...view.now, settings: acts.settings() }), program);
  offerProjector(element);
  need(element, ".carts-frame").addEventListener(WANTED, (event) => {
    const { detail } = /** @type {CustomEvent} */ (event);
    detail.heard = true;
    const set = { ...acts.settings() };
    client
      .ask(counting, () => ({ kind: "energy", scene, set }))
      .then(
        ({ header, numbers }) => detail.answer(header.ok ? columnsOf(header, numbers) : null),
        () => detail.answer(null),
      );
  });
  const find = element.querySelector(".carts-find")
    ? new FindForces(element, baked.fence.id, acts.found)
    : null;
  const how = new How(
    element,
    view,
    client,
    (more) => {
      return { kind: "how", scene, set: { ...acts.settings() }, ...more };
    },
    life.signal,
  );
  const ladder = new Ladder(element, client, () => {
    return { kind: "relevance", scene, set: { ...acts.settings() } };
  });
  const follow = (/** @type {import("../../../view/types.js").Run} */ run) => {
    ladder.follow(run);
    return how.follow(run);
  };
  /** @param {import("./values.js").Values} values @param {import("../../../view/types.js").Header} header */
  const show = (values, header) => {
    // Until Python answers, prepared runs are shown, and the sliders with their values.
    const pending = client.state === "ready" ? values.pending : new Set();
    sliders.show(values.good, header, pending);
    presets.show(values.good, header);
  };
  return { controls: sliders, presets, show, find, how, follow };
}

/**
 * The prediction that the lesson asks for before the run; null where it asks for none.
 * @param {HTMLElement} element @param {import("../../../view/types.js").Baked} baked
 * @param {import("./scene-view.js").SceneView} view
 * @param {{locked: (now: boolean) => void, forgotten: (now: boolean) => void}} acts
 */
export function askFirst(element, baked, view, { locked, forgotten }) {
  const ask = element.querySelector(".carts-predict");
  if (!(ask instanceof HTMLElement)) return null;
  const draw = (/** @type {any} */ guesses) => {
    for (const stage of view.stages) stage.guess(guesses);
  };
  const { signal } = /** @type {AbortController} */ (lives.get(element));
  return new Predict(ask, baked, draw, locked, forgotten, signal);
}

/** @param {any} header @param {Float64Array} numbers @returns {import("../../../view/ledger-effects.js").Parts} */
function columnsOf({ parts, carts, rows }, numbers) {
  const column = (/** @type {number} */ k) => numbers.subarray(k * rows, (k + 1) * rows);
  return {
    names: parts,
    t: column(0),
    columns: parts.map((/** @type {string} */ _, /** @type {number} */ k) => column(k + 1)),
    moving: Array.from({ length: carts }, (_, k) => column(parts.length + k + 1)),
  };
}
