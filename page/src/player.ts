/** A recorded flow on a canvas: particles, the channel, gauges, the dead zone and the loads. */
import type { Scene } from './data';
import { h } from './dom';
import { boxOf, toWorld, usefulLength, type Box, type Point } from './geometry';
import type { Frame, Recording } from './recording';
import { column, valueAt, type Series } from './series';
import { colorScale, splat, type ColorScale, type Quantity } from './splat';
import { view } from './view';

/** What of the series is drawn over the particles. */
interface Loads {
  foot: Point;
  crest: Point;
  x: Float32Array;
  z: Float32Array;
}

/** The forces of the barriers, by the names of their columns. */
function loadsOf(scene: Scene, series: Series | null): Loads[] {
  if (!series) return [];
  const list: Loads[] = [];
  scene.barriers.forEach((barrier, k) => {
    const x = column(series, `barrier_${k + 1}_force_x_n_per_m`);
    const z = column(series, `barrier_${k + 1}_force_z_n_per_m`);
    if (x && z) list.push({ foot: barrier.outline[0]!, crest: barrier.outline[1]!, x, z });
  });
  return list;
}

export class Player {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  private readonly world: (x: number, z: number) => Point;
  private readonly loads: Loads[];
  private readonly deadZone: Float32Array | null;
  private readonly largestLoad: number;
  private box: Box;
  private readonly whole: Box;
  private what: Quantity = 'speed';
  private scale: ColorScale;
  private time = 0;
  private wanted = -1;
  private image: ImageData | null = null;
  private key = '';
  overlays = true;
  /** Called after a frame was drawn, with what it took [ms]. */
  drawn: ((milliseconds: number) => void) | null = null;

  constructor(
    readonly recording: Recording,
    private readonly series: Series | null,
    label: string,
  ) {
    const { scene, reach_m } = recording.header;
    this.world = toWorld(scene.slope_deg);
    this.loads = loadsOf(scene, series);
    this.deadZone = series && column(series, 'dead_zone_length_m');
    this.largestLoad = Math.max(
      1e-9,
      ...this.loads.map((load) => load.x.reduce((most, x, k) => Math.max(most, Math.hypot(x, load.z[k]!)), 0)),
    );
    this.scale = colorScale(recording.header, this.what);
    const margin = 2 * recording.header.spacing_m;
    const length = Math.min(Math.max(usefulLength(scene), reach_m[2] + margin), scene.domain.length_m);
    const points = [this.world(-margin, 0), this.world(length, 0), this.world(0, scene.reservoir.height_m * 1.05)];
    for (const barrier of scene.barriers) points.push(...barrier.outline.map(([x, z]) => this.world(x, z)));
    this.whole = this.box = boxOf(points);
    this.canvas = h('canvas', { class: 'flow', role: 'img', 'aria-label': label });
    this.element = h('div', { class: 'player' }, this.canvas);
    this.drag();
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
  }

  /** Shows the part of the channel that a saved view shows, and keeps what is shown for the next. */
  remember(key: string): void {
    const box = view.get<number[]>(key, []);
    if (box.length === 4 && box.every(Number.isFinite)) {
      const [left, right, bottom, top] = box as [number, number, number, number];
      if (right > left && top > bottom) this.box = { left, right, bottom, top };
    }
    this.key = key;
  }

  private moved(): void {
    if (this.key) view.set(this.key, [this.box.left, this.box.right, this.box.bottom, this.box.top]);
    this.redraw();
  }

  get quantity(): Quantity {
    return this.what;
  }

  get colors(): ColorScale {
    return this.scale;
  }

  show(what: Quantity): void {
    this.what = what;
    this.scale = colorScale(this.recording.header, what);
    this.redraw();
  }

  set(time: number): void {
    this.time = time;
    this.redraw();
  }

  /** Nearer (factor > 1) or farther, about the middle; 0 shows everything. */
  zoom(factor: number): void {
    if (factor === 0) this.box = this.whole;
    else {
      const { left, right, bottom, top } = this.box;
      const [x, y] = [(left + right) / 2, (bottom + top) / 2];
      this.box = {
        left: x + (left - x) / factor,
        right: x + (right - x) / factor,
        bottom: y + (bottom - y) / factor,
        top: y + (top - y) / factor,
      };
    }
    this.moved();
  }

  /** The view around a barrier. */
  look(barrier: number): void {
    const outline = this.recording.header.scene.barriers[barrier]?.outline;
    if (!outline) return;
    const box = boxOf(outline.map(([x, z]) => this.world(x, z)));
    const size = 2.2 * Math.max(box.right - box.left, box.top - box.bottom);
    const [x, y] = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
    this.box = { left: x - size, right: x + size, bottom: y - size * 0.4, top: y + size * 0.6 };
    this.moved();
  }

  private pan(dx: number, dy: number): void {
    const { scale } = this.fit();
    const [x, y] = [-dx / scale, dy / scale];
    const { left, right, bottom, top } = this.box;
    this.box = { left: left + x, right: right + x, bottom: bottom + y, top: top + y };
    this.moved();
  }

  private drag(): void {
    let from: Point | null = null;
    this.canvas.addEventListener('pointerdown', (event) => {
      from = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (!from) return;
      this.pan(event.clientX - from[0], event.clientY - from[1]);
      from = [event.clientX, event.clientY];
    });
    this.canvas.addEventListener('pointerup', () => (from = null));
    this.canvas.addEventListener('pointercancel', () => (from = null));
  }

  /** Pixels of the style sheet per metre, and where the box's upper left corner lies. */
  private fit(): { scale: number; left: number; top: number; width: number; height: number } {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const pad = 14;
    const { left, right, bottom, top } = this.box;
    const scale = Math.min((width - 2 * pad) / (right - left), (height - 2 * pad) / (top - bottom));
    return {
      scale,
      left: (width - scale * (right - left)) / 2 - scale * left,
      top: (height - scale * (top - bottom)) / 2 + scale * top,
      width,
      height,
    };
  }

  /** Draws the frame of the time, as soon as it is decoded. */
  redraw(): void {
    const index = this.recording.frameAt(this.time);
    this.wanted = index;
    const now = this.recording.frameNow(index);
    if (now) this.draw(now, index);
    else {
      void this.recording.frame(index).then((frame) => {
        if (this.wanted === index) this.draw(frame, index);
      });
    }
  }

  private draw(frame: Frame, index: number): void {
    const fit = this.fit();
    if (fit.width === 0 || fit.height === 0) return;
    const start = performance.now();
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    const width = Math.round(fit.width * ratio);
    const height = Math.round(fit.height * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.image = null;
    }
    const context = this.canvas.getContext('2d')!;
    this.image ??= context.createImageData(width, height);
    const pixels = new Uint32Array(this.image.data.buffer);
    pixels.fill(0xffffffff);
    const { header } = this.recording;
    const { length_m: step, origin_m: origin } = header.steps;
    const s = (header.scene.slope_deg * Math.PI) / 180;
    const scale = fit.scale * ratio;
    const [ox, oy] = this.world(origin, origin);
    splat(
      pixels,
      width,
      height,
      frame,
      header.particles,
      {
        x0: fit.left * ratio + scale * ox,
        xx: scale * step * Math.cos(s),
        xz: scale * step * Math.sin(s),
        y0: fit.top * ratio - scale * oy,
        yx: scale * step * Math.sin(s),
        yz: -scale * step * Math.cos(s),
        radius: 0.72 * header.spacing_m * scale, // no gaps between neighbours on a diagonal
      },
      this.what,
      this.scale,
    );
    context.putImageData(this.image, 0, 0);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.overlay(context, fit, header.times_s[index]!);
    context.setTransform(1, 0, 0, 1, 0, 0);
    this.canvas.dataset['frame'] = String(index);
    this.drawn?.(performance.now() - start);
  }

  private overlay(
    context: CanvasRenderingContext2D,
    fit: ReturnType<Player['fit']>,
    time: number,
  ): void {
    const { scene } = this.recording.header;
    const at = (x: number, z: number): Point => {
      const [X, Y] = this.world(x, z);
      return [fit.left + fit.scale * X, fit.top - fit.scale * Y];
    };
    const line = (points: Point[], close = false): void => {
      context.beginPath();
      points.forEach(([x, y], k) => (k === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
      if (close) context.closePath();
    };
    context.lineWidth = 1.5;
    context.strokeStyle = '#333';
    line([at(0, scene.reservoir.height_m * 1.1), at(0, 0), at(scene.domain.length_m, 0)]);
    context.stroke();
    context.fillStyle = '#555';
    for (const outline of [...scene.barriers.map((b) => b.outline), ...scene.solids]) {
      line(outline.map(([x, z]) => at(x, z)), true);
      context.fill();
    }
    context.font = '13px system-ui, sans-serif';
    context.fillStyle = '#111';
    context.textAlign = 'right';
    context.fillText(`${time.toFixed(2)} s`, fit.width - 10, 20);
    context.textAlign = 'left';
    if (!this.overlays) return;
    // Gauges: the lines through the feet of the barriers, or the gauge of an open channel.
    context.setLineDash([4, 4]);
    context.strokeStyle = '#0072b2';
    context.lineWidth = 1;
    const tall = scene.reservoir.height_m;
    const gauges = scene.barriers.length > 0 ? scene.barriers.map((b) => b.foot_x_m) : [scene.monitor_x_m];
    for (const x of gauges) {
      const foot = at(x, 0);
      line([foot, [foot[0], foot[1] - tall * fit.scale]]);
      context.stroke();
    }
    context.setLineDash([]);
    this.drawDeadZone(context, at, time);
    for (const load of this.loads) this.drawLoad(context, fit, at, load, time);
  }

  private drawDeadZone(
    context: CanvasRenderingContext2D,
    at: (x: number, z: number) => Point,
    time: number,
  ): void {
    const { scene, spacing_m } = this.recording.header;
    if (!this.deadZone || !this.series || scene.barriers.length === 0) return;
    const length = valueAt(this.series, this.deadZone, time);
    if (!(length > 0)) return;
    const foot = scene.barriers[0]!.foot_x_m;
    const below = -2 * spacing_m;
    const [a, b] = [at(foot - length, below), at(foot, below)];
    context.strokeStyle = '#d55e00';
    context.lineWidth = 3;
    context.beginPath();
    context.moveTo(a[0], a[1]);
    context.lineTo(b[0], b[1]);
    context.stroke();
    context.fillStyle = '#b34700';
    context.textAlign = 'right';
    context.lineWidth = 3;
    context.strokeStyle = '#fff';
    context.strokeText('dead zone', a[0] - 4, a[1] + 16);
    context.fillText('dead zone', a[0] - 4, a[1] + 16);
    context.textAlign = 'left';
  }

  private drawLoad(
    context: CanvasRenderingContext2D,
    fit: ReturnType<Player['fit']>,
    at: (x: number, z: number) => Point,
    load: Loads,
    time: number,
  ): void {
    const fx = valueAt(this.series!, load.x, time);
    const fz = valueAt(this.series!, load.z, time);
    const size = Math.hypot(fx, fz);
    if (!(size > 0.01 * this.largestLoad)) return;
    const [ux, uy] = this.world(fx / size, fz / size);
    const length = (size / this.largestLoad) * Math.min(120, fit.width / 6);
    const tip = at((load.foot[0] + load.crest[0]) / 2, (load.foot[1] + load.crest[1]) / 2);
    const tail: Point = [tip[0] - ux * length, tip[1] + uy * length];
    context.strokeStyle = context.fillStyle = '#cc0044';
    context.lineWidth = 2.5;
    context.beginPath();
    context.moveTo(tail[0], tail[1]);
    context.lineTo(tip[0], tip[1]);
    context.stroke();
    context.beginPath();
    context.moveTo(tip[0], tip[1]);
    context.lineTo(tip[0] - 9 * ux - 4 * uy, tip[1] + 9 * uy - 4 * ux);
    context.lineTo(tip[0] - 9 * ux + 4 * uy, tip[1] + 9 * uy + 4 * ux);
    context.fill();
    const words = `${size.toFixed(size < 10 ? 1 : 0)} N/m`;
    // Downstream of the barrier, where there is seldom anything else.
    context.lineWidth = 3;
    context.strokeStyle = '#fff';
    context.strokeText(words, tip[0] + 16, tip[1] - 2);
    context.fillText(words, tip[0] + 16, tip[1] - 2);
  }
}
