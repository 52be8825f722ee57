import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { flagAtRest, flagPresent, Recording, type RecordingHeader, eventOf } from '../src/recording';

/** Writes a recording as docs/recordings.md says, independently of the program. */
function encode(codes: number[][][], flags: number[][], framesPerChunk: number): Uint8Array {
  const n = flags[0]!.length;
  const chunks: Uint8Array[] = [];
  for (let first = 0; first < codes.length; first += framesPerChunk) {
    const frames = codes.slice(first, first + framesPerChunk);
    const bytes: number[] = [];
    for (let field = 0; field < 5; ++field) {
      const words: number[] = [];
      frames.forEach((frame, k) => {
        for (let i = 0; i < n; ++i) {
          let expected = 0;
          if (k === 0) expected = i === 0 ? 0 : frame[field]![i - 1]!;
          else if (k === 1 || field > 1) expected = frames[k - 1]![field]![i]!;
          else expected = 2 * frames[k - 1]![field]![i]! - frames[k - 2]![field]![i]!;
          const difference = ((frame[field]![i]! - expected) << 16) >> 16;
          words.push(((difference << 1) ^ (difference >> 31)) & 0xffff);
        }
      });
      bytes.push(...words.map((word) => word & 255), ...words.map((word) => word >> 8));
    }
    bytes.push(...flags.slice(first, first + framesPerChunk).flat());
    chunks.push(deflateSync(Uint8Array.from(bytes)));
  }
  const header: Partial<RecordingHeader> = {
    name: 'test',
    particles: n,
    times_s: codes.map((_, k) => 0.02 * k),
    chunk_bytes: chunks.map((chunk) => chunk.length),
    frames_per_chunk: framesPerChunk,
  };
  const text = Buffer.from(JSON.stringify(header));
  const size = Buffer.alloc(4);
  size.writeUInt32LE(text.length);
  return Buffer.concat([Buffer.from('PARAPET\n'), size, text, ...chunks]);
}

function example(frames: number): { codes: number[][][]; flags: number[][] } {
  const codes: number[][][] = [];
  const flags: number[][] = [];
  for (let k = 0; k < frames; ++k) {
    codes.push(
      Array.from({ length: 5 }, (_, field) =>
        Array.from({ length: 7 }, (_, i) => (field === 3 ? 32768 - 40 * i + k : (65000 + 97 * i * (field + 1) + 13 * k * k) % 65536)),
      ),
    );
    flags.push(Array.from({ length: 7 }, (_, i) => (i === 2 && k > 4 ? 0 : flagPresent | (i % 3 === 0 ? flagAtRest : 0))));
  }
  return { codes, flags };
}

test('every frame comes back, in any order', async () => {
  const { codes, flags } = example(37);
  const recording = new Recording(encode(codes, flags, 16));
  assert.equal(recording.frames, 37);
  for (const k of [0, 36, 15, 16, 1, 20, 35]) {
    const frame = await recording.frame(k);
    assert.deepEqual([...frame.codes], codes[k]!.flat(), `frame ${k}`);
    assert.deepEqual([...frame.flags], flags[k]!, `flags of frame ${k}`);
  }
});

test('the frame of a time is the last one that is not later', () => {
  const { codes, flags } = example(20);
  const recording = new Recording(encode(codes, flags, 16));
  assert.equal(recording.frameAt(0), 0);
  assert.equal(recording.frameAt(0.0399), 1);
  assert.equal(recording.frameAt(0.04), 2);
  assert.equal(recording.frameAt(100), 19);
  assert.equal(recording.frameAt(-1), 0);
});

test('damaged bytes are refused', async () => {
  const { codes, flags } = example(3);
  const bytes = encode(codes, flags, 16);
  assert.throws(() => new Recording(bytes.subarray(1)));
  assert.throws(() => new Recording(bytes.subarray(0, bytes.length - 1)));
  const changed = Uint8Array.from(bytes);
  changed[bytes.length - 3]! ^= 255;
  await assert.rejects(new Recording(changed).frame(0));
});

test('a design of several events says which of them was recorded', () => {
  assert.equal(eventOf('0020 event_2', '0020'), 'event_2');
  assert.equal(eventOf('0020 event_2', 'my study/0020'), 'event_2');
  assert.equal(eventOf('0020', '0020'), '');
  assert.equal(eventOf('single barrier', 'single barrier'), '');
});
