/** How far bumpers and walls give way, so that bodies that overlap are drawn touching. */

/** @typedef {{half: number, bumper: number}} Sprung half of a cart with its bumpers, and one bumper; in units of the picture */
/** @typedef {{left: number | null, right: number | null}} Faces x of the walls in units; null where the track is open */

/**
 * Two carts share the overlap; a bumper gives way by its own length at most, and a wall by the rest.
 * @param {Sprung[]} carts @param {number[]} centres of the carts in units @param {Faces} faces
 * @returns {{left: number[], right: number[], dents: {left: number, right: number}}} of each cart's bumpers and of the walls, in units
 */
export function squeezes(carts, centres, faces) {
  const left = carts.map(() => 0);
  const right = carts.map(() => 0);
  const dents = { left: 0, right: 0 };
  for (let gap = 0; gap <= carts.length; gap += 1) {
    const [a, b] = [carts[gap - 1], carts[gap]];
    const end = a ? Number(centres[gap - 1]) + a.half : faces.left;
    const start = b ? Number(centres[gap]) - b.half : faces.right;
    if (end === null || start === null) continue;
    const overlap = Math.max(0, end - start);
    const share = Math.min(a?.bumper ?? 0, b ? overlap / 2 : overlap);
    const rest = Math.min(b?.bumper ?? 0, overlap - share);
    if (b) left[gap] = rest;
    if (a) right[gap - 1] = Math.min(a.bumper, overlap - rest);
    if (!a) dents.left = overlap - rest;
    if (!b) dents.right = overlap - share;
  }
  return { left, right, dents };
}
