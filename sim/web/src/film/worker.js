/**
 * Opens a film, shows its frames, looks at clicks and follows the marks: away from the page, which stays in hand.
 *
 *     {id, do: "open", file}                    → {facts}
 *     {id, do: "frame", time, step}             → {time, picture}; step 1, −1: of the frame after, before it
 *     {id, do: "mark", time, click}             → {mark}; null: nothing stands out there
 *     {id, do: "follow", time, clicks}          → {part} many times, at last {rows, broken}; broken: the
 *                                               rest cannot be read
 *     {id, do: "stop"}                          follows asked for until this one end with {rows: null}
 *
 * What cannot be done is answered with {refused: {code, detail}}.
 */

import { Film, Refused } from "./film.js";
import { around, Follower } from "./follow.js";
import { patchOf } from "./patch.js";

/** @typedef {import("./along.js").Row} Row */
/** @typedef {import("./follow.js").Point} Point */

const ENOUGH = 2; // frames are something to read
const OFTEN = 100; // ms between two words on how far it is

/** @type {any} */
const page = self;
/** @type {Film | null} */
let film = null;
let stopped = 0; // what was asked for until this one
let last = Promise.resolve(); // one after the other: they share the decoder

/** @returns {Film} */
function opened() {
  if (!film) throw new Refused("broken");
  return film;
}

/** @param {Film} from @param {import("mediabunny").VideoSample} sample @param {Point} click @returns {Follower | null} */
function start(from, sample, click) {
  const box = around(click, from.facts);
  const patch = patchOf(from.pixels(sample, box), box);
  return Follower.of(patch, click, sample.timestamp, from.facts);
}

/** @type {Record<string, (asked: any) => Promise<Record<string, unknown>>>} */
const WAYS = {
  async open({ file }) {
    film = await Film.open(file);
    return { facts: film.facts };
  },

  async frame({ time, step }) {
    const sample = await opened().at(time, step);
    return { time: sample.timestamp, picture: opened().picture(sample) };
  },

  async mark({ time, click }) {
    const found = start(opened(), await opened().at(time), click);
    return { mark: found && { ...found.place, radius: found.template.half / 1.5 } };
  },

  async follow({ id, time, clicks }) {
    const from = opened();
    /** @type {Row[]} */
    const rows = [];
    /** @type {(Follower | null)[]} */
    let marks = [];
    let told = 0;
    try {
      for await (const sample of from.from(time)) {
        const t = sample.timestamp;
        if (!rows.length) {
          marks = clicks.map((/** @type {Point} */ click) => start(from, sample, click));
          rows.push({ t, marks: marks.map((mark) => mark && { ...mark.place }) });
        } else rows.push({ t, marks: marks.map((mark) => mark && seen(from, sample, mark)) });
        sample.close();
        if (id <= stopped) return { rows: null };
        if (performance.now() - told < OFTEN) continue;
        told = performance.now();
        page.postMessage({ id, part: (t - time) / (from.facts.end - time) });
        await new Promise((resolve) => setTimeout(resolve)); // hears “stop”
      }
    } catch (error) {
      if (rows.length < ENOUGH) throw error;
      return { rows, broken: true };
    }
    return { rows, broken: false };
  },
};

/** @param {Film} from @param {import("mediabunny").VideoSample} sample @param {Follower} mark */
function seen(from, sample, mark) {
  const box = mark.box(sample.timestamp);
  return mark.take(patchOf(from.pixels(sample, box), box), sample.timestamp);
}

/** @param {any} asked */
async function answer(asked) {
  try {
    const found = await WAYS[asked.do]?.(asked);
    const picture = found?.picture;
    page.postMessage({ id: asked.id, done: true, ...found }, picture ? [picture] : []);
  } catch (error) {
    const { code = "broken", detail = String(error) } = /** @type {Refused} */ (error);
    page.postMessage({ id: asked.id, done: true, refused: { code, detail } });
  }
}

page.onmessage = (/** @type {MessageEvent} */ { data }) => {
  if (data.do === "stop") stopped = data.id;
  else last = last.then(() => answer(data));
};
