/** From the channel (x along the bed, z normal to it) to the world (X to the right, Y upwards). */
import type { Scene } from './data';

export type Point = [number, number];

export function toWorld(slopeDeg: number): (x: number, z: number) => Point {
  const s = (slopeDeg * Math.PI) / 180;
  const c = Math.cos(s);
  const n = Math.sin(s);
  return (x, z) => [x * c + z * n, -x * n + z * c];
}

export interface Box {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

export function boxOf(points: Point[]): Box {
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const [x, y] of points) {
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.bottom = Math.min(box.bottom, y);
    box.top = Math.max(box.top, y);
  }
  return box;
}

/** Corners of a barrier: foot, crest, and with a deflector its tip (all on the upstream side). */
export function corners(barrier: Scene['barriers'][number]): { foot: Point; crest: Point; tip: Point | null } {
  return {
    foot: barrier.outline[0]!,
    crest: barrier.outline[1]!,
    tip: barrier.deflector ? barrier.outline[2]! : null,
  };
}

/** How far down the channel a drawing should go [m]. */
export function usefulLength(scene: Scene): number {
  const last = Math.max(scene.reservoir.length_m, ...scene.barriers.flatMap((b) => b.outline.map((p) => p[0])));
  const wanted = scene.barriers.length > 0 ? last * 1.25 : scene.monitor_x_m * 1.25;
  return Math.min(scene.domain.length_m, Math.max(wanted, scene.reservoir.length_m * 2));
}
