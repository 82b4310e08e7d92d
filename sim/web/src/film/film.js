/**
 * A film, frame by frame, each with the time that its file says: the distance of two frames is not taken for
 * equal, since phones let it vary. Runs in the worker. Nothing is read but the file that was chosen.
 */

import {
  BlobSource,
  Input,
  MATROSKA,
  MP4,
  QTFF,
  UnsupportedInputFormatError,
  VideoSampleSink,
  WEBM,
} from "mediabunny";

import { clamp } from "./clamp.js";

/** @typedef {import("./patch.js").Box} Box */
/** @typedef {{width: number, height: number, begin: number, end: number}} Facts pixels; times in s */

const AHEAD = 1; // s; so far a film is played on to a frame, else it is looked for anew

const TINY = 1e-6; // s; files count in no smaller parts

/** Why a film cannot be opened; the page has the words. */
export class Refused extends Error {
  /** @param {string} code @param {string} detail */
  constructor(code, detail = "") {
    super(code);
    this.code = code;
    this.detail = detail;
  }
}

/** @typedef {import("mediabunny").VideoSample} Sample */

export class Film {
  /** @type {AsyncGenerator<Sample, void, unknown> | null} */
  #run = null;
  /** @type {Sample | null} */
  #shown = null;
  /** @type {Sample | null} */
  #next = null;

  /** @param {VideoSampleSink} sink @param {Facts} facts */
  constructor(sink, facts) {
    this.sink = sink;
    this.facts = facts;
    this.canvas = new OffscreenCanvas(1, 1);
    this.pen = pen(this.canvas);
  }

  /** @param {Blob} file @returns {Promise<Film>} raises Refused */
  static async open(file) {
    if (typeof VideoDecoder !== "function" || typeof OffscreenCanvas !== "function") {
      throw new Refused(isSecureContext ? "no-decoder" : "not-secure");
    }
    const track = await trackOf(file);
    const width = await track.getDisplayWidth();
    const height = await track.getDisplayHeight();
    const begin = Math.max(0, await track.getFirstTimestamp());
    const end = await track.computeDuration();
    return new Film(new VideoSampleSink(track), { width, height, begin, end });
  }

  /** All frames from this time on; the caller closes each. @param {number} time s */
  from(time) {
    return this.sink.samples(time);
  }

  /** The frame that is shown at this time, or one beside it; it is closed with the next one. @param {number} time s @param {number} step so many after it, or before it @returns {Promise<Sample>} */
  async at(time, step = 0) {
    try {
      let found = await this.#at(time);
      for (let left = Math.abs(step); left; left -= 1) {
        const { timestamp } = found;
        found = await this.#at(step < 0 ? timestamp - TINY : (this.#next?.timestamp ?? timestamp));
      }
      return found;
    } catch (error) {
      await this.#leave().catch(() => {}); // the next frame is looked for anew
      throw error;
    }
  }

  /** @param {number} time s @returns {Promise<Sample>} */
  async #at(time) {
    const asked = clamp(time, this.facts.begin, this.facts.end);
    const near = this.#shown && asked >= this.#shown.timestamp;
    if (!near || asked > Number(this.#shown?.timestamp) + AHEAD) {
      await this.#leave();
      this.#run = this.sink.samples(asked);
    }
    this.#next ??= await this.#step();
    while (this.#next && (!this.#shown || this.#next.timestamp <= asked)) {
      this.#shown?.close();
      this.#shown = this.#next;
      this.#next = await this.#step();
    }
    if (!this.#shown) throw new Refused("broken");
    return this.#shown;
  }

  async #step() {
    const { value } = (await this.#run?.next()) ?? {};
    return value ?? null;
  }

  async #leave() {
    this.#shown?.close();
    this.#next?.close();
    this.#shown = null;
    this.#next = null;
    await this.#run?.return();
  }

  /** The pixels of a piece of a frame, red, green, blue, opaque. @param {Sample} sample @param {Box} box */
  pixels(sample, { left, top, width, height }) {
    if (this.canvas.width < width || this.canvas.height < height) {
      this.canvas.width = Math.max(this.canvas.width, width);
      this.canvas.height = Math.max(this.canvas.height, height);
    }
    sample.draw(this.pen, left, top, width, height, 0, 0, width, height);
    return this.pen.getImageData(0, 0, width, height).data;
  }

  /** The whole frame as a picture for the page. @param {Sample} sample */
  picture(sample) {
    const { width, height } = this.facts;
    const canvas = new OffscreenCanvas(width, height);
    sample.draw(pen(canvas), 0, 0, width, height);
    return canvas.transferToImageBitmap();
  }
}

/** @param {OffscreenCanvas} canvas */
function pen(canvas) {
  const made = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
  if (!made) throw new Refused("no-decoder");
  return made;
}

/** @param {Blob} file */
async function trackOf(file) {
  const input = new Input({ source: new BlobSource(file), formats: [MP4, QTFF, WEBM, MATROSKA] });
  const track = await input.getPrimaryVideoTrack().catch((error) => {
    throw new Refused(error instanceof UnsupportedInputFormatError ? "format" : "broken");
  });
  if (!track) throw new Refused((await input.getTracks()).length ? "no-picture" : "broken");
  if (!(await track.canDecode())) {
    const name = track.codec ?? (await track.getCodecParameterString()) ?? "?";
    throw new Refused("codec", name.toUpperCase());
  }
  return track;
}
