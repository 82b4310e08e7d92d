/** The page is not left by mistake while it holds what is nowhere else: nothing of it is kept. */

/** @param {import("./classroom.js").Classroom} classroom @param {AbortSignal} signal */
export function stay(classroom, signal) {
  /** A file that is dropped beside a field: the browser would open it in place of the page. @param {DragEvent} event */
  const drop = (event) => {
    const { defaultPrevented, dataTransfer } = event; // prevented: a field takes it
    if (defaultPrevented || !dataTransfer?.types.includes("Files")) return; // words go into any box
    event.preventDefault();
    dataTransfer.dropEffect = "none";
  };
  addEventListener("dragover", drop, { signal });
  addEventListener("drop", drop, { signal });
  const leave = (/** @type {BeforeUnloadEvent} */ event) => {
    if (!classroom.unsaved) return;
    event.preventDefault();
    event.returnValue = true; // Chrome before 119 asks by this only
  };
  addEventListener("beforeunload", leave, { signal });
}
