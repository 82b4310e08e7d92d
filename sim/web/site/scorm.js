// The page around the lessons in a SCORM 1.2 package: it tells the learning platform that the lessons
// were opened, that something was handed in (a form, or a file of answers saved), and for how long
// they were open. Nothing else is told: no answer, no mark.

(() => {
  const MOST_PARENTS = 20;
  const HANDED_IN = ["carts-handed-in", "carts-file-saved"]; // events of the lessons' own pages

  /** The platform's half, in a window around this one or in the one that opened it. @param {any} from */
  function find(from) {
    let place = from;
    for (let k = 0; k < MOST_PARENTS && place; k += 1) {
      try {
        if (place.API) return place.API;
        if (place === place.parent) return null;
        place = place.parent;
      } catch {
        return null; // another origin
      }
    }
    return null;
  }

  const platform = find(window) ?? find(window.opener);
  if (!platform) return;
  const began = Date.now();
  if (String(platform.LMSInitialize("")) !== "true") return;
  // Else a platform may begin anew at the next visit, and forget what was handed in. Said at once:
  // of what a page says when it goes, some browsers bring nothing to the platform.
  platform.LMSSetValue("cmi.core.exit", "suspend");
  // What a platform or a teacher has set already ("completed", "passed" …) is never taken back.
  const open = ["", "not attempted", "incomplete", "browsed"];
  const begun = () => open.includes(String(platform.LMSGetValue("cmi.core.lesson_status") ?? ""));
  if (begun()) set("incomplete");

  let over = false;
  const lessons = /** @type {HTMLIFrameElement | null} */ (document.querySelector("iframe"));
  lessons?.addEventListener("load", listen);
  listen(); // it may have loaded before this script ran

  /** Every page of the lessons is a document of its own. */
  function listen() {
    for (const name of HANDED_IN) lessons?.contentDocument?.addEventListener(name, completed);
  }

  function completed() {
    if (!over && begun()) set("completed");
  }

  /** @param {string} status */
  function set(status) {
    platform.LMSSetValue("cmi.core.lesson_status", status);
    platform.LMSCommit("");
  }

  addEventListener("pagehide", () => {
    if (over) return;
    over = true;
    platform.LMSSetValue("cmi.core.session_time", duration(Date.now() - began));
    platform.LMSCommit("");
    platform.LMSFinish("");
  });

  /** HHHH:MM:SS, as SCORM 1.2 writes it. @param {number} ms */
  function duration(ms) {
    const seconds = Math.min(Math.floor(ms / 1000), 9999 * 3600);
    const parts = [Math.floor(seconds / 3600), Math.floor(seconds / 60) % 60, seconds % 60];
    return parts.map((part, k) => String(part).padStart(k ? 2 : 4, "0")).join(":");
  }
})();
