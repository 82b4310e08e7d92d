/**
 * Follows one finger or mouse until it lets go, and no button but the first: a menu that another one opens
 * swallows the end. What it took hold of may be drawn anew at every step: the window is what stays.
 * @param {PointerEvent} down @param {(pixels: number, event: PointerEvent) => void} moved how far to the right it is from where it began
 * @returns {boolean} whether it is followed
 */
export function followPointer(down, moved) {
  if (down.button > 0) return false;
  const leaving = new AbortController();
  const { signal } = leaving;
  const follow = (/** @type {PointerEvent} */ now) => {
    if (now.pointerId !== down.pointerId) return;
    if (now.buttons & 1) moved(now.clientX - down.clientX, now);
    else leaving.abort();
  };
  addEventListener("pointermove", follow, { signal });
  addEventListener("pointerup", follow, { signal });
  addEventListener("pointercancel", follow, { signal });
  return true;
}

const FAR = 8; // px: no tap any more

/**
 * Where a reader points: a mouse at once and as long as it is held; a finger or pen when it has tapped, or goes
 * sideways. One that scrolls the page points at nothing.
 * @param {SVGElement} place @param {(event: MouseEvent) => void} point
 */
export function onPointed(place, point) {
  place.addEventListener("click", point);
  place.addEventListener("pointerdown", (down) => {
    let points = down.pointerType === "mouse";
    const moved = (/** @type {number} */ pixels, /** @type {PointerEvent} */ now) => {
      points ||= Math.abs(pixels) > Math.max(FAR, Math.abs(now.clientY - down.clientY));
      if (points) point(now);
    };
    if (followPointer(down, moved)) moved(0, down);
  });
}
