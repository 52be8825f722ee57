/** What each variable does: Sobol' indices, main effects, and slices through the chosen design. */
import { axisStyle, Chart, tooltipStyle } from './chart';
import type { Slice, StudyPage } from './data';
import type { MainEffect } from './recommendation';
import { h, select } from './dom';
import { numberText, type Keys } from './format';
import { color } from './theme';
import { view } from './view';

type Curve = { at: (number | string)[]; middle: number[]; lower: number[]; upper: number[] };

function ofEffect(effect: MainEffect): Curve {
  return { at: effect.at, middle: effect.mean, lower: effect.lower_95, upper: effect.upper_95 };
}

function ofSlice(slice: Slice): Curve {
  return { at: slice.at, middle: slice.median, lower: slice.lower_95, upper: slice.upper_95 };
}

/** A curve in its band; a choice has a bar per option. */
function curveChart(curve: Curve, across: string, up: string, here: number | string | undefined): Chart {
  const named = curve.at.some((one) => typeof one === 'string');
  return new Chart(
    () => `${up} along ${across}, with a 95 % band from ${numberText(Math.min(...curve.lower))} to ${numberText(Math.max(...curve.upper))}`,
    () => {
      const points = (values: number[]): [number | string, number][] => values.map((value, k) => [curve.at[k]!, value]);
      const band = { type: 'line', symbol: 'none', silent: true, stack: 'band', animation: false, lineStyle: { opacity: 0 } };
      return {
        animation: false,
        grid: { left: 64, right: 14, top: 14, bottom: 44 },
        tooltip: {
          trigger: 'axis',
          ...tooltipStyle(),
          formatter: (items: { dataIndex: number }[]) => {
            const k = items[0]?.dataIndex ?? 0;
            return `${numberText(curve.middle[k])} (95 %: ${numberText(curve.lower[k])} to ${numberText(curve.upper[k])})`;
          },
        },
        xAxis: axisStyle(across, { type: named ? 'category' : 'value', scale: true, nameGap: 26, boundaryGap: named }),
        yAxis: axisStyle('', { type: 'value', scale: true }),
        series: [
          { ...band, data: points(curve.lower), stackStrategy: 'all' },
          {
            ...band,
            data: points(curve.upper.map((value, k) => value - curve.lower[k]!)),
            stackStrategy: 'all',
            areaStyle: { color: color('accent'), opacity: 0.22 },
          },
          {
            type: 'line',
            symbol: named ? 'diamond' : 'none',
            symbolSize: 9,
            animation: false,
            data: points(curve.middle),
            color: color('accent'),
            lineStyle: { width: named ? 0 : 2 },
          },
          ...(typeof here === 'number' && !named
            ? [
                {
                  type: 'line',
                  symbol: 'none',
                  silent: true,
                  animation: false,
                  data: [
                    [here, Math.min(...curve.lower)],
                    [here, Math.max(...curve.upper)],
                  ],
                  color: color('text'),
                  lineStyle: { type: 'dashed', width: 1 },
                },
              ]
            : []),
        ],
      };
    },
    'small',
  );
}

function sobolChart(names: string[], first: { value: number; lower_95: number; upper_95: number }[], total: typeof first, metric: string): Chart {
  return new Chart(
    () =>
      `Sobol' indices for ${metric}: ` +
      names.map((name, k) => `${name} alone ${numberText(first[k]!.value)}, with interactions ${numberText(total[k]!.value)}`).join('; '),
    () => {
      const bars = (title: string, list: typeof first, fill: string): object => ({
        type: 'bar',
        name: title,
        animation: false,
        barGap: '10%',
        data: list.map((one) => one.value),
        itemStyle: { color: fill },
      });
      const whiskers = (list: typeof first, offset: number): object => ({
        type: 'custom',
        silent: true,
        animation: false,
        z: 5,
        data: list.map((one, k) => [one.lower_95, one.upper_95, k]),
        encode: { x: [0, 1], y: 2 },
        renderItem: (
          _: unknown,
          api: { value(k: number): number; coord(p: number[]): number[]; size(p: number[]): number[] },
        ) => {
          const [a, b] = [api.coord([api.value(0), api.value(2)]), api.coord([api.value(1), api.value(2)])];
          const y = a[1]! + offset * api.size([0, 1])[1]! * 0.19;
          return {
            type: 'line',
            shape: { x1: a[0], x2: b[0], y1: y, y2: y },
            style: { stroke: color('text'), lineWidth: 1.5 },
          };
        },
      });
      return {
        animation: false,
        grid: { left: 150, right: 20, top: 36, bottom: 44 },
        legend: { top: 4, textStyle: { color: color('text') } },
        tooltip: { ...tooltipStyle(), trigger: 'axis', axisPointer: { type: 'shadow' }, valueFormatter: (value: unknown) => numberText(Number(value)) },
        xAxis: axisStyle('share of the variance', { type: 'value', min: 0, max: 1, nameGap: 26 }),
        yAxis: axisStyle('', { type: 'category', data: names, inverse: true, axisLabel: { color: color('text'), width: 130, overflow: 'break' } }),
        series: [
          bars('alone', first, color('accent')),
          bars('with interactions', total, color('faint')),
          whiskers(first, -1),
          whiskers(total, 1),
        ],
      };
    },
    'sobol',
  );
}

export function effectsView(page: StudyPage, keys: Keys): HTMLElement {
  const { sensitivity } = page.recommendation;
  const slices = page.slices?.metrics ?? [];
  // By the surrogate's name: two may model one metric, such as a quantile and a share of the events.
  const titles = new Map([...(sensitivity?.metrics ?? []), ...slices].map((one) => [one.name, keys.modelled(one.name, one.metric)]));
  const names = [...titles.keys()];
  if (names.length === 0) {
    return h('p', { class: 'note' }, 'The study has no surrogates: too few designs ended well, or its method fits none.');
  }
  const place = h('div');
  const shown: Chart[] = [];
  const show = (name: string): void => {
    const title = titles.get(name)!;
    shown.splice(0).forEach((chart) => chart.dispose());
    const parts: Node[] = [];
    const one = sensitivity?.metrics.find((entry) => entry.name === name);
    const curves = h('div', { class: 'panels' });
    const keep = (chart: Chart): Chart => {
      shown.push(chart);
      return chart;
    };
    if (one) {
      const q = one.q_squared === null ? 'not known' : numberText(one.q_squared);
      parts.push(
        h('p', {}, `From a surrogate of ${one.designs} designs; leave-one-out Q² ${q}. ${one.varies ? '' : 'It does not vary over the box.'}`),
        h('h3', {}, "Sobol' indices: what share of the variation each variable makes"),
        keep(
          sobolChart(
            one.variables.map((v) => keys.words(v.name)),
            one.variables.map((v) => v.first),
            one.variables.map((v) => v.total),
            title,
          ),
        ).element,
      );
      for (const variable of one.variables) {
        const chart = keep(curveChart(ofEffect(variable.main_effect), keys.label(variable.name), title, undefined));
        curves.append(h('figure', {}, h('figcaption', {}, keys.words(variable.name)), chart.element));
      }
      parts.push(h('h3', {}, `Main effects: ${title}, averaged over all other variables`), curves);
    } else {
      parts.push(
        h('p', { class: 'note' }, 'Sobol\' indices and main effects come with the recommendation: ', h('code', {}, page.commands.find((c) => c.what.includes('recommend'))?.command ?? 'parapet recommend DIR')),
      );
    }
    const cut = slices.find((entry) => entry.name === name);
    if (cut) {
      const panels = h('div', { class: 'panels' });
      for (const slice of cut.slices) {
        const variables = page.designs.variables[slice.variable] ?? [];
        const row = page.designs.id.indexOf(page.slices!.design);
        const chart = keep(curveChart(ofSlice(slice), keys.label(slice.variable), title, variables[row] ?? undefined));
        panels.append(h('figure', {}, h('figcaption', {}, keys.words(slice.variable)), chart.element));
      }
      parts.push(h('h3', {}, `Slices through design ${page.slices!.design}: ${title}, the others kept`), panels);
    }
    place.replaceChildren(...parts);
  };
  const start = view.choice('effects', names, names[0]!);
  const element = h('div', {}, select('Quantity', names.map((name) => ({ value: name, text: titles.get(name)! })), start, (name) => {
    view.set('effects', name);
    show(name);
  }), place);
  show(start);
  return element;
}

export function convergenceView(page: StudyPage): HTMLElement | null {
  const history = page.recommendation.hypervolume?.history ?? [];
  const single = page.objectives.length === 1;
  const objective = page.objectives[0]!;
  const values = page.designs.objectives[objective.name] ?? [];
  let points: [number, number][] = history
    .filter((one) => one.hypervolume !== null)
    .map((one) => [one.evaluations, one.hypervolume!]);
  if (single) {
    points = [];
    let best: number | null = null;
    page.designs.feasible.forEach((feasible, row) => {
      const value = values[row];
      if (feasible && typeof value === 'number') {
        best = best === null ? value : objective.goal === 'maximize' ? Math.max(best, value) : Math.min(best, value);
      }
      if (best !== null) points.push([row + 1, best]);
    });
  }
  if (points.length < 2) return null;
  const what = single ? 'best value so far' : 'dominated hypervolume';
  return new Chart(
    () => `Convergence: ${what} from ${numberText(points[0]![1])} after ${points[0]![0]} designs to ${numberText(points[points.length - 1]![1])} after ${points[points.length - 1]![0]}`,
    () => ({
      animation: false,
      grid: { left: 84, right: 20, top: 16, bottom: 50 },
      tooltip: { trigger: 'axis', ...tooltipStyle(), valueFormatter: (value: unknown) => numberText(Number(value)) },
      xAxis: axisStyle('designs evaluated', { type: 'value', nameGap: 28 }),
      yAxis: axisStyle(what, { type: 'value', scale: true, nameGap: 62 }),
      series: [{ type: 'line', step: 'end', symbol: 'none', animation: false, data: points, color: color('accent'), lineStyle: { width: 2 } }],
    }),
    'series',
  ).element;
}
