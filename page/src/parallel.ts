/** Parallel coordinates: drag along an axis to keep what lies there. */
import type { ECharts } from 'echarts/core';
import { Chart } from './chart';
import { palette } from './colors';
import { axisValue, bestRows, onFront, type DesignTable, type Quantity } from './designs';
import { button, checkbox, h, select } from './dom';
import type { Keys } from './format';
import type { Store } from './store';
import { color } from './theme';
import { view } from './view';

export class ParallelView {
  readonly element: HTMLElement;
  private readonly chart: Chart;
  private readonly axes: Set<string>;
  private readonly counter = h('span', { class: 'note', role: 'status' });
  private chart_: ECharts | null = null;
  private own = false; // a filter that comes from this view's brushes

  constructor(
    private readonly table: DesignTable,
    private readonly store: Store,
    /** A quantity with a colour for each of its options, instead of one for each kind. */
    private readonly byOption?: Quantity,
  ) {
    const first = table.quantities.filter((one) => one.group === 'variable' || one.group === 'objective');
    this.axes = new Set(view.get('parallel.axes', first.slice(0, 12).map((one) => one.key)).filter((key) => table.find(key)));
    this.chart = new Chart(
      () => `Parallel coordinates of ${this.shownAxes().map((one) => one.label).join(', ')} for the designs that ended well`,
      () => this.option(),
      'axes',
    );
    this.chart.whenReady((chart) => {
      this.chart_ = chart;
      chart.on('axisareaselected', () => this.brushed());
    });
    store.selectionChanged(() => this.chart.update());
    store.filterChanged(() => {
      this.count();
      if (!this.own) this.chart.update();
    });
    this.wide();
    const frame = h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Parallel coordinates' }, this.chart.element);
    this.element = h('div', {}, this.fields(), frame, this.axisChoice());
    this.count();
  }

  private fields(): HTMLElement {
    const ranked = this.table.quantities.filter((one) => one.goal);
    let by = ranked.find((one) => one.key === view.get('best.by', '')) ?? ranked[0];
    const share = h('input', { type: 'range', min: 1, max: 100, value: view.get('best.share', 100), 'aria-label': 'Best share in per cent' });
    const shown = h('output', {}, '100 %');
    const apply = (): void => {
      shown.textContent = `${share.value} %`;
      view.set('best.share', Number(share.value));
      if (by) view.set('best.by', by.key);
      const all = Number(share.value) >= 100 || !by;
      this.store.filter('best', all ? null : bestRows(by!, Number(share.value) / 100, (row) => this.counts(row)));
    };
    share.addEventListener('input', apply);
    if (Number(share.value) < 100) apply();
    return h(
      'div',
      { class: 'row' },
      h('label', { class: 'field' }, h('span', {}, 'Best'), share, shown),
      ranked.length > 0 &&
        select('by', ranked.map((one) => ({ value: one.key, text: one.label })), by!.key, (key) => {
          by = this.table.find(key);
          apply();
        }),
      button('Clear brushes', () => {
        share.value = '100';
        apply();
        this.store.filter('axes', null);
        this.chart_?.clear();
        this.chart_?.setOption(this.option());
      }),
      this.counter,
    );
  }

  private axisChoice(): HTMLElement {
    return h(
      'details',
      {},
      h('summary', {}, 'Axes'),
      h(
        'div',
        { class: 'ticks' },
        ...this.table.quantities.map((one) =>
          checkbox(one.label, this.axes.has(one.key), (on) => {
            if (on) this.axes.add(one.key);
            else this.axes.delete(one.key);
            view.set('parallel.axes', [...this.axes]);
            this.wide();
            this.chart_?.clear();
            this.chart_?.setOption(this.option());
          }),
        ),
      ),
    );
  }

  /** Designs that are compared: ended well, at the finest spacing. */
  private counts(row: number): boolean {
    const kind = this.table.kind[row];
    return kind !== 'failed' && kind !== 'coarse';
  }

  private shownAxes(): Quantity[] {
    return this.table.quantities.filter((one) => this.axes.has(one.key));
  }

  /** As wide as its axes need. */
  private wide(): void {
    this.chart.element.style.setProperty('--axes', String(this.axes.size + 1));
  }

  private rows(): number[] {
    const rows: number[] = [];
    for (let row = 0; row < this.table.rows; ++row) if (this.counts(row)) rows.push(row);
    return rows;
  }

  private count(): void {
    const rows = this.rows();
    const n = rows.filter((row) => this.store.passes(row)).length;
    this.counter.textContent = `${n} of ${rows.length} designs`;
  }

  /** What lies within all brushed axes. */
  private brushed(): void {
    const model = (this.chart_ as unknown as { getModel(): { getSeriesByIndex(k: number): { getRawIndicesByActiveState(state: string): number[] } } }).getModel();
    const series = model.getSeriesByIndex(0);
    const rows = this.rows();
    const active = series.getRawIndicesByActiveState('active').map((k) => rows[k]!);
    const normal = series.getRawIndicesByActiveState('normal');
    this.own = true;
    this.store.filter('axes', normal.length > 0 ? null : new Set(active));
    this.own = false;
  }

  private option(): Record<string, unknown> {
    const axes = this.shownAxes();
    const { id } = this.table.page.designs;
    const rows = this.rows();
    const width = Math.max(60, (this.chart.width - 160) / Math.max(1, axes.length - 1) - 14);
    return {
      animation: false,
      parallel: { left: 80, right: 80, top: 72, bottom: 34, parallelAxisDefault: { areaSelectStyle: { width: 24, color: color('accent'), borderColor: color('accent'), opacity: 0.3 } } },
      parallelAxis: axes.map((one, dim) => ({
        dim,
        name: `${one.label}${one.goal ? (one.goal === 'maximize' ? ' ▲' : ' ▼') : ''}`,
        type: one.options ? 'category' : 'value',
        data: one.options,
        scale: true,
        nameGap: 16,
        nameTextStyle: { color: color('text'), fontSize: 12, lineHeight: 14, width, overflow: 'break' },
        axisLine: { lineStyle: { color: color('line') } },
        axisTick: { lineStyle: { color: color('line') } },
        axisLabel: { color: color('text') },
      })),
      series: [
        {
          id: 'all',
          type: 'parallel',
          smooth: false,
          progressive: 500,
          animation: false,
          inactiveOpacity: 0.03,
          activeOpacity: 0.9,
          lineStyle: { width: 1.2, opacity: rows.length > 500 ? 0.12 : 0.45 },
          data: rows.map((row) => {
            const kind = this.table.kind[row]!;
            const place = this.store.selected.indexOf(id[row]!);
            const main = place >= 0;
            const option = this.byOption ? axisValue(this.byOption, row) : null;
            const plain = option !== null ? palette[option % palette.length]! : onFront(kind) ? color('accent') : kind === 'infeasible' ? color('bad') : color('good');
            const passes = this.store.passes(row) || main;
            return {
              value: axes.map((one) => (one.options ? (one.values[row] ?? '-') : (axisValue(one, row) ?? '-'))),
              lineStyle: {
                color: main && option === null ? palette[place % palette.length] : plain,
                width: main ? 4 : onFront(kind) ? 2.2 : 1.2,
                ...(main ? { opacity: 1 } : passes ? {} : { opacity: 0.03 }),
              },
            };
          }),
        },
      ],
    };
  }
}

/** Distributions of the variables, of all designs and of those that pass the filters. */
export function distributions(table: DesignTable, keys: Keys, store: Store): HTMLElement {
  const bins = 12;
  const variables = table.quantities.filter((one) => one.group === 'variable');
  const element = h('div', { class: 'histograms' });
  const update = (): void => {
    element.replaceChildren(
      ...variables.map((one) => {
        const spec = table.page.variables.find((variable) => variable.name === one.name);
        const tried = one.values.filter((value): value is number => typeof value === 'number');
        const low = one.options ? -0.5 : (spec?.lower ?? tried.reduce((least, value) => Math.min(least, value), Infinity));
        const top = one.options ? one.options.length - 0.5 : (spec?.upper ?? tried.reduce((most, value) => Math.max(most, value), -Infinity));
        const high = top > low ? top : low + 1;
        const n = one.options ? one.options.length : bins;
        const all = new Array<number>(n).fill(0);
        const kept = new Array<number>(n).fill(0);
        for (let row = 0; row < table.rows; ++row) {
          const value = axisValue(one, row);
          if (value === null) continue;
          const bin = Math.min(n - 1, Math.max(0, Math.floor(((value - low) / (high - low)) * n)));
          all[bin]! += 1;
          if (store.passes(row)) kept[bin]! += 1;
        }
        const most = Math.max(1, ...all);
        const bars = h('div', { class: 'bars', 'aria-hidden': 'true' });
        all.forEach((count, k) => {
          const bar = h('div', { class: 'slot' }, h('div', { class: 'all' }), h('div', { class: 'kept' }));
          (bar.children[0] as HTMLElement).style.height = `${(100 * count) / most}%`;
          (bar.children[1] as HTMLElement).style.height = `${(100 * kept[k]!) / most}%`;
          bars.append(bar);
        });
        const ends = one.options ? one.options.join(', ') : `${keys.quantity(one.name, low)} to ${keys.quantity(one.name, high)}`;
        return h('figure', { class: 'histogram' }, h('figcaption', {}, keys.words(one.name)), bars, h('p', { class: 'note' }, ends));
      }),
    );
  };
  store.filterChanged(update);
  update();
  return element;
}
