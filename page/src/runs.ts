/** Drawings, series and playback of one to four runs side by side. */
import type { Common, Run, StudiesPage } from './data';
import { blockBytes } from './blocks';
import { Clock } from './clock';
import { controls } from './controls';
import { h, type Child } from './dom';
import { drawing } from './drawing';
import { programText, type Keys } from './format';
import { Player } from './player';
import { eventOf, Recording } from './recording';
import { readSeries, type Series } from './series';
import { seriesPanels, type NamedSeries } from './seriesplot';
import { view } from './view';

export function titleBlock(page: Common, title: string): Parameters<typeof drawing>[1] {
  // Of several studies a run is called STUDY/ID, and is drawn with the hash of its own.
  const member = page.kind === 'studies' ? (page as StudiesPage).studies.find((one) => title.startsWith(`${one.label}/`)) : undefined;
  return {
    title: member ? title.slice(member.label.length + 1) : title,
    study: member?.label ?? page.name,
    date: page.date.slice(0, 10),
    hash: member?.hash ?? page.hash,
    program: programText((member ? member.simulated_by : page.simulated_by) ?? page.program),
  };
}

async function seriesOf(run: Run | undefined): Promise<Series | null> {
  const bytes = blockBytes(run?.series);
  return bytes ? readSeries(bytes) : null;
}

/** Says how to make what is not there. */
function missing(run: Run | undefined): Child {
  const command = run?.record_command;
  return h(
    'p',
    { class: 'note missing' },
    'This flow was not recorded. ',
    command ? 'To record it, type ' : null,
    command ? h('code', {}, command) : null,
  );
}

/** Views of the runs, filled in as soon as their data are decoded. */
export function compareRuns(
  page: Common,
  keys: Keys,
  names: readonly string[],
  heading: (name: string) => Child,
  withDrawings: boolean,
): HTMLElement {
  const clock = new Clock();
  const element = h('div', { class: 'compare' });
  const columns = h('div', { class: `columns columns-${Math.min(4, names.length)}` });
  element.append(columns);
  const places = names.map((name) => {
    const run = page.runs[name];
    const place = h('div', { class: 'run' }, h('h3', {}, heading(name)));
    if (withDrawings && run?.scene) place.append(drawing(run.scene, titleBlock(page, name)));
    columns.append(place);
    return place;
  });
  void (async () => {
    const series = await Promise.all(names.map((name) => seriesOf(page.runs[name])));
    const players: Player[] = [];
    let end = 0;
    names.forEach((name, k) => {
      const run = page.runs[name];
      const times = series[k]?.values[0];
      if (times && times.length > 0) end = Math.max(end, times[times.length - 1]!);
      const bytes = blockBytes(run?.recording);
      if (!bytes) {
        places[k]!.append(missing(run) as Node);
        return;
      }
      const recording = new Recording(bytes);
      const player = new Player(recording, series[k]!, `Flow of ${recording.header.name}`);
      player.remember(`play.box.${k}`);
      end = Math.max(end, recording.end);
      places[k]!.append(player.element);
      const event = eventOf(recording.header.name, name);
      if (event) {
        places[k]!.append(h('p', { class: 'note' }, `Played is ${event}, the event in which the first objective is worst. Time series are kept of studies of one event only.`));
      }
      players.push(player);
    });
    const start = view.get('play.time', 0);
    clock.setEnd(end);
    if (players.length > 0) {
      element.append(controls(clock, players));
      clock.watch((time) => players.forEach((player) => player.set(time)));
      clock.set(start);
    }
    const named: NamedSeries[] = names.flatMap((name, k) =>
      series[k] ? [{ name, series: series[k]!, windows: page.runs[name]?.windows ?? [] }] : [],
    );
    if (named.length > 0) element.append(seriesPanels(named, keys, clock));
    element.dataset['ready'] = 'true';
  })().catch((error: unknown) => {
    element.append(h('p', { class: 'error', role: 'alert' }, `Damaged data: ${String(error)}`));
  });
  return element;
}
