/**
 * Opens a film, shows its frames, looks at clicks and follows the marks: away from the page, which stays in hand.
 *
 *     {id, do: "open", file}                    → {facts}
 *     {id, do: "frame", time}                   → {time, picture}
 *     {id, do: "mark", time, click}             → {mark}; null: nothing stands out there
 *     {id, do: "follow", time, clicks}          → {part} many times, at last {rows}
 *     {do: "stop"}                              the one under way ends with {rows: null}
 *
 * What cannot be done is answered with {refused: {code, detail}}.
 */

import { Film, Refused } from "./film.js";
import { around, Follower } from "./follow.js";
import { patchOf } from "./patch.js";

/** @typedef {import("./along.js").Row} Row */
/** @typedef {import("./follow.js").Point} Point */

const OFTEN = 100; // ms between two words on how far it is

/** @type {any} */
const page = self;
/** @type {Film | null} */
let film = null;
let stopped = false;
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

  async frame({ time }) {
    const sample = await opened().at(time);
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
    for await (const sample of from.from(time)) {
      const t = sample.timestamp;
      if (!rows.length) {
        marks = clicks.map((/** @type {Point} */ click) => start(from, sample, click));
        rows.push({ t, marks: marks.map((mark) => mark && { ...mark.place }) });
      } else rows.push({ t, marks: marks.map((mark) => mark && seen(from, sample, mark)) });
      sample.close();
      if (stopped) return { rows: null };
      if (performance.now() - told < OFTEN) continue;
      told = performance.now();
      page.postMessage({ id, part: (t - time) / (from.facts.end - time) });
      await new Promise((resolve) => setTimeout(resolve)); // hears “stop”
    }
    return { rows };
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
    stopped = false;
    const found = await WAYS[asked.do]?.(asked);
    const picture = found?.picture;
    page.postMessage({ id: asked.id, done: true, ...found }, picture ? [picture] : []);
  } catch (error) {
    const { code = "broken", detail = String(error) } = /** @type {Refused} */ (error);
    page.postMessage({ id: asked.id, done: true, refused: { code, detail } });
  }
}

page.onmessage = (/** @type {MessageEvent} */ { data }) => {
  if (data.do === "stop") stopped = true;
  else last = last.then(() => answer(data));
};
