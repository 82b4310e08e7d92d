/**
 * What the bridge answers, see `sim/bridge/measured_answer.py`. SI units.
 *
 * @typedef {import("../language.js").Said} Said
 * @typedef {{t: number[], value: number[]}} Track
 * @typedef {{touch: number, x: number, distance: number, v: [number, number], ratio: number, e: number, duration: number}} Hand
 * @typedef {{t: number[], x: [number[], number[]]}} Curve
 * @typedef {{line: number | null, reason: Said, hint: Said}} Fault
 * @typedef {{parameters: Hand, curve: Curve, residuals: [number[], number[]], spread: number, counted?: number}} Drawn in m; counted: readings, by a fit
 * @typedef {{kind: "length" | "force" | "acceleration", names: [string, string], read: Said[],
 *   assumed: ("time" | "length" | "force")[], chosen?: Units | null, run?: string, runs?: string[], tracks: [Track, Track],
 *   report?: Report, forces?: {t: number[], F: [number[], number[]]}}} Read assumed: no column names their unit; chosen: by the reader or the lesson
 * @typedef {{key: string, name: Said, value: number, low: number, high: number, unit: string, interval: Said, text: Said}} Known
 * @typedef {{kind: string, names: string[], read: Said[], law_words: Said, added: Said, doubt: Said, effect: string, known: Known[],
 *   untold: {key: string, name: Said, reason: Said}[], noise: number, sentences: Said[], scene: Said,
 *   fence: Said, calls_for: string | null, segments?: Segment[], rungs?: Rungs | null}} Report
 * @typedef {{scatter: number, line: Said, taken: Said, rows: {effect: string, changes: number, missed: number, without: number,
 *   verdict: "shown" | "not-shown" | "against", sentence: Said}[]}} Rungs in m
 * @typedef {{from: number, until: number, cart: string, kind: string}} Segment times in s
 * @typedef {{from: number, until: number, cart: string | null, kind: string}} Given by the reader; null: both carts
 * @typedef {{refused: Fault[], source?: number}} Refused
 * @typedef {{length: string, time: string, force: string}} Units an empty one: not chosen yet
 *
 * What the generator wrote:
 * @typedef {{id: string, title: string, name: string, text: string, units: Units | null, offered: Record<keyof Units, string[]>,
 *   law: string, synthetic: boolean, read: Read | null}} Facts
 *
 * What a reader has done here, as it is kept:
 * @typedef {{name: string, texts: string[], cells: string[][], pasted?: string, units: Units, run?: string, from: string, until: string,
 *   law: string, effect: string, distance: string, masses: string[], together?: boolean, segments?: Given[], hand: Hand | null, fitted: "" | "fitted" | "compared"}} Kept
 */
export {};
