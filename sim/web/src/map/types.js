/**
 * What the generator wrote about a map, and what Python answers. SI units but where it says “shown”.
 *
 * @typedef {{set: string, label: string, unit: string, per: number, low: number, high: number,
 *   decimals: number, values: number[]}} Axis low, high: shown
 * @typedef {{low: number, step: number, count: number, colours: number[][], none: number[],
 *   zero: number, line: number[]}} Scale zero: bands below zero
 * @typedef {{map: Record<string, unknown>, of: string | null, packages: string[], label: string, unit: string,
 *   decimals: number, axes: Axis[], here: number[], at: number | null, controls: import("../../../view/types.js").Control[],
 *   scale: Scale, value: import("../../../view/scales.js").Axis, plot: [number, number, number, number],
 *   size: [number, number]}} MapFacts
 * @typedef {{axes: number[][], rows: number, columns: number, values: Float64Array, why: string}} Grid
 */
export {};
