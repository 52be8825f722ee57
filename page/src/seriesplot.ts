/** Time series of several runs over each other, with the clock's cursor. */
import type { Chart } from './chart';
import { Chart as MadeChart, axisStyle, tooltipStyle } from './chart';
import type { Clock } from './clock';
import { palette } from './colors';
import type { Run } from './data';
import { h, select } from './dom';
import type { Keys } from './format';
import { allColumns, firstPanels, panels, type Panel } from './panels';
import type { Series } from './series';
import { color } from './theme';
import { view } from './view';

export interface NamedSeries {
  name: string;
  series: Series;
  /** Of the loads. */
  windows: NonNullable<Run['windows']>;
}

const dashes: ('solid' | 'dashed' | 'dotted')[] = ['solid', 'dashed', 'dotted'];

function points(series: Series, values: Float32Array): [number, number | null][] {
  const times = series.values[0]!;
  return Array.from(values, (value, k) => [times[k]!, Number.isFinite(value) ? value : null]);
}

/** The windows of a load over the forces of its barrier: as long as the mean, as high as it. */
function windowLines(panel: Panel, runs: NamedSeries[], keys: Keys): object[] {
  if (!/^force_x/.test(panel.title)) return [];
  const most = Math.max(...runs.flatMap((run) => run.windows.map((one) => one.value)));
  return runs.flatMap(({ name, windows }, run) =>
    windows
      .filter((one) => panel.columns.includes(`barrier_${one.barrier}_${panel.title}`))
      .map((one) => ({
        id: `${name} ${one.key}`,
        type: 'line',
        name: `${runs.length > 1 ? `${name}: ` : ''}${panel.columns.length > 1 ? keys.words(one.key) : keys.words(one.key).replace(/^barrier \d+ /, '')} ${keys.quantity(one.key, one.value)}`,
        data: [
          {
            value: [one.from_s, one.value],
            // Named where it stands: a legend of all windows would hide that of the runs.
            label: {
              show: runs.length === 1 && one.value > 0.1 * most, // others would lie over each other
              position: [0, -14],
              color: palette[run % palette.length],
              fontSize: 11,
              textBorderColor: color('paper'),
              textBorderWidth: 3,
              formatter: `${keys.words(one.key).replace(/^barrier \d+ /, '')} ${keys.quantity(one.key, one.value)}`,
            },
          },
          [one.to_s, one.value],
        ],
        labelLayout: { hideOverlap: true },
        symbol: 'rect',
        symbolSize: [2, 10],
        animation: false,
        color: palette[run % palette.length],
        lineStyle: { width: 5, opacity: 0.8 },
        z: 6,
      })),
  );
}

function plot(panel: Panel, runs: NamedSeries[], keys: Keys, clock: Clock): HTMLElement {
  const lines = (): object[] =>
    runs.flatMap(({ name, series }, run) =>
      panel.columns.flatMap((columnName, k) => {
        const at = series.columns.indexOf(columnName);
        if (at < 0) return [];
        const barrier = /^barrier_(\d+)_/.exec(columnName)?.[1];
        const which = barrier && panel.columns.length > 1 ? `, barrier ${barrier}` : '';
        return [
          {
            id: `${name} ${columnName}`,
            type: 'line',
            name: `${name}${which}`,
            data: points(series, series.values[at]!),
            showSymbol: false,
            animation: false,
            color: palette[run % palette.length],
            lineStyle: { width: 1.8, type: dashes[k % dashes.length] },
            sampling: 'minmax',
          },
        ];
      }),
    );
  const title = keys.label(panel.columns[0]!).replace(/^barrier \d+ /, '');
  const windowed = windowLines(panel, runs, keys);
  const named = lines().map((line) => (line as { name: string }).name);
  const chart: Chart = new MadeChart(
    () => `Time series of ${title} for ${runs.map((run) => run.name).join(', ')}`,
    () => ({
      animation: false,
      grid: { left: 64, right: 16, top: 34, bottom: 44 },
      tooltip: { trigger: 'axis', ...tooltipStyle(), axisPointer: { type: 'line' } },
      legend: { top: 4, textStyle: { color: color('text'), lineHeight: 16 }, itemHeight: 8, type: 'scroll', data: named },
      xAxis: axisStyle('time [s]', { type: 'value', nameGap: 26, max: clock.end || undefined }),
      yAxis: axisStyle('', { type: 'value', scale: true, boundaryGap: [0, windowed.length > 0 ? '12%' : 0] }),
      series: [...lines(), ...windowed],
    }),
    'series',
  );
  const cursor = h('div', { class: 'cursor', 'aria-hidden': 'true' });
  chart.element.append(cursor);
  const move = (time: number): void => {
    const x = chart.instance?.convertToPixel({ xAxisIndex: 0 }, time);
    if (typeof x === 'number' && Number.isFinite(x)) cursor.style.transform = `translateX(${x}px)`;
  };
  const stop = clock.watch(move);
  chart.whenReady((instance) => {
    move(clock.time);
    instance.getZr().on('click', (event) => {
      const time = instance.convertFromPixel({ xAxisIndex: 0 }, event.offsetX);
      if (typeof time === 'number') clock.set(time);
    });
  });
  const figure = h('figure', { class: 'panel' }, h('figcaption', {}, title), chart.element);
  figure.addEventListener('parapet-remove', () => {
    stop();
    chart.dispose();
  });
  return figure;
}

/** Panels of the runs with a choice of what they show. */
export function seriesPanels(runs: NamedSeries[], keys: Keys, clock: Clock): HTMLElement {
  const all = panels(allColumns(runs.map((run) => run.series.columns)));
  const shown = view.get('series.panels', firstPanels(all)).filter((title) => all.some((one) => one.title === title));
  const grid = h('div', { class: 'panels' });
  const make = (): void => {
    grid.querySelectorAll('figure').forEach((one) => one.dispatchEvent(new Event('parapet-remove')));
    grid.replaceChildren(
      ...shown.map((title, place) => {
        const panel = all.find((one) => one.title === title)!;
        const options = all.map((one) => ({
          value: one.title,
          text: keys.words(one.columns[0]!).replace(/^barrier \d+ /, ''),
        }));
        const choice = select('Shown', options, title, (value) => {
          shown[place] = value;
          view.set('series.panels', shown);
          make();
        });
        return h('div', {}, choice, plot(panel, runs, keys, clock));
      }),
    );
  };
  make();
  return grid;
}
