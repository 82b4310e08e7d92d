/** Films with the camera of this computer, on pages that may use it: what was filmed goes the way of a chosen film. */

import { html } from "../shared/dom.js";
import * as words from "./words.js";

const KINDS = ["video/mp4;codecs=avc1", "video/webm;codecs=vp9", "video/webm"];
const WANTED = { width: { ideal: 1280 }, frameRate: { ideal: 60 }, facingMode: "environment" };
const LONGEST = 60_000; // ms; then it stops by itself

/**
 * @param {Element} before the camera's picture stands after it @param {(file: File) => void} take
 * @param {(text: string) => void} tell why there is no picture
 * @returns {Promise<() => void>} ends it, and nothing was filmed
 */
export async function filmWithCamera(before, take, tell) {
  /** @type {MediaStream | undefined} */
  let stream;
  const close = () => {
    for (const track of stream?.getTracks() ?? []) track.stop();
  };
  const type = KINDS.find((kind) => MediaRecorder.isTypeSupported(kind)) ?? "";
  /** @type {MediaRecorder} */
  let recorder;
  try {
    stream = await navigator.mediaDevices.getUserMedia({ video: WANTED, audio: false });
    recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 12e6 });
  } catch {
    close();
    tell(words.noCamera());
    return () => {};
  }
  const place = html("div", "carts-film");
  const video = /** @type {HTMLVideoElement} */ (html("video", "carts-film-view"));
  Object.assign(video, { srcObject: stream, muted: true, playsInline: true });
  video.setAttribute("aria-label", words.cameraPicture());
  const button = html("button", "carts-button carts-film-stop", words.startFilming());
  place.append(video, button);
  before.after(place);
  void video.play().catch(() => {});
  button.focus();

  /** @type {Blob[]} */
  const parts = [];
  let kept = true;
  const end = () => {
    close();
    place.remove();
  };
  recorder.ondataavailable = ({ data }) => parts.push(data);
  recorder.onstop = () => {
    end();
    if (kept) take(new File(parts, type.includes("mp4") ? "film.mp4" : "film.webm", { type }));
  };
  button.addEventListener("click", () => {
    if (recorder.state === "recording") return recorder.stop();
    recorder.start();
    button.textContent = words.stopFilming();
    setTimeout(() => recorder.state === "recording" && recorder.stop(), LONGEST);
  });
  return () => {
    kept = false;
    if (recorder.state === "recording") recorder.stop();
    end();
  };
}
