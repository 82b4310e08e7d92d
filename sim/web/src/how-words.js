/** Every sentence of “How is this computed?”. */

import { fixed, short } from "./numbers.js";

/** @typedef {{cost: {solution: number, points: number}}} Cost seconds */
/**
 * @typedef {{method: string, step: number | null, rtol: number | null, steps: number, evaluations: number, blown: number | null, whole: boolean,
 *   seconds: {stepped: number, exact: number}, error: {v: number | null, x: number | null},
 *   energy: {made: number | null, initial: number}}} Compared see `sim/bridge/how_answer.py`
 */

export const LOCKED =
  "Make your prediction and lock it first. Then you can see how the run is computed.";
export const PLAN = "The plan, found before anything moves:";
export const MEASURING = "Measuring on this computer …";
export const NO_PYTHON = "Python does not run here, so nothing can be measured.";
export const SWITCH =
  "What if a program went step by step? The run then plays as that method computes it. Dashed: exact.";
export const LOADING = "Python’s scipy is being loaded …";
export const METHOD = "method";
export const STEP = "step";
export const TOLERANCE = "tolerance";
export const EXACT = "exact (as always)";
export const FAILED = "The exact run is shown.";

/** @type {Record<string, string>} */
export const METHODS = {
  euler: "Euler",
  "semi-implicit": "semi-implicit Euler",
  verlet: "velocity Verlet",
  rk4: "RK4",
  "rk4-events": "RK4 + located touches",
  rk45: "adaptive RK45 + located touches",
  adaptive: "adaptive DOP853 + located touches",
};

/** @type {Record<string, string>} what each solver of the plan is for */
const SOLVERS = {
  "free-flight": "free flight, exact",
  flight: "flight with forces, exact",
  "pair-contact": "one contact at a time, exact",
  "power-series": "several forces at once, exact to rounding",
  adaptive: "no formula: an adaptive method with located touches",
};

/** @type {Record<string, string>} */
const USED = {
  "free-flight": "free flights",
  flight: "flights",
  "pair-contact": "contacts",
  "pair-phase": "contacts with other forces",
  "power-series": "series for several forces",
  adaptive: "steps of an adaptive method",
  instant: "impacts",
};

/** @param {import("./types.js").Phase} phase @param {number} decimals @returns {[string, string, string]} when, how, why */
export function phaseWords({ from, until, solver, why }, decimals) {
  const times = `${fixed(from, decimals)} to ${fixed(until, decimals)} s`;
  return [times, SOLVERS[solver] ?? solver, `${(why[0] ?? "").toUpperCase()}${why.slice(1)}.`];
}

/** @param {number} seconds */
function duration(seconds) {
  if (seconds >= 1) return `${short(seconds, 2)} s`;
  if (seconds >= 1e-3) return `${short(1e3 * seconds, 2)} ms`;
  return `${short(1e6 * seconds, 2)} µs`;
}

/** @param {Record<string, number>} solvers how often each was used @returns {string} */
export function formulasWords(solvers) {
  const used = Object.entries(solvers).map(([name, count]) => `${USED[name] ?? name}: ${count}`);
  return used.length ? `Formulas worked out, ${used.join(", ")}.` : "";
}

/** @param {Cost} answer @returns {string} */
export function costWords({ cost }) {
  const all = cost.solution + cost.points;
  return (
    `On this computer, just now: ${duration(all)}, of which ${duration(cost.solution)} for the motion ` +
    `and ${duration(cost.points)} for the points of the curves.`
  );
}

/** @param {Compared} how @returns {string} the length of a step, or the tolerance */
export function sizeWords({ step, rtol, steps }) {
  if (rtol) return `tolerance 1e${Math.round(Math.log10(rtol))}`;
  return `${steps} steps of ${duration(Number(step))}`;
}

/** @param {number} until in s @param {number} parts @returns {string} beside the slider */
export function stepWords(until, parts) {
  return `${duration(until / parts)} (run / ${parts})`;
}

/** @param {number} rtol */
export function toleranceWords(rtol) {
  return `1e${Math.round(Math.log10(rtol))}`;
}

/** @param {Compared} how @returns {string} beside the carts */
export function signWords(how) {
  return `Step by step: ${METHODS[how.method]}, ${sizeWords(how)}. Not exact. Dashed: exact.`;
}

const BEYOND = "beyond all numbers";
const UNKNOWN = "not known: the exact run was stopped before";
const MANY = 10; // times the energy at the start: percents say no more

/** @param {Compared} how @returns {[string, string][]} what is told of a stepped run */
export function comparedWords(how) {
  const { error, energy, seconds, evaluations, blown, whole } = how;
  /** @type {[string, string][]} */
  const told = [
    ["largest error of a velocity at the end", whole ? amount(error.v, "m/s") : UNKNOWN],
    ["largest error of a position at the end", whole ? amount(error.x, "m") : UNKNOWN],
    ["energy made from nothing", made(energy)],
    ["times that all forces were computed", String(evaluations)],
    ["time on this computer", ratioWords(seconds)],
  ];
  if (blown !== null) {
    told.unshift(["the numbers blow up", `at ${fixed(blown, 2)} s; drawn up to there`]);
  }
  return told;
}

/** @param {number | null} value @param {string} unit */
function amount(value, unit) {
  return value === null ? BEYOND : `${short(value, 2)} ${unit}`;
}

/** @param {Compared["energy"]} energy */
function made({ made: joules, initial }) {
  if (joules === null) return BEYOND;
  if (!initial) return `${short(joules, 2)} J`;
  const part = joules / initial;
  const of = Math.abs(part) < MANY ? `${short(100 * part, 2)} % of` : `${short(part, 2)} times`;
  return `${short(joules, 2)} J, ${of} the energy at the start`;
}

/** @param {Compared["seconds"]} seconds */
function ratioWords({ stepped, exact }) {
  const ratio = stepped / exact;
  if (ratio >= 1)
    return `${duration(stepped)}, ${short(ratio, 2)} times the exact run’s ${duration(exact)}`;
  return `${duration(stepped)}; the exact run takes ${short(1 / ratio, 2)} times as long, ${duration(exact)}`;
}
