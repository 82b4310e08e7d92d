/** Sentences for readers: what happens, and what is in the model. */

import { bodiesOf, body, isWall } from "./bodies.js";
import { pairsApart } from "./effects.js";
import { ended, tr } from "./language.js";
import { figures, fixed, NOISE, speedUnit } from "./numbers.js";

/** @typedef {import("./types.js").RunEvent} RunEvent */
/** @typedef {import("./types.js").Header} Header */
/** @typedef {{decimals: Record<string, number>, scale: number, camera: number, forces: boolean}} Telling */
/** @typedef {Record<string, string>} Laws the law of each pair, by its name such as A-B */

/** @type {Record<string, [string, string, string]>} title, symbol, unit */
export const QUANTITIES = {
  x: [tr("Position"), "x", "m"],
  v: [tr("Velocity"), "v", "m/s"],
  a: [tr("Acceleration"), "a", "m/s²"],
  F: [tr("Contact force"), "F", "N"],
  R: [tr("Resultant force"), "R", "N"],
  p: [tr("Momentum"), "p", "kg m/s"],
  energy: [tr("Kinetic energy"), "E", "J"],
};
export const APART = "apart"; // instead of a law: what acts between the two never lets them touch
const IMPULSE_ONLY = tr("too large and too short to draw: see the impulses under “What happens”");
const JUMP_ONLY = tr("where v jumps, the acceleration is too large and too short to draw");

/** @param {number} velocity @param {number} decimals @param {number} scale of velocities in the scene */
export function motion(velocity, decimals, scale) {
  if (isRest(velocity, scale)) return tr("at rest");
  const [per, unit] = speedUnit(scale);
  const speed = `${fixed(Math.abs(velocity) / per, decimals)}\u00a0${unit}`;
  return velocity > 0
    ? tr("{speed} to the right", { speed })
    : tr("{speed} to the left", { speed });
}

/** @param {Header} header @returns {Laws} */
export function lawsOf(header) {
  const laws = Object.fromEntries(header.contacts.map(({ pair, law }) => [pair, law]));
  for (const bodies of pairsApart(header)) laws[bodies.join("-")] = APART;
  return laws;
}

/** @param {Header} header @returns {Set<string>} pairs of which no body has a bumper */
export function bareOf({ bodies, contacts }) {
  const sprung = bodies.filter((one) => one.bumper_length > 0).map(({ name }) => name);
  const bare = contacts.filter((contact) => !contact.bodies.some((name) => sprung.includes(name)));
  return new Set(bare.map(({ pair }) => pair));
}

/** @param {number} velocity @param {number} scale */
function isRest(velocity, scale) {
  return Math.abs(velocity) < NOISE * scale;
}

/** @param {RunEvent} event @param {Telling} telling @param {Laws} laws @param {Set<string>} bare pairs without bumpers @param {import("./types.js").Track} track @returns {string} what happens at an event */
export function eventSentence(event, telling, laws, bare, track) {
  const { decimals, scale, camera, forces } = telling;
  const names = event.bodies;
  const pair = capital(bodiesOf(names, track));
  const impulse = event.impulse ?? 0;
  const speeds = names
    .filter((name) => !isWall(name) && name in (event.after ?? {}))
    .map((name) => `${name}: ${motion((event.after[name] ?? 0) - camera, decimals.v ?? 2, scale)}`);
  const after = speeds.map(ended).join(" ");
  const size = `${figures(impulse)}\u00a0N\u00a0s`;
  const shown = forces && impulse ? tr("Impulse on each: {size}.", { size }) : "";
  const told = (/** @type {string[]} */ ...sentences) => sentences.filter(Boolean).join(" ");
  switch (event.kind) {
    case "contact": {
      if (impulse && laws[names.join("-")] === "velcro") {
        return told(tr("{pair} hit and stay together.", { pair }), shown, after);
      }
      if (impulse && joined(event, scale)) return told(...hitAndGoOn(event, telling, pair), shown);
      if (impulse) {
        return told(tr("{pair} hit each other and part at once.", { pair }), shown, after);
      }
      const [mover, other] = names[0] === "left" ? [names[1], names[0]] : [names[0], names[1]];
      return tr("{mover} touches {other}.", {
        mover: String(mover),
        other: body(String(other), track),
      });
    }
    case "peak":
      return peakSentence(event, telling, laws, bare, pair);
    case "separate": {
      if (!joined(event, scale)) return told(tr("{pair} separate.", { pair }), shown, after);
      const ended = { pair: bodiesOf(names, track) };
      const rest = isWall(String(names[0])) || isWall(String(names.at(-1)));
      if (rest) {
        const stay = tr("The push between {pair} has ended; they stay together.", ended);
        return told(stay, shown, after);
      }
      return told(pushEnded(event, telling, ended.pair), shown);
    }
    case "stick":
      return told(tr("{pair} stay together.", { pair }), after);
    case "stop":
      return names[1]
        ? tr("{pair} stop: the track holds them.", { pair })
        : tr("{cart} stops: the track holds it.", { cart: pair });
    case "start":
      return names[1]
        ? tr("{pair} start to move.", { pair })
        : tr("{cart} starts to move.", { cart: pair });
    case "release":
      if (impulse || !event.force) {
        return told(tr("The exploder between {pair} releases.", { pair }), shown, after);
      }
      return forces
        ? tr("The spring between {pair} is let go: {force} on each.", {
            pair,
            force: `${fixed(event.force, decimals.F ?? 2)}\u00a0N`,
          })
        : tr("The spring between {pair} is let go.", { pair });
    case "end":
      return tr("End of the run.");
    default:
      return `${event.kind}: ${pair}.`;
  }
}

/**
 * At the greatest force; where a bumper warms by a damper, that is not where it is squeezed the most.
 * @param {RunEvent} event @param {Telling} telling @param {Laws} laws @param {Set<string>} bare @param {string} pair
 */
function peakSentence({ bodies, force: greatest }, { decimals, forces }, laws, bare, pair) {
  const key = bodies.join("-");
  const force = `${fixed(greatest ?? 0, decimals.F ?? 2)}\u00a0N`;
  if (laws[key] === APART) {
    return forces
      ? tr("{pair} are nearest: {force} on each.", { pair, force })
      : tr("{pair} are nearest.", { pair });
  }
  const told = forces && greatest;
  if (laws[key] !== "bumper") {
    return told
      ? tr("{pair} push hardest: {force} on each.", { pair, force })
      : tr("{pair} push hardest.", { pair });
  }
  if (told) {
    return bare.has(key)
      ? tr("{pair}: squeezed the most, {force} on each.", { pair, force })
      : tr("{pair}: bumpers squeezed the most, {force} on each.", { pair, force });
  }
  return bare.has(key)
    ? tr("{pair}: squeezed the most.", { pair })
    : tr("{pair}: bumpers squeezed the most.", { pair });
}

/** Whether both bodies have one velocity after the event; a wall has none. @param {RunEvent} event @param {number} scale */
function joined({ bodies, after }, scale) {
  const [left, right] = bodies.map((name) => (isWall(name) ? 0 : Number(after[name])));
  return isRest(Number(left) - Number(right), scale); // rounding, not motion
}

/** @param {RunEvent} event of two bodies with one velocity @param {Telling} telling @param {string} pair @returns {string[]} */
function hitAndGoOn(event, telling, pair) {
  const how = together(event, telling);
  return how === null
    ? [tr("{pair} hit and stay together, at rest.", { pair })]
    : [tr("{pair} hit and go on together at {velocity}.", { pair, velocity: how })];
}

/** @param {RunEvent} event of two bodies with one velocity @param {Telling} telling @param {string} pair */
function pushEnded(event, telling, pair) {
  const how = together(event, telling);
  return how === null
    ? tr("The push between {pair} has ended; they stay together, at rest.", { pair })
    : tr("The push between {pair} has ended; they go on together at {velocity}.", {
        pair,
        velocity: how,
      });
}

/** @param {RunEvent} event of two bodies with one velocity @param {Telling} telling @returns {string | null} it; null: at rest */
function together({ bodies, after }, { decimals, scale, camera }) {
  const cart = bodies.find((name) => !isWall(name)) ?? "";
  const seen = Number(after[cart]) - camera;
  return isRest(seen, scale) ? null : motion(seen, decimals.v ?? 2, scale);
}

/** @param {import("./exits.js").Exit} exit @param {number} decimals @param {number} scale @returns {string} */
export function exitSentence({ name, side, velocity }, decimals, scale) {
  const [per, unit] = speedUnit(scale);
  const speed = `${fixed(Math.abs(velocity) / per, decimals)}\u00a0${unit}`;
  return side === "right"
    ? tr("{name} leaves the picture on the right, still {speed}.", { name, speed })
    : tr("{name} leaves the picture on the left, still {speed}.", { name, speed });
}

/**
 * What a graph cannot show of a run, or why it is empty; "" where there is nothing to say.
 * @param {string} quantity @param {RunEvent[]} events @param {number} curves that are drawn
 */
export function graphNote(quantity, events, curves) {
  const struck = events.some((event) => event.kind === "contact" && event.impulse);
  if (struck && quantity === "F") return IMPULSE_ONLY;
  if (struck && (quantity === "a" || quantity === "R")) return JUMP_ONLY;
  return quantity === "F" && !curves ? tr("no contact force in this run") : "";
}

/** @param {string} name of a graph or a quantity @returns {string} it within a sentence */
export function lower(name) {
  return name.slice(0, 1).toLowerCase() + name.slice(1);
}

/** @param {string} text */
export function capital(text) {
  return text.slice(0, 1).toUpperCase() + text.slice(1);
}
