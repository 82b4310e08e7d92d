/** What we use of mediabunny; its own types name classes of the DOM that TypeScript's do not agree with. */
export interface VideoSample {
  readonly timestamp: number;
  draw(
    pen: OffscreenCanvasRenderingContext2D,
    dx: number,
    dy: number,
    dw: number,
    dh: number,
  ): void;
  draw(
    pen: OffscreenCanvasRenderingContext2D,
    sx: number,
    sy: number,
    sw: number,
    sh: number,
    dx: number,
    dy: number,
    dw: number,
    dh: number,
  ): void;
  close(): void;
}
export interface VideoTrack {
  readonly codec: string | null;
  getDisplayWidth(): Promise<number>;
  getDisplayHeight(): Promise<number>;
  getFirstTimestamp(): Promise<number>;
  computeDuration(): Promise<number>;
  getCodecParameterString(): Promise<string | null>;
  canDecode(): Promise<boolean>;
}
export class BlobSource {
  constructor(blob: Blob);
}
export class Input {
  constructor(options: { source: BlobSource; formats: object[] });
  getPrimaryVideoTrack(): Promise<VideoTrack | null>;
  getTracks(): Promise<object[]>;
}
export class VideoSampleSink {
  constructor(track: VideoTrack);
  samples(start?: number): AsyncGenerator<VideoSample, void, unknown>;
}
export class UnsupportedInputFormatError extends Error {}
export const MATROSKA: object;
export const MP4: object;
export const QTFF: object;
export const WEBM: object;
