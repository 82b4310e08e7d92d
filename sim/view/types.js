/**
 * Shapes of the data that the page passes around. SI units; + is to the right.
 *
 * @typedef {{name: string, mass: number, position: number, velocity: number, length: number, bumper_length: number}} Body
 * @typedef {{left: string, right: string, length: number | null}} Track
 * @typedef {{pair: string, bodies: [string, string], law: string, restitution: number | null, stiffness: number | null}} Contact
 * @typedef {{t: number, kind: string, bodies: string[], before: Record<string, number>, after: Record<string, number>, impulse: number | null, force: number | null}} RunEvent
 * @typedef {{from: number, until: number, tier: number, solver: string, why: string, packages: string[]}} Phase
 * @typedef {{code: string, message: string}} Warning
 * @typedef {{kind: string, index: number, active: boolean, numbers: Record<string, number>, carts: string[],
 *   between: [string, string] | null, by: string | null}} Effect
 * @typedef {{path: (string | number)[], code: string, message: string, hint: string}} Problem
 * @typedef {ArrayLike<number>} Column
 * @typedef {Record<string, Column>} Columns
 *
 * What a run is made of besides its numbers:
 * @typedef {{ok: boolean, title: string | null, until: number, gravity: number, bodies: Body[], track: Track,
 *   contacts: Contact[], rows: number, columns: string[][], events: RunEvent[], plan: Phase[],
 *   notSimulated: string[], effects: Effect[], warnings: Warning[], problems?: Problem[]}} Header
 *
 * The numbers; two rows at one time are a jump (before, after):
 * @typedef {{t: Column, x: Columns, v: Columns, a: Columns, F: Columns, dF: Columns, E: Columns, events: RunEvent[]}} Trajectory
 * @typedef {{header: Header, trajectory: Trajectory}} Run
 *
 * The lesson's wishes:
 * @typedef {{set: string, label: string, unit: string, per: number, low: number, high: number, step: number, value: number}} Control
 * @typedef {{kind: "arrows" | "curve" | "choice" | "text", ask: string, talk: boolean, pairs: [string, string][], cart: string | null, options: string[]}} PredictSpec
 * @typedef {{id: string, scene: Record<string, unknown>, show: string[], forces: "shown" | "hidden", boxes: "mass" | "alike", slow: "auto" | "never" | "stops",
 *   camera: number, packages: string[], controls: Control[], switches: {set: string, value: boolean}[], predict: PredictSpec | null,
 *   presets: Record<string, Record<string, number | string>>}} Fence
 *
 * The scales and layouts that the generator fixed:
 * @typedef {{kind: string, width: number, height: number, origin: number, scale: number, low: number, high: number, lanes: number,
 *   ranks: number, stagger: number, track: number, rows: number[], beam: number, force: number, velocity: number,
 *   slots: Record<string, number>, tilt: number}} Layout
 * @typedef {{perHeight: number, alike: boolean, tallest: number, force: number, velocity: number,
 *   decimals: Record<string, number>, reach: Record<string, [number, number, number, number]>, layouts: Layout[]}} View
 *
 * A page's facts about one scene:
 * @typedef {{fence: Fence, view: View, run: Run}} Baked
 */
export {};
