/**
 * Follows one finger or mouse until it lets go. What it took hold of may be drawn anew at every step: the
 * window is what stays.
 * @param {PointerEvent} down @param {(pixels: number) => void} moved how far to the right it is from where it began
 */
export function followPointer(down, moved) {
  const leaving = new AbortController();
  const { signal } = leaving;
  addEventListener(
    "pointermove",
    (move) => {
      if (move.pointerId === down.pointerId) moved(move.clientX - down.clientX);
    },
    { signal },
  );
  for (const end of ["pointerup", "pointercancel"]) {
    const letGo = (/** @type {any} */ up) => up.pointerId === down.pointerId && leaving.abort();
    addEventListener(end, letGo, { signal });
  }
}
