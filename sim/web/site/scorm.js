// The page around the lessons in a SCORM 1.2 package: it tells the learning platform that the lessons
// were opened and for how long. Nothing else is told: no answer, no mark.

(() => {
  const MOST_PARENTS = 20;

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
  const status = platform.LMSGetValue("cmi.core.lesson_status");
  if (!status || status === "not attempted" || status === "incomplete") {
    platform.LMSSetValue("cmi.core.lesson_status", "completed");
  }
  platform.LMSCommit("");

  let over = false;
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
