/** A recorded flow: docs/recordings.md describes the file. */
import type { Scene } from './data';
import { inflate } from './series';

export interface RecordingHeader {
  name: string;
  spacing_m: number;
  particles: number;
  times_s: number[];
  chunk_bytes: number[];
  frames_per_chunk: number;
  reach_m: [number, number, number, number];
  scene: Scene;
  steps: {
    length_m: number;
    origin_m: number;
    speed_m_s: number;
    pressure_pa: number;
    viscosity_ratio: number;
    least_viscosity_pa_s: number;
    rest_speed_m_s: number;
  };
}

/** Fields in the order in which they are stored. */
export const placeX = 0;
export const placeZ = 1;
export const speed = 2;
export const pressure = 3;
export const viscosity = 4;
const fields = 5;

export const flagPresent = 1;
export const flagAtRest = 2;

/** Counts of one frame, a view into its chunk. */
export interface Frame {
  codes: Uint16Array; // [field][particle]
  flags: Uint8Array; // [particle]
}

const magic = 'PARAPET\n';
const chunksKept = 6;

/** The event that was recorded, of a design with several: its recording is called "0020 event_2". */
export function eventOf(recorded: string, name: string): string {
  const id = name.slice(name.lastIndexOf('/') + 1);
  return recorded.startsWith(`${id} `) ? recorded.slice(id.length + 1) : '';
}

export class Recording {
  readonly header: RecordingHeader;
  private readonly starts: number[] = [];
  private readonly chunks = new Map<number, Promise<Uint8Array>>();
  private readonly decoded = new Map<number, { codes: Uint16Array; flags: Uint8Array }>();

  constructor(private readonly bytes: Uint8Array) {
    const head = new TextDecoder().decode(bytes.subarray(0, magic.length));
    if (head !== magic) throw new Error('this is no recording');
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const size = view.getUint32(magic.length, true);
    let start = magic.length + 4 + size;
    this.header = JSON.parse(
      new TextDecoder().decode(bytes.subarray(magic.length + 4, start)),
    ) as RecordingHeader;
    for (const length of this.header.chunk_bytes) {
      this.starts.push(start);
      start += length;
    }
    if (start !== bytes.length) throw new Error('the recording is damaged');
  }

  get frames(): number {
    return this.header.times_s.length;
  }

  /** Time of the last frame [s]. */
  get end(): number {
    return this.header.times_s[this.frames - 1] ?? 0;
  }

  /** The last frame that is not later than a time. */
  frameAt(time: number): number {
    const times = this.header.times_s;
    let low = 0;
    let high = times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle]! <= time + 1e-9) low = middle + 1;
      else high = middle;
    }
    return Math.max(0, low - 1);
  }

  async frame(index: number): Promise<Frame> {
    const chunk = Math.floor(index / this.header.frames_per_chunk);
    const now = this.frameNow(index);
    if (now) {
      if (chunk + 1 < this.starts.length) void this.inflated(chunk + 1); // the next one meanwhile
      return now;
    }
    const raw = await this.inflated(chunk);
    if (!this.decoded.has(chunk)) this.keep(chunk, this.decode(raw, chunk));
    return this.frameNow(index)!;
  }

  /** The frame if its chunk is decoded already. */
  frameNow(index: number): Frame | null {
    const { particles, frames_per_chunk } = this.header;
    const chunk = Math.floor(index / frames_per_chunk);
    const found = this.decoded.get(chunk);
    if (!found) return null;
    const place = index - chunk * frames_per_chunk;
    const size = fields * particles;
    return {
      codes: found.codes.subarray(place * size, (place + 1) * size),
      flags: found.flags.subarray(place * particles, (place + 1) * particles),
    };
  }

  private inflated(chunk: number): Promise<Uint8Array> {
    let promise = this.chunks.get(chunk);
    if (!promise) {
      const start = this.starts[chunk]!;
      promise = inflate(this.bytes.subarray(start, start + this.header.chunk_bytes[chunk]!));
      this.chunks.set(chunk, promise);
      if (this.chunks.size > 2) this.chunks.delete(this.chunks.keys().next().value!);
    }
    return promise;
  }

  private keep(chunk: number, value: { codes: Uint16Array; flags: Uint8Array }): void {
    this.decoded.set(chunk, value);
    if (this.decoded.size > chunksKept) this.decoded.delete(this.decoded.keys().next().value!);
  }

  private decode(raw: Uint8Array, chunk: number): { codes: Uint16Array; flags: Uint8Array } {
    const n = this.header.particles;
    const first = chunk * this.header.frames_per_chunk;
    const frames = Math.min(this.header.frames_per_chunk, this.frames - first);
    const plane = frames * n;
    if (raw.length !== (2 * fields + 1) * plane) throw new Error('the recording is damaged');
    const codes = new Uint16Array(fields * plane);
    for (let frame = 0; frame < frames; ++frame) {
      for (let field = 0; field < fields; ++field) {
        const low = 2 * field * plane + frame * n;
        const high = low + plane;
        const here = (frame * fields + field) * n;
        const last = here - fields * n;
        const before = last - fields * n;
        const moves = field === placeX || field === placeZ;
        for (let i = 0; i < n; ++i) {
          const word = raw[low + i]! | (raw[high + i]! << 8);
          const difference = (word >> 1) ^ -(word & 1);
          let expected: number;
          if (frame === 0) expected = i === 0 ? 0 : codes[here + i - 1]!;
          else if (frame === 1 || !moves) expected = codes[last + i]!;
          else expected = 2 * codes[last + i]! - codes[before + i]!;
          codes[here + i] = expected + difference; // modulo 2^16
        }
      }
    }
    return { codes, flags: raw.subarray(2 * fields * plane) };
  }
}
