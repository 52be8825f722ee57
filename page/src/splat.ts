/** Particles into the pixels of a canvas: a disc each, by rows of precomputed widths. */
import {
  flagAtRest,
  flagPresent,
  placeX,
  placeZ,
  pressure,
  speed,
  viscosity,
  type Frame,
  type RecordingHeader,
} from './recording';
import { moveColor, packed, restColor, viridis } from './colors';

export type Quantity = 'speed' | 'pressure' | 'viscosity' | 'rest';

/** Colours by count, and what their ends mean. */
export interface ColorScale {
  table: Uint32Array;
  /** Count of the first colour, and counts from one colour to the next. */
  first: number;
  step: number;
  least: number;
  greatest: number;
}

const colors = 256;

function table(): Uint32Array {
  return Uint32Array.from({ length: colors }, (_, k) => packed(...viridis(k / (colors - 1))));
}

/** The scale of a quantity: fixed for a recording, so that colours mean the same in every frame. */
export function colorScale(header: RecordingHeader, what: Quantity): ColorScale {
  const { steps, scene } = header;
  if (what === 'pressure') {
    const greatest = 2 * scene.density_kg_m3 * scene.gravity_m_s2 * scene.reservoir.height_m;
    const count = greatest / steps.pressure_pa;
    return { table: table(), first: 32768, step: count / colors, least: 0, greatest };
  }
  if (what === 'viscosity') {
    const count = (value: number): number =>
      Math.log(value / steps.least_viscosity_pa_s) / Math.log(steps.viscosity_ratio);
    const [least, greatest] = [1, 1000];
    return { table: table(), first: count(least), step: (count(greatest) - count(least)) / colors, least, greatest };
  }
  const fall = Math.sqrt(2 * scene.gravity_m_s2 * scene.reservoir.height_m);
  const greatest = 1.2 * fall; // fronts run about as fast as a fall from there
  return { table: table(), first: 0, step: greatest / steps.speed_m_s / colors, least: 0, greatest };
}

/** From counts to pixels: px = x0 + xx cx + xz cz, and y likewise. */
export interface Placement {
  x0: number;
  xx: number;
  xz: number;
  y0: number;
  yx: number;
  yz: number;
  radius: number;
}

/** Half widths of the rows of a disc. */
export function discRows(radius: number): Int32Array {
  const r = Math.max(0.5, radius);
  const reach = Math.floor(r);
  return Int32Array.from({ length: 2 * reach + 1 }, (_, k) => Math.floor(Math.sqrt(r * r - (k - reach) ** 2)));
}

export function splat(
  pixels: Uint32Array,
  width: number,
  height: number,
  frame: Frame,
  particles: number,
  place: Placement,
  what: Quantity,
  scale: ColorScale,
): void {
  const { codes, flags } = frame;
  const field = (what === 'pressure' ? pressure : what === 'viscosity' ? viscosity : speed) * particles;
  const atX = placeX * particles;
  const atZ = placeZ * particles;
  const rows = discRows(place.radius);
  const reach = (rows.length - 1) / 2;
  const resting = packed(...restColor);
  const moving = packed(...moveColor);
  const perColor = 1 / scale.step;
  for (let i = 0; i < particles; ++i) {
    const flag = flags[i]!;
    if ((flag & flagPresent) === 0) continue;
    const cx = codes[atX + i]!;
    const cz = codes[atZ + i]!;
    const px = Math.round(place.x0 + place.xx * cx + place.xz * cz);
    const py = Math.round(place.y0 + place.yx * cx + place.yz * cz);
    if (px + reach < 0 || px - reach >= width || py + reach < 0 || py - reach >= height) continue;
    let color: number;
    if (what === 'rest') {
      color = (flag & flagAtRest) !== 0 ? resting : moving;
    } else {
      const at = (codes[field + i]! - scale.first) * perColor;
      color = scale.table[at <= 0 ? 0 : at >= colors ? colors - 1 : at | 0]!;
    }
    const top = py - reach < 0 ? reach - py : 0;
    const bottom = py + reach >= height ? height - 1 - py + reach : 2 * reach;
    for (let row = top; row <= bottom; ++row) {
      const half = rows[row]!;
      const left = px - half < 0 ? 0 : px - half;
      const right = px + half >= width ? width - 1 : px + half;
      const start = (py - reach + row) * width;
      pixels.fill(color, start + left, start + right + 1);
    }
  }
}
