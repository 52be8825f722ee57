/** The page of a sweep: the scorecard against what was published, figures, and playback of rows. */
import { axisStyle, Chart, tooltipStyle } from './chart';
import { checkSection } from './check';
import { palette } from './colors';
import type { Barrier, Published, Scene, SweepPage, SweepRow } from './data';
import { button, h, section, select, type Child } from './dom';
import { count, numberText, valueElement, type Keys } from './format';
import { compareRuns } from './runs';
import { mostSelected, Store } from './store';
import { Table, type Column } from './table';
import { color } from './theme';
import { view } from './view';

interface Pair {
  row: SweepRow;
  key: string;
  paper: Published;
  value: number | null;
  verdict: string;
  distance: number;
}

function pairsOf(page: SweepPage): Pair[] {
  return page.rows.flatMap((row) =>
    Object.entries(row.paper).map(([key, paper]) => ({
      row,
      key,
      paper,
      value: row.metrics[key] ?? null,
      verdict: row.agreement[key]?.verdict ?? 'none',
      distance: row.agreement[key]?.distance ?? 0,
    })),
  );
}

function publishedText(paper: Published): string {
  const { lower, upper } = paper;
  let range = '';
  if (lower !== undefined && upper !== undefined) range = `${numberText(lower)} to ${numberText(upper)}`;
  else if (lower !== undefined) range = `at least ${numberText(lower)}`;
  else if (upper !== undefined) range = `at most ${numberText(upper)}`;
  const value = paper.value !== undefined ? numberText(paper.value) : '';
  return [value, range && (value ? `(${range})` : range)].filter(Boolean).join(' ');
}

const verdictWords: Record<string, string> = { agrees: 'agrees', misses: 'misses', none: 'no range printed' };

function scorecard(page: SweepPage, keys: Keys): HTMLElement {
  const pairs = pairsOf(page);
  const verdict = (pair: Pair): string => verdictWords[pair.verdict] ?? pair.verdict;
  const columns: Column[] = [
    { key: 'row', label: 'Row', name: true, value: (k) => pairs[k]!.row.id },
    { key: 'metric', label: 'Quantity', value: (k) => keys.label(pairs[k]!.key) },
    { key: 'computed', label: 'Computed', numeric: true, value: (k) => pairs[k]!.value, show: (k) => valueElement(pairs[k]!.value) },
    { key: 'published', label: 'Published', numeric: true, value: (k) => publishedText(pairs[k]!.paper) },
    { key: 'verdict', label: 'Verdict', value: (k) => verdict(pairs[k]!), show: (k) => h('span', { class: `badge ${pairs[k]!.verdict === 'agrees' ? 'good' : pairs[k]!.verdict === 'misses' ? 'bad' : ''}` }, verdict(pairs[k]!)) },
    { key: 'source', label: 'Source and note', value: (k) => [pairs[k]!.paper.source, pairs[k]!.paper.note].filter(Boolean).join('; ') },
  ];
  return new Table({ name: `${page.name}-scorecard`, caption: 'Computed beside published values', hint: 'text, or conditions: verdict = misses', columns, rows: pairs.length }).element;
}

/** Computed values of all rows with the printed ones laid over. */
function figure(page: SweepPage, keys: Keys, key: string): Chart {
  const rows = page.rows;
  return new Chart(
    () => `${keys.label(key)} of every row; printed values where there are some. The scorecard and the table hold the numbers.`,
    () => ({
      animation: false,
      grid: { left: 84, right: 20, top: 40, bottom: 84 },
      legend: { top: 4, textStyle: { color: color('text') } },
      tooltip: { ...tooltipStyle(), trigger: 'axis', valueFormatter: (value: unknown) => (Array.isArray(value) ? value.slice(1, 3).map((v) => numberText(v as number)).join(' to ') : numberText(value as number)) },
      xAxis: axisStyle('', { type: 'category', data: rows.map((row) => row.id), axisLabel: { color: color('text'), rotate: 40, interval: 0 } }),
      yAxis: axisStyle(keys.label(key), { type: 'value', scale: false, nameGap: 60 }),
      series: [
        { type: 'bar', name: 'computed', animation: false, data: rows.map((row) => row.metrics[key] ?? null), itemStyle: { color: palette[0] }, barMaxWidth: 34 },
        { type: 'scatter', name: 'printed in the paper', animation: false, symbol: 'diamond', symbolSize: 14, itemStyle: { color: palette[1], borderColor: color('paper'), borderWidth: 1 }, data: rows.map((row) => row.paper[key]?.value ?? null), z: 5 },
        {
          type: 'custom',
          name: 'range of the paper',
          animation: false,
          itemStyle: { color: palette[1] },
          data: rows.flatMap((row, k) => {
            const paper = row.paper[key];
            return paper?.lower !== undefined && paper.upper !== undefined ? [[k, paper.lower, paper.upper]] : [];
          }),
          encode: { x: 0, y: [1, 2] },
          renderItem: (_: unknown, api: { value(k: number): number; coord(p: number[]): number[] }) => {
            const [a, b] = [api.coord([api.value(0), api.value(1)]), api.coord([api.value(0), api.value(2)])];
            const [x, y1, y2] = [a[0]!, a[1]!, b[1]!];
            return {
              type: 'path',
              shape: { pathData: `M${x} ${y1}L${x} ${y2}M${x - 7} ${y1}L${x + 7} ${y1}M${x - 7} ${y2}L${x + 7} ${y2}` },
              style: { stroke: palette[1], lineWidth: 2.5, fill: 'none' },
            };
          },
          z: 4,
        },
      ],
    }),
    'tall',
  );
}

/** What a row's first barrier is like: what the paper draws its results over. */
const across: { value: string; text: string; unit: string; of: (barrier: Barrier) => number | null }[] = [
  { value: 'angle', text: 'deflector angle', unit: '°', of: (one) => one.deflector?.angle_deg ?? null },
  { value: 'length', text: 'deflector length', unit: 'm', of: (one) => one.deflector?.length_m ?? null },
  { value: 'height', text: 'height of the first barrier', unit: 'm', of: (one) => one.height_m },
];

/** Rows that differ in nothing else of their first barrier make one line. */
function lineOf(scene: Scene, but: string): string {
  const { height_m, deflector } = scene.barriers[0]!;
  const parts = [
    but !== 'height' && `${numberText(1000 * height_m)} mm high`,
    but !== 'angle' && (deflector ? `${numberText(deflector.angle_deg)}°` : 'bare'),
    but !== 'length' && deflector && `deflector ${numberText(1000 * deflector.length_m)} mm`,
    scene.barriers.length > 1 && `${scene.barriers.length} barriers, ${numberText(scene.barriers[1]!.foot_x_m - scene.barriers[0]!.foot_x_m)} m apart`,
  ];
  return parts.filter(Boolean).join(', ');
}

/** Computed values over a dimension of the first barrier, with the printed ones laid over. */
function dimensionFigure(page: SweepPage, keys: Keys, key: string, over: (typeof across)[number]): Chart {
  const lines = new Map<string, [number, number, string][]>();
  const printed: { value: [number, number]; name: string }[] = [];
  const ranges: [number, number, number][] = [];
  for (const row of page.rows) {
    const scene = page.runs[row.id]?.scene;
    const x = scene?.barriers[0] ? over.of(scene.barriers[0]) : null;
    if (!scene || x === null) continue;
    const value = row.metrics[key];
    const name = lineOf(scene, over.value);
    if (typeof value === 'number') lines.set(name, [...(lines.get(name) ?? []), [x, value, row.id]]);
    const paper = row.paper[key];
    if (paper?.value !== undefined) printed.push({ value: [x, paper.value], name: row.id });
    if (paper?.lower !== undefined && paper.upper !== undefined) ranges.push([x, paper.lower, paper.upper]);
  }
  return new Chart(
    () => `${keys.label(key)} over the ${over.text}, ${count(lines.size, 'line')}; printed values where there are some. The scorecard and the table hold the numbers.`,
    () => ({
      animation: false,
      grid: { left: 84, right: 20, top: 64, bottom: 56 },
      legend: { top: 4, textStyle: { color: color('text') } },
      tooltip: { ...tooltipStyle(), trigger: 'item', formatter: (item: { name?: string; value: (number | string)[] }) => `${item.value[2] ?? item.name ?? ''}: ${numberText(Number(item.value[1]))}` },
      xAxis: axisStyle(`${over.text} [${over.unit}]`, { type: 'value', scale: true, nameGap: 32 }),
      yAxis: axisStyle(keys.label(key), { type: 'value', scale: true, nameGap: 60 }),
      series: [
        ...[...lines].map(([name, points], k) => ({
          type: 'line',
          name,
          animation: false,
          symbol: 'circle',
          symbolSize: 9,
          data: [...points].sort((a, b) => a[0] - b[0]),
          color: palette[(k === 1 ? 2 : k > 1 ? k + 1 : k) % palette.length],
          lineStyle: { width: 2 },
        })),
        { type: 'scatter', name: 'printed in the paper', animation: false, symbol: 'diamond', symbolSize: 14, color: palette[1], itemStyle: { color: palette[1], borderColor: color('paper'), borderWidth: 1 }, data: printed, z: 5 },
        ...ranges.map(([x, low, high]) => ({ type: 'line', name: 'range of the paper', animation: false, symbol: 'rect', symbolSize: [14, 2], color: palette[1], lineStyle: { width: 2.5 }, data: [[x, low], [x, high]], z: 4 })),
      ],
    }),
    'tall',
  );
}

export function sweepSections(page: SweepPage, keys: Keys): HTMLElement[] {
  const pairs = pairsOf(page);
  const tally = (word: string): number => pairs.filter((pair) => pair.verdict === word).length;
  const published = [...new Set(pairs.map((pair) => pair.key))];
  const all = [...new Set(page.rows.flatMap((row) => Object.keys(row.metrics).filter((key) => row.metrics[key] !== null)))];
  const keysShown = [...published, ...all.filter((key) => !published.includes(key))];
  const place = h('div');
  let chart: Chart | null = null;
  let quantity = '';
  let over = view.choice('figure.over', ['row', ...across.map((one) => one.value)], 'row');
  const show = (key: string): void => {
    view.set('figure', key);
    chart?.dispose();
    quantity = key;
    const dimension = across.find((one) => one.value === over);
    chart = dimension ? dimensionFigure(page, keys, key, dimension) : figure(page, keys, key);
    place.replaceChildren(chart.element, h('p', { class: 'note' }, keys.definition(key) ?? ''));
  };
  const store = new Store();
  const playback = h('div');
  const update = (): void => {
    playback.replaceChildren(
      store.selected.length > 0
        ? compareRuns(page, keys, store.selected, (id): Child => id, true)
        : h('p', { class: 'note' }, 'Choose rows above.'),
    );
    choice.querySelectorAll('button').forEach((one) => one.setAttribute('aria-pressed', String(store.isSelected(one.dataset['row'] ?? ''))));
  };
  const choice = h(
    'div',
    { class: 'row' },
    ...page.rows.map((row) => button(row.id, () => store.toggle(row.id), { 'data-row': row.id, title: row.description, 'aria-pressed': 'false' })),
  );
  store.selectionChanged(update);
  const shown = view.choice('figure', keysShown, keysShown[0] ?? '');
  if (shown) show(shown);
  const recorded = page.rows.find((row) => page.runs[row.id]?.recording) ?? page.rows[0];
  store.start(view.get('chosen', recorded ? [recorded.id] : []).filter((id) => page.rows.some((row) => row.id === id)));
  store.selectionChanged(() => view.set('chosen', [...store.selected]));
  update();
  const columns: Column[] = [
    { key: 'id', label: 'Row', name: true, value: (k) => page.rows[k]!.id },
    { key: 'status', label: 'Status', value: (k) => (page.rows[k]!.status === 'ok' ? 'ok' : `failed: ${page.rows[k]!.reason}`) },
    { key: 'description', label: 'Description', value: (k) => page.rows[k]!.description },
    ...all.map((key): Column => ({ key, label: keys.label(key), title: keys.definition(key), numeric: true, value: (k) => page.rows[k]!.metrics[key] ?? null, show: (k) => valueElement(page.rows[k]!.metrics[key]) })),
  ];
  const failed = page.rows.filter((row) => row.status !== 'ok').length;
  return [
    section(
      'answer',
      'Does it agree with what was published?',
      h(
        'div',
        { class: `verdict ${tally('misses') > 0 || failed > 0 ? 'warn' : 'good'}` },
        h('p', { class: 'headline' }, `${tally('agrees')} of ${tally('agrees') + tally('misses')} printed ranges are met.`),
        h('p', {}, `${page.rows.length} rows at a particle spacing of ${numberText(1000 * page.spacing_m)} mm${failed > 0 ? `, ${failed} failed` : ''}; ${tally('none')} printed values come without a range. Source: ${page.source}.`),
      ),
      scorecard(page, keys),
    ),
    section('figures', 'Figures', h('div', { class: 'row' }, select('Quantity', keysShown.map((key) => ({ value: key, text: keys.label(key) })), shown, show), select('Across', [{ value: 'row', text: 'rows' }, ...across.map((one) => ({ value: one.value, text: one.text }))], over, (value) => {
      over = value;
      view.set('figure.over', value);
      show(quantity);
    })), place),
    section('flow', 'What does the flow look like?', h('p', {}, `Up to ${mostSelected} rows side by side.`), choice, playback),
    section('rows', 'All rows', new Table({ name: page.name, caption: 'Every row with all its metrics', columns, rows: page.rows.length }).element),
    checkSection(page),
  ];
}
