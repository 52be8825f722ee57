/** A dimensioned drawing with a title block, to scale: one unit of the drawing is a millimetre on
 *  paper when it is printed 180 mm wide. */
import type { Scene } from './data';
import { svg, type Child } from './dom';
import { boxOf, corners, toWorld, usefulLength, type Box, type Point } from './geometry';

const sheetWidth = 180;
const scales = [0.1, 0.2, 0.25, 0.5, 1, 2, 2.5, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000, 2000, 5000, 10000];

export interface TitleBlock {
  title: string;
  study: string;
  date: string;
  hash: string;
  program: string;
}

/** The first scale 1:n at which a length [m] fits a width [mm]. */
export function scaleFor(length: number, width: number): number {
  return scales.find((n) => (length * 1000) / n <= width) ?? scales[scales.length - 1]!;
}

/** Lengths of a drawing in millimetres, or metres where everything is large. */
function dimensionText(length: number, metres: boolean): string {
  return metres ? `${Number(length.toPrecision(4))} m` : String(Number((length * 1000).toFixed(1)));
}

/** Maps world metres into a view's place on the sheet, y downwards. */
class View {
  constructor(
    private readonly box: Box,
    private readonly scale: number, // 1:n
    private readonly left: number,
    private readonly top: number,
  ) {}

  static height(box: Box, scale: number): number {
    return ((box.top - box.bottom) * 1000) / scale;
  }

  static width(box: Box, scale: number): number {
    return ((box.right - box.left) * 1000) / scale;
  }

  at([x, y]: Point): Point {
    return [
      this.left + ((x - this.box.left) * 1000) / this.scale,
      this.top + ((this.box.top - y) * 1000) / this.scale,
    ];
  }
}

const fixed = (value: number): string => value.toFixed(2);
const path = (points: Point[], closed = false): string =>
  points.map((p, k) => `${k === 0 ? 'M' : 'L'}${fixed(p[0])} ${fixed(p[1])}`).join('') + (closed ? 'Z' : '');

function text(at: Point, words: string, attributes: Record<string, string | number> = {}): SVGElement {
  return svg('text', { x: fixed(at[0]), y: fixed(at[1]), 'font-size': 3.2, ...attributes }, words);
}

/** A dimension line beside a-b, `offset` to its left (seen from a to b), with arrows and its number;
 *  its extension lines begin `gap` away. */
function dimension(a: Point, b: Point, offset: number, words: string, gap = 0): SVGElement {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const [nx, ny] = [uy, -ux]; // to the left on a page whose y points down
  const reach = (p: Point, d: number): Point => [p[0] + nx * d, p[1] + ny * d];
  const sign = Math.sign(offset);
  const [a1, b1] = [reach(a, offset), reach(b, offset)];
  let angle = (Math.atan2(uy, ux) * 180) / Math.PI;
  if (angle > 90.01 || angle <= -90) angle += 180; // never upside down
  const short = length < 9;
  const middle: Point = [(a1[0] + b1[0]) / 2, (a1[1] + b1[1]) / 2];
  const up = angle > 90 || angle < -90 ? -1 : 1;
  const label = reach(middle, sign * (short ? 2.4 : 1.6) * up);
  const arrow = (tip: Point, direction: number): string => {
    const d = short ? -direction : direction;
    const base: Point = [tip[0] + d * ux * 1.8, tip[1] + d * uy * 1.8];
    return path([tip, [base[0] + nx * 0.45, base[1] + ny * 0.45], [base[0] - nx * 0.45, base[1] - ny * 0.45]], true);
  };
  const shaft: Point[] = short
    ? [[a1[0] - ux * 4, a1[1] - uy * 4], [b1[0] + ux * 4, b1[1] + uy * 4]]
    : [a1, b1];
  return svg(
    'g',
    { class: 'dimension' },
    svg('path', { d: path([reach(a, sign * (gap + 0.6)), reach(a, offset + sign * 1)]) + path([reach(b, sign * (gap + 0.6)), reach(b, offset + sign * 1)]) + path(shaft) }),
    svg('path', { class: 'arrow', d: arrow(a1, 1) + arrow(b1, -1) }),
    text(label, words, {
      'text-anchor': 'middle',
      'dominant-baseline': 'middle',
      transform: `rotate(${fixed(angle)} ${fixed(label[0])} ${fixed(label[1])})`,
    }),
  );
}

function outlines(scene: Scene, view: View, world: (x: number, z: number) => Point): Child[] {
  const solid = (corner: [number, number][]): SVGElement =>
    svg('path', { class: 'solid', d: path(corner.map(([x, z]) => view.at(world(x, z))), true) });
  return [...scene.barriers.map((b) => solid(b.outline)), ...scene.solids.map(solid)];
}

/** Bed with the hatching that says ground. */
function bed(view: View, world: (x: number, z: number) => Point, from: number, to: number): SVGElement {
  const a = view.at(world(from, 0));
  const b = view.at(world(to, 0));
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  let marks = path([a, b]);
  for (let d = 2; d < length; d += 3) {
    const p: Point = [a[0] + ((b[0] - a[0]) * d) / length, a[1] + ((b[1] - a[1]) * d) / length];
    marks += path([p, [p[0] - 1.4, p[1] + 1.8]]);
  }
  return svg('path', { class: 'bed', d: marks });
}

/** The slope as a triangle below and left of a corner: above the bed's lower end nothing else is drawn. */
function slopeMark(slopeDeg: number, corner: Point): Child[] {
  const s = (slopeDeg * Math.PI) / 180;
  const [dx, dy] = [12 * Math.cos(s), 12 * Math.sin(s)];
  const start: Point = [corner[0] - dx, corner[1]];
  return [
    svg('path', { class: 'dimension-line', d: path([start, corner, [corner[0], corner[1] + dy]], true) }),
    text([start[0] - 1.5, corner[1] + 1], `${Number(slopeDeg.toFixed(2))}°`, { 'text-anchor': 'end' }),
  ];
}

function overview(scene: Scene, top: number, metres: boolean): { parts: Child[]; height: number; scale: number } {
  const world = toWorld(scene.slope_deg);
  const length = usefulLength(scene);
  const { length_m: rl, height_m: rh } = scene.reservoir;
  const points = [world(0, 0), world(length, 0), world(0, rh * 1.1), world(rl, rh)];
  for (const b of scene.barriers) points.push(...b.outline.map(([x, z]) => world(x, z)));
  const box = boxOf(points);
  // Low enough that the sheet leaves room for the numbers on page one.
  const scale = Math.max(scaleFor(box.right - box.left, sheetWidth - 20), scaleFor(box.top - box.bottom, 50));
  const view = new View(box, scale, (sheetWidth - View.width(box, scale)) / 2, top + 6);
  const at = (x: number, z: number): Point => view.at(world(x, z));
  const wall = at(0, 0);
  const parts: Child[] = [
    bed(view, world, 0, length),
    svg('path', { class: 'bed', d: path([wall, at(0, rh * 1.1)]) }),
    svg('path', { class: 'release', d: path([at(0, 0), at(rl, 0), at(rl, rh), at(0, rh)], true) }),
    ...outlines(scene, view, world),
  ];
  let from: Point = [0, 0];
  for (const barrier of scene.barriers) {
    const { foot } = corners(barrier);
    parts.push(dimension(at(from[0], 0), at(foot[0], 0), -9, dimensionText(foot[0] - from[0], metres)));
    from = foot;
  }
  parts.push(...slopeMark(scene.slope_deg, [at(length, 0)[0], top + 2]));
  // The bed's lower end, or the dimensions where the bed is flat.
  const lowest = Math.max(at(length, 0)[1] + 3, at(from[0], 0)[1] + 12 * Math.cos((scene.slope_deg * Math.PI) / 180));
  return { parts, height: lowest - top, scale };
}

function detail(
  scene: Scene,
  index: number,
  left: number,
  top: number,
  width: number,
  metres: boolean,
): { parts: Child[]; height: number } {
  const world = toWorld(scene.slope_deg);
  const barrier = scene.barriers[index]!;
  const { foot, crest, tip } = corners(barrier);
  const points = barrier.outline.map(([x, z]) => world(x, z));
  const size = Math.max(barrier.height_m, barrier.deflector?.length_m ?? 0);
  points.push(world(foot[0] - 0.35 * size, 0), world(foot[0] + 0.5 * size, 0));
  const box = boxOf(points);
  const scale = Math.max(scaleFor(box.right - box.left, width - 34), scaleFor(box.top - box.bottom, 36));
  const view = new View(box, scale, left + (width - View.width(box, scale)) / 2 + 4, top + 12);
  const at = (p: Point): Point => view.at(world(p[0], p[1]));
  const [f, c] = [at(foot), at(crest)];
  const parts: Child[] = [
    text([left + width / 2, top + 3], `Barrier ${index + 1}, scale ${scaleText(scale)}`, {
      'text-anchor': 'middle',
      class: 'caption',
    }),
    bed(view, world, foot[0] - 0.35 * size, foot[0] + 0.5 * size),
    ...outlines({ ...scene, barriers: [barrier], solids: [] }, view, world),
    dimension(f, c, 7, dimensionText(barrier.height_m, metres)),
  ];
  if (tip && barrier.deflector) {
    const t = at(tip);
    const thick = (barrier.thickness_m * 1000) / scale;
    parts.push(dimension(c, t, -(thick + 6), dimensionText(barrier.deflector.length_m, metres), thick));
    // The deflector points upstream, to the left: its angle is measured from the level line.
    const radius = Math.min(15, Math.hypot(t[0] - c[0], t[1] - c[1]) * 0.8);
    const angle = (barrier.deflector.angle_deg * Math.PI) / 180;
    const level: Point = [c[0] - radius, c[1]];
    const on: Point = [c[0] - radius * Math.cos(angle), c[1] - radius * Math.sin(angle)];
    const sweep = angle > 0 ? 1 : 0;
    parts.push(
      svg('path', {
        class: 'dimension-line',
        d:
          path([c, [c[0] - radius - 4, c[1]]]) +
          `M${fixed(level[0])} ${fixed(level[1])}A${fixed(radius)} ${fixed(radius)} 0 0 ${sweep} ${fixed(on[0])} ${fixed(on[1])}`,
      }),
      text([c[0] - radius - 5, c[1] + 1], `${Number(barrier.deflector.angle_deg.toFixed(1))}°`, {
        'text-anchor': 'end',
      }),
    );
  }
  return { parts, height: View.height(box, scale) + 15 };
}

function scaleText(n: number): string {
  return n >= 1 ? `1:${n}` : `${1 / n}:1`;
}

function titleBlock(block: TitleBlock, top: number, scale: number, metres: boolean): Child[] {
  const rows: [string, string, number][] = [
    ['Drawing', block.title, 0],
    ['Study', block.study, 60],
    ['Date', block.date, 120],
    ['Hash', block.hash, 0],
    ['Program', block.program, 60],
    ['Scale', `${scaleText(scale)} at 180 mm${metres ? '' : '; lengths in mm'}`, 120],
  ];
  const shorten = (words: string): string => (words.length > 34 ? `${words.slice(0, 33)}…` : words);
  return [
    svg('path', {
      class: 'frame',
      d: `M0 ${top}H180V${top + 20}H0ZM60 ${top}V${top + 20}M120 ${top}V${top + 20}M0 ${top + 10}H180`,
    }),
    ...rows.flatMap(([name, words, x], k) => {
      const y = top + (k < 3 ? 0 : 10);
      return [
        text([x + 1.5, y + 3.4], name, { class: 'small', 'font-size': 2.4 }),
        text([x + 1.5, y + 8], shorten(words), { 'font-size': 3 }),
      ];
    }),
  ];
}

/** The sheet of one arrangement. */
export function drawing(scene: Scene, block: TitleBlock): SVGElement {
  const metres = scene.reservoir.height_m >= 2;
  const whole = overview(scene, 2, metres);
  const parts: Child[] = [...whole.parts];
  let top = whole.height + 4;
  const n = Math.min(3, scene.barriers.length);
  let height = 0;
  for (let k = 0; k < n; ++k) {
    const one = detail(scene, k, (k * sheetWidth) / n, top, sheetWidth / n, metres);
    parts.push(...one.parts);
    height = Math.max(height, one.height);
  }
  top += height + 2;
  parts.push(...titleBlock(block, top, whole.scale, metres));
  const total = top + 20;
  const words = scene.barriers
    .map((b, k) => {
      const plate = b.deflector
        ? `, deflector ${dimensionText(b.deflector.length_m, metres)} at ${Number(b.deflector.angle_deg.toFixed(1))} degrees`
        : '';
      return `barrier ${k + 1} at ${dimensionText(b.foot_x_m, metres)} along the bed, ${dimensionText(b.height_m, metres)} high${plate}`;
    })
    .join('; ');
  return svg(
    'svg',
    {
      class: 'drawing',
      viewBox: `-1 -1 ${sheetWidth + 2} ${fixed(total + 2)}`,
      role: 'img',
      'aria-label': `Drawing of ${block.title}: ${words || 'an open channel'}. ${metres ? '' : 'Lengths in millimetres.'}`,
    },
    svg('rect', { class: 'sheet', x: -0.5, y: -0.5, width: sheetWidth + 1, height: fixed(total + 1) }),
    ...parts,
  );
}
