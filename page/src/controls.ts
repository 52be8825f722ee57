/** Play, pause, scrub, speed, step, and the keys for them. */
import { speeds, type Clock } from './clock';
import { viridisText } from './colors';
import { button, h, select } from './dom';
import { numberText } from './format';
import type { Player } from './player';
import type { Quantity } from './splat';
import { view } from './view';

const quantities: { value: Quantity; text: string; unit: string }[] = [
  { value: 'speed', text: 'speed', unit: 'm/s' },
  { value: 'pressure', text: 'pressure', unit: 'Pa' },
  { value: 'viscosity', text: 'apparent viscosity', unit: 'Pa s' },
  { value: 'rest', text: 'at rest', unit: '' },
];

/** The colour bar of what the players show. */
function legend(player: Player): HTMLElement {
  const what = quantities.find((one) => one.value === player.quantity)!;
  if (what.value === 'rest') {
    const swatch = (kind: string, words: string): HTMLElement =>
      h('span', { class: 'key' }, h('span', { class: `swatch ${kind}` }), words);
    return h('div', { class: 'legend' }, swatch('resting', 'at rest'), swatch('moving', 'moving'));
  }
  const bar = h('canvas', { class: 'bar', width: 256, height: 1, 'aria-hidden': 'true' });
  const context = bar.getContext('2d')!;
  for (let k = 0; k < 256; ++k) {
    context.fillStyle = viridisText(k / 255);
    context.fillRect(k, 0, 1, 1);
  }
  const { least, greatest } = player.colors;
  const log = what.value === 'viscosity' ? ' (logarithmic)' : '';
  return h(
    'div',
    { class: 'legend' },
    h('span', {}, numberText(least)),
    bar,
    h('span', {}, `${numberText(greatest)} ${what.unit}${log}`),
  );
}

/** The keys that the player knows; also written below it. */
const keys = 'Space plays, arrow keys step, Home and End jump, + and − change the speed.';

export function controls(clock: Clock, players: Player[]): HTMLElement {
  const first = players[0]!;
  const times = first.recording.header.times_s;
  const play = button('Play', () => (clock.playing ? clock.pause() : clock.play()), { class: 'play' });
  const scrub = h('input', {
    type: 'range',
    class: 'scrub',
    min: 0,
    max: clock.end,
    step: 'any',
    value: 0,
    'aria-label': 'Time of the flow in seconds',
    input: () => {
      clock.pause();
      clock.set(Number(scrub.value));
    },
  });
  const output = h('output', { class: 'time' });
  const step = (frames: number): void => {
    clock.pause();
    const at = Math.min(times.length - 1, Math.max(0, first.recording.frameAt(clock.time) + frames));
    clock.set(times[at]!);
  };
  const bar = h('div', {}, legend(first));
  const show = (what: string): void => {
    view.set('play.colour', what);
    players.forEach((player) => player.show(what as Quantity));
    bar.replaceChildren(legend(first));
  };
  const speed = h('select', {
    change: () => {
      view.set('play.speed', Number(speed.value));
      clock.setSpeed(Number(speed.value));
    },
  });
  clock.setSpeed(view.choice('play.speed', speeds, clock.speed));
  const colour = view.choice('play.colour', quantities.map((one) => one.value), first.quantity);
  if (colour !== first.quantity) show(colour);
  for (const one of speeds) speed.append(h('option', { value: one }, `× ${one}`));
  const overlays = h('input', {
    type: 'checkbox',
    checked: view.get('play.overlays', true),
    change: () => {
      view.set('play.overlays', overlays.checked);
      for (const player of players) {
        player.overlays = overlays.checked;
        player.redraw();
      }
    },
  });
  players.forEach((player) => (player.overlays = overlays.checked));
  const state = (): void => {
    play.textContent = clock.playing ? 'Pause' : 'Play';
    scrub.max = String(clock.end);
    speed.value = String(clock.speed);
  };
  const moved = (time: number): void => {
    scrub.value = String(time);
    scrub.setAttribute('aria-valuetext', `${time.toFixed(2)} seconds`);
    view.set('play.time', time);
    output.textContent = `${time.toFixed(2)} of ${clock.end.toFixed(2)} s`;
  };
  clock.watch(moved);
  clock.watchState(state);
  state();
  moved(clock.time);
  const faster = (by: number): void => {
    const at = speeds.indexOf(clock.speed) + by;
    if (speeds[at] !== undefined) clock.setSpeed(speeds[at]!);
  };
  const bindings: Record<string, () => void> = {
    ' ': () => (clock.playing ? clock.pause() : clock.play()),
    ArrowLeft: () => step(-1),
    ArrowRight: () => step(1),
    Home: () => clock.set(0),
    End: () => clock.set(clock.end),
    '+': () => faster(1),
    '-': () => faster(-1),
  };
  const barriers = first.recording.header.scene.barriers.length;
  const views = [
    button('Whole channel', () => players.forEach((player) => player.zoom(0))),
    ...Array.from({ length: barriers }, (_, k) =>
      button(`Barrier ${k + 1}`, () => players.forEach((player) => player.look(k))),
    ),
    button('Nearer', () => players.forEach((player) => player.zoom(1.4))),
    button('Farther', () => players.forEach((player) => player.zoom(1 / 1.4))),
  ];
  const element = h(
    'div',
    { class: 'controls', role: 'group', 'aria-label': 'Playback' },
    h(
      'div',
      { class: 'row' },
      play,
      button('◀ Step back', () => step(-1)),
      button('Step on ▶', () => step(1)),
      scrub,
      output,
    ),
    h(
      'div',
      { class: 'row' },
      h('label', { class: 'field' }, h('span', {}, 'Speed'), speed),
      select('Colour', quantities, first.quantity, show),
      h('label', { class: 'tick' }, overlays, ' gauges, dead zone and loads'),
      ...views,
    ),
    bar,
    h('p', { class: 'note' }, `${keys} Drag a picture to move it.`),
  );
  element.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    const own = target.tagName === 'SELECT' || (target.tagName === 'BUTTON' && event.key === ' ');
    const action = own ? undefined : bindings[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
  return element;
}
