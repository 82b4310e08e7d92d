/** Every sentence of “How is this computed?”. */

import { counted, ended, inRow, told, tr } from "../../../../view/language.js";
import { fixed, short } from "../../../../view/numbers.js";
import { capital } from "../../../../view/words.js";

/** @typedef {{cost: {solution: number, points: number}}} Cost seconds */
/**
 * @typedef {{method: string, step: number | null, rtol: number | null, steps: number, evaluations: number, blown: number | null, whole: boolean,
 *   seconds: {stepped: number, exact: number}, error: {v: number | null, x: number | null},
 *   energy: {made: number | null, initial: number}}} Compared see `sim/bridge/how_answer.py`
 */

export const LOCKED = tr(
  "Make your prediction and lock it first. Then you can see how the run is computed.",
);
export const UNWATCHED = tr("Watch the run to its end first: this tells what happens in it.");
export const PLAN = tr("The plan, found before anything moves:");
export const MEASURING = tr("Measuring on this computer …");
export const NO_PYTHON = tr("Python does not run here, so nothing can be measured.");
export const SWITCH = tr(
  "What if a program went step by step? The run then plays as that method computes it. Dashed: exact.",
);
export const LOADING = tr("Python’s scipy is being loaded …");
export const METHOD = tr("method");
export const STEP = tr("step");
export const TOLERANCE = tr("tolerance");
export const EXACT = tr("exact (as always)");
export const FAILED = tr("The exact run is shown.");

/** @type {Record<string, string>} */
export const METHODS = {
  euler: "Euler",
  "semi-implicit": tr("semi-implicit Euler"),
  verlet: tr("velocity Verlet"),
  rk4: "RK4",
  "rk4-events": tr("RK4 + located touches"),
  rk45: tr("adaptive RK45 + located touches"),
  adaptive: tr("adaptive DOP853 + located touches"),
};

/** @type {Record<string, string>} what each solver of the plan is for */
const SOLVERS = {
  "free-flight": tr("free flight, exact"),
  flight: tr("flight with forces, exact"),
  "pair-contact": tr("one contact at a time, exact"),
  "power-series": tr("several forces at once, exact to rounding"),
  adaptive: tr("no formula: an adaptive method with located touches"),
};

/** @type {Record<string, string>} */
const USED = {
  "free-flight": tr("free flights"),
  flight: tr("flights"),
  "pair-contact": tr("contacts"),
  "pair-phase": tr("contacts with other forces"),
  "power-series": tr("series for several forces"),
  modes: tr("sums of swings"),
  adaptive: tr("steps of an adaptive method"),
  instant: tr("impacts"),
};

/** @param {import("../../../../view/types.js").Phase} phase @param {number} decimals @returns {[string, string, string]} when, how, why */
export function phaseWords({ from, until, solver, why }, decimals) {
  const times = tr("{from} to {until} s", {
    from: fixed(from, decimals),
    until: fixed(until, decimals),
  });
  const sentence = ended(capital(told(why)));
  return [times, SOLVERS[solver] ?? solver, sentence];
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
  return used.length ? tr("Formulas worked out, {counts}.", { counts: inRow(used) }) : "";
}

/** @param {Cost} answer @returns {string} */
export function costWords({ cost }) {
  const all = cost.solution + cost.points;
  return tr(
    "On this computer, just now: {all}, of which {motion} for the motion and {points} for the points of the curves.",
    { all: duration(all), motion: duration(cost.solution), points: duration(cost.points) },
  );
}

/** @param {Compared} how @returns {string} the length of a step, or the tolerance */
function sizeWords({ step, rtol, steps }) {
  if (rtol) return tr("tolerance {size}", { size: toleranceWords(rtol) });
  return counted("1 step of {step}", "{n} steps of {step}", Number(steps), {
    step: duration(Number(step)),
  });
}

/** @param {number} until in s @param {number} parts @returns {string} beside the slider */
export function stepWords(until, parts) {
  return tr("{step} (run / {parts})", { step: duration(until / parts), parts });
}

/** @param {number} rtol */
export function toleranceWords(rtol) {
  return `1e${Math.round(Math.log10(rtol))}`;
}

/** @param {Compared} how @returns {string} beside the carts */
export function signWords(how) {
  return tr("Step by step: {method}, {size}. Not exact. Dashed: exact.", {
    method: String(METHODS[how.method]),
    size: sizeWords(how),
  });
}

const BEYOND = tr("beyond all numbers");
const UNKNOWN = tr("not known: the exact run was stopped before");
const MANY = 10; // times the energy at the start: percents say no more

/** @param {Compared} how @returns {[string, string][]} what is told of a stepped run */
export function comparedWords(how) {
  const { error, energy, seconds, evaluations, blown, whole } = how;
  /** @type {[string, string][]} */
  const rows = [
    [tr("largest error of a velocity at the end"), whole ? amount(error.v, "m/s") : UNKNOWN],
    [tr("largest error of a position at the end"), whole ? amount(error.x, "m") : UNKNOWN],
    [tr("energy made from nothing"), made(energy)],
    [tr("times that all forces were computed"), String(evaluations)],
    [tr("time on this computer"), ratioWords(seconds)],
  ];
  if (blown !== null) {
    const until = tr("at {time} s; drawn up to there", { time: fixed(blown, 2) });
    rows.unshift([tr("the numbers blow up"), until]);
  }
  return rows;
}

/** @param {number | null} value @param {string} unit */
function amount(value, unit) {
  return value === null ? BEYOND : `${short(value, 2)} ${unit}`;
}

/** @param {Compared["energy"]} energy */
function made({ made: joules, initial }) {
  if (joules === null) return BEYOND;
  if (!(initial > 0)) return `${short(joules, 2)} J`;
  const part = joules / initial;
  const size = {
    energy: `${short(joules, 2)} J`,
    part: short(part, 2),
    percent: short(100 * part, 2),
  };
  return Math.abs(part) < MANY
    ? tr("{energy}, {percent} % of the energy at the start", size)
    : tr("{energy}, {part} times the energy at the start", size);
}

/** @param {Compared["seconds"]} seconds */
function ratioWords({ stepped, exact }) {
  const ratio = stepped / exact;
  const both = { stepped: duration(stepped), exact: duration(exact) };
  return ratio >= 1
    ? tr("{stepped}, {ratio} times the exact run’s {exact}", { ...both, ratio: short(ratio, 2) })
    : tr("{stepped}; the exact run takes {ratio} times as long, {exact}", {
        ...both,
        ratio: short(1 / ratio, 2),
      });
}
