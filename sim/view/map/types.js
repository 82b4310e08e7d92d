/**
 * What the generator wrote about a map, and what Python answers. SI units but where it says “shown”.
 *
 * @typedef {{set: string, label: string, unit: string, per: number, low: number, high: number,
 *   values: number[]}} Axis low, high: shown
 * @typedef {{low: number, step: number, count: number, colours: import("./palette.js").Colour[], zero: number}} Scale
 *   `count` bands from `low` upwards; zero: bands below zero
 * @typedef {{map: Record<string, unknown>, of: string | null, packages: string[], label: string, unit: string,
 *   low: number, high: number, axes: Axis[], here: number[], at: number | null, controls: import("../types.js").Control[],
 *   draw?: Drawn}} MapFacts low, high: of the values, whatever the sliders say; draw: for a page that draws it itself
 * @typedef {{id: string, title: string, values: (number | null)[], why: string}} Drawn
 * @typedef {{axes: number[][], rows: number, columns: number, values: Float64Array, why: import("../language.js").Said}} Grid
 */
export {};
