/** The scene that a map is of runs with the point that the reader has chosen. */

/**
 * @param {string} id of the scene @param {Record<string, number | string>} values by path
 * @param {(message: string) => void} tell what went wrong; empty: nothing
 */
export async function runPoint(id, values, tell) {
  const scene = /** @type {any} */ (document.getElementById(id));
  if (typeof scene?.set !== "function") return;
  try {
    tell("");
    await scene.set(values);
    scene.time = 0;
    scene.scrollIntoView({ block: "start" });
    scene.querySelector(".carts-play")?.focus({ preventScroll: true });
  } catch (error) {
    tell(/** @type {Error} */ (error).message);
  }
}
