/** The page of one simulation. */
import { metricTable } from './advice';
import { checkSection } from './check';
import type { SimulationPage } from './data';
import { h, section } from './dom';
import { drawing } from './drawing';
import { numberText, withUncertainty, type Keys } from './format';
import { compareRuns, titleBlock } from './runs';

/** Metrics that stand on page one: those with an uncertainty, else the first of each unit. */
function leading(page: SimulationPage, keys: Keys): string[] {
  const { metrics, uncertainty } = page.result;
  const known = Object.keys(metrics).filter((key) => metrics[key] !== null);
  const sure = known.filter((key) => uncertainty?.[key]);
  if (sure.length > 0) return sure.slice(0, 9);
  const units = new Set<string>();
  return known
    .filter((key) => {
      const unit = keys.unit(key);
      const fresh = !units.has(unit);
      units.add(unit);
      return fresh;
    })
    .slice(0, 9);
}

export function simulationSections(page: SimulationPage, keys: Keys): HTMLElement[] {
  const { result } = page;
  const scene = page.runs[page.name]?.scene;
  const ok = result.status === 'ok';
  const warnings = result.warnings ?? [];
  const kind = ok ? (warnings.length > 0 ? 'warn' : 'good') : 'bad';
  return [
    section(
      'answer',
      'What came of it?',
      h(
        'div',
        { class: 'sheet-grid' },
        h(
          'div',
          {},
          h(
            'div',
            { class: `verdict ${kind}` },
            h('p', { class: 'headline' }, ok ? `The run ended at ${numberText(result.stop_time_s)} s of flow.` : `The run failed at ${numberText(result.stop_time_s)} s.`),
            h('p', {}, ok ? `Reason: ${result.stop_reason.replace(/_/g, ' ')}.` : result.reason),
            ...warnings.map((one) => h('p', {}, h('span', { class: 'badge warn' }, 'warning'), ` ${one.text}`)),
          ),
          h(
            'dl',
            { class: 'lead' },
            ...leading(page, keys).flatMap((key) => {
              const value = result.metrics[key]!;
              const own = result.uncertainty?.[key];
              const unit = keys.unit(key);
              return [
                h('dt', { title: keys.definition(key) }, keys.words(key)),
                h('dd', {}, h('data', { value: String(value), title: String(value) }, own ? withUncertainty(value, own.expanded_95) : numberText(value)), unit ? `\u00a0${unit}` : ''),
              ];
            }),
          ),
        ),
        scene ? h('figure', { class: 'sheet-drawing' }, drawing(scene, titleBlock(page, page.name))) : null,
      ),
    ),
    section(
      'sure',
      'How sure are we?',
      result.uncertainty
        ? h('p', {}, 'Uncertainty at 95 %: grid convergence and scatter between lattices of particles, together.')
        : h('p', { class: 'note' }, 'The uncertainty was not asked for. ', h('code', {}, page.commands.find((one) => one.what.includes('uncertainty'))?.command ?? 'parapet simulate CASE --uncertainty'), ' gives it.'),
      metricTable(result.metrics, result.metrics_absent, keys, result.uncertainty),
    ),
    section('flow', 'What does the flow look like?', compareRuns(page, keys, [page.name], (name) => name, false)),
    checkSection(page),
  ];
}
