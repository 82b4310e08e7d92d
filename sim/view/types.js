/**
 * Shapes of the data that the page passes around. SI units; + is to the right.
 *
 * @typedef {{name: string, mass: number, position: number, velocity: number, length: number, bumper_length: number}} Body
 * @typedef {{left: string, right: string, length: number | null, left_is?: string, right_is?: string}} Track `left_is`: what stands there instead of a wall
 * @typedef {{pair: string, bodies: [string, string], law: string, restitution: number | null, stiffness: number | null}} Contact
 * @typedef {{t: number, kind: string, bodies: string[], before: Record<string, number>, after: Record<string, number>, impulse: number | null, force: number | null}} RunEvent
 * @typedef {{from: number, until: number, tier: number, solver: string, why: import("./language.js").Said, packages: string[]}} Phase
 * @typedef {{code: string, message: import("./language.js").Said}} Warning
 * @typedef {{kind: string, index: number, active: boolean, numbers: Record<string, number>, carts: string[],
 *   between: [string, string] | null, by: string | null, called?: string, agent?: string}} Effect
 * @typedef {{path: (string | number)[], code: string, message: import("./language.js").Said, hint: import("./language.js").Said}} Problem
 * @typedef {ArrayLike<number>} Column
 * @typedef {Record<string, Column>} Columns
 *
 * What a run is made of besides its numbers:
 * @typedef {{ok: boolean, title: string | null, until: number, gravity: number, bodies: Body[], track: Track,
 *   contacts: Contact[], rows: number, columns: string[][], events: RunEvent[], plan: Phase[],
 *   energy?: {parts: Record<string, {initial: number, final: number}>},
 *   notSimulated: string[], effects: Effect[], warnings: Warning[], problems?: Problem[]}} Header
 *
 * The numbers; two rows at one time are a jump (before, after):
 * @typedef {{t: Column, x: Columns, v: Columns, a: Columns, F: Columns, dF: Columns, E: Columns, on?: Columns, events: RunEvent[]}} Trajectory
 * @typedef {{header: Header, trajectory: Trajectory}} Run
 *
 * The lesson's wishes:
 * @typedef {{set: string, label: string, short: string, unit: string, per: number, low: number, high: number, step: number, value: number}} Control
 * @typedef {{kind: "arrows" | "curve" | "choice" | "text", ask: string, talk: boolean, scale: "relative" | "newtons", quantity: "F" | "v" | "x", sure: boolean, pairs: [string, string][], cart: string | null, options: string[]}} PredictSpec
 * @typedef {{id: string, scene: Record<string, unknown>, show: string[], forces: "shown" | "hidden" | "none", boxes: "mass" | "alike", skins: Record<string, string>, slow: "auto" | "never" | "stops", watch: "first" | "free",
 *   camera: number, packages: string[], controls: Control[], switches: {set: string, label: string, value: boolean}[], opened: string[], predict: PredictSpec | null,
 *   presets: Record<string, Record<string, number | string>>, presetNumbers: Record<string, Record<string, number>>}} Fence
 *
 * The scales and layouts that the generator fixed:
 * @typedef {{kind: string, width: number, height: number, origin: number, scale: number, low: number, high: number, lanes: number,
 *   ranks: number, stagger: number, track: number, rows: number[], beam: number, force: number, velocity: number,
 *   slots: Record<string, number>, tape: number, tilt: number, above: boolean}} Layout
 * @typedef {{perHeight: number, alike: boolean, tallest: number, mayTear: boolean, gives: number, force: number, velocity: number,
 *   decimals: Record<string, number>, reach: Record<string, [number, number, number, number]>, layouts: Layout[]}} View
 *
 * What `sim/effects/<kind>/view.js` says of an effect; whatever it leaves out, the drawing has a plain answer for:
 * `name` in lists of what is left out, `leftOut` below the picture; `row` of its force arrow from above, `side` of a cart where it
 * acts, `agent` it comes from, `around`: who gets the momentum, `earth`: the Earth too; `link`: what a label calls it that acts between two
 * bodies (null: no lasting force), `lasts`: whether this one does, `apart`: never lets them touch; `stored`, `warms`: its parts of the energy ledger; `slope` in rad; `acts` then, and is `seen` (left out: while it acts); `pieces`: what it looks like.
 * @typedef {(name: string, side: "left" | "right") => number} Face drawing coordinate of a side of a body
 * @typedef {(name: string) => number} Centre drawing coordinate of the middle of a cart
 * @typedef {{key: string, cls: string, behind?: boolean, d?: string, text?: string, x?: string, y?: string, anchor?: string}} Piece
 * @typedef {{everyone: boolean, on: string, both: string, agent: string, seen: (text: string) => string}} Said
 * @typedef {{name?: string, leftOut?: string, row?: number, side?: (force: number) => "below" | "above" | "left" | "right" | "middle",
 *   agent?: (effect: Effect) => string, around?: string | ((effect: Effect, agent: string) => string), earth?: boolean,
 *   link?: string | null, lasts?: (effect: Effect) => boolean, apart?: boolean, stored?: string, warms?: (effect: Effect) => string, slope?: (effect: Effect) => number,
 *   forceName?: (on: string, by: string) => string, label?: (told: {on: string, by: string, size: string}) => string,
 *   acts?: (effect: Effect, t: number) => boolean, seen?: (effect: Effect, t: number) => boolean, phrase?: (effect: Effect, said: Said) => string[],
 *   pieces?: (effect: Effect, place: {key: string, header: Header, run: Run, t: number, layout: Layout, face: Face, centre: Centre}) => Piece[],
 *   marks?: (effect: Effect, agent: string, until: number, forces: boolean) => {t: number, sentence: string}[]}} EffectView
 *
 * A page's facts about one scene:
 * @typedef {{fence: Fence, view: View, run: Run}} Baked
 */
export {};
