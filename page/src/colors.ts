/** Colours that colour-blind readers can tell apart. */

/** Viridis (van der Walt and Smith 2015), every sixteenth colour; perceptually uniform. */
const viridisStops = [
  0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e, 0x1f988b, 0x22a884,
  0x35b779, 0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725,
];

/** The palette of Okabe and Ito (2008), darkened where white paper asks for it. */
export const palette = ['#0072b2', '#d55e00', '#009e73', '#aa4499', '#b8860b', '#56a0d0', '#5b5b5b'];

export function viridis(share: number): [number, number, number] {
  const at = Math.min(1, Math.max(0, share)) * (viridisStops.length - 1);
  const low = Math.min(viridisStops.length - 2, Math.floor(at));
  const t = at - low;
  const a = viridisStops[low]!;
  const b = viridisStops[low + 1]!;
  const mix = (shift: number): number =>
    Math.round(((a >> shift) & 255) * (1 - t) + ((b >> shift) & 255) * t);
  return [mix(16), mix(8), mix(0)];
}

export function viridisText(share: number): string {
  const [r, g, b] = viridis(share);
  return `rgb(${r},${g},${b})`;
}

/** A colour as ImageData holds it, on little-endian machines (all browsers of today). */
export function packed(r: number, g: number, b: number): number {
  return ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
}

export const restColor: [number, number, number] = [0xd5, 0x5e, 0x00];
export const moveColor: [number, number, number] = [0x56, 0xa0, 0xd0];
