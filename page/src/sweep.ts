/** The page of a sweep: the scorecard against what was published, figures, and playback of rows. */
import { axisStyle, Chart, tooltipStyle } from './chart';
import { checkSection } from './check';
import { palette } from './colors';
import type { Published, SweepPage, SweepRow } from './data';
import { button, h, section, select, type Child } from './dom';
import { numberText, valueElement, type Keys } from './format';
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
    { key: 'row', label: 'Row', value: (k) => pairs[k]!.row.id },
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

export function sweepSections(page: SweepPage, keys: Keys): HTMLElement[] {
  const pairs = pairsOf(page);
  const tally = (word: string): number => pairs.filter((pair) => pair.verdict === word).length;
  const published = [...new Set(pairs.map((pair) => pair.key))];
  const all = [...new Set(page.rows.flatMap((row) => Object.keys(row.metrics).filter((key) => row.metrics[key] !== null)))];
  const keysShown = [...published, ...all.filter((key) => !published.includes(key))];
  const place = h('div');
  let chart: Chart | null = null;
  const show = (key: string): void => {
    view.set('figure', key);
    chart?.dispose();
    chart = figure(page, keys, key);
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
    { key: 'id', label: 'Row', value: (k) => page.rows[k]!.id },
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
    section('figures', 'Figures', select('Quantity', keysShown.map((key) => ({ value: key, text: keys.label(key) })), shown, show), place),
    section('flow', 'What does the flow look like?', h('p', {}, `Up to ${mostSelected} rows side by side.`), choice, playback),
    section('rows', 'All rows', new Table({ name: page.name, caption: 'Every row with all its metrics', columns, rows: page.rows.length }).element),
    checkSection(page),
  ];
}
