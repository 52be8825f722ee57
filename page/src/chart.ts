/** ECharts with what this page uses of it, drawn in the colours of the page. */
import { BarChart, CustomChart, LineChart, ParallelChart, ScatterChart } from 'echarts/charts';
import {
  AriaComponent,
  GridComponent,
  LegendComponent,
  ParallelComponent,
  TooltipComponent,
} from 'echarts/components';
import { LabelLayout } from 'echarts/features';
import { init, use, type ECharts, type EChartsCoreOption } from 'echarts/core';
import { CanvasRenderer } from 'echarts/renderers';
import { h } from './dom';
import { color, onTheme } from './theme';

use([
  AriaComponent,
  BarChart,
  CanvasRenderer,
  CustomChart,
  GridComponent,
  LabelLayout,
  LegendComponent,
  LineChart,
  ParallelChart,
  ParallelComponent,
  ScatterChart,
  TooltipComponent,
]);

const charts = new Set<Chart>();

/** Text and lines of all charts in the colours of the style sheet. */
export function axisStyle(name = '', extra: object = {}): object {
  return {
    name,
    nameLocation: 'middle',
    nameTextStyle: { color: color('text'), fontSize: 13 },
    axisLine: { show: true, onZero: false, lineStyle: { color: color('line') } },
    axisTick: { lineStyle: { color: color('line') } },
    axisLabel: { color: color('text'), fontSize: 12, hideOverlap: true },
    splitLine: { lineStyle: { color: color('grid') } },
    ...extra,
  };
}

/** Tooltips are drawn on the canvas: as HTML they would need inline styles, which the page forbids. */
export function tooltipStyle(): object {
  return {
    renderMode: 'richText',
    backgroundColor: color('raised'),
    borderColor: color('line'),
    textStyle: { color: color('text'), fontSize: 13 },
    confine: true,
  };
}

export class Chart {
  readonly element: HTMLElement;
  private readonly place: HTMLElement;
  private made: ECharts | null = null;
  private readonly ready: ((chart: ECharts) => void)[] = [];

  /** @param describe one sentence for those who do not see it
   *  @param option made anew whenever colours or data change */
  constructor(
    private readonly describe: () => string,
    private readonly option: () => EChartsCoreOption,
    kind = '',
  ) {
    this.place = h('div', { class: `chart ${kind}`, role: 'img', 'aria-label': describe() });
    this.element = h('div', { class: 'chart-frame' }, this.place);
    charts.add(this);
    // Charts that nobody has scrolled to yet cost nothing.
    new IntersectionObserver(
      (entries, observer) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        observer.disconnect();
        this.make();
      },
      { rootMargin: '300px' },
    ).observe(this.place);
  }

  /** In pixels of the style sheet. */
  get width(): number {
    return this.place.clientWidth || 1200;
  }

  get instance(): ECharts | null {
    return this.made;
  }

  /** Called with the chart once it is there. */
  whenReady(action: (chart: ECharts) => void): void {
    if (this.made) action(this.made);
    else this.ready.push(action);
  }

  make(): void {
    if (this.made) return;
    this.made = init(this.place, null, { renderer: 'canvas' });
    this.made.setOption(this.option());
    this.ready.splice(0).forEach((action) => action(this.made!));
    new ResizeObserver(() => this.resize()).observe(this.place);
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.place;
    if (this.made && clientWidth > 0 && (clientWidth !== this.made.getWidth() || clientHeight !== this.made.getHeight())) {
      this.made.resize();
    }
  }

  /** Draws anew what has changed. */
  update(replace: string[] = ['series']): void {
    this.place.setAttribute('aria-label', this.describe());
    this.made?.setOption(this.option(), { replaceMerge: replace });
  }

  dispose(): void {
    charts.delete(this);
    this.made?.dispose();
    this.made = null;
  }
}

onTheme(() => charts.forEach((chart) => chart.update()));
window.addEventListener('beforeprint', () =>
  charts.forEach((chart) => {
    chart.make();
    chart.resize();
  }),
);
window.addEventListener('afterprint', () => charts.forEach((chart) => chart.resize()));
