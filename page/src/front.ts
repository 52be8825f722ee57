/** The front and everything around it: any quantity against any other. */
import type { ECharts } from 'echarts/core';
import { axisStyle, Chart, tooltipStyle } from './chart';
import type { Recommendation } from './recommendation';
import { palette } from './colors';
import { axisValue, kinds, onFront, type DesignTable, type Kind, type Quantity } from './designs';
import { checkbox, h, select } from './dom';
import type { Keys } from './format';
import type { Store } from './store';
import { color } from './theme';
import { view } from './view';

const symbols: Record<Kind, string> = {
  front: 'diamond',
  'front-warned': 'emptyDiamond',
  feasible: 'circle',
  warned: 'triangle',
  infeasible: 'path://M0 0L1 0L5 4L9 0L10 0L10 1L6 5L10 9L10 10L9 10L5 6L1 10L0 10L0 9L4 5L0 1Z',
  coarse: 'emptyCircle',
  failed: 'emptyRect',
};

interface Point {
  value: [number, number];
  row: number;
  itemStyle?: { color: string; borderColor: string };
}

export class FrontView {
  readonly element: HTMLElement;
  private readonly chart: Chart;
  private readonly shown = new Set<Kind>(['front', 'front-warned', 'feasible', 'warned', 'infeasible']);
  private readonly hover: Set<string>;
  private x: Quantity;
  private y: Quantity;
  private bars = true;

  constructor(
    private readonly table: DesignTable,
    private readonly keys: Keys,
    private readonly store: Store,
    /** What a study has found; nothing where several are laid side by side. */
    private readonly advice: Recommendation = {},
    /** A quantity with a colour for each of its options, instead of one for each kind. */
    private readonly byOption?: Quantity,
  ) {
    const numeric = table.quantities;
    const objectives = numeric.filter((one) => one.group === 'objective');
    const other = numeric.find((one) => one.group === 'variable')!;
    this.x = table.find(view.get('front.x', '')) ?? objectives[1] ?? other;
    this.y = table.find(view.get('front.y', '')) ?? objectives[0] ?? numeric[0]!;
    if (view.get('front.feasible', false)) this.shown.delete('infeasible');
    this.bars = view.get('front.bars', true);
    this.hover = new Set([...objectives, ...numeric.filter((one) => one.group === 'variable')].map((one) => one.key));
    this.chart = new Chart(
      () => this.describe(),
      () => this.option(),
      'tall',
    );
    this.chart.whenReady((chart) => this.listen(chart));
    store.selectionChanged(() => this.chart.update());
    store.filterChanged(() => this.chart.update());
    this.element = h('div', {}, this.fields(), this.chart.element, this.barNote(), this.hoverChoice());
  }

  private fields(): HTMLElement {
    const options = this.table.quantities.map((one) => ({ value: one.key, text: `${one.label} (${one.group})` }));
    const choose = (label: string, start: Quantity, set: (one: Quantity) => void): HTMLElement =>
      select(label, options, start.key, (key) => {
        set(this.table.find(key)!);
        this.chart.update();
      });
    const row = h(
      'div',
      { class: 'row' },
      choose('Across', this.x, (one) => {
        this.x = one;
        view.set('front.x', one.key);
      }),
      choose('Up', this.y, (one) => {
        this.y = one;
        view.set('front.y', one.key);
      }),
      checkbox('feasible only', !this.shown.has('infeasible'), (only) => {
        view.set('front.feasible', only);
        this.shown.delete('infeasible');
        if (!only) this.shown.add('infeasible');
        this.chart.update();
      }),
    );
    for (const kind of ['coarse', 'failed'] as Kind[]) {
      if (!this.table.kind.includes(kind)) continue;
      const words = kinds.find((one) => one.kind === kind)!.words;
      row.append(
        checkbox(words, false, (on) => {
          if (on) this.shown.add(kind);
          else this.shown.delete(kind);
          this.chart.update();
        }),
      );
    }
    row.append(
      checkbox('95 % bars', this.bars, (on) => {
        view.set('front.bars', on);
        this.bars = on;
        this.chart.update();
      }),
    );
    return row;
  }

  /** What the bars are; over drawn events they need not hold what was simulated. */
  private barNote(): HTMLElement | null {
    if ((this.advice.front ?? []).length === 0) return null;
    const events = this.table.page.objectives.some((one) => one.statistic !== undefined);
    return h(
      'p',
      { class: 'note' },
      events
        ? 'Bars: 95 % intervals of what the surrogates estimate over all events. A mark is the value of the simulated events alone and may lie outside.'
        : 'Bars: 95 % intervals of what the surrogates estimate.',
    );
  }

  private hoverChoice(): HTMLElement {
    return h(
      'details',
      {},
      h('summary', {}, 'Shown when the pointer is on a design'),
      h(
        'div',
        { class: 'ticks' },
        ...this.table.quantities.map((one) =>
          checkbox(one.label, this.hover.has(one.key), (on) => {
            if (on) this.hover.add(one.key);
            else this.hover.delete(one.key);
          }),
        ),
      ),
    );
  }

  private describe(): string {
    const { front } = this.table.page.designs;
    const n = front.filter(Boolean).length;
    return `${this.y.label} against ${this.x.label} for ${this.table.rows} designs, ${n} of them on the front. The table below holds the same numbers.`;
  }

  private tooltip(row: number): string {
    const { designs } = this.table.page;
    const lines = [`Design ${designs.id[row]}`, kinds.find((one) => one.kind === this.table.kind[row])!.words];
    for (const one of this.table.quantities) {
      if (this.hover.has(one.key)) {
        lines.push(`${this.keys.words(one.name)}: ${this.keys.quantity(one.name, one.values[row])}`);
      }
    }
    if (designs.reason[row]) lines.push(designs.reason[row]!);
    for (const words of designs.warnings[row] ?? []) lines.push(`Warning: ${words}`);
    return lines.join('\n').replace(/[{}|]/g, ' '); // what ECharts' rich text would read as marks
  }

  private optionColor(row: number): string | null {
    if (!this.byOption) return null;
    const place = axisValue(this.byOption, row);
    return place === null ? null : palette[place % palette.length]!;
  }

  private points(kind: Kind): Point[] {
    const found: Point[] = [];
    this.table.kind.forEach((one, row) => {
      if (one !== kind || !this.store.passes(row)) return;
      const [x, y] = [axisValue(this.x, row), axisValue(this.y, row)];
      if (x === null || y === null) return;
      const own = this.optionColor(row);
      found.push({ value: [x, y], row, ...(own ? { itemStyle: { color: own, borderColor: own } } : {}) });
    });
    return found;
  }

  /** Bars of the surrogates' intervals, for designs of the front. */
  private intervals(): object[] {
    if (!this.bars) return [];
    const lines: (number | null)[][] = [];
    for (const design of this.advice.front ?? []) {
      const row = this.table.rowOf.get(design.id);
      if (row === undefined || !this.store.passes(row)) continue;
      const of = (quantity: Quantity) => design.objectives.find((one) => one.name === quantity.name);
      const [a, b] = [of(this.x), of(this.y)];
      const x = axisValue(this.x, row);
      const y = axisValue(this.y, row);
      if (x === null || y === null) continue;
      if (a && a.lower_95 !== null && a.upper_95 !== null) lines.push([a.lower_95, y], [a.upper_95, y], [null, null]);
      if (b && b.lower_95 !== null && b.upper_95 !== null) lines.push([x, b.lower_95], [x, b.upper_95], [null, null]);
    }
    return [
      {
        id: 'bars',
        type: 'line',
        name: '95 % interval of the surrogate',
        data: lines,
        symbol: 'none',
        silent: true,
        animation: false,
        color: color('faint'),
        lineStyle: { width: 1.5 },
        z: 2,
      },
    ];
  }

  private option(): Record<string, unknown> {
    const colors: Record<Kind, string> = {
      front: color('accent'),
      'front-warned': color('accent'),
      feasible: color('good'),
      warned: color('warn'),
      infeasible: color('bad'),
      coarse: color('faint'),
      failed: color('bad'),
    };
    const axis = (one: Quantity, extra: object): object =>
      axisStyle(one.goal ? `${one.label} (${one.goal === 'maximize' ? 'more' : 'less'} is better)` : one.label, {
        type: one.options ? 'category' : 'value',
        data: one.options,
        scale: true,
        boundaryGap: one.options ? true : ['4%', '4%'],
        // What is never negative has no negative axis.
        ...(one.options ? {} : { min: (of: { min: number; max: number }) => (of.min >= 0 && of.min < 0.05 * of.max ? 0 : undefined) }),
        ...extra,
      });
    const series: object[] = kinds.map(({ kind, words }) => ({
      id: kind,
      type: 'scatter',
      name: words,
      data: this.shown.has(kind) ? this.points(kind) : [],
      symbol: symbols[kind],
      symbolSize: onFront(kind) ? 13 : 8,
      itemStyle: { color: this.byOption ? color('soft') : colors[kind], opacity: onFront(kind) ? 1 : 0.75, borderColor: colors[kind] },
      animation: false,
      z: onFront(kind) ? 4 : 3,
    }));
    const recommended = this.advice.recommended?.id;
    const chosen = [...new Set([...(recommended ? [recommended] : []), ...this.store.selected])].flatMap((id) => {
      const row = this.table.rowOf.get(id);
      if (row === undefined) return [];
      const [x, y] = [axisValue(this.x, row), axisValue(this.y, row)];
      if (x === null || y === null) return [];
      const place = this.store.selected.indexOf(id);
      const own = place < 0 ? color('text') : palette[place % palette.length]!;
      return [
        {
          value: [x, y],
          row,
          itemStyle: { borderColor: own },
          label: { formatter: id === recommended ? `${id} (recommended)` : id, position: place % 2 === 1 ? 'bottom' : 'top' },
        },
      ];
    });
    series.push({
      id: 'chosen',
      type: 'scatter',
      name: 'chosen',
      data: chosen,
      symbol: 'circle',
      symbolSize: 22,
      itemStyle: { color: 'transparent', borderColor: color('text'), borderWidth: 2, opacity: 1 },
      label: { show: true, position: 'top', color: color('text'), fontSize: 13, textBorderColor: color('paper'), textBorderWidth: 4 },
      labelLayout: { hideOverlap: false, moveOverlap: 'shiftY' },
      animation: false,
      z: 5,
    });
    return {
      animation: false,
      grid: { left: 84, right: 24, top: 64, bottom: 56 },
      legend: {
        top: 4,
        textStyle: { color: color('text') },
        data: kinds.filter(({ kind }) => this.shown.has(kind) && this.table.kind.includes(kind)).map(({ words }) => words),
      },
      tooltip: {
        trigger: 'item',
        ...tooltipStyle(),
        formatter: (item: { data: { row?: number } }) =>
          item.data.row === undefined ? '' : this.tooltip(item.data.row),
      },
      xAxis: axis(this.x, { nameGap: 32 }),
      yAxis: axis(this.y, { nameGap: 60 }),
      series: [...series, ...this.intervals()],
    };
  }

  private listen(chart: ECharts): void {
    chart.on('click', (event) => {
      const row = (event.data as { row?: number } | undefined)?.row;
      if (row !== undefined) this.store.toggle(this.table.page.designs.id[row]!);
    });
  }

  /** Where a design is drawn, in pixels of the chart; for tests and keyboards. */
  place(id: string): [number, number] | null {
    const row = this.table.rowOf.get(id);
    if (row === undefined || !this.chart.instance) return null;
    const [x, y] = [axisValue(this.x, row), axisValue(this.y, row)];
    return x === null || y === null
      ? null
      : (this.chart.instance.convertToPixel({ xAxisIndex: 0, yAxisIndex: 0 }, [x, y]) as [number, number]);
  }
}
